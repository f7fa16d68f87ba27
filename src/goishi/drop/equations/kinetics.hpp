#pragma once
/// \file
/// What the equations of a contact are made of: the stone, per unit of mass, and its motion at the integrator's variables.

#include <array>
#include <cstddef>
#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/contact_motion.hpp>
#include <goishi/drop/equations/slip.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/shape/surface.hpp>

namespace goishi {

namespace detail {

/// What of the stone, its mass and the settings the contact phase needs, once per drop. Everything per unit of mass.
template <class T>
struct ContactBody {
  Stone<T> stone;
  Mobility<T> mobility;  // of mass 1
  Vec3<T> gravity;
  T strength;   // |gravity|, or where there is none what the first motion makes of it: what forces are measured by
  T frequency;  // [1/s] √(2 strength/w)
  T friction, rolling_resistance, pivot_radius, damping;
  T slip_coefficient;  // slip_proportional
  T contensou;         // 8 a_c/3π
  T creep_square;      // of the creep speed
  FrictionModel model;
  bool resists;  // rolling resistance or pivot friction
};

/// The variables of the contact phase. The height is the support function's; in rolling the slip is zero. The slip is
/// (σ, φ), size and direction, under dry friction, and (s_x, s_y) under the smooth laws. `loss` is the energy that
/// friction, resistance and damping have taken. What may be stiff stands at the end: the slip by friction, L by resistance.
inline constexpr std::size_t variables = 12;
template <class T>
using Variables = std::array<T, variables>;
namespace at {
inline constexpr std::size_t u = 0, x = 3, y = 4, spin = 5, loss = 6, L = 7, slip = 10, direction = 11;
}
namespace stiff {  // as bits
inline constexpr unsigned turning = 7U << at::L, slip = 3U << at::slip, direction = 1U << at::direction;
}

/// The motion, and the resistance against it.
template <class T>
struct Kinetics : ContactMotion<T> {
  Vec3<T> torque;  // of resistance, per normal force
  Vec3<T> brake;   // J τ × r: what that does to the contact point
};

}  // namespace detail

namespace formula {

/// A vector that integration has taken off the unit sphere by a relative δ, back to O(δ³), without a root: by
/// (15 − 10 q + 3 q²)/8 for 1/√q, q = |a|².
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> reunited_axis(const Vec3<T>& a) {
  const T q = scalar::sq(a.x()) + scalar::sq(a.y()) + scalar::sq(a.z());
  const T scale = (T(15) - q * (T(10) - T(3) * q)) / T(8);
  return {T(a.x() * scale), T(a.y() * scale), T(a.z() * scale)};
}

/// What damping with the rate c takes of the energy   [m²/s³]: 2 c times what is kinetic.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline T damping_power(const ContactPlace<T>& now, const T& damping, const T& s_x, const T& s_y) {
  return T(2) * damping * formula::contact_kinetic_energy(now, s_x, s_y);
}

/// The rates of the contact phase's variables but the slip's, of a contact point that slips with (s_x, s_y) under a
/// force F per unit of mass; the torque τ of resistance goes with F's normal part N. The axis turns with ω; the centre
/// moves with s − ω × r; L̇ = r × F + N τ − c L; the loss is what friction, resistance and damping take, the last given as
/// `damped`; the spin angle is that of an attitude carried from the axis `origin`.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline detail::Variables<T> contact_rates(const ContactTurn<T>& k, const Vec3<T>& torque,
                                                        const T& damping, const T& damped, const Vec3<T>& F,
                                                        const T& s_x, const T& s_y, const Vec3<T>& origin) {
  const Vec3<T> moment = formula::cross(k.r, F), v = formula::centre_velocity(k, s_x, s_y);
  const T N = F.z();
  const T lost = -(F.x() * s_x + F.y() * s_y + N * formula::dot(torque, k.w)) + damped;
  return {k.u_rate.x(),
          k.u_rate.y(),
          k.u_rate.z(),
          v.x(),
          v.y(),
          formula::carried_spin_rate(origin, k.u, k.u_rate, k.spin_rate),
          lost,
          T(moment.x() + N * torque.x() - damping * k.L.x()),
          T(moment.y() + N * torque.y() - damping * k.L.y()),
          T(moment.z() + N * torque.z() - damping * k.L.z()),
          T(0),
          T(0)};
}

}  // namespace formula

