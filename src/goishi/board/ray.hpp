#pragma once
/// \file
/// Where a ray meets the board, for picking: the box as it stands, with all six faces.

#include <goishi/board/board.hpp>
#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <string_view>

namespace goishi {

enum class BoardFace { surface, underside, left, right, bottom, top };

[[nodiscard]] constexpr std::string_view to_string(BoardFace face) {
  constexpr std::string_view names[] = {"surface", "underside", "left side", "right side", "bottom side", "top side"};
  return names[static_cast<std::size_t>(face)];
}

/// Where the line p + t u, u a unit vector, is in the board: entry <= t <= exit.
template <class T>
struct BoardRayHit {
  bool hit = false;                                     // the line meets the board
  T entry = scalar::unset<T>();                         // [m], may be negative: behind the start
  T exit = scalar::unset<T>();                          // [m]
  bool forward = false;                                 // something of it lies ahead
  T first = scalar::unset<T>();                         // the first point ahead: the entry, or from inside the exit
  Vec3<T> p_W = Vec3<T>::Constant(scalar::unset<T>());  // there
  Vec3<T> n_W = Vec3<T>::Constant(scalar::unset<T>());  // unit, out of the board, there
  BoardFace face = BoardFace::surface;                  // there
};

namespace detail {

/// An end of the stretch that the line has in the board, on the face across an axis, at its low or its high end.
template <class T>
struct BoardCrossing {
  T t;
  int axis;
  bool high;
};

[[nodiscard]] inline BoardFace face_of(int axis, bool high) {
  constexpr BoardFace faces[3][2] = {{BoardFace::left, BoardFace::right},
                                     {BoardFace::bottom, BoardFace::top},
                                     {BoardFace::underside, BoardFace::surface}};
  return faces[axis][high ? 1 : 0];
}

}  // namespace detail

/// Entry, exit and the first hit ahead of a ray. A ray within a face meets the board; one that meets two faces at once
/// is said to hit one of them.
///
/// Domain  a finite start, a unit direction within `unit_tolerance`, a board of `make_board`, entry and exit that T can
///         hold; else InvalidArgument.
/// Error   entry and exit: a difference and a quotient, each rounded once. The hit lies on its face exactly (DOMAIN-10).
template <Ordered T>
[[nodiscard]] BoardRayHit<T> cast_ray(const Board<T>& board, const Vec3<T>& p_W, const Vec3<T>& u_W) {
  detail::require_board(board);
  require(scalar::is_finite(T(p_W.x() + p_W.y() + p_W.z())), "start", p_W.transpose(), "must be finite");
  require(detail::is_unit_defect(T(formula::dot(u_W, u_W) - T(1))), "direction", detail::length(u_W),
          "must be a unit vector (its length is shown)");
  const Vec3<T> low(-board.half_width, -board.half_length, -board.thickness);
  const Vec3<T> high(board.half_width, board.half_length, T(0));
  BoardRayHit<T> result;
  detail::BoardCrossing<T> entry{-std::numeric_limits<T>::infinity(), 2, true};
  detail::BoardCrossing<T> exit{std::numeric_limits<T>::infinity(), 2, true};
  for (int i = 2; i >= 0; --i) {
    if (!(u_W[i] < T(0)) && !(T(0) < u_W[i])) {
      if (p_W[i] < low[i] || high[i] < p_W[i]) {
        return result;
      }
      continue;
    }
    const bool upwards = T(0) < u_W[i];
    const T in = ((upwards ? low[i] : high[i]) - p_W[i]) / u_W[i];
    const T out = ((upwards ? high[i] : low[i]) - p_W[i]) / u_W[i];
    if (entry.t < in) {
      entry = {in, i, !upwards};
    }
    if (out < exit.t) {
      exit = {out, i, upwards};
    }
  }
  if (exit.t < entry.t) {
    return result;
  }
  require(scalar::is_finite(entry.t) && scalar::is_finite(exit.t), "start", p_W.transpose(),
          "must not be so far that the way to the board is no number");
  result.hit = true;
  result.entry = entry.t;
  result.exit = exit.t;
  result.forward = !(exit.t < T(0));
  if (result.forward) {
    const detail::BoardCrossing<T>& first = entry.t < T(0) ? exit : entry;
    result.first = first.t;
    result.face = detail::face_of(first.axis, first.high);
    result.n_W = Vec3<T>::Zero();
    result.n_W[first.axis] = T(first.high ? 1 : -1);
    result.p_W = p_W + first.t * u_W;
    result.p_W[first.axis] = first.high ? high[first.axis] : low[first.axis];
  }
  return result;
}

}  // namespace goishi
