#pragma once
/// \file
/// How far a mesh is from its stone, and the mesh that a tolerance asks for.

#include <algorithm>
#include <cmath>
#include <goishi/error.hpp>
#include <goishi/mesh/mesh.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace goishi {

namespace detail {

/// Unit normal of a triangle. Zero of one without area.
template <Ordered T>
[[nodiscard]] Vec3<T> facet_normal(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const Vec3<T> across = formula::cross(formula::minus(b, a), formula::minus(c, a));
  const T length = scalar::sqrt(formula::dot(across, across));
  return T(0) < length ? formula::scaled(T(T(1) / length), across) : Vec3<T>(T(0), T(0), T(0));
}

/// The greatest value on an arc of directions, from u to v, of how far the stone goes beyond the point p, as far as it is above
/// `most`: it is that, to a thousandth.
///
/// Between two directions it is at most the greater of its values at their ends over the cosine of half their
/// angle: a support is sublinear, h(a u + b v) <= a h(u) + b h(v). So an arc is halved until nothing above is left.
template <Ordered T>
[[nodiscard]] T greatest_on_arc(const Stone<T>& stone, const Vec3<T>& p, const Vec3<T>& u, const T& at_u,
                                const Vec3<T>& v, const T& at_v, const T& most, int depth = 40) {
  const T larger = at_u < at_v ? at_v : at_u;
  // cos² of half the angle, at least of a right one: beyond, no bound is worth having.
  const T half = (T(1) + formula::dot(u, v)) / T(2);
  const T worth = most * (T(1) + T(1) / T(1000));
  const T found = most < larger ? larger : most;
  if (depth == 0 || (T(1) / T(2) < half && larger <= worth * scalar::sqrt(half))) {
    return found;
  }
  const Vec3<T> sum = formula::plus(u, v);
  const T length = scalar::sqrt(formula::dot(sum, sum));
  if (!(T(0) < length)) {
    return found;
  }
  const Vec3<T> middle = formula::scaled(T(T(1) / length), sum);
  const T there = support_value_of_unit(stone, middle) - formula::dot(middle, p);
  const T first = greatest_on_arc(stone, p, u, at_u, middle, there, found, depth - 1);
  return greatest_on_arc(stone, p, middle, there, v, at_v, first, depth - 1);
}

}  // namespace detail

/// The greatest distance between a stone and a mesh in it   [m]: of a point of either from the other. (Hausdorff's.)
///
/// A point x of the surface is nearest to a facet, an edge or a vertex of the mesh, in a direction u that its neighbours
/// allow, and then |x − p| <= h(u) − u · p for the stone's support h: the greatest of these, over facets and the arcs
/// between the normals of two that meet in an edge that juts out, is a bound, and what is nearest to a vertex
/// is covered by the arcs around it. It is reached if the mesh is convex. From the mesh to the stone is never farther.
///
/// Domain  a closed mesh (`topology`) with its vertices on the stone's surface, else InvalidArgument (what is not closed).
/// Error   at most 1/1000 above the bound, and 4 ε of the width; meshes of `tessellate`: the bound is the distance, to 1 % (MESH-3).
template <Ordered T>
[[nodiscard]] T deviation(const Mesh<T>& mesh, const Stone<T>& stone) {
  const Mesh<T> solid = weld(mesh, Weld::position);
  const auto corner = [&](const Triangle& triangle, std::size_t i) -> const Vec3<T>& {
    return solid.points[triangle[i]];
  };
  std::vector<Vec3<T>> normals;
  std::vector<T> heights;  // of the stone over each facet
  normals.reserve(solid.triangles.size());
  heights.reserve(solid.triangles.size());
  T most(0);
  for (const Triangle& triangle : solid.triangles) {
    const Vec3<T> n = detail::facet_normal(corner(triangle, 0), corner(triangle, 1), corner(triangle, 2));
    require(T(0) < formula::dot(n, n), "mesh", triangle[0], "must have no triangle without area (a corner is shown)");
    const T height = detail::support_value_of_unit(stone, n) - formula::dot(n, corner(triangle, 0));
    normals.push_back(n);
    heights.push_back(height);
    most = most < height ? height : most;
  }
  const std::vector<detail::HalfEdge> edges = detail::half_edges(solid);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const detail::HalfEdge& edge = edges[i];
    const bool two = i + 1 < edges.size() && edges[i + 1].low == edge.low && edges[i + 1].high == edge.high &&
                     edges[i + 1].rising != edge.rising;
    const bool more = i + 2 < edges.size() && edges[i + 2].low == edge.low && edges[i + 2].high == edge.high;
    require(two && !more, "mesh", edge.low, "must be closed: each edge of two triangles, once in each direction");
    const Vec3<T>&u = normals[edge.triangle], &v = normals[edges[i + 1].triangle];
    const Vec3<T>& p = solid.points[edge.low];
    // It juts out if the far corner of one triangle is below the plane of the other.
    const Triangle& other = solid.triangles[edges[i + 1].triangle];
    const std::size_t far = other[0] != edge.low && other[0] != edge.high   ? 0
                            : other[1] != edge.low && other[1] != edge.high ? 1
                                                                            : 2;
    if (formula::dot(u, formula::minus(corner(other, far), p)) < T(0)) {
      most = detail::greatest_on_arc(stone, p, u, heights[edge.triangle], v, heights[edges[i + 1].triangle], most);
    }
  }
  return most;
}