namespace detail {

/// Under the root of the resistance: an angular velocity of 1e-12 frequencies, which has no direction any more.
template <Ordered T>
[[nodiscard]] inline T resistance_floor(const ContactBody<T>& body) {
  return (scalar::sq(body.rolling_resistance) + scalar::sq(body.pivot_radius)) *
         scalar::sq(T(T(1e-12) * body.frequency));
}

/// Torque of resistance, per normal force   [m].
template <Ordered T>
[[nodiscard]] inline Vec3<T> resistance_torque(const ContactBody<T>& body, const Vec3<T>& w) {
  return formula::resistance(scalar::sq(body.rolling_resistance), scalar::sq(body.pivot_radius), w,
                             resistance_floor(body));
}

template <Ordered T>
[[nodiscard]] inline ContactGeometry<T> geometry_of(const Stone<T>& stone, Feature feature, const Vec3<T>& u) {
  const T radial_square = scalar::sq(u.x()) + scalar::sq(u.y());
  return feature == Feature::rim
             ? formula::rim_contact(stone, T(u.z()), scalar::sqrt(radial_square))
             : formula::cap_contact(stone, feature == Feature::lower_cap ? T(1) : T(-1), T(u.z()), radial_square);
}

// The rates see the axis' direction, so that its length, which the integration lets drift, is nobody's.
template <Ordered T>
[[nodiscard]] inline Vec3<T> axis_of(const Variables<T>& y) {
  return formula::reunited_axis(Vec3<T>(y[at::u], y[at::u + 1], y[at::u + 2]));
}
template <Ordered T>
[[nodiscard]] inline Vec3<T> momentum_of(const Variables<T>& y) {
  return {y[at::L], y[at::L + 1], y[at::L + 2]};
}

template <Ordered T>
[[nodiscard]] inline ContactPlace<T> place_of(const ContactBody<T>& body, Feature feature, const Variables<T>& y) {
  const Vec3<T> u = axis_of(y);
  return formula::contact_place(body.mobility, geometry_of(body.stone, feature, u), u, momentum_of(y));
}

template <Ordered T>
[[nodiscard]] inline Kinetics<T> kinetics(const ContactBody<T>& body, Feature feature, const Variables<T>& y) {
  const Vec3<T> u = axis_of(y);
  Kinetics<T> k{
      formula::contact_motion(body.mobility, body.gravity, geometry_of(body.stone, feature, u), u, momentum_of(y)),
      Vec3<T>::Zero(), Vec3<T>::Zero()};
  if (body.resists) {
    k.torque = resistance_torque(body, k.w);
    k.brake = formula::turned_point(body.mobility, k.u, k.r, k.torque);
  }
  return k;
}

/// What a law of friction that is smooth in the slip takes per normal force and slip   [s/m], of a contact that turns with w_z.
template <Ordered T>
[[nodiscard]] T smooth_friction(const ContactBody<T>& body, const T& slip_square, const T& w_z) {
  if (body.model == FrictionModel::slip_proportional) {
    return body.slip_coefficient;
  }
  return T(0) < body.friction
             ? formula::patch_friction(body.friction, body.contensou, w_z, slip_square, body.creep_square)
             : T(0);
}

/// The least denominator of a normal force that still counts as solvable: below, friction jams (Painlevé).
template <Ordered T>
[[nodiscard]] T jam_margin(const T& W_zz) {
  return T(1e-6) * W_zz;
}

/// `formula::contact_rates`, where nothing is damped without the energy that damping would take.
template <Ordered T>
[[nodiscard]] inline Variables<T> rates(const ContactBody<T>& body, const ContactTurn<T>& k, const Vec3<T>& torque,
                                        const Vec3<T>& F, const T& s_x, const T& s_y, const Vec3<T>& origin) {
  const T damped = T(0) < body.damping ? formula::damping_power<T>(k, body.damping, s_x, s_y) : T(0);
  return formula::contact_rates<T>(k, torque, body.damping, damped, F, s_x, s_y, origin);
}

template <Ordered T>
[[nodiscard]] inline Variables<T> rates(const ContactBody<T>& body, const Kinetics<T>& k, const Vec3<T>& F,
                                        const T& s_x, const T& s_y, const Vec3<T>& origin) {
  return rates<T>(body, k, k.torque, F, s_x, s_y, origin);
}

}  // namespace detail
}  // namespace goishi
