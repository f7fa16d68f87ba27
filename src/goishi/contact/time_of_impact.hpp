#pragma once
/// \file
/// When a flying stone first touches: a plane, the board, another flying stone. Free flight is exact, so along one normal
/// the gap is an explicit function of time whose first root can be certified. Against anything that is not a plane, the
/// separating normal of the moment gives such a function, which is never above the true separation: its first root is a
/// time before which nothing can touch.

#include <goishi/contact/gap_along.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/vector.hpp>
#include <limits>

namespace goishi {

template <class T>
struct TimeOfImpact {
  ImpactStatus status = ImpactStatus::not_converged;
  T time = scalar::unset<T>();  // [s] of the hit; else up to when it is proved that nothing touches
  Separation<T> contact;        // then
  int steps = 0;                // of the root finder
  int separations = 0;          // normals that were needed
};

namespace detail {

/// The work of one query is bounded by both: some 5 ms.
inline constexpr int most_root_steps = 100000, most_normals = 2000;

/// Advances by the first root along the separating normal of the moment, until the separation itself vanishes.
/// `separate(t)` is the separation then; `along(contact)` the gap along its normal as a function of time.
template <Ordered T, class Separate, class Along>
[[nodiscard]] TimeOfImpact<T> advance_to_contact(const T& horizon, const RoundOff<T>& nothing, Separate&& separate,
                                                 Along&& along) {
  TimeOfImpact<T> result;
  T t(0);
  for (result.separations = 1; result.separations <= most_normals; ++result.separations) {
    result.contact = separate(t);
    result.time = t;
    if (result.contact.status == SeparationStatus::not_converged) {
      return result;
    }
    if (result.contact.gap < -nothing.gap && result.separations == 1) {
      result.status = ImpactStatus::overlapping;
      return result;
    }
    const GapAlong<T> gap = along(result.contact);
    if (result.contact.gap <= nothing.gap && gap(t).rate <= nothing.rate) {
      result.status = ImpactStatus::hit;
      return result;
    }
    const RootSearch<T> root = first_root(gap, t, horizon, nothing, most_root_steps - result.steps);
    result.steps += root.steps;
    if (root.status != ImpactStatus::hit) {
      result.status = root.status;
      result.time = root.time;
      return result;
    }
    if (!(t < root.time)) {
      result.status = ImpactStatus::hit;
      return result;
    }
    t = root.time;
  }
  return result;
}

/// The round-off of a gap at the start of a flight, and of its rate: `some` ε of the stone's width and of the speeds, 8 ε
/// of where it is.
template <Ordered T>
[[nodiscard]] RoundOff<T> round_off_of(const Stone<T>& stone, const FlightPath<T>& path, int some) {
  const T epsilon = std::numeric_limits<T>::epsilon(), width = outer_width(stone);
  return {.gap = epsilon * (T(some) * width + T(8) * size_of(path.p_W)),
          .rate = epsilon * T(some) * (size_of(path.v_W) + scalar::abs(path.rate) * width)};
}

template <Ordered T>
[[nodiscard]] GapAlong<T> gap_along(const Stone<T>& stone, const FlightPath<T>& path, const Vec3<T>& n,
                                    const T& offset) {
  GapAlong<T> gap(T(formula::dot(n, path.p_W) - offset), formula::dot(n, path.v_W), formula::dot(n, path.a_W));
  gap.add(formula::wobble(stone, path, n));
  return gap;
}

}  // namespace detail

/// When a flying stone first touches a plane: the first root, certified.
///
/// What counts, here and below: bodies *touch* while their gap is within its round-off of zero, 8 ε of where they are at the
/// start and k ε of the width, k = 8 (64 at the board, 256 of two stones). They are *hit* at the first time at which they
/// touch and the gap does not open: its rate is not positive, to k ε of the speeds. So a stone that lies, slides or rolls on
/// what it touches, or starts into it, hits at 0; one that starts by leaving hits when it comes back; one that grazes hits.
///
/// Domain  a finite path with unit axes, its numbers, the stone's r and r Ω² below √max/16; horizon > 0 (infinite is
///         allowed), a finite gap; else InvalidArgument.
/// Error   time and gap as close as the gap's own round-off allows (claim TOI-1).
/// Cost    nothing while the centre is too high; then at most some 30 steps for falls up to 100 rad/s. 100 000 steps at
///         most, then `not_converged`.
/// Proof   derivations/support.cpp: H'' >= −M.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Plane<T>& plane,
                                             const T& horizon) {
  detail::require_path(stone, path);
  detail::require_direction(plane.n_W);
  require(scalar::abs(plane.offset) < detail::Squares<T>::most, "offset", plane.offset,
          "must be finite, and so must the square of 16 times it");
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  detail::RoundOff<T> nothing = detail::round_off_of(stone, path, 8);
  nothing.gap = nothing.gap + T(8) * std::numeric_limits<T>::epsilon() * scalar::abs(plane.offset);
  const detail::GapAlong<T> gap = detail::gap_along(stone, path, plane.n_W, plane.offset);
  const detail::RootSearch<T> root = detail::first_root(gap, T(0), horizon, nothing, detail::most_root_steps, true);
  if (root.status != ImpactStatus::hit && root.status != ImpactStatus::overlapping) [[unlikely]] {
    return {.status = root.status, .time = root.time, .contact = {}, .steps = root.steps};
  }
  TimeOfImpact<T> result{
      .status = root.status,
      .time = root.time,
      .contact = detail::separation_along(detail::placed_at(stone, path, root), plane.n_W, plane.offset),
      .steps = root.steps,
      .separations = 1};
  if (!scalar::is_finite(result.contact.gap)) [[unlikely]] {
    result.status = ImpactStatus::not_converged;  // so late that T cannot tell where the stone is
  }
  return result;
}

