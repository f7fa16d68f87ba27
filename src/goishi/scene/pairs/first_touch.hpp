#pragma once
/// \file
/// When two stones that move come as near as `clearance`: advanced by times in which they provably cannot.

#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/scene/pairs/moving.hpp>

namespace goishi::detail {

/// What was found between two stones, from a time up to another.
template <class T>
struct FirstTouch {
  bool touches = false;  // at `time`
  T time = T(0);         // [s] else until then nothing touches
  int separations = 0;
};

/// How fast the first stone's contact point leaves the second's, along the normal   [m/s].
template <Ordered T>
[[nodiscard]] T leaving_speed(const Separation<T>& contact, const Sight<T>& first, const Sight<T>& second) {
  const auto at = [&](const Sight<T>& stone, const Vec3<T>& p) {
    return formula::plus(stone.v, formula::cross(stone.w, formula::minus(p, stone.placed.p_W)));
  };
  return formula::dot(contact.n_W, formula::minus(at(first, contact.p_stone), at(second, contact.p_other)));
}

/// The gap along a normal of two stones that fly, as a function of time from `origin` on.
template <Ordered T>
[[nodiscard]] GapAlong<T> gap_along(const Moving<T>& first, const Moving<T>& second, const Vec3<T>& n, const T& origin,
                                    const T& clearance) {
  const auto seen_from = [&](const Moving<T>& moving) {
    const T t = origin - moving.begin;
    FlightPath<T> path = moving.path;
    path.p_W = formula::centre_at(path, t);
    path.v_W = formula::plus(path.v_W, t, path.a_W);
    path.u_W = placed_at(*moving.stone, moving.path, t).u_W;
    return path;
  };
  const FlightPath<T> one = seen_from(first), two = seen_from(second);
  GapAlong<T> gap(T(formula::dot(n, formula::minus(one.p_W, two.p_W)) - clearance),
                  formula::dot(n, formula::minus(one.v_W, two.v_W)), formula::dot(n, formula::minus(one.a_W, two.a_W)));
  gap.add(formula::wobble(*first.stone, one, n));
  gap.add(formula::wobble(*second.stone, two, n));
  return gap;
}

/// From `start` up to `limit`, both in what is known of both. Stones touch that are no further apart than `clearance` and a
/// hundredth of it, and do not part; `now` is their separation at the start.
///
/// Flights: as `time_of_impact`, by roots of the gap along the normal of the moment. A stretch of contact: the gap along
/// that normal is at least H + H' s − M s²/2, M what both may bend; and no gap closes faster than both stones move.
/// Error  it is within a fiftieth of the clearance when it touches.
template <Ordered T>
[[nodiscard]] FirstTouch<T> first_touch(const Moving<T>& first, const Moving<T>& second, const T& start, const T& limit,
                                        const T& clearance, Separation<T> now) {
  constexpr int most = 200;
  const T near = clearance / T(100);
  const bool fly = first.touching == nullptr && second.touching == nullptr;
  const T bend = fly ? T(0) : T(bend_of(first) + bend_of(second));
  const T speed = first.speed + second.speed;
  T t = start;
  FirstTouch<T> result;
  for (int i = 0; i < most; ++i) {
    const Sight<T> one = sight(first, t), two = sight(second, t);
    if (0 < i) {
      now = separation(one.placed, two.placed);
      ++result.separations;
    }
    const T leaving = leaving_speed(now, one, two);
    const T height = now.gap - clearance;
    if (height <= near && leaving <= T(0)) {
      return {.touches = true, .time = t, .separations = result.separations};
    }
    const T open = height < T(0) ? T(0) : height;
    T step = T(0) < speed ? T(open / speed) : std::numeric_limits<T>::infinity();
    if (fly) {
      // Its root is where the gap is down to half of what counts as touching.
      const GapAlong<T> gap = gap_along(first, second, now.n_W, t, T(clearance + near / T(2)));
      const RootSearch<T> root = first_root(gap, T(0), T(limit - t), {T(near / T(4)), T(0)}, 1000);
      const bool none_till_then = root.status == ImpactStatus::none;
      step = none_till_then ? std::numeric_limits<T>::infinity() : step < root.time ? root.time : step;
    } else {
      const T bound =
          T(0) < bend || leaving < T(0) ? safe_step(open, leaving, bend) : std::numeric_limits<T>::infinity();
      step = step < bound ? bound : step;
    }
    if (!(t + step < limit)) {
      result.time = limit;
      return result;
    }
    if (!(t < t + step)) {
      return {.touches = true, .time = t, .separations = result.separations};
    }
    t = t + step;
  }
  result.time = t;
  return result;
}

}  // namespace goishi::detail
