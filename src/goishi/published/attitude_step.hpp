#pragma once
/// \file
/// How the talk's loop turns a body in one step, for comparison only: it keeps the angular velocity, not the angular
/// momentum. Its semi-implicit Euler step of the position is also that of `Scheme::explicit_euler`, in motion/steppers.hpp.

#include <goishi/motion/state.hpp>
#include <goishi/motion/step_formulas.hpp>

namespace goishi::detail {

template <class T>
struct PublishedTurn {
  Quat<T> q_WB;  // 0, not a unit, where its square overflowed
  Vec3<T> L_W;
};

/// Explicit Euler with ω, renormalised. ω stays, so the angular momentum goes round with the body (claim PUBLISHED-7).
template <Ordered T>
[[nodiscard]] PublishedTurn<T> published_turn(const Quat<T>& q, const Vec3<T>& w_WB, const RigidBody<T>& body,
                                              const T& dt) {
  const Quat<T> next = detail::normalized(formula::raw_euler_attitude(q, w_WB, dt));
  const Vec3<T> L_W = formula::angular_momentum_W(next, body, formula::in_body(next, w_WB));
  return {.q_WB = next, .L_W = L_W};
}

}  // namespace goishi::detail