/// When a flying stone first touches the board, whichever part of it.
/// Domain  as above; a board of `make_board`.   Cost  2000 normals and 100 000 steps at most, then `not_converged`.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Board<T>& board,
                                             const T& horizon) {
  detail::require_path(stone, path);
  detail::require_board(board);
  require(board.half_width < detail::Squares<T>::most && board.half_length < detail::Squares<T>::most, "board",
          board.half_width, "must have sides whose squares are finite (its half width is shown)");
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  detail::RoundOff<T> nothing = detail::round_off_of(stone, path, 64);
  nothing.gap = nothing.gap + T(8) * std::numeric_limits<T>::epsilon() * (board.half_width + board.half_length);
  return detail::advance_to_contact(
      horizon, nothing, [&](const T& t) { return detail::separation(detail::placed_at(stone, path, t), board); },
      [&](const Separation<T>& contact) {
        return detail::gap_along(stone, path, contact.n_W, detail::reach_of(board, contact.n_W));
      });
}

/// When two flying stones first touch.
/// Domain, cost  as above.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Stone<T>& other,
                                             const FlightPath<T>& other_path, const T& horizon) {
  detail::require_path(stone, path);
  detail::require_path(other, other_path);
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  const detail::RoundOff<T> one = detail::round_off_of(stone, path, 256),
                            two = detail::round_off_of(other, other_path, 256);
  return detail::advance_to_contact(
      horizon, detail::RoundOff<T>{T(one.gap + two.gap), T(one.rate + two.rate)},
      [&](const T& t) {
        return detail::separation(detail::placed_at(stone, path, t), detail::placed_at(other, other_path, t));
      },
      [&](const Separation<T>& contact) {
        const Vec3<T>& n = contact.n_W;
        detail::GapAlong<T> gap(formula::dot(n, formula::minus(path.p_W, other_path.p_W)),
                                formula::dot(n, formula::minus(path.v_W, other_path.v_W)),
                                formula::dot(n, formula::minus(path.a_W, other_path.a_W)));
        gap.add(formula::wobble(stone, path, n));
        gap.add(formula::wobble(other, other_path, n));
        return gap;
      });
}

/// The same of a stone in the state in which it is, with its moments or mobility as `free_flight` takes them; `other` is a
/// plane or the board.
/// Domain  that of `free_flight`, and as above.
template <Ordered T, class Turning, class Other>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const State<T>& state, const Turning& turning,
                                             const Vec3<T>& gravity, const Other& other, const T& horizon) {
  return time_of_impact(stone, path_of(state, turning, gravity), other, horizon);
}

/// And of two stones.
template <Ordered T, class Turning>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const State<T>& state, const Turning& turning,
                                             const Stone<T>& other, const State<T>& other_state,
                                             const Turning& other_turning, const Vec3<T>& gravity, const T& horizon) {
  return time_of_impact(stone, path_of(state, turning, gravity), other, path_of(other_state, other_turning, gravity),
                        horizon);
}

}  // namespace goishi
