#pragma once
/// \file
/// The board as triangles, for whoever draws it.

#include <goishi/board/board.hpp>
#include <goishi/error.hpp>
#include <goishi/mesh/mesh.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// Three meshes in W: the block is closed; lines and star points lie in its upper face, z = 0, so whoever draws lifts them or draws
/// them last.
template <class T>
struct BoardMesh {
  Mesh<T> block;
  Mesh<T> lines;
  Mesh<T> star_points;
};

/// How the board is marked   [m].
template <class T>
struct BoardMarks {
  T line_width = T(1) / T(1000);
  T star_diameter = T(4) / T(1000);
  int star_segments = 32;
};

namespace detail {

/// Two triangles between four corners, counter-clockwise as seen from where n points.
template <class T>
void add_quad(Mesh<T>& mesh, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d, const Vec3<T>& n) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Vec3<T>* p : {&a, &b, &c, &d}) {
    mesh.points.push_back(*p);
    mesh.normals.push_back(n);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A rectangle in the plane z = 0.
template <class T>
void add_flat(Mesh<T>& mesh, const T& low_x, const T& low_y, const T& high_x, const T& high_y) {
  const T z(0);
  add_quad<T>(mesh, {low_x, low_y, z}, {high_x, low_y, z}, {high_x, high_y, z}, {low_x, high_y, z}, {z, z, T(1)});
}

}  // namespace detail

/// The board's block (24 vertices, a flat normal a face), its lines and its star points.
///
/// Domain  a board of `make_board`, 0 < widths < the spacing, 3 <= segments <= 1000; else InvalidArgument.
template <Ordered T>
[[nodiscard]] BoardMesh<T> mesh_of(const Board<T>& board, const BoardMarks<T>& marks = {}) {
  detail::require_board(board);
  const T spacing = board.spacing_y < board.spacing_x ? board.spacing_y : board.spacing_x;
  const auto require_mark = [&](const char* argument, const T& value) {
    require(T(0) < value && value < spacing, argument, value, "must be above 0 and below the spacing, ", spacing, " m");
  };
  require_mark("line_width", marks.line_width);
  require_mark("star_diameter", marks.star_diameter);
  require(3 <= marks.star_segments && marks.star_segments <= 1000, "star_segments", marks.star_segments,
          "must be 3 … 1000");
  BoardMesh<T> result;
  const Vec3<T> half(board.half_width, board.half_length, board.thickness);
  // Each face: its normal, and the two directions along it that it is the product of.
  for (int axis = 0; axis < 3; ++axis) {
    for (const T& side : {T(-1), T(1)}) {
      Vec3<T> n = Vec3<T>::Zero(), e = Vec3<T>::Zero(), f = Vec3<T>::Zero();
      n[axis] = side;
      e[(axis + 1) % 3] = side;
      f[(axis + 2) % 3] = T(1);
      const auto corner = [&](const T& along_e, const T& along_f) {
        const Vec3<T> unit = formula::plus(n, formula::combination(along_e, e, along_f, f));
        // From −thickness to 0 in z.
        return Vec3<T>(T(unit.x() * half.x()), T(unit.y() * half.y()), unit.z() < T(0) ? T(-half.z()) : T(0));
      };
      detail::add_quad<T>(result.block, corner(T(-1), T(-1)), corner(T(1), T(-1)), corner(T(1), T(1)),
                          corner(T(-1), T(1)), n);
    }
  }
  const Vec3<T> first = intersection(board, 0, 0), last = intersection(board, board.lines - 1, board.lines - 1);
  const T half_line = marks.line_width / T(2);
  for (int i = 0; i < board.lines; ++i) {
    const Vec3<T> at = intersection(board, i, i);
    detail::add_flat<T>(result.lines, T(at.x() - half_line), T(first.y() - half_line), T(at.x() + half_line),
                        T(last.y() + half_line));
    detail::add_flat<T>(result.lines, T(first.x() - half_line), T(at.y() - half_line), T(last.x() + half_line),
                        T(at.y() + half_line));
  }
  for (const auto& [i, j] : star_points(board)) {
    const Vec3<T> middle = intersection(board, i, j);
    Mesh<T>& stars = result.star_points;
    const auto centre = static_cast<std::uint32_t>(stars.points.size());
    const auto count = static_cast<std::uint32_t>(marks.star_segments);
    stars.points.push_back(middle);
    for (std::uint32_t k = 0; k < count; ++k) {
      const T angle = T(2) * scalar::pi<T>() * static_cast<T>(k) / static_cast<T>(count);
      const T radius = marks.star_diameter / T(2);
      const auto [s, c] = scalar::sincos(angle);
      stars.points.push_back({T(middle.x() + radius * c), T(middle.y() + radius * s), T(0)});
      stars.triangles.push_back({centre, centre + 1 + k, centre + 1 + (k + 1) % count});
    }
    stars.normals.resize(stars.points.size(), Vec3<T>(T(0), T(0), T(1)));
  }
  return result;
}

}  // namespace goishi
