#pragma once
/// \file
/// Triangles and their vertices: how a mesh is welded, and whether it is a closed surface.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <vector>

namespace goishi {

/// The corners of a triangle, as places in a mesh's list of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles, in B for a stone, in W for a board. A vertex is a point with a normal: where the surface has
/// an edge, its points stand once for each of its sides.
template <class T>
struct Mesh {
  std::vector<Vec3<T>> points;   // [m]
  std::vector<Vec3<T>> normals;  // unit, outwards, of the true surface; one for each point
  std::vector<Triangle> triangles;
};

/// What makes two vertices one.
enum class Weld { position_and_normal, position };

namespace detail {

template <Ordered T>
void require_mesh(const Mesh<T>& mesh) {
  require(mesh.points.size() == mesh.normals.size(), "normals", mesh.normals.size(), "must be as many as the points, ",
          mesh.points.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < mesh.points.size(), "triangles", corner, "must name points of the mesh, which has ",
              mesh.points.size());
    }
  }
}

/// A table of vertices by their coordinates, with open addressing: each gets the place of the first one like it.
class FirstOfEach {
 public:
  explicit FirstOfEach(std::size_t count) : slots_(std::bit_ceil(2 * count + 1), none) {}

  /// The first that was asked for with this hash and of which `same` says that it is like this one; else this one.
  template <class Same>
  std::uint32_t operator()(std::uint64_t hash, std::uint32_t vertex, Same&& same) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] != none && !same(slots_[slot])) {
      slot = (slot + 1) & mask;
    }
    if (slots_[slot] == none) {
      slots_[slot] = vertex;
    }
    return slots_[slot];
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> slots_;
};

/// Of equal coordinates equal; −0 is 0.
template <Ordered T>
[[nodiscard]] std::uint64_t mixed(std::uint64_t hash, const Vec3<T>& v) {
  for (int i = 0; i < 3; ++i) {
    const double x = static_cast<double>(v[i]) + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof(bits));  // libc++ 13 has no bit_cast
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
    hash = (hash ^ hash >> 32) * 0xd6e8feb86659fd93U;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace detail

/// Each triangle with vertices of its own, as a program that draws triangle by triangle has them.
template <Ordered T>
[[nodiscard]] Mesh<T> unwelded(const Mesh<T>& mesh) {
  detail::require_mesh(mesh);
  Mesh<T> result;
  result.points.reserve(3 * mesh.triangles.size());
  result.normals.reserve(3 * mesh.triangles.size());
  result.triangles.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t corner : triangle) {
      result.points.push_back(mesh.points[corner]);
      result.normals.push_back(mesh.normals[corner]);
    }
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// The mesh with one vertex in place of all that are equal, which keeps the normal of the first; what no triangle uses
/// goes. By position alone, the triangles on the two sides of an edge are joined, which is what a solid needs and a
/// drawing must not have.
///
/// Equal means the same numbers: `tessellate` gives neighbours the same ones. Linear in the size of the mesh.
template <Ordered T>
[[nodiscard]] Mesh<T> weld(const Mesh<T>& mesh, Weld what = Weld::position_and_normal) {
  detail::require_mesh(mesh);
  constexpr std::uint32_t unseen = 0xffffffffU;
  detail::FirstOfEach first_of(mesh.points.size());
  std::vector<std::uint32_t> place(mesh.points.size(), unseen);  // in the result, of the first of each
  Mesh<T> result;
  result.triangles.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    Triangle welded{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = triangle[i];
      if (place[corner] == unseen) {
        std::uint64_t hash = detail::mixed<T>(0, mesh.points[corner]);
        if (what == Weld::position_and_normal) {
          hash = detail::mixed<T>(hash, mesh.normals[corner]);
        }
        const std::uint32_t first = first_of(hash, corner, [&](std::uint32_t other) {
          return mesh.points[other] == mesh.points[corner] &&
                 (what == Weld::position || mesh.normals[other] == mesh.normals[corner]);
        });
        if (place[first] == unseen) {
          place[first] = static_cast<std::uint32_t>(result.points.size());
          result.points.push_back(mesh.points[first]);
          result.normals.push_back(mesh.normals[first]);
        }
        place[corner] = place[first];
      }
      welded[i] = place[corner];
    }
    result.triangles.push_back(welded);
  }
  return result;
}

/// How the triangles of a mesh hang together, by its points.
struct Topology {
  std::size_t points = 0;  // after welding by position
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t loose_edges = 0;  // not of exactly two triangles, one in each direction
  std::size_t degenerate = 0;   // triangles of which two corners are one point

  [[nodiscard]] long euler_characteristic() const {
    return static_cast<long>(points) - static_cast<long>(edges) + static_cast<long>(triangles);
  }
  /// Watertight and consistently oriented: each edge is passed once in each direction.
  [[nodiscard]] bool is_closed() const { return loose_edges == 0 && degenerate == 0; }
};

namespace detail {

/// An edge of a triangle: its ends in ascending order, the triangle, and whether that passes it from low to high.
struct HalfEdge {
  std::uint32_t low, high, triangle;
  bool rising;
};

/// The edges of all triangles, those of the same ends together.
template <Ordered T>
[[nodiscard]] std::vector<HalfEdge> half_edges(const Mesh<T>& mesh) {
  // By counting: the edges of each low end, and these by their high ends.
  std::vector<std::uint32_t> begin(mesh.points.size() + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& triangle = mesh.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
        visit(HalfEdge{std::min(from, to), std::max(from, to), i, from < to});
      }
    }
  };
  each([&](const HalfEdge& edge) { ++begin[edge.low + 1]; });
  for (std::size_t i = 1; i < begin.size(); ++i) {
    begin[i] += begin[i - 1];
  }
  std::vector<HalfEdge> edges(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  each([&](const HalfEdge& edge) { edges[next[edge.low]++] = edge; });
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    std::sort(edges.data() + begin[i], edges.data() + begin[i + 1],
              [](const HalfEdge& a, const HalfEdge& b) { return a.high < b.high; });
  }
  return edges;
}

}  // namespace detail

/// Of the mesh as it is after welding by position.
template <Ordered T>
[[nodiscard]] Topology topology(const Mesh<T>& mesh) {
  const Mesh<T> solid = weld(mesh, Weld::position);
  Topology result{.points = solid.points.size(), .triangles = solid.triangles.size()};
  for (const Triangle& t : solid.triangles) {
    result.degenerate += t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ? 1 : 0;
  }
  const std::vector<detail::HalfEdge> edges = detail::half_edges(solid);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    int rising = 0;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) {
      rising += edges[end].rising ? 1 : 0;
      ++end;
    }
    ++result.edges;
    result.loose_edges += end - i == 2 && rising == 1 ? 0 : 1;
    i = end;
  }
  return result;
}

}  // namespace goishi
