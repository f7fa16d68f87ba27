#pragma once
/// \file
/// Stone against a plane: one support.

#include <goishi/contact/contact.hpp>
#include <type_traits>

namespace goishi {

/// The half space n · x <= offset.
template <class T>
struct Plane {
  Vec3<T> n_W = {T(0), T(0), T(1)};  // unit, out of the solid
  T offset = T(0);                   // [m]
};

namespace formula {

/// Gap between a stone, its axis u making μ = |u · n| with the plane's normal, and the plane that its centre is `height`
/// over   [m], where it meets the plane with a cap or with its rim.   Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] T cap_gap(const Stone<T>& stone, const T& height, const T& axial, const T& radial_square) {
  return height - formula::cap_support(stone, axial, radial_square);
}

template <Field T>
[[nodiscard]] T rim_gap(const Stone<T>& stone, const T& height, const T& radial) {
  return height - formula::rim_support(stone, radial);
}

/// Where a stone that its axis u tilts meets a surface z = const below it, from its centre   [m]: S the support, −S' its
/// slope by u_z (`rim_slope`, ±d on a cap).
///
///     r = (−S' u_x, −S' u_y, −S)
///
/// Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> level_contact(const Vec3<T>& u, const T& support, const T& slope) {
  return {T(slope * u.x()), T(slope * u.y()), T(-support)};
}

}  // namespace formula

namespace detail {

/// The gap of a stone that sees the plane's normal in a direction.
template <Ordered T>
[[nodiscard]] inline T gap_of(const Stone<T>& stone, const T& height, const Direction<T>& n) {
  return meets_cap(stone, n) ? formula::cap_gap(stone, height, n.axial, n.radial_square)
                             : formula::rim_gap(stone, height, n.radial);
}

/// The separation from a surface z = `level`: that along Wz, of which a stone sees what the surface sees of its axis.
template <Ordered T>
[[nodiscard, gnu::always_inline]] inline Separation<T> separation_above(const Placed<T>& placed, const T& level) {
  const Stone<T>& stone = placed.stone;
  const Direction<T> n = direction(placed.u_W);
  const bool cap = meets_cap(stone, n), upwards = !(placed.u_W.z() < T(0));
  const T support = cap ? formula::cap_support(stone, n.axial, n.radial_square) : formula::rim_support(stone, n.radial);
  const T slope = cap ? scalar::signed_as(stone.sphere_offset, T(placed.u_W.z()))
                      : formula::rim_slope(stone, T(placed.u_W.z()), n.radial);
  const Vec3<T> r = formula::level_contact(placed.u_W, support, slope);
  const T gap = placed.p_W.z() - level - support;
  const T x = placed.p_W.x() + r.x(), y = placed.p_W.y() + r.y();
  return {.status = gap < T(0) ? SeparationStatus::overlapping : SeparationStatus::separated,
          .gap = gap,
          .n_W = {T(0), T(0), T(1)},
          .p_stone = {x, y, T(placed.p_W.z() + r.z())},
          .p_other = {x, y, level},
          .feature = feature_below(cap, upwards)};
}

/// Whether a stone that was made has a pose, all but its height over the plane: that shows in the gap. Asked first, while
/// the attitude is in registers.
template <Ordered T>
[[nodiscard]] inline bool is_placed(const Stone<T>& stone, const Pose<T>& pose) {
  return all(is_unit(pose.q_WB), T(0) < stone.height, scalar::is_finite(T(pose.p_WB.x() + pose.p_WB.y())));
}

/// Says what is wrong where that or the plane is not.
template <Ordered T>
[[noreturn, gnu::noinline, gnu::cold]] void refuse(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane) {
  require_direction(plane.n_W);
  static_cast<void>(place(stone, pose));
  throw_invalid("offset", plane.offset, "must be finite, and so must the gap");
}

}  // namespace detail

/// Separation of a stone and a plane.
///
/// Domain  a finite pose with a unit attitude, a unit normal, a finite offset, a gap that T can hold; else InvalidArgument.
/// Error   gap within 1e-15 of the greater of width and distance (claim CONTACT-1).
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane) {
  const bool sound = detail::all(detail::is_placed(stone, pose), detail::is_unit(plane.n_W));
  const Vec3<T> u_W = formula::unit_axis(pose.q_WB);
  Separation<T> result = detail::separation_along<T>({stone, pose.p_WB, u_W}, plane.n_W, plane.offset);
  if (!detail::all(sound, scalar::is_finite(result.gap))) [[unlikely]] {
    detail::refuse(stone, pose, plane);
  }
  return result;
}

/// Separation of a stone and the surface z = `level`: what a scene on a board asks most, in half the time.
///
/// Domain, error  as above.
template <Ordered T>
[[nodiscard]] Separation<T> surface_separation(const Stone<T>& stone, const Pose<T>& pose,
                                               const std::type_identity_t<T>& level = std::type_identity_t<T>(0)) {
  const bool sound = detail::is_placed(stone, pose);
  const Vec3<T> u_W = formula::unit_axis(pose.q_WB);
  Separation<T> result = detail::separation_above<T>({stone, pose.p_WB, u_W}, level);
  if (!detail::all(sound, scalar::is_finite(result.gap))) [[unlikely]] {
    detail::refuse(stone, pose, Plane<T>{.offset = level});
  }
  return result;
}

/// Only the gap to the playing surface z = 0: what a scene with many stones asks first.
/// Domain  a finite pose with a unit attitude, a stone of `make_stone`; else InvalidArgument.
/// Error   as above, and |q|² − 1 of the width: the attitude is taken as it is.
template <Ordered T>
[[nodiscard]] T surface_gap(const Stone<T>& stone, const Pose<T>& pose) {
  detail::require_stone(stone);
  detail::require_point(pose.p_WB, "position");
  require_unit(pose.q_WB);
  // What a stone sees of the plane's normal is what the plane sees of its axis.
  return detail::gap_of(stone, T(pose.p_WB.z()), detail::direction(formula::symmetry_axis(pose.q_WB)));
}

/// Only the gap to any plane.
/// Domain, error  as of `separation`.
template <Ordered T>
[[nodiscard]] T surface_gap(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane) {
  const bool sound = detail::all(detail::is_placed(stone, pose), detail::is_unit(plane.n_W));
  const detail::Direction<T> n = detail::see<T>(formula::unit_axis(pose.q_WB), plane.n_W).direction;
  const T gap = detail::gap_of(stone, T(formula::dot(plane.n_W, pose.p_WB) - plane.offset), n);
  if (!detail::all(sound, scalar::is_finite(gap))) [[unlikely]] {
    detail::refuse(stone, pose, plane);
  }
  return gap;
}

}  // namespace goishi
