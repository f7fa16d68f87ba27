#pragma once
/// \file
/// When a flying stone first touches: a plane, the board, another flying stone. Free flight is exact, so along one normal
/// the gap is an explicit function of time whose first root can be certified. Against anything that is not a plane, the
/// separating normal of the moment gives such a function, which is never above the true separation: its first root is a
/// time before which nothing can touch.

#include <goishi/contact/flight_path.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>
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

/// Advances by the first root along the separating normal of the moment, until the separation itself vanishes.
/// `separate(t)` is the separation then; `along(n, contact)` the gap along that normal as a function of time.
template <Ordered T, class Separate, class Along>
[[nodiscard]] TimeOfImpact<T> advance_to_contact(const T& horizon, const T& small, Separate&& separate, Along&& along) {
  constexpr int most_normals = 200;
  TimeOfImpact<T> result;
  T t(0);
  for (result.separations = 1; result.separations <= most_normals; ++result.separations) {
    result.contact = separate(t);
    result.time = t;
    if (result.contact.status == SeparationStatus::not_converged) {
      return result;
    }
    if (result.contact.gap < -small && result.separations == 1) {
      result.status = ImpactStatus::overlapping;
      return result;
    }
    const GapAlong<T> gap = along(result.contact);
    if (result.contact.gap <= small && gap(t).rate < T(0)) {
      result.status = ImpactStatus::hit;
      return result;
    }
    const RootSearch<T> root = first_root(gap, t, horizon);
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

template <Ordered T>
[[nodiscard]] GapAlong<T> gap_along(const Stone<T>& stone, const FlightPath<T>& path, const Vec3<T>& n,
                                    const T& offset) {
  GapAlong<T> gap(T(n.dot(path.p_W) - offset), n.dot(path.v_W), n.dot(path.a_W));
  gap.add(wobble(stone, path, n));
  return gap;
}

}  // namespace detail

/// When a flying stone first touches a plane: the first root, certified.
///
/// Domain  a finite path with unit axes, horizon > 0 (infinite is allowed); else InvalidArgument.
/// Error   time and gap as close as the gap's own round-off allows (claim TOI-1).
/// Cost    nothing while the centre is too high; then at most some 30 steps for falls up to 100 rad/s.
/// Proof   derivations/support.cpp: H'' >= −M.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Plane<T>& plane,
                                             const T& horizon) {
  detail::require_path(path);
  detail::require_direction(plane.n_W);
  require(scalar::is_finite(plane.offset), "offset", plane.offset, "must be finite");
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  const T small = T(8) * std::numeric_limits<T>::epsilon() * outer_width(stone);
  const detail::GapAlong<T> gap = detail::gap_along(stone, path, plane.n_W, plane.offset);
  TimeOfImpact<T> result;
  const auto contact_at = [&](const T& t) {
    return detail::separation_along(detail::placed_at(stone, path, t), plane.n_W, plane.offset);
  };
  if (gap(T(0)).gap < -small) {
    result.status = ImpactStatus::overlapping;
    result.time = T(0);
    result.contact = contact_at(T(0));
    return result;
  }
  const detail::RootSearch<T> root = detail::first_root(gap, T(0), horizon);
  result.status = root.status;
  result.time = root.time;
  result.steps = root.steps;
  if (root.status == ImpactStatus::hit) {
    result.separations = 1;
    result.contact = contact_at(root.time);
  }
  return result;
}

/// When a flying stone first touches the board, whichever part of it.
/// Domain  as above; a board of `make_board`.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Board<T>& board,
                                             const T& horizon) {
  detail::require_path(path);
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  const T small = T(64) * std::numeric_limits<T>::epsilon() * outer_width(stone);
  return detail::advance_to_contact(
      horizon, small, [&](const T& t) { return detail::separation(detail::placed_at(stone, path, t), board); },
      [&](const Separation<T>& contact) {
        return detail::gap_along(stone, path, contact.n_W, detail::reach_of(board, contact.n_W));
      });
}

/// When two flying stones first touch.
/// Domain  as above.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> time_of_impact(const Stone<T>& stone, const FlightPath<T>& path, const Stone<T>& other,
                                             const FlightPath<T>& other_path, const T& horizon) {
  detail::require_path(path);
  detail::require_path(other_path);
  require(T(0) < horizon, "horizon", horizon, "must be positive");
  const T small = T(256) * std::numeric_limits<T>::epsilon() * (outer_width(stone) + outer_width(other));
  return detail::advance_to_contact(
      horizon, small,
      [&](const T& t) {
        return detail::separation(detail::placed_at(stone, path, t), detail::placed_at(other, other_path, t));
      },
      [&](const Separation<T>& contact) {
        const Vec3<T>& n = contact.n_W;
        detail::GapAlong<T> gap(n.dot(Vec3<T>(path.p_W - other_path.p_W)), n.dot(Vec3<T>(path.v_W - other_path.v_W)),
                                n.dot(Vec3<T>(path.a_W - other_path.a_W)));
        gap.add(detail::wobble(stone, path, n));
        gap.add(detail::wobble(other, other_path, n));
        return gap;
      });
}

}  // namespace goishi
