#pragma once
/// \file
/// The impulses that the impact laws are made of. Velocities are of the contact points, first body less second; n is
/// the unit normal, out of the second towards the first; impulses are on the first.

#include <goishi/impact/contact_matrix.hpp>

namespace goishi::formula {

/// The impulse along n that turns the approach v · n < 0 into −e v · n, without friction   [N s]:
///
///     j = −(1 + e) v · n / K,   K = n · W n
///
/// It changes the energy by −(1 − e²)(v · n)²/(2K).
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] T normal_impulse(const T& approach, const T& normal_mobility, const T& restitution) {
  return -((T(1) + restitution) * approach) / normal_mobility;
}

/// The impulse along the unit direction t of the slip that would stop it   [N s]: j_t = −v · t / (t · W t), <= 0. A
/// part λ of it, 0 <= λ <= 1, changes the energy by −λ (2 − λ)(v · t)²/(2 t · W t).
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] T stopping_impulse(const T& slip, const T& tangential_mobility) {
  return -(slip / tangential_mobility);
}

/// The impulse after which the contact is at rest, in all directions: p_II = −W⁻¹ v   [N s].
/// Proof  derivations/impact_laws.cpp.
template <Field T, template <class> class Matrix>
[[nodiscard]] inline Vec3<T> sticking_impulse(const Matrix<T>& W, const Vec3<T>& v_W) {
  return formula::scaled(T(-1), formula::solution(W, v_W));
}

/// Chatterjee and Ruina's impulse with tangential restitution 0   [N s], from the frictionless plastic one,
/// p_I = j_I n, and the sticking one, p_II:
///
///     p = (1 + e) p_I + κ (p_II − p_I)
///
/// Exact restitution: n · W (p_II − p_I) = 0, so v⁺ · n = −e v · n whatever κ. No energy is gained: p_II − p_I is
/// orthogonal to p_I in the metric of W, so the energy changes by
///
///     ½ (‖p − p_II‖² − ‖p_II‖²) = −½ ((1 − e²) ‖p_I‖² + κ (2 − κ) ‖p_II − p_I‖²)
///
/// which is not positive for 0 <= e <= 1, 0 <= κ <= 2. With v_I = v + W p_I, which lies across n, friction's power on
/// it is −κ v_I · W⁻¹ v_I <= 0: friction is against the slip that the plastic normal impulse leaves.
/// Proof  derivations/impact_laws.cpp.
template <Field T>
[[nodiscard]] Vec3<T> chatterjee_ruina_impulse(const T& plastic, const Vec3<T>& sticking, const Vec3<T>& n_W,
                                               const T& restitution, const T& kappa) {
  return formula::plus(formula::scaled(kappa, sticking), T((T(1) + restitution - kappa) * plastic), n_W);
}

/// The κ that puts Chatterjee and Ruina's impulse on the friction cone, |p_t| = μ p_n:
///
///     κ = μ (1 + e) j_I / (|p_II,t| − μ (p_II,n − j_I))
///
/// Given with `normal` = c μ (1 + e) j_I, `needed` = c |p_II,t| and `gained` = c μ (p_II,n − j_I), any c > 0.
/// Domain  needed > normal + gained: sticking is outside the cone; then 0 <= κ < 1.
/// Limits  μ -> 0: 0.   Proof  derivations/impact_laws.cpp.
template <Field T>
[[nodiscard]] T cone_fraction(const T& normal, const T& needed, const T& gained) {
  return normal / (needed - gained);
}

/// What an impulse p does to the energy of the bodies   [J]: p · (v + v⁺)/2, the velocity of the contact before and
/// after.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] T work(const Vec3<T>& impulse, const Vec3<T>& before, const Vec3<T>& after) {
  return formula::dot(impulse, formula::plus(before, after)) / T(2);
}

}  // namespace goishi::formula