namespace detail {

/// What a band would be off, seen where it is widest, in a flat metric: of a triangle with the circumradius R, R²/2.
template <class T>
struct BandMetric {
  T across;  // from joint to joint   [√m]
  T around;  // the whole rim

  /// The least rows with which n rings keep the tolerance; 0 if there are none.
  [[nodiscard]] int rows(Tessellation method, int n, const T& tolerance) const {
    const T segment = around / static_cast<T>(5 * n);
    const T square = T(2) * tolerance;  // R²
    const T left = square - scalar::sq(segment) / T(4);
    if (left < T(0)) {
      return 0;
    }
    // Isosceles triangles between rows that are staggered: the circle through their corners; else right ones.
    const T height = method == Tessellation::subdivision ? T(scalar::sqrt(square) + scalar::sqrt(left))
                                                         : T(T(2) * scalar::sqrt(left));
    const T rows = across / height;
    return rows < T(most_rings) ? 1 + static_cast<int>(rows) : 0;
  }
};

template <Ordered T>
[[nodiscard]] BandMetric<T> band_metric(const Stone<T>& stone) {
  return {T(T(2) * scalar::atan2(stone.joint_sine, stone.joint_cosine) * scalar::sqrt(stone.bevel_minor_radius)),
          T(T(2) * scalar::pi<T>() * scalar::sqrt(T(outer_width(stone) / T(2))))};
}

}  // namespace detail

namespace detail {

/// C, if n rings are off C/n²: of a cap of height s, or of the rim.
template <Ordered T>
[[nodiscard]] T rings_constant(const Stone<T>& stone, Tessellation method) {
  const T segment = T(2) * scalar::pi<T>() / T(5);  // of the rim, times n
  const T rim = scalar::sq(segment) / T(8) * outer_width(stone) / T(2);
  const T s = (stone.height - stone.bevel) / T(2);
  const T angle = scalar::atan2(stone.joint_cosine, stone.joint_sine);
  const T right = scalar::sq(angle) + scalar::sq(T(segment * stone.joint_cosine));
  const T cap = method == Tessellation::subdivision ? T(s / T(2)) : T(stone.sphere_radius * right / T(8));
  return cap < rim ? rim : cap;
}

}  // namespace detail

/// A mesh, by few triangles, that is nowhere farther from the stone than the tolerance   [m], as `deviation` finds.
///
/// Domain  a tolerance of at least 512 ε of the width, and one that 1024 rings and rows keep, else InvalidArgument.
/// Error   none: it is kept. The triangles are at most 1.3 times the best possible for stones of the catalogue from 1000
///         on (MESH-5). The cost is that of some meshes and their `deviation`.
template <Ordered T>
[[nodiscard]] Fineness fineness_for(const Stone<T>& stone, Tessellation method, const T& tolerance) {
  require_positive("tolerance", tolerance);
  const T least = T(512) * std::numeric_limits<T>::epsilon() * outer_width(stone);
  require(least <= tolerance, "tolerance", tolerance, "must be above round-off, at least ", least, " m");
  const bool sharp = !(T(0) < stone.bevel);
  const detail::BandMetric<T> band = detail::band_metric(stone);
  const auto triangles = [&](const Fineness& f) {
    const double n = f.rings, m = f.rows;
    return (method == Tessellation::subdivision ? n : 2.0 * n - 1.0) * n + n * m;
  };
  // What n rings are off is about C/n². More rings than the caps need may spare rows.
  const T constant = detail::rings_constant(stone, method);
  std::optional<Fineness> kept;
  T allowed = tolerance;
  for (int trial = 0; trial < 12; ++trial) {
    const T rings = scalar::sqrt(T(constant / allowed));
    std::optional<Fineness> next;
    const int first = rings < static_cast<T>(most_rings) ? 1 + static_cast<int>(rings) : most_rings + 1;
    for (int n = first; n <= std::min(2 * first, most_rings); ++n) {
      const Fineness fineness{n, sharp ? 0 : band.rows(method, n, allowed)};
      if ((sharp || 0 < fineness.rows) && (!next || triangles(fineness) < triangles(*next))) {
        next = fineness;
      }
    }
    if (!next || (kept && !(triangles(*next) < triangles(*kept)))) {
      break;
    }
    const T found = deviation(tessellate(stone, method, *next), stone);
    if (found <= tolerance) {
      kept = next;
    }
    allowed = allowed * tolerance / found * (found <= tolerance ? T(1) : T(1) - T(1) / T(1000));
  }
  require(kept.has_value(), "tolerance", tolerance, "must be one that ", most_rings, " rings and rows keep");
  return *kept;
}

}  // namespace goishi
