#pragma once
/// \file
/// The talk's linear response, for comparison only: an impact without rotation and without friction. Use `resolve`.

#include <goishi/impact/material.hpp>
#include <goishi/shape/surface.hpp>
#include <type_traits>

namespace goishi {
namespace formula {

/// The talk's linear response: j = −(1 + e) p · n with p = m v the momentum; no rotation, no friction   [N s]. It is
/// `normal_impulse` with K = 1/m. With the velocity of the contact point instead (spin included), and the mass alone,
/// it gains energy as soon as (1 + e) m K > 2 (claim PUBLISHED-14).
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] T linear_impulse(const Vec3<T>& momentum, const Vec3<T>& n_W, const T& restitution) {
  return -((T(1) + restitution) * formula::dot(momentum, n_W));
}

}  // namespace formula

/// A body that does not turn meets a fixed one with a momentum; j = −(1 + e) p · n if it approaches.
/// Returns the impulse along n   [N s]; 0 for a body that leaves.
/// Domain  0 <= e <= 1, a unit normal, a finite momentum; else InvalidArgument.
template <Ordered T>
[[nodiscard]] T linear_response(const Vec3<T>& momentum, const Vec3<T>& n_W,
                                const std::type_identity_t<T>& restitution) {
  require_material(Material<T>{.restitution = restitution, .friction = T(0)});
  detail::require_point(momentum, "momentum");
  detail::require_direction(n_W);
  return formula::dot(momentum, n_W) < T(0) ? formula::linear_impulse(momentum, n_W, restitution) : T(0);
}

}  // namespace goishi
