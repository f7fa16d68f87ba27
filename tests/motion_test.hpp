#pragma once
/// \file
/// What the tests of motion share.

#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <limits>
#include <numbers>

namespace goishi::motion_test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A stone of size 33, rounded; its bodies are flat: I_t < I_a.
inline const Moments<double> stone_moments{.axial = 2.125e-7, .transverse = 1.25e-7};
inline const Vec3<double> weightless = Vec3<double>::Zero();

template <class T>
[[nodiscard]] Vec3<T> vec_zero() {
  return Vec3<T>(T(0), T(0), T(0));
}

/// A body at rest at the origin but for its rotation.
template <class T>
[[nodiscard]] State<T> turning(const Quat<T>& q_WB, const Vec3<T>& L_W) {
  return {.p_WB = Vec3<T>(T(0), T(0), T(0)), .q_WB = q_WB, .v_WB = Vec3<T>(T(0), T(0), T(0)), .L_W = L_W};
}

/// A state without zeros.
[[nodiscard]] inline State<double> moving() {
  return {
      .p_WB = {0.1, -0.2, 0.3}, .q_WB = {0.1, -0.7, 0.5, 0.5}, .v_WB = {1.0, 2.0, -3.0}, .L_W = {2e-6, -3e-6, 5e-6}};
}

/// The angle between two attitudes   [rad].
template <class T>
[[nodiscard]] T angle_between(const Quat<T>& p, const Quat<T>& q) {
  using std::asin;
  const Quat<T> difference = p.conjugate() * q;
  return T(2) * asin(difference.vec().norm() / difference.norm());
}

/// The documented error of the attitude after a free flight (FLIGHT-1)   [rad].
template <class T>
[[nodiscard]] T flight_bound(const State<T>& start, const Moments<T>& moments, const T& t) {
  using std::abs;
  const T axial_momentum = (start.q_WB.conjugate() * start.L_W).z();
  const Mobility<T> mobility = make_mobility(moments);
  const T turn = start.L_W.norm() * abs(t) * mobility.transverse + abs(T(axial_momentum * t * mobility.axial));
  return T(8) * std::numeric_limits<T>::epsilon() * (T(1) + turn);
}

/// The same double, bit by bit but for the sign of 0.
[[nodiscard]] inline bool same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

}  // namespace goishi::motion_test
