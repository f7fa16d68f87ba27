#pragma once
/// \file
/// Stone against the board: the surface, its sides, edges and corners, infinitely deep. The board is convex, so the
/// separation is the greatest over its normals, which form cones: a point (surface or side), a quarter circle (an edge)
/// and an octant (a corner). Each region of the board tests only what it needs.

#include <goishi/board/board.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/contact/octant.hpp>
#include <goishi/contact/stone_plane.hpp>

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
  return board.half_width * scalar::abs(T(n.x())) + board.half_length * scalar::abs(T(n.y()));
}

/// Whether a side has to be asked that is `distance` from the stone's centre (< 0: the centre is beyond it), where `gap`
/// is the greatest separation along any normals without it.
///
/// g(n) = n · p − S(n) − (the board's reach); n_x >= 0 is a normal's part towards the side, n' the rest of it, S(e) the
/// stone's support that way. S(n') <= S(n) + n_x S(e), so that g(n) <= g(n') − n_x (distance − S(e)); g(n') <= |n'| gap;
/// and 1 − |n'| = 1 − √(1 − n_x²) <= n_x. Hence g(n) <= gap wherever distance >= S(e) + max(0, −gap); and S(e) is at most
/// r₁ + r₂, the stone's `reach`.
template <Ordered T>
[[nodiscard]] bool needs_side(const T& distance, const T& reach, const T& gap) {
  return distance < reach || (gap < T(0) && distance < reach - gap);
}

/// How far inside the near and the far one of two sides something is.
template <class T>
struct SideDistances {
  T near, far;
};

template <Ordered T>
[[nodiscard]] SideDistances<T> side_distances(const T& half, const T& p) {
  const T size = scalar::abs(p);
  return {.near = half - size, .far = half + size};
}

/// The normal of the board that separates most, where a side is needed. `gap` is that of some normal, or below it. The
/// near sides are asked first: then the far ones are seldom needed.
template <Ordered T>
[[nodiscard]] OctantMaximum<T> octants_maximum(const Placed<T>& placed, const Board<T>& board, const T& reach, T gap) {
  const Vec3<T>& p_W = placed.p_W;
  const SideDistances<T> x = side_distances(board.half_width, T(p_W.x()));
  const SideDistances<T> y = side_distances(board.half_length, T(p_W.y()));
  const Needs needs{.side_x = needs_side(x.near, reach, gap), .side_y = needs_side(y.near, reach, gap)};
  OctantMaximum<T> best;
  const auto ask = [&](bool far_x, bool far_y) {
    const T sign_x = (p_W.x() < T(0)) == far_x ? T(1) : T(-1), sign_y = (p_W.y() < T(0)) == far_y ? T(1) : T(-1);
    const Vec3<T> p(T(sign_x * p_W.x() - board.half_width), T(sign_y * p_W.y() - board.half_length), p_W.z());
    const Vec3<T> u(T(sign_x * placed.u_W.x()), T(sign_y * placed.u_W.y()), placed.u_W.z());
    const OctantMaximum<T> found = Octant<T>(placed.stone, p, u).maximum(needs);
    best.certified = best.certified && found.certified;
    if (best.value < found.value) {
      best.value = found.value;
      best.n = {T(sign_x * found.n.x()), T(sign_y * found.n.y()), found.n.z()};
    }
  };
  ask(false, false);
  gap = best.value;
  const bool far_x = needs.side_x && needs_side(x.far, reach, gap),
             far_y = needs.side_y && needs_side(y.far, reach, gap);
  if (far_x) {
    ask(true, false);
  }
  if (far_y) {
    ask(false, true);
  }
  if (far_x && far_y) {
    ask(true, true);
  }
  return best;
}

/// Where a side is needed.
template <Ordered T>
[[nodiscard]] Separation<T> separation_with_sides(const Placed<T>& placed, const Board<T>& board, const T& reach,
                                                  const T& gap) {
  const OctantMaximum<T> best = octants_maximum(placed, board, reach, gap);
  const Vec3<T>& n = best.n;
  Separation<T> result = separation_along(placed, n, reach_of(board, n));
  result.other_feature = board_feature(n.x() < T(0) || T(0) < n.x(), n.y() < T(0) || T(0) < n.y(), T(0) < n.z());
  result.certified = best.certified;
  return result;
}

template <Ordered T>
[[nodiscard]] Separation<T> separation(const Placed<T>& placed, const Board<T>& board) {
  const T reach = outer_width(placed.stone) / T(2);
  const T x = side_distances(board.half_width, T(placed.p_W.x())).near;
  const T y = side_distances(board.half_length, T(placed.p_W.y())).near;
  const T nearest = x < y ? x : y, other = x < y ? y : x;
  const Vec3<T> up(T(0), T(0), T(1));
  // The surface's gap is at least this, which mostly settles what is needed.
  T gap = placed.p_W.z() - reach;
  if (!needs_side(nearest, reach, gap)) {
    return separation_above(placed, T(0));
  }
  if (!(nearest < reach) || (!(other < reach) && needs_side(other, reach, gap))) {
    const auto support_along = [&](const Vec3<T>& n) {
      return support_value(placed.stone, see<T>(placed.u_W, n).direction);
    };
    const T surface = placed.p_W.z() - support_along(up);
    const T side = -nearest - support_along(x < y ? Vec3<T>(T(1), T(0), T(0)) : Vec3<T>(T(0), T(1), T(0)));
    gap = surface < side ? side : surface;
    if (!needs_side(nearest, reach, gap)) {
      return separation_above(placed, T(0));
    }
  }
  const T size = board.half_width + board.half_length + placed.stone.sphere_radius + scalar::abs(T(placed.p_W.x())) +
                 scalar::abs(T(placed.p_W.y())) + scalar::abs(T(placed.p_W.z()));
  if (Squares<T>::hold(size)) [[likely]] {
    return separation_with_sides(placed, board, reach, gap);
  }
  // In a world of another size.
  const T factor = Squares<T>::factor(size);
  const Stone<T> stone = scaled(factor, placed.stone);
  Board<T> wood = board;
  wood.half_width = factor * board.half_width;
  wood.half_length = factor * board.half_length;
  return scaled_back(factor, Vec3<T>(Vec3<T>::Zero()),
                     separation_with_sides(Placed<T>{stone, Vec3<T>(factor * placed.p_W), placed.u_W}, wood,
                                           T(factor * reach), T(factor * gap)));
}

}  // namespace detail

/// What a board stands on.
template <Ordered T>
[[nodiscard]] Plane<T> floor_of(const Board<T>& board) {
  return {{T(0), T(0), T(1)}, board.floor};
}

/// Separation of a stone and the board.
///
/// Domain  a finite pose with a unit attitude, a board of `make_board`; else InvalidArgument. A stone inside the board is
///         ordinary: the shortest way out. So are lengths of any magnitude (claim DOMAIN-CONTACT-1).
/// Error   gap within 1e-13 of the width (claims CONTACT-2, CONTACT-3), and as a distance at the board's own: 4 ε of the
///         board and of where the stone is.
/// Cost    what is near decides: over the middle of the surface one support; near an edge one search over a quarter circle;
///         near a corner three and the corner. A stone that is deep asks all sides that may be the shortest way out.
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Board<T>& board) {
  detail::require_board(board);
  return detail::separation(detail::place(stone, pose), board);
}

}  // namespace goishi
