#pragma once
/// \file
/// Triangles and vertices in the order in which a graphics card reads them with the fewest repetitions, by meshoptimizer.

#include <goishi/mesh/mesh.hpp>

namespace goishi::cli {

/// The same triangles, in another order, each beginning with any of its corners; the vertices as they are first used.
[[nodiscard]] Mesh<double> in_cache_order(const Mesh<double>& mesh);

/// How many vertices a card with a cache of 16 works out for each triangle: 3 without one, 0.5 at best.
[[nodiscard]] double vertices_per_triangle(const Mesh<double>& mesh);

}  // namespace goishi::cli
