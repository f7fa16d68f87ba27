#pragma once
/// \file
/// Where a flight ends: the plane, the board or the floor, asked only what the flight can reach.

#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/state/run.hpp>
#include <limits>

namespace goishi {

namespace detail {

/// Whether the centre is over the primary region from now to t.
template <Ordered T>
[[nodiscard]] bool stays_inside(const Run<T>& run, const FlightPath<T>& path, const T& t) {
  const auto inside = [&](std::size_t axis, const T& half, const T& when) {
    const auto i = static_cast<Eigen::Index>(axis);
    const T x = path.p_W[i] + when * (path.v_W[i] + when / T(2) * path.a_W[i]);
    return scalar::abs(x) <= half - run.reach;
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const T& half = axis == 0 ? run.board->half_width : run.board->half_length;
    const auto i = static_cast<Eigen::Index>(axis);
    const T turn = path.v_W[i] * path.a_W[i] < T(0) ? T(-path.v_W[i] / path.a_W[i]) : T(0);
    if (!inside(axis, half, T(0)) || !inside(axis, half, t) || (turn < t && !inside(axis, half, turn))) {
      return false;
    }
  }
  return true;
}

/// When the gap of a stone that has just left a plane is surely open, or if it does not open by itself, until when it is
/// still closed to round-off   [s].
template <Ordered T>
[[nodiscard]] T opening_time(const Run<T>& run) {
  const FlightPath<T> path = path_of(run.state, run.mobility, run.settings.gravity);
  const GapAlong<T> gap = gap_along(run.stone, path, Vec3<T>(T(0), T(0), T(1)), run.level);
  const T sure = T(512) * std::numeric_limits<T>::epsilon() * (outer_width(run.stone) + scalar::abs(run.level));
  const T unit = T(1) / run.scales.frequency;
  T closed(0);
  for (T t = T(2e-7) * unit; t < T(0.25) * unit; t = T(2) * t) {
    const typename GapAlong<T>::Value then = gap(t);
    if (sure < then.gap && T(0) < then.rate) {
      return t;
    }
    if (then.gap < -sure) {
      break;
    }
    closed = t;
  }
  return closed;
}

/// The first touch within `left`.
template <Ordered T>
[[nodiscard]] TimeOfImpact<T> next_impact(const Run<T>& run, const T& left) {
  const FlightPath<T> path = path_of(run.state, run.mobility, run.settings.gravity);
  if (!run.board) {
    return time_of_impact(run.stone, path, Plane<T>{}, left);
  }
  // Over the middle of the surface the flight has one axis to ask.
  if (T(0) < run.state.p_WB.z() && stays_inside(run, path, T(0))) {
    TimeOfImpact<T> hit = time_of_impact(run.stone, path, Plane<T>{}, left);
    if (hit.status == ImpactStatus::hit && stays_inside(run, path, hit.time)) {
      return hit;
    }
  }
  TimeOfImpact<T> hit = time_of_impact(run.stone, path, *run.board, left);
  // The floor matters only before.
  const T until = hit.status == ImpactStatus::none ? left : hit.time;
  if (hit.status != ImpactStatus::overlapping && T(0) < until) {
    const TimeOfImpact<T> on_floor = time_of_impact(run.stone, path, floor_of(*run.board), until);
    const int steps = hit.steps + on_floor.steps, separations = hit.separations + on_floor.separations;
    if (on_floor.status != ImpactStatus::none && (hit.status == ImpactStatus::none || on_floor.time < hit.time)) {
      hit = on_floor;
    }
    hit.steps = steps;
    hit.separations = separations;
  }
  return hit;
}

}  // namespace detail
}  // namespace goishi
