#pragma once
/// \file
/// A stone that touches a plane, as formulas: where, how the point of contact moves over it, what a force there does to
/// it, and the force that keeps it at rest. Rolling and sliding are both made of this.
///
/// Everything is per unit of mass, in W, with the plane's normal along Wz: forces are accelerations, and a `Mobility` is
/// that of mass 1 (`linear` = 1). u is the symmetry axis, η = u_z, S(η) the support in the direction −Wz, r points from
/// the centre of mass to the contact.
///
/// Source  Newton and Euler; Pars, A Treatise on Analytical Dynamics (1965), chapter 7, for rolling.

#include <goishi/impact/contact_matrix.hpp>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// S(η) and its derivatives, at one η.
template <class T>
struct ContactGeometry {
  T height;     // S [m]
  T slope;      // S' [m]
  T curvature;  // S'' [m]
};

/// A stone in contact at one moment: where it is, and how it turns.
template <class T>
struct ContactPlace {
  Vec3<T> u;      // unit, symmetry axis
  Vec3<T> L;      // [m²/s] angular momentum about the centre of mass
  Vec3<T> w;      // [1/s] ω = J L
  Vec3<T> r;      // [m] from the centre of mass to the contact
  T height;       // [m] S: of the centre of mass over the plane
  Vec3<T> point;  // [m/s] ω × r: what turning adds to the velocity of the point in contact
};

/// And how that goes on. Rates are those of ω alone: forces do not enter.
template <class T>
struct ContactTurn : ContactPlace<T> {
  Vec3<T> u_rate;  // [1/s] ω × u
  T spin_rate;     // [1/s] ω · u
  Vec3<T> need;    // [m/s²] acceleration of that point = W F − `need` under a force F on it
};

/// And what a force does.
template <class T>
struct ContactMotion : ContactTurn<T> {
  ContactMatrix<T> W;
};

/// What forces and torques make of a motion in contact, or a motion itself.
template <class T>
struct ContactGain {
  Vec3<T> point;  // [m/s] velocity of the contact point
  Vec3<T> w;      // [1/s] ω
};

namespace formula {

/// On a cap, S = r − d |η|. `side` is 1 on the lower cap (η > 0), −1 on the upper.
/// Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline ContactGeometry<T> cap_contact(const Stone<T>& stone, const T& side, const T& eta,
                                                    const T& radial_square) {
  return {.height = formula::cap_support(stone, T(side * eta), radial_square),
          .slope = T(-(side * stone.sphere_offset)),
          .curvature = T(0)};
}

/// On the rim, S = r₁ √(1 − η²) + r₂. `radial` is √(u_x² + u_y²).
/// Domain  radial > 0.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline ContactGeometry<T> rim_contact(const Stone<T>& stone, const T& eta, const T& radial) {
  const T over = stone.bevel_major_radius / radial;
  return {.height = formula::rim_support(stone, radial),
          .slope = T(-(over * eta)),
          .curvature = T(-(over / (radial * radial)))};
}

/// Where the contact is: r = −S' u_h − S ẑ, ω = J L.
/// Domain  |u| = 1.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline ContactPlace<T> contact_place(const Mobility<T>& mobility, const ContactGeometry<T>& geometry,
                                                   const Vec3<T>& u, const Vec3<T>& L) {
  ContactPlace<T> now;
  now.u = u;
  now.L = L;
  now.w = formula::combination(mobility.transverse, L, T(mobility.axial * formula::dot(u, L)), u);
  now.height = geometry.height;
  now.r = {T(-(geometry.slope * u.x())), T(-(geometry.slope * u.y())), T(-now.height)};
  now.point = formula::cross(now.w, now.r);
  return now;
}

/// How that goes on, without a force:
///
///     ṙ = S'' η̇ (η ẑ − u) − S' u̇,   J L = ω,   J̇ L = (1/I_a − 1/I_t) (u · L) u̇
///     need = −g − J̇ L × r − ω × ṙ
///
/// Domain  |u| = 1.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline ContactTurn<T> contact_turn(const Mobility<T>& mobility, const Vec3<T>& gravity,
                                                 const ContactGeometry<T>& geometry, const Vec3<T>& u,
                                                 const Vec3<T>& L) {
  ContactTurn<T> now;
  static_cast<ContactPlace<T>&>(now) = formula::contact_place(mobility, geometry, u, L);
  const T momentum = formula::dot(u, L);
  const T along = mobility.axial * momentum;
  now.spin_rate = (mobility.transverse + mobility.axial) * momentum;
  now.u_rate = formula::scaled(mobility.transverse, formula::cross(L, u));
  const T turn = geometry.curvature * now.u_rate.z();
  const Vec3<T> r_rate(T(-(turn * u.x() + geometry.slope * now.u_rate.x())),
                       T(-(turn * u.y() + geometry.slope * now.u_rate.y())), T(-(geometry.slope * now.u_rate.z())));
  const Vec3<T> gyration = formula::cross(now.u_rate, now.r), swept = formula::cross(now.w, r_rate);
  now.need = {T(-(gravity.x() + along * gyration.x() + swept.x())),
              T(-(gravity.y() + along * gyration.y() + swept.y())),
              T(-(gravity.z() + along * gyration.z() + swept.z()))};
  return now;
}

