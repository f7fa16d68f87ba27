#pragma once
/// \file
/// The default law: Chatterjee and Ruina's, with tangential restitution 0.
/// Source  A. Chatterjee, A. Ruina, "A new algebraic rigid-body collision law based on impulse space considerations",
///         Journal of Applied Mechanics 65 (1998).

#include <goishi/impact/impulses.hpp>
#include <goishi/impact/material.hpp>

namespace goishi::detail {

/// p = (1 + e) p_I + κ (p_II − p_I), κ = 1, or the value that puts p on the friction cone
/// (`formula::chatterjee_ruina_impulse`). With κ = 1 the contact leaves with e W p_I: no slip but what the
/// restitution's own impulse makes.
template <Ordered T, template <class> class Matrix>
[[nodiscard]] inline LawImpulse<T> chatterjee_ruina_ordinary(const Collision<T, Matrix>& c) {
  const T approach = formula::dot(c.v, c.n);
  const T mobility = formula::dot(c.n, formula::product(c.W, c.n));
  const T plastic = formula::normal_impulse(approach, mobility, T(0));
  const Vec3<T> sticking = formula::sticking_impulse(c.W, c.v);
  const T sticking_normal = formula::dot(sticking, c.n);
  const Vec3<T> tangential = formula::plus(sticking, T(-sticking_normal), c.n);
  // Sticking needs |p_t| <= μ p_n; over μ where that is above 1, because it may be infinite.
  const bool rough = T(1) < c.friction;
  const T against = rough ? T(1) : c.friction, along = rough ? T(T(1) / c.friction) : T(1);
  const T normal = against * ((T(1) + c.restitution) * plastic), gained = against * (sticking_normal - plastic);
  const T needed = along * scalar::sqrt(formula::dot(tangential, tangential));
  const bool sticks = !(normal < needed - gained);
  const T kappa = sticks ? T(1) : formula::cone_fraction(normal, needed, gained);
  return {sticks ? ImpactOutcome::stuck : ImpactOutcome::slid,
          formula::chatterjee_ruina_impulse(plastic, sticking, c.n, c.restitution, kappa), 1};
}

/// The same of any size: in units in which no product leaves the range of T. By
/// copies: no address of W or v leaves, so they stay in registers.
template <Ordered T>
[[nodiscard, gnu::noinline]] LawImpulse<T> chatterjee_ruina_rescaled(const ContactMatrix<T>& W_W, const Vec3<T>& v_W,
                                                                     const Vec3<T>& n_W, const T& restitution,
                                                                     const T& friction) {
  const Units<T> units = units_of(W_W, v_W);
  const ContactMatrix<T> W = units.of(W_W);
  const Vec3<T> v = units.of(v_W);
  return units.back(chatterjee_ruina_ordinary(Collision<T>{W, v, n_W, restitution, friction}));
}

/// Whether no product on the law's way leaves the range of T.
template <Ordered T, template <class> class Matrix>
[[nodiscard]] inline bool is_ordinary(const Collision<T, Matrix>& c) {
  const T least = least_ordinary<T>();
  const T approach = -formula::dot(c.v, c.n);
  const T mobility = formula::dot(c.n, formula::product(c.W, c.n));
  return all(least < approach, approach * least < T(1), least < mobility, mobility * least < T(1));
}

/// The law. In line and in its own units where those are ordinary ones.
template <Ordered T>
[[nodiscard]] inline LawImpulse<T> chatterjee_ruina(const Collision<T>& c) {
  if (!is_ordinary(c)) [[unlikely]] {
    return chatterjee_ruina_rescaled<T>({c.W.xx, c.W.yy, c.W.zz, c.W.xy, c.W.xz, c.W.yz}, {c.v.x(), c.v.y(), c.v.z()},
                                        c.n, c.restitution, c.friction);
  }
  return chatterjee_ruina_ordinary(c);
}

}  // namespace goishi::detail
