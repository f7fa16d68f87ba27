#pragma once
/// \file
/// An attitude from a symmetry axis: the contact phase integrates the axis, and beside it one angle.

#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>

namespace goishi::formula {

/// The shortest rotation that takes the unit vector a to the unit vector b.
/// Domain  a ≠ −b.   Proof  derivations/contact_motion.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> shortest_rotation(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<T> axis = formula::cross(a, b);
  const T w = T(1) + formula::dot(a, b);
  const T over = T(1) / scalar::sqrt(T(scalar::sq(w) + formula::dot(axis, axis)));
  return Quat<T>(T(w * over), T(axis.x() * over), T(axis.y() * over), T(axis.z() * over));
}

/// The attitude q_a of a body whose axis was a, carried with the axis to u by the shortest rotation, and turned by an
/// angle ψ about it: shortest(a, u) q_a (cos ψ/2, ẑ sin ψ/2).
/// Domain  a ≠ −u.   Proof  derivations/contact_phase.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> carried_attitude(const Vec3<T>& a, const Quat<T>& q_a, const Vec3<T>& u, const T& spin) {
  const Quat<T> q = formula::product(formula::shortest_rotation(a, u), q_a);
  const auto [s, c] = scalar::sincos(T(spin / T(2)));
  return Quat<T>(T(q.w() * c - q.z() * s), T(q.x() * c + q.y() * s), T(q.y() * c - q.x() * s),
                 T(q.z() * c + q.w() * s));
}

/// Rate of the angle ψ by which a body has turned about its axis u, beyond the shortest rotation from a to u   [1/s]:
///
///     q = shortest(a, u) q_a spin(ψ),   ψ̇ = ω · u + a · (u × u̇) / (1 + a · u)
///
/// Domain  a ≠ −u.   Proof  derivations/contact_motion.cpp.
template <Field T>
[[nodiscard]] inline T carried_spin_rate(const Vec3<T>& a, const Vec3<T>& u, const Vec3<T>& u_rate,
                                         const T& spin_rate) {
  return spin_rate + formula::dot(a, formula::cross(u, u_rate)) / (T(1) + formula::dot(a, u));
}

}  // namespace goishi::formula
