#pragma once
/// \file
/// What moves: the state of a rigid body, with angular momentum as the primary rotational quantity.

#include <goishi/error.hpp>
#include <goishi/mass/rigid_body.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>

namespace goishi {

/// Where a body is and how it moves. NaN until set. The angular velocity is derived (`angular_velocity_B`): between
/// impacts L_W is constant and it is not.
template <class T>
struct State {
  Vec3<T> p_WB = Vec3<T>::Constant(scalar::unset<T>());  // [m] position of the centre of mass
  Quat<T> q_WB = Quat<T>(scalar::unset<T>(), scalar::unset<T>(), scalar::unset<T>(), scalar::unset<T>());  // attitude
  Vec3<T> v_WB = Vec3<T>::Constant(scalar::unset<T>());  // [m/s] velocity of the centre of mass
  Vec3<T> L_W = Vec3<T>::Constant(scalar::unset<T>());   // [kg m²/s] angular momentum about the centre of mass
};

/// Throws InvalidArgument unless everything is finite and the attitude a unit quaternion.
template <Ordered T>
void require_state(const State<T>& state) {
  if (!scalar::is_finite(state.p_WB) || !scalar::is_finite(state.v_WB) || !scalar::is_finite(state.L_W)) [[unlikely]] {
    const auto require_each = [](const char* argument, const Vec3<T>& v) {
      for (const T& coordinate : v) {
        require(scalar::is_finite(coordinate), argument, coordinate, "must be finite");
      }
    };
    require_each("position", state.p_WB);
    require_each("velocity", state.v_WB);
    require_each("angular momentum", state.L_W);
  }
  require_unit(state.q_WB);
}

namespace formula {

/// A vector of W in B: q_WB⁻¹ v_W.
template <Field T>
[[nodiscard]] Vec3<T> in_body(const Quat<T>& q_WB, const Vec3<T>& v_W) {
  return q_WB.conjugate() * v_W;
}

/// Angular velocity in B   [rad/s]: ω_B = I⁻¹ L_B.
template <Field T>
[[nodiscard]] Vec3<T> angular_velocity_B(const State<T>& state, const RigidBody<T>& body) {
  return formula::in_body(state.q_WB, state.L_W).cwiseQuotient(body.moments);
}

/// Angular velocity in W   [rad/s].
template <Field T>
[[nodiscard]] Vec3<T> angular_velocity_W(const State<T>& state, const RigidBody<T>& body) {
  return state.q_WB * formula::angular_velocity_B(state, body);
}

/// Angular momentum in W of a body that turns with ω_B   [kg m²/s]: q_WB (I ω_B).
template <Field T>
[[nodiscard]] Vec3<T> angular_momentum_W(const Quat<T>& q_WB, const RigidBody<T>& body, const Vec3<T>& w_WB_B) {
  return q_WB * Vec3<T>(body.moments.cwiseProduct(w_WB_B));
}

}  // namespace formula

}  // namespace goishi