/// And what a force F at the contact and a torque τ beside it do: d/dt (v + ω × r) = W F + J τ × r − need.
/// Domain  |u| = 1.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline ContactMotion<T> contact_motion(const Mobility<T>& mobility, const Vec3<T>& gravity,
                                                     const ContactGeometry<T>& geometry, const Vec3<T>& u,
                                                     const Vec3<T>& L) {
  ContactMotion<T> now;
  static_cast<ContactTurn<T>&>(now) = formula::contact_turn(mobility, gravity, geometry, u, L);
  now.W = formula::contact_matrix(mobility, u, now.r);
  return now;
}

/// What a torque τ does to the contact point   [m/s²]: J τ × r.
/// Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> turned_point(const Mobility<T>& mobility, const Vec3<T>& u, const Vec3<T>& r,
                                          const Vec3<T>& torque) {
  return formula::cross(formula::turning(mobility, u, torque), r);
}

/// What a force F at the contact and a torque τ beside it add in a unit of time, or impulses at once: W F + J τ × r to
/// the velocity of the contact point, J (τ + r × F) to ω.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline ContactGain<T> contact_gain(const Mobility<T>& mobility, const ContactMotion<T>& now,
                                                 const Vec3<T>& force, const Vec3<T>& torque) {
  const Vec3<T> w = formula::turning(mobility, now.u, torque);
  return {formula::plus(formula::product(now.W, force), formula::cross(w, now.r)),
          formula::plus(w, formula::turning(mobility, now.u, formula::cross(now.r, force)))};
}

/// What they do on a motion: F · point + τ · ω. On the motion before and half of their own gain, that is the change of
/// the kinetic energy.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline T contact_work(const Vec3<T>& force, const Vec3<T>& torque, const ContactGain<T>& motion) {
  return formula::dot(force, motion.point) + formula::dot(torque, motion.w);
}

/// Rolling resistance and pivot friction: their torque per normal force   [m]
///
///     τ = −(δ² ω_h + κ² ω_z) / √(δ² |ω_h|² + κ² ω_z²)
///
/// Horizontally it is at most δ, upright at most κ, and it is singular at ω = 0 alone. `floor` is added under the root.
/// Domain  squares >= 0, not all of the root's zero.   Proof  derivations/contact_motion.cpp (it only brakes).
template <Elementary T>
[[nodiscard]] inline Vec3<T> resistance(const T& delta_square, const T& kappa_square, const Vec3<T>& w,
                                        const T& floor) {
  const T root = scalar::sqrt(
      T(delta_square * (scalar::sq(w.x()) + scalar::sq(w.y())) + kappa_square * scalar::sq(w.z()) + floor));
  const T roll = delta_square / root, pivot = kappa_square / root;
  return {T(-(roll * w.x())), T(-(roll * w.y())), T(-(pivot * w.z()))};
}

/// The force that keeps the contact point at rest: (W + b ẑᵀ) F = need, where b = J τ × r is what the resistance that
/// goes with a normal force of 1 does to the point.
/// Domain  det(W + b ẑᵀ) ≠ 0: with b = 0 always.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> rolling_force(const ContactMatrix<T>& W, const Vec3<T>& brake, const Vec3<T>& need) {
  const T xz = W.xz + brake.x(), yz = W.yz + brake.y(), zz = W.zz + brake.z();
  const T m_x = W.yy * zz - yz * W.yz, m_y = W.xy * zz - yz * W.xz, m_z = W.xy * W.yz - W.yy * W.xz;
  const T over = T(1) / (W.xx * m_x - W.xy * m_y + xz * m_z);
  const T p = need.y() * zz - yz * need.z(), q = need.y() * W.yz - W.yy * need.z();
  const T s = W.xy * need.z() - need.y() * W.xz;
  return {T(over * (need.x() * m_x - W.xy * p + xz * q)), T(over * (W.xx * p - need.x() * m_y + xz * s)),
          T(over * (need.x() * m_z - W.xx * q - W.xy * s))};
}

/// Velocity of the centre of mass of a stone whose contact point slips with (s_x, s_y)   [m/s]: s − ω × r.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> centre_velocity(const ContactPlace<T>& now, const T& s_x, const T& s_y) {
  return {T(s_x - now.point.x()), T(s_y - now.point.y()), T(-now.point.z())};
}

/// Kinetic energy of a stone in contact whose contact point slips with (s_x, s_y)   [m²/s²]: ½ (L · ω + |v|²), with
/// v = s − ω × r along the plane and v_z = −(ω × r)_z.
/// Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline T contact_kinetic_energy(const ContactPlace<T>& now, const T& s_x, const T& s_y) {
  return (formula::dot(now.L, now.w) + scalar::sq(T(s_x - now.point.x())) + scalar::sq(T(s_y - now.point.y())) +
          scalar::sq(now.point.z())) /
         T(2);
}

/// The factor of all velocities that takes so much of a kinetic energy.
/// Domain  no more than all of it.   Proof  derivations/contact_phase.cpp.
template <Elementary T>
[[nodiscard]] inline T slowing(const T& taken, const T& kinetic) {
  return scalar::sqrt(T(T(1) - taken / kinetic));
}

/// The energy of a stone in contact, its centre over (x, y), with this kinetic energy   [m²/s²]: zero potential at the
/// origin.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline T contact_energy(const ContactPlace<T>& now, const Vec3<T>& gravity, const T& x, const T& y,
                                      const T& kinetic) {
  return kinetic - (gravity.x() * x + gravity.y() * y + gravity.z() * now.height);
}

}  // namespace formula
}  // namespace goishi
