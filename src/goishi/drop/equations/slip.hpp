#pragma once
/// \file
/// Friction that slips, as formulas: what a law of friction and the normal force that goes with it do to the slip. Per
/// unit of mass, as in contact_motion.hpp.

#include <goishi/drop/equations/contact_motion.hpp>

namespace goishi {

/// Rate of a slip s = σ (cos φ, sin φ) under dry friction.
template <class T>
struct SlipRate {
  T N;             // [m/s²] normal force
  T denominator;   // of N; <= 0 is Painlevé's case
  T along;         // [m/s²] σ̇
  T across;        // [m/s²] σ φ̇
  T across_slope;  // [m/s²] d(σ φ̇)/dφ
};

/// Rate of a slip s = (s_x, s_y) under friction −k N s.
template <class T>
struct GlideRate {
  T N;            // [m/s²] normal force
  T denominator;  // of N; <= 0 is Painlevé's case
  T x, y;         // [m/s²] ṡ
};

/// Its slope, ∂ṡ/∂s.
template <class T>
struct GlideSlope {
  T xx, xy, yx, yy;  // [1/s] ∂ṡ_x/∂s_x, ∂ṡ_x/∂s_y …
};

namespace formula {

/// From what dry friction with a normal force of 1 does to the contact point, p, and from how that
/// changes with the direction φ, p'. The normal force is the one that keeps the point on the plane:
///
///     N = need_z / p_z,   ṡ = N p − need
///
/// Domain  p_z > 0.   Proof  derivations/slip.cpp, the slope included.
template <Field T>
[[nodiscard]] inline SlipRate<T> slip_under(const Vec3<T>& p, const Vec3<T>& p_slope, const Vec3<T>& need, const T& c,
                                            const T& s) {
  SlipRate<T> rate;
  rate.denominator = p.z();
  const T over = T(1) / rate.denominator;
  rate.N = need.z() * over;
  const T N_slope = -(rate.N * over * p_slope.z());
  const T a_x = rate.N * p.x() - need.x(), a_y = rate.N * p.y() - need.y();
  rate.along = a_x * c + a_y * s;
  rate.across = a_y * c - a_x * s;
  const T b_x = N_slope * p.x() + rate.N * p_slope.x(), b_y = N_slope * p.y() + rate.N * p_slope.y();
  rate.across_slope = b_y * c - b_x * s - rate.along;
  return rate;
}

/// Dry friction, F = N (−μ c, −μ s, 1) for the slip's direction (c, s), a unit vector: p = W (−μ c, −μ s, 1) + b.
/// b = J τ × r is what the resistance of a normal force 1 does to the contact point.
/// Domain  as above.   Proof  derivations/slip.cpp.
template <Field T>
[[nodiscard]] inline SlipRate<T> slip_rate(const ContactMatrix<T>& W, const Vec3<T>& brake, const Vec3<T>& need,
                                           const T& mu, const T& c, const T& s) {
  const Vec3<T> p(T(W.xz + brake.x() - mu * (W.xx * c + W.xy * s)), T(W.yz + brake.y() - mu * (W.xy * c + W.yy * s)),
                  T(W.zz + brake.z() - mu * (W.xz * c + W.yz * s)));
  const Vec3<T> p_slope(T(mu * (W.xx * s - W.xy * c)), T(mu * (W.xy * s - W.yy * c)), T(mu * (W.xz * s - W.yz * c)));
  return formula::slip_under(p, p_slope, need, c, s);
}

/// Friction in proportion to the slip, F = N (−k s_x, −k s_y, 1), with the normal force that keeps the contact point on
/// the plane. Every smooth law is of this form, with a k of its own.
/// Domain  D = W_zz + b_z − k (W_xz s_x + W_yz s_y) > 0.   Proof  derivations/slip.cpp.
template <Field T>
[[nodiscard]] inline GlideRate<T> glide_rate(const ContactMatrix<T>& W, const Vec3<T>& brake, const Vec3<T>& need,
                                             const T& k, const T& s_x, const T& s_y) {
  const Vec3<T> q(T(-(k * s_x)), T(-(k * s_y)), T(1));
  const Vec3<T> gained = formula::plus(formula::product(W, q), brake);
  GlideRate<T> rate;
  rate.denominator = gained.z();
  rate.N = need.z() / gained.z();
  rate.x = rate.N * gained.x() - need.x();
  rate.y = rate.N * gained.y() - need.y();
  return rate;
}

/// The slope of `glide_rate` and of damping with the rate c, where friction per normal force is g = k s, ∂g/∂s = k (1
/// − q s sᵀ): q = (k/μ)² of `patch_friction`, and 0 where k is a constant.
/// Proof  derivations/slip.cpp.
template <Field T>
[[nodiscard]] inline GlideSlope<T> glide_slope(const ContactMatrix<T>& W, const Vec3<T>& brake,
                                               const GlideRate<T>& rate, const T& k, const T& share, const T& s_x,
                                               const T& s_y, const T& damping) {
  const T g_xx = k * (T(1) - share * s_x * s_x), g_xy = -(k * share * s_x * s_y);
  const T g_yy = k * (T(1) - share * s_y * s_y);
  const T over = rate.N / rate.denominator;
  const T p_x = W.xz + brake.x() - k * (W.xx * s_x + W.xy * s_y);
  const T p_y = W.yz + brake.y() - k * (W.xy * s_x + W.yy * s_y);
  const T pull_x = over * (W.xz * g_xx + W.yz * g_xy), pull_y = over * (W.xz * g_xy + W.yz * g_yy);
  return {.xx = T(pull_x * p_x - rate.N * (W.xx * g_xx + W.xy * g_xy) - damping),
          .xy = T(pull_y * p_x - rate.N * (W.xx * g_xy + W.xy * g_yy)),
          .yx = T(pull_x * p_y - rate.N * (W.xy * g_xx + W.yy * g_xy)),
          .yy = T(pull_y * p_y - rate.N * (W.xy * g_xy + W.yy * g_yy) - damping)};
}

/// What damping with the rate c leaves of a rate of x: ẋ − c x. Both momenta, and with them the slip, are damped so.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline T damped(const T& rate, const T& damping, const T& x) {
  return rate - damping * x;
}

/// The force at a contact with the normal force N and friction −`drag` (x, y)   [m/s²]: μ N against the slip's
/// direction, k N against the slip.
/// Proof  derivations/slip.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> friction_force(const T& N, const T& drag, const T& x, const T& y) {
  return {T(-(drag * x)), T(-(drag * y)), N};
}

/// Friction per normal force and slip of a contact patch that also turns (Coulomb–Contensou, in Zhuravlev's form)
/// [s/m]: μ / √(|s|² + (8 a_c ω_z / 3π)² + creep²). `patch` is 8 a_c/3π, `creep` the slip below which friction is
/// proportional to it even where the patch does not turn.
/// Domain  not all three of the root zero.   Limits  no patch, no creep: μ/|s|.
/// Source  Zhuravlev, J. Appl. Math. Mech. 62 (1998) 705.   Proof  derivations/slip.cpp.
template <Elementary T>
[[nodiscard]] inline T patch_friction(const T& mu, const T& patch, const T& w_z, const T& slip_square,
                                      const T& creep_square) {
  return mu / scalar::sqrt(T(slip_square + scalar::sq(T(patch * w_z)) + creep_square));
}

}  // namespace formula
}  // namespace goishi
