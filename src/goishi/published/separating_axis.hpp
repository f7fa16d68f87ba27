#pragma once
/// \file
/// The talk's test of a stone against the board, as published: for comparison only. Use `separation`.

#include <array>
#include <cstddef>
#include <goishi/board/board.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/vector.hpp>
#include <vector>

namespace goishi {

/// "Which axis to push out along?"
enum class PushOut {
  least_penetration,
  most_penetration,
  preferred  // the axis most in line with a direction that the caller prefers
};

/// What the published test answers.
template <class T>
struct PublishedSeparation {
  bool colliding = false;                                  // no axis separates
  Vec3<T> axis_W = Vec3<T>::Constant(scalar::unset<T>());  // to push out along; else the first that separates
  T depth = scalar::unset<T>();                            // along it [m]; not colliding: < 0
  Region region = Region::out_of_reach;                    // where the stone is; out of reach: no axis, no depth
};

namespace detail {

/// The fixed axes of a region, in the published order, and how many they are.
template <class T>
struct PublishedAxes {
  std::array<Vec3<T>, 7> axes;
  std::size_t count = 0;

  void add(const Vec3<T>& axis) { axes[count++] = detail::unit(axis); }
};

template <Ordered T>
[[nodiscard]] PublishedAxes<T> published_axes(Region region) {
  const bool left = region == Region::left || region == Region::bottom_left || region == Region::top_left;
  const bool right = region == Region::right || region == Region::bottom_right || region == Region::top_right;
  const bool bottom = region == Region::bottom || region == Region::bottom_left || region == Region::bottom_right;
  const bool top = region == Region::top || region == Region::top_left || region == Region::top_right;
  const Vec3<T> up(T(0), T(0), T(1));
  const Vec3<T> x(T(left ? -1 : 1), T(0), T(0)), y(T(0), T(bottom ? -1 : 1), T(0));
  PublishedAxes<T> result;
  result.add(up);
  if (left || right) {
    result.add(x);
    result.add(x + up);
  }
  if (bottom || top) {
    result.add(y);
    result.add(y + up);
  }
  if ((left || right) && (bottom || top)) {
    result.add(x + y);
    result.add(x + y + up);
  }
  return result;
}

/// How deep a stone is in the board along an axis   [m]; < 0: the axis separates them.
template <Ordered T>
[[nodiscard]] T published_depth(const Stone<T>& stone, const Placed<T>& placed, const Board<T>& board,
                                const Vec3<T>& axis) {
  const Vec3<T> size = axis.cwiseAbs();
  const T reach = size.x() * board.half_width + size.y() * board.half_length;
  const T support = support_value(stone, see<T>(placed.u_W, axis).direction);
  return reach - (formula::dot(axis, placed.p_W) - support);
}

template <Ordered T>
[[nodiscard]] Region published_region(const Stone<T>& stone, const Pose<T>& pose, const Board<T>& board) {
  return region_of(board, pose.p_WB, T(outer_width(stone) / T(2)));
}

}  // namespace detail

/// The separating-axis test of the talk. A stone and the board collide if none of the region's fixed axes separates
/// them: up; a side's, and its edge's at 45°; at a corner both sides', three edges' and the corner's, (±1, ±1, 1)/√3.
/// The stone is then pushed out along one of them.
///
/// It is wrong in two ways, which `separation` is not. A stone that meets an edge or a corner along another normal is
/// called colliding while it is still apart, by up to r (sec 22.5° − 1) at an edge. And a stone that does collide is
/// pushed out along an axis that is not the contact normal, by more than its depth. Only the axes are the talk's; the
/// support, which was wrong too, is ours.
///
/// Domain  a finite pose with a unit attitude; a unit `preferred` direction where it is used; a board of `make_board`;
///         else InvalidArgument.
template <Ordered T>
[[nodiscard]] PublishedSeparation<T> separating_axis_published(const Stone<T>& stone, const Pose<T>& pose,
                                                               const Board<T>& board,
                                                               PushOut push_out = PushOut::least_penetration,
                                                               const Vec3<T>& preferred = {T(0), T(0), T(1)}) {
  const detail::Placed<T> placed = detail::place(stone, pose);
  if (push_out == PushOut::preferred) {
    detail::require_direction(preferred, "preferred");
  }
  PublishedSeparation<T> result;
  result.region = detail::published_region(stone, pose, board);
  if (result.region == Region::out_of_reach) {
    return result;
  }
  const detail::PublishedAxes<T> tested = detail::published_axes<T>(result.region);
  T best(0);
  for (std::size_t i = 0; i < tested.count; ++i) {
    const Vec3<T>& axis = tested.axes[i];
    const T depth = detail::published_depth(stone, placed, board, axis);
    if (depth < T(0)) {
      result.colliding = false;
      result.axis_W = axis;
      result.depth = depth;
      return result;
    }
    // Of equals the last in the preferred direction, else the first: as published.
    const T merit = push_out == PushOut::preferred          ? formula::dot(axis, preferred)
                    : push_out == PushOut::most_penetration ? depth
                                                            : T(-depth);
    if (!result.colliding || best < merit || (push_out == PushOut::preferred && !(merit < best))) {
      best = merit;
      result.axis_W = axis;
      result.depth = depth;
    }
    result.colliding = true;
  }
  return result;
}

/// An axis of the published test.
template <class T>
struct PublishedAxis {
  Vec3<T> axis_W = Vec3<T>::Constant(scalar::unset<T>());  // unit, out of the board
  T depth = scalar::unset<T>();                            // of the stone along it [m]; < 0: it separates
};

/// All axes that the published test has where the stone is, in its order; out of reach none.
/// Domain  as above.
template <Ordered T>
[[nodiscard]] std::vector<PublishedAxis<T>> published_axes(const Stone<T>& stone, const Pose<T>& pose,
                                                           const Board<T>& board) {
  const detail::Placed<T> placed = detail::place(stone, pose);
  const Region region = detail::published_region(stone, pose, board);
  std::vector<PublishedAxis<T>> result;
  if (region == Region::out_of_reach) {
    return result;
  }
  const detail::PublishedAxes<T> tested = detail::published_axes<T>(region);
  for (std::size_t i = 0; i < tested.count; ++i) {
    const Vec3<T>& axis = tested.axes[i];
    result.push_back({axis, detail::published_depth(stone, placed, board, axis)});
  }
  return result;
}

}  // namespace goishi
