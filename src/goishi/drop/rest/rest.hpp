#pragma once
/// \file
/// When a stone in contact comes to rest, and when one that slips stops turning: forces hold it, and what is left of the
/// motion does not take it anywhere.

#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/rest/statics.hpp>

namespace goishi {

namespace formula {

/// The torque's greatest power against an angular velocity, per normal force and unit of |ω|   [m]: √(δ²ω_h² +
/// κ²ω_z²)/|ω|, with `roll_square` = ω_h² and `pivot_square` = ω_z².
/// Domain  ω ≠ 0.   Proof  derivations/contact_phase.cpp.
template <Elementary T>
[[nodiscard]] T resistance_lever(const T& delta, const T& kappa, const T& roll_square, const T& pivot_square) {
  return scalar::sqrt(
      T((scalar::sq(delta) * roll_square + scalar::sq(kappa) * pivot_square) / (roll_square + pivot_square)));
}

}  // namespace formula

namespace detail {

/// `formula::resistance_lever`, and 0 where nothing turns.
template <Ordered T>
[[nodiscard]] T resistance_lever(const ContactBody<T>& body, const Vec3<T>& w) {
  const T roll_square = scalar::sq(w.x()) + scalar::sq(w.y()), pivot_square = scalar::sq(w.z());
  return T(0) < roll_square + pivot_square
             ? formula::resistance_lever(body.rolling_resistance, body.pivot_radius, roll_square, pivot_square)
             : T(0);
}

template <Ordered T>
[[nodiscard]] T greatest_lever(const ContactBody<T>& body) {
  return body.rolling_resistance < body.pivot_radius ? body.pivot_radius : body.rolling_resistance;
}

/// Round-off of a kinetic energy that is none   [J/kg].
template <Ordered T>
[[nodiscard]] T no_energy(const ContactBody<T>& body) {
  return T(1e-4) * std::numeric_limits<T>::epsilon() * body.strength * body.stone.width;
}

/// Whether a stone that slips has stopped turning, and resistance holds it so. The force that then acts has the direction
/// of the present one, and bears the weight.
template <Ordered T, class Equations>
[[nodiscard]] bool stops_turning(const ContactBody<T>& body, const Equations& equations, const T& angle) {
  if constexpr (Equations::used < variables) {
    return false;
  }
  const Kinetics<T>& k = equations.now;
  const T energy = formula::dot(k.L, k.w) / T(2), N = -body.gravity.z();
  if (!(energy <= N * greatest_lever(body) * angle)) {
    return false;
  }
  const Vec3<T> force = formula::scaled(T(N / equations.force.z()), equations.force);
  const T share = resistance_share(body, {k.r, {T(0), T(0), T(1)}}, force);
  // By a margin: at the limit itself a stone would be let go at once, and stopped again.
  return share < T(0.999) && energy <= N * resistance_lever(body, k.w) * (T(1) - share) * angle;
}

/// At rest: what is left of the kinetic energy is less than resistance takes in turning by `angle` (rad), and statics
/// holds the stone.
template <Ordered T, class Equations>
[[nodiscard]] bool is_at_rest(const ContactBody<T>& body, const Equations& equations, const Variables<T>& y,
                              const T& angle) {
  const Kinetics<T>& k = equations.now;
  const T weight = -body.gravity.z(), nothing = no_energy(body);
  const T most = weight * greatest_lever(body) * angle + nothing;
  if (most < formula::dot(k.L, k.w)) {
    return false;
  }
  const T energy = formula::contact_kinetic_energy(k, equations.slip_x(y), equations.slip_y(y));
  if (most < energy || !is_held(body, k.r)) {
    return false;
  }
  if (energy <= nothing) {
    return true;
  }
  const T share = resistance_share(body, {k.r, {T(0), T(0), T(1)}}, Vec3<T>(-body.gravity));
  return energy <= weight * resistance_lever(body, k.w) * (T(1) - share) * angle + nothing;
}

}  // namespace detail
}  // namespace goishi
