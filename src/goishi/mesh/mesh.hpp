#pragma once
/// \file
/// Triangles and their vertices.

#include <array>
#include <cstdint>
#include <goishi/vector.hpp>
#include <vector>

namespace goishi {

/// The corners of a triangle, as places in a mesh's list of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A closed surface of triangles, in B for a stone, in W for a board. A vertex is a point with a normal: where the
/// surface has an edge, its points stand once for each of its sides.
template <class T>
struct Mesh {
  std::vector<Vec3<T>> points;   // [m]
  std::vector<Vec3<T>> normals;  // unit, outwards, of the true surface; one for each point
  std::vector<Triangle> triangles;
};

}  // namespace goishi
