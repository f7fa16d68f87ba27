#pragma once
/// \file
/// Elliptic integrals and functions of balls, by Arb: what the library computes of them is cut off where its scalar no longer
/// tells, and a ball would not know. With these in their place Jacobi's solution encloses. Included before it is used.

#include <acb_elliptic.h>
#include <acb_modular.h>

#include <goishi/motion/elliptic.hpp>

#include "verify/oracles/numbers/ordered_ball.hpp"

namespace goishi::verify::reference {

/// Arb's complex balls, freed together.
class ComplexBalls {
 public:
  static constexpr slong count = 8;
  ComplexBalls() : values_(_acb_vec_init(count)) {}
  ComplexBalls(const ComplexBalls&) = delete;
  ComplexBalls& operator=(const ComplexBalls&) = delete;
  ~ComplexBalls() { _acb_vec_clear(values_, count); }
  [[nodiscard]] acb_ptr operator[](int i) { return values_ + i; }
  void set(int i, const OrderedBall& x) { acb_set_arb(values_ + i, x.ball().get()); }
  [[nodiscard]] OrderedBall real(int i) const {
    Ball result;
    arb_set(result.get(), acb_realref(values_ + i));
    return OrderedBall(result);
  }

 private:
  acb_ptr values_;
};

}  // namespace goishi::verify::reference

namespace goishi::elliptic {

template <>
inline verify::OrderedBall carlson_f<verify::OrderedBall>(verify::OrderedBall x, verify::OrderedBall y,
                                                          verify::OrderedBall z) {
  verify::reference::ComplexBalls balls;
  balls.set(0, x);
  balls.set(1, y);
  balls.set(2, z);
  acb_elliptic_rf(balls[3], balls[0], balls[1], balls[2], 0, verify::Ball::precision);
  return balls.real(3);
}

template <>
inline verify::OrderedBall carlson_j<verify::OrderedBall>(verify::OrderedBall x, verify::OrderedBall y,
                                                          verify::OrderedBall z, verify::OrderedBall p) {
  verify::reference::ComplexBalls balls;
  balls.set(0, x);
  balls.set(1, y);
  balls.set(2, z);
  balls.set(3, p);
  acb_elliptic_rj(balls[4], balls[0], balls[1], balls[2], balls[3], 0, verify::Ball::precision);
  return balls.real(4);
}

/// By theta functions of the nome: with τ = i K'/K and z = u/(2K),
/// sn = (θ₃ θ₁(z))/(θ₂ θ₄(z)), cn = (θ₄ θ₂(z))/(θ₂ θ₄(z)), dn = (θ₄ θ₃(z))/(θ₃ θ₄(z)), and K = π/(2 agm(1, √m₁)).
template <>
class JacobiFunctions<verify::OrderedBall> {
  using T = verify::OrderedBall;

 public:
  explicit JacobiFunctions(const T& m1) : m1_(m1) {}

  [[nodiscard]] T quarter_period() const { return quarter_period_of(m1_); }

  [[nodiscard]] Jacobi<T> operator()(const T& u) const {
    const T K = quarter_period();
    verify::reference::ComplexBalls balls;  // θ₁ … θ₄ at z, z, τ
    balls.set(4, u / (T(2) * K));
    arb_set(acb_imagref(balls[5]), (quarter_period_of(T(1) - m1_) / K).ball().get());
    const auto thetas = [&] {
      acb_modular_theta(balls[0], balls[1], balls[2], balls[3], balls[4], balls[5], verify::Ball::precision);
      return std::array<T, 4>{balls.real(0), balls.real(1), balls.real(2), balls.real(3)};
    };
    const std::array<T, 4> at_u = thetas();
    balls.set(4, T(0));
    const std::array<T, 4> at_0 = thetas();
    return {.sn = at_0[2] * at_u[0] / (at_0[1] * at_u[3]),
            .cn = at_0[3] * at_u[1] / (at_0[1] * at_u[3]),
            .dn = at_0[3] * at_u[2] / (at_0[2] * at_u[3])};
  }

 private:
  [[nodiscard]] static T quarter_period_of(const T& m1) {
    verify::Ball mean;
    arb_agm(mean.get(), verify::Ball(1).get(), scalar::sqrt(m1).ball().get(), verify::Ball::precision);
    return scalar::pi<T>() / (T(2) * T(mean));
  }
  T m1_;
};

}  // namespace goishi::elliptic
