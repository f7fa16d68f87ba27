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
/// `most`: it is that, to a millionth.
///
/// Between two directions it is at most the greater of its values at their ends over the cosine of half their
/// angle: a support is sublinear, h(a u + b v) <= a h(u) + b h(v). So an arc is halved until nothing above is left.
template <Ordered T>
[[nodiscard]] T greatest_on_arc(const Stone<T>& stone, const Vec3<T>& p, const Vec3<T>& u, const T& at_u,
                                const Vec3<T>& v, const T& at_v, const T& most, int depth = 40) {
  const T larger = at_u < at_v ? at_v : at_u;
  // cos² of half the angle, at least of a right one: beyond, no bound is worth having.
  const T half = (T(1) + formula::dot(u, v)) / T(2);
  const T worth = most * (T(1) + T(1) / T(1000000));
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
/// Error   a millionth, and 4 ε of the width; meshes of `tessellate`: the bound is the distance (MESH-3).
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

/// The least count of parts of a length of which each is at most so long; beyond `most_rings` where there are none.
template <Ordered T>
[[nodiscard]] int parts(const T& length, const T& longest) {
  const T count = T(0) < longest ? T(length / longest) : static_cast<T>(most_rings);
  return count < static_cast<T>(most_rings) ? 1 + static_cast<int>(count) : most_rings + 1;
}

/// What a stone is off as a mesh, to the leading order in its edges, turned round: how fine it must be.
template <Ordered T>
class FinenessSearch {
 public:
  FinenessSearch(const Stone<T>& stone, Tessellation method)
      : method_(method),
        sharp_(!(T(0) < stone.bevel)),
        band_(band_metric(stone)),
        cap_height_((stone.height - stone.bevel) / T(2)),
        cap_(scalar::sqrt(stone.sphere_radius) * scalar::atan2(stone.joint_cosine, stone.joint_sine)),
        cap_rim_(T(2) * scalar::pi<T>() / T(5) * scalar::sqrt(stone.sphere_radius) * stone.joint_cosine) {}

  /// That with the fewest triangles for a tolerance, or none.
  [[nodiscard]] std::optional<Fineness> operator()(const T& tolerance) const {
    // A chord of the rim is an eighth of its square off, as the band's metric has it: with fewer segments none keeps it.
    const int first = parts(band_.around, T(scalar::sqrt(T(T(8) * tolerance))));
    std::optional<Fineness> best;
    for (int segments = first; segments <= std::min(2 * first, most_rings); ++segments) {
      const Fineness fineness = with(segments, tolerance);
      if (fineness.rings <= most_rings && fineness.rows <= most_rings && fineness.segments <= most_rings &&
          (!best || triangle_count(method_, fineness) < triangle_count(method_, *best))) {
        best = fineness;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Fineness with(int segments, const T& tolerance) const {
    const T square = T(2) * tolerance;  // R²
    Fineness result{.segments = segments};
    if (method_ == Tessellation::subdivision) {
      // n² = 0.53 s/δ, of caps as stones have them; equilateral triangles would have 4π/(15√3) = 0.48.
      result.rings = parts(T(scalar::sqrt(T(T(53) / T(100) * cap_height_))), T(scalar::sqrt(tolerance)));
      // A ring that takes up a few more segments has worse triangles than one ring more would cost.
      if (100 * segments < 109 * result.rings) {
        result.rings = std::max(segments, result.rings);
      }
      result.segments = std::max(segments, result.rings);
    } else {
      const T side = cap_rim_ / static_cast<T>(segments);  // of right triangles, which have 2R as the longest
      result.rings = parts(cap_, root(T(T(4) * square - scalar::sq(side))));
    }
    if (!sharp_) {
      const T segment = band_.around / static_cast<T>(result.segments);
      const T isosceles = scalar::sqrt(square) + root(T(square - scalar::sq(segment) / T(4)));
      const T right = root(T(T(4) * square - scalar::sq(segment)));
      result.rows = parts(band_.across, method_ == Tessellation::subdivision ? isosceles : right);
      if (method_ == Tessellation::subdivision && isosceles < segment / T(2)) {
        result.rows = most_rings + 1;
      }
    }
    return result;
  }

  [[nodiscard]] static T root(const T& x) { return T(0) < x ? T(scalar::sqrt(x)) : T(0); }

  Tessellation method_;
  bool sharp_;
  BandMetric<T> band_;
  T cap_height_;     // s
  T cap_, cap_rim_;  // from the middle to the rim, and a fifth of it, over √r
};

}  // namespace detail

/// A mesh, by few triangles, that is nowhere farther from the stone than the tolerance   [m], as `deviation` finds.
///
/// Domain  a tolerance of at least 512 ε of the width, and one that 1024 rings, rows and segments keep, else
///         InvalidArgument.
/// Error   none: it is kept. At a micrometre and below, by subdivision, stones of the catalogue get at most 1.3 times the
///         triangles of the least possible; where a tolerance asks for few rings, whole numbers of them cost more (MESH-5). The cost is that of some meshes and their `deviation`.
template <Ordered T>
[[nodiscard]] Fineness fineness_for(const Stone<T>& stone, Tessellation method, const T& tolerance) {
  require_positive("tolerance", tolerance);
  const T least = T(512) * std::numeric_limits<T>::epsilon() * outer_width(stone);
  require(least <= tolerance, "tolerance", tolerance, "must be above round-off, at least ", least, " m");
  const detail::FinenessSearch<T> search(stone, method);
  std::optional<Fineness> kept, last;
  T allowed = tolerance;
  for (int trial = 0; trial < 64; ++trial) {
    const std::optional<Fineness> next = search(allowed);
    if (!next || (kept && triangle_count(method, *kept) <= triangle_count(method, *next))) {
      break;
    }
    if (last == next) {
      allowed = allowed * T(63) / T(64);  // whole numbers, which did not do
      continue;
    }
    last = next;
    const T found = deviation(tessellate(stone, method, *next), stone);
    if (found <= tolerance) {
      kept = next;
    }
    allowed = allowed * tolerance / found;
  }
  require(kept.has_value(), "tolerance", tolerance, "must be one that ", most_rings, " rings, rows and segments keep");
  return *kept;
}

}  // namespace goishi
