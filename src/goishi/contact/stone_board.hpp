#pragma once
/// \file
/// Stone against the board: the surface, its sides, edges and corners, infinitely deep. The board is convex, so the
/// separation is the greatest over its normals, which form cones: a point (surface or side), a quarter circle (an edge)
/// and an octant (a corner). Each region of the board tests only what it needs.

#include <goishi/board/board.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/contact/octant.hpp>

namespace goishi {

namespace detail {

[[nodiscard]] inline OtherFeature board_feature(bool x, bool y, bool z) {
  if (z) {
    return x && y ? OtherFeature::corner : x || y ? OtherFeature::top_edge : OtherFeature::surface;
  }
  return x && y ? OtherFeature::vertical_edge : OtherFeature::side;
}

/// How far the board reaches in a direction: the greatest n · x over it, for n_z >= 0.
template <Ordered T>
[[nodiscard]] T reach_of(const Board<T>& board, const Vec3<T>& n) {
  return board.half_width * (n.x() < T(0) ? T(-n.x()) : n.x()) + board.half_length * (n.y() < T(0) ? T(-n.y()) : n.y());
}

template <Ordered T>
void require_board(const Board<T>& board) {
  require(T(0) < board.half_width && T(0) < board.half_length, "board", board.half_width,
          "must be one of make_board (its half width is shown)");
}

/// What a stone's place lets it touch; deep inside the board it may be pushed out through any side.
template <Ordered T>
[[nodiscard]] Needs needs_of(const Placed<T>& placed, const Board<T>& board) {
  using std::abs;
  const T reach = outer_width(placed.stone) / T(2);
  const bool deep = placed.p_W.z() < -(placed.stone.height / T(2));
  return {.side_x = deep || board.half_width - reach < abs(placed.p_W.x()),
          .side_y = deep || board.half_length - reach < abs(placed.p_W.y())};
}

/// The normal of the board that separates most, one of its sides being near.
template <Ordered T>
[[nodiscard]] OctantMaximum<T> octants_maximum(const Placed<T>& placed, const Board<T>& board, Needs needs) {
  OctantMaximum<T> best;
  const T reach = outer_width(placed.stone) / T(2);
  const bool left = placed.p_W.x() < T(0), bottom = placed.p_W.y() < T(0);
  // The near sides; the far ones too where the stone's centre is nearly as close to them.
  const int signs_x = needs.side_x && (left ? T(-placed.p_W.x()) : placed.p_W.x()) < reach ? 2 : 1;
  const int signs_y = needs.side_y && (bottom ? T(-placed.p_W.y()) : placed.p_W.y()) < reach ? 2 : 1;
  for (int i = 0; i < signs_x; ++i) {
    for (int j = 0; j < signs_y; ++j) {
      const T sign_x = left == (i == 0) ? T(-1) : T(1), sign_y = bottom == (j == 0) ? T(-1) : T(1);
      const Vec3<T> p(T(sign_x * placed.p_W.x() - board.half_width), T(sign_y * placed.p_W.y() - board.half_length),
                      placed.p_W.z());
      const Vec3<T> u(T(sign_x * placed.u_W.x()), T(sign_y * placed.u_W.y()), placed.u_W.z());
      const OctantMaximum<T> found = Octant<T>(placed.stone, p, u).maximum(needs);
      best.certified = best.certified && found.certified;
      if (best.value < found.value) {
        best.value = found.value;
        best.n = {T(sign_x * found.n.x()), T(sign_y * found.n.y()), found.n.z()};
      }
    }
  }
  return best;
}

template <Ordered T>
[[nodiscard]] Separation<T> separation(const Placed<T>& placed, const Board<T>& board) {
  Vec3<T> n(T(0), T(0), T(1));
  bool certified = true;
  const Needs needs = needs_of(placed, board);
  if (needs.side_x || needs.side_y) {
    const OctantMaximum<T> best = octants_maximum(placed, board, needs);
    n = best.n;
    certified = best.certified;
  }
  Separation<T> result = separation_along(placed, n, reach_of(board, n));
  result.other_feature = board_feature(n.x() < T(0) || T(0) < n.x(), n.y() < T(0) || T(0) < n.y(), T(0) < n.z());
  result.certified = certified;
  return result;
}

}  // namespace detail

/// Separation of a stone and the board.
///
/// Domain  a finite pose with a unit attitude, a board of `make_board`; else InvalidArgument. A stone inside the board is
///         ordinary: the shortest way out.
/// Error   gap within 1e-13 of the width (claims CONTACT-2, CONTACT-3).
/// Cost    the region decides: over the middle of the surface one support; near an edge one search over a quarter circle;
///         near a corner three and the corner.
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Board<T>& board) {
  detail::require_board(board);
  return detail::separation(detail::place(stone, pose), board);
}

}  // namespace goishi
