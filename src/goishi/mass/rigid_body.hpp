#pragma once
/// \file
/// A rigid body: mass and principal moments, and their inverses, which its motion by momenta and its answer to impulses ask
/// for.

#include <concepts>
#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>
#include <type_traits>

namespace goishi {

/// Mass and principal moments, about Bx, By, Bz. A stone's are (I_t, I_t, I_a).
template <class T>
struct RigidBody {
  T mass = scalar::unset<T>();                              // [kg]
  Vec3<T> moments = Vec3<T>::Constant(scalar::unset<T>());  // [kg m²]
};

/// Domain  mass > 0; moments > 0, none above the sum of the other two; all finite; else InvalidArgument.
template <Ordered T>
[[nodiscard]] RigidBody<T> make_rigid_body(const std::type_identity_t<T>& mass, const Vec3<T>& moments) {
  require_positive("mass", mass);
  const char* broken = broken_inertia_rule(moments);
  if (broken != nullptr) {
    throw_invalid("moments", moments.transpose(), broken);
  }
  return {.mass = mass, .moments = moments};
}

/// Domain  mass > 0, 0 < I_a <= 2 I_t; all finite; else InvalidArgument.
template <Ordered T>
[[nodiscard]] RigidBody<T> make_rigid_body(const std::type_identity_t<T>& mass, const Moments<T>& moments) {
  require_positive("mass", mass);
  require_physical(moments);
  return {.mass = mass, .moments = {moments.transverse, moments.transverse, moments.axial}};
}

template <Ordered T>
[[nodiscard]] RigidBody<T> make_rigid_body(const MassProperties<T>& stone) {
  return make_rigid_body(stone.mass, stone.moments);
}

/// How a body with a symmetry axis moves by its momenta and answers to impulses. Made by `make_mobility`, once per body. A
/// torque-free one turns at |L| · `transverse` about L and at L_z · `axial` about Bz.
template <class T>
struct Mobility {
  T linear = scalar::unset<T>();      // 1/m [1/kg]
  T transverse = scalar::unset<T>();  // 1/I_t [1/(kg m²)]
  T axial = scalar::unset<T>();       // 1/I_a − 1/I_t [1/(kg m²)]
};

namespace formula {

/// 1/m, 1/I_t, 1/I_a − 1/I_t, the last as (I_t − I_a)/I_a/I_t: a ball's is 0, and no product of moments underflows.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] Mobility<T> mobility(const T& mass, const Moments<T>& moments) {
  return {.linear = T(T(1) / mass),
          .transverse = T(T(1) / moments.transverse),
          .axial = T((moments.transverse - moments.axial) / moments.axial / moments.transverse)};
}

/// Of a body whose moments I_x and I_y are equal.
template <Field T>
[[nodiscard]] Mobility<T> mobility(const RigidBody<T>& body) {
  return formula::mobility(body.mass, Moments<T>{.axial = body.moments.z(), .transverse = body.moments.x()});
}

/// Of mass 1, where only turning counts.
template <Field T>
[[nodiscard]] Mobility<T> mobility(const Moments<T>& moments) {
  return formula::mobility(T(1), moments);
}

/// Angular velocity from angular momentum, both in W   [rad/s]:
///
///     ω = I⁻¹ L = L/I_t + (1/I_a − 1/I_t)(u · L) u
///
/// Domain  u unit.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> turning(const Mobility<T>& mobility, const Vec3<T>& u_W, const Vec3<T>& L_W) {
  const T along = mobility.axial * formula::dot(u_W, L_W);
  return {T(mobility.transverse * L_W.x() + along * u_W.x()), T(mobility.transverse * L_W.y() + along * u_W.y()),
          T(mobility.transverse * L_W.z() + along * u_W.z())};
}

}  // namespace formula

namespace detail {

template <Ordered T>
void require_inverse(const char* argument, const T& value, const T& inverse) {
  require(scalar::tiny<T>() <= inverse && scalar::is_finite(inverse), argument, value,
          "must have an inverse that its type can hold");
}

}  // namespace detail

/// Domain  mass > 0, 0 < I_a <= 2 I_t; all finite, and their inverses numbers of T, not below the least normal one; else
///         InvalidArgument.
template <Ordered T>
[[nodiscard]] Mobility<T> make_mobility(const std::type_identity_t<T>& mass, const Moments<T>& moments) {
  require_positive("mass", mass);
  require_physical(moments);
  Mobility<T> result = formula::mobility(mass, moments);
  detail::require_inverse("mass", mass, result.linear);
  detail::require_inverse("transverse", moments.transverse, result.transverse);
  detail::require_inverse("axial", moments.axial, T(T(1) / moments.axial));
  return result;
}

template <Ordered T>
[[nodiscard]] Mobility<T> make_mobility(const MassProperties<T>& stone) {
  return make_mobility(stone.mass, stone.moments);
}

/// Of mass 1, where only turning counts.
template <Ordered T>
[[nodiscard]] Mobility<T> make_mobility(const Moments<T>& moments) {
  return make_mobility(T(1), moments);
}

/// Of a body that does not turn: every law without friction is then the linear response, for one body or for two.
/// Domain  mass > 0 and finite, and its inverse, too; else InvalidArgument.
template <Ordered T>
[[nodiscard]] Mobility<T> make_linear_mobility(const T& mass) {
  require_positive("mass", mass);
  detail::require_inverse("mass", mass, T(T(1) / mass));
  return {.linear = T(T(1) / mass), .transverse = T(0), .axial = T(0)};
}
[[nodiscard]] inline Mobility<double> make_linear_mobility(std::integral auto mass) {
  return make_linear_mobility(static_cast<double>(mass));
}

/// Of a body that does not answer: no impulse changes how it moves.
template <Field T>
[[nodiscard]] constexpr Mobility<T> fixed_mobility() {
  return {.linear = T(0), .transverse = T(0), .axial = T(0)};
}

}  // namespace goishi
