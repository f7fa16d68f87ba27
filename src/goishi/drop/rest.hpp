#pragma once
/// \file
/// When a stone in contact rests, and when one that slips has stopped turning.

#include <goishi/drop/contact_state.hpp>
#include <goishi/drop/locked.hpp>

namespace goishi::detail {

/// Whether a stone that slips has stopped turning, and resistance holds it so.
template <Ordered T, class Equations>
[[nodiscard]] bool stops_turning(const ContactState<T>& contact, const Equations& equations, const T& angle) {
  if constexpr (Equations::used < variables) {
    return false;
  }
  const Kinetics<T>& k = equations.now;
  const T energy = formula::dot(k.L, k.w) / T(2);
  const T N = equations.force.z();
  const T most = contact.body.rolling_resistance < contact.body.pivot_radius ? contact.body.pivot_radius
                                                                             : contact.body.rolling_resistance;
  if (N * most * angle < energy) {
    return false;
  }
  const T share = resistance_share(contact.body, k.r, equations.force, contact.scales.length);
  return share < T(1) && energy <= N * resistance_lever(contact.body, k.w) * (T(1) - share) * angle;
}

/// At rest: what is left of the kinetic energy is less than resistance takes in turning by `angle` (rad), and gravity
/// is too weak to turn the stone or make it slip.
template <Ordered T, class Equations>
[[nodiscard]] bool is_at_rest(const ContactState<T>& contact, const Equations& equations, const T& angle) {
  const Kinetics<T>& k = equations.now;
  const T& delta = contact.body.rolling_resistance;
  const T& kappa = contact.body.pivot_radius;
  const T weight = -contact.body.gravity.z();
  const T nothing = T(1e-20);  // [J/kg] round-off of a stone that nothing moves
  const T most = weight * (delta < kappa ? kappa : delta) * angle + nothing;
  if (most < formula::dot(k.L, k.w)) {
    return false;
  }
  const T energy = formula::contact_kinetic_energy(k, equations.slip_x(contact.y), equations.slip_y(contact.y));
  if (most < energy) {
    return false;
  }
  const T pull = scalar::sqrt(T(scalar::sq(contact.body.gravity.x()) + scalar::sq(contact.body.gravity.y())));
  if (contact.body.friction * weight < pull) {
    return false;
  }
  const T share = resistance_share(contact.body, k.r, Vec3<T>(-contact.body.gravity), contact.scales.length);
  return share < T(1) && energy <= weight * resistance_lever(contact.body, k.w) * (T(1) - share) * angle + nothing;
}

}  // namespace goishi::detail
