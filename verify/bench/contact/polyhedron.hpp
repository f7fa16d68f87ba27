#pragma once
/// \file
/// A stone as game engines hold it: the convex hull of points on its surface.

#include <goishi/rotation.hpp>
#include <vector>

#include "verify/oracles/stone/hull.hpp"

namespace goishi::verify::bench::contact {

/// Rings of as many points each; neighbouring rings have their points on the same meridians: every face is plane.
struct Polyhedron {
  std::vector<Vec3<double>> points;
  std::vector<std::vector<int>> faces;       // counter-clockwise, seen from outside
  std::vector<std::vector<int>> neighbours;  // of each point, along the edges
};

/// The rings lie so that the gaps to the outline between them are about equal, on caps and bevel.
/// Domain  a bevelled stone; rings >= 4.
[[nodiscard]] Polyhedron make_polyhedron(const Hull<Digits50>& hull, int rings);

/// The point farthest in a direction, by walking uphill from the point `start`: on a convex body that ends at the top.
[[nodiscard]] int farthest_point(const Polyhedron& body, const Vec3<double>& direction, int start);

}  // namespace goishi::verify::bench::contact
