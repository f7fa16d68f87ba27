#pragma once
/// \file
/// What free flight keeps: energy, linear and angular momentum; and the same state seen from another inertial frame.

#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// Standard gravity, g = 9.80665 m/s² exactly. (The talk's 9.8 · 10 with lengths in centimetres is a tenth of it.)
template <Field T>
[[nodiscard]] constexpr T standard_gravity() {
  return T(980665) / T(100000);
}

/// The acceleration of gravity in W: (0, 0, −g)   [m/s²].
template <Field T>
[[nodiscard]] Vec3<T> gravity_W(const T& g = standard_gravity<T>()) {
  return {T(0), T(0), T(-g)};
}

// Formulas, without checks: right to round-off for attitudes of length 1, and as much more as |q|² is off, where v², g · p,
// L/I and what is asked for are numbers that T can hold (DOMAIN-15).

namespace formula {

/// Energy of rotation   [J]: ½ L_B · I⁻¹ L_B.
template <Field T>
[[nodiscard]] T rotational_energy(const State<T>& state, const RigidBody<T>& body) {
  const Vec3<T> L_B = formula::in_body(state.q_WB, state.L_W);
  return formula::dot(L_B, Vec3<T>(L_B.cwiseQuotient(body.moments))) / T(2);
}

/// Energy of translation   [J]: ½ m v².
template <Field T>
[[nodiscard]] T translational_energy(const State<T>& state, const RigidBody<T>& body) {
  return body.mass * formula::dot(state.v_WB, state.v_WB) / T(2);
}

/// Energy of position in uniform gravity   [J], zero at the origin of W: −m g · p.
template <Field T>
[[nodiscard]] T potential_energy(const State<T>& state, const RigidBody<T>& body, const Vec3<T>& gravity) {
  return -(body.mass * formula::dot(gravity, state.p_WB));
}

/// The energy that free flight keeps   [J].   Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] T energy(const State<T>& state, const RigidBody<T>& body, const Vec3<T>& gravity) {
  return formula::rotational_energy(state, body) + formula::translational_energy(state, body) +
         formula::potential_energy(state, body, gravity);
}

/// m v   [kg m/s].
template <Field T>
[[nodiscard]] Vec3<T> linear_momentum(const State<T>& state, const RigidBody<T>& body) {
  return body.mass * state.v_WB;
}

/// Angular momentum about a point P of W   [kg m²/s]: L_W + (p_WB − p_WP) × m v.
template <Field T>
[[nodiscard]] Vec3<T> angular_momentum_about(const Vec3<T>& p_WP, const State<T>& state, const RigidBody<T>& body) {
  const Vec3<T> arm = state.p_WB - p_WP;
  return state.L_W + arm.cross(formula::linear_momentum(state, body));
}

/// The state of B seen from the inertial frame V, which has the pose (p_WV, q_WV) now and moves with v_WV, not turning.
/// Every invariant of the result is the invariant in V.   Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] State<T> seen_from(const Vec3<T>& p_WV, const Quat<T>& q_WV, const Vec3<T>& v_WV, const State<T>& state) {
  const Quat<T> q_VW = formula::reunited(q_WV).conjugate();  // so that what it is off is not added to what q_WB is
  return {.p_WB = q_VW * Vec3<T>(state.p_WB - p_WV),
          .q_WB = formula::product(q_VW, state.q_WB),
          .v_WB = q_VW * Vec3<T>(state.v_WB - v_WV),
          .L_W = q_VW * state.L_W};
}

}  // namespace formula

}  // namespace goishi
