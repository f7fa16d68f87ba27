#pragma once
/// \file
/// Stone against a plane: one support.

#include <goishi/contact/contact.hpp>

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

}  // namespace formula

/// Separation of a stone and a plane.
///
/// Domain  a finite pose with a unit attitude, a unit normal, a finite offset, a gap that T can hold; else InvalidArgument.
/// Error   gap within 1e-15 of the greater of width and distance (claim CONTACT-1).
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane) {
  detail::require_direction(plane.n_W);
  Separation<T> result = detail::separation_along(detail::place(stone, pose), plane.n_W, plane.offset);
  require(scalar::is_finite(result.gap), "offset", plane.offset, "must be finite, and so must the gap");
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
  const detail::Direction<T> n = detail::direction(formula::symmetry_axis(pose.q_WB));
  return detail::meets_cap(stone, n) ? formula::cap_gap(stone, pose.p_WB.z(), n.axial, n.radial_square)
                                     : formula::rim_gap(stone, pose.p_WB.z(), n.radial);
}

}  // namespace goishi
