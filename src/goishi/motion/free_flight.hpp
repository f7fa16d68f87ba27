#pragma once
/// \file
/// Free flight of a body with a symmetry axis, exactly: no time step.

#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>

namespace goishi {

/// What free rotation asks of a body with a symmetry axis. Made by `make_top_rates`, once per body.
template <class T>
struct TopRates {
  T precession = scalar::unset<T>();  // 1/I_t [1/(kg m²)]
  T spin = scalar::unset<T>();        // 1/I_a − 1/I_t [1/(kg m²)]
};

namespace formula {

/// The centre of mass after a time t under constant gravity: p + v t + g t²/2, v + g t. Attitude and L_W stay.
/// Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] State<T> ballistic_flight(const State<T>& state, const Vec3<T>& gravity, const T& t) {
  const Vec3<T> gain = t * gravity;
  return {.p_WB = state.p_WB + t * (state.v_WB + gain / T(2)),
          .q_WB = state.q_WB,
          .v_WB = state.v_WB + gain,
          .L_W = state.L_W};
}

/// Rates of a torque-free top per unit of momentum, once per body: |L| · `precession` about L, L_z · `spin` about Bz.
///
///     precession = 1/I_t,   spin = 1/I_a − 1/I_t = (I_t − I_a) / (I_t I_a)
///
/// Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] TopRates<T> top_rates(const Moments<T>& moments) {
  const T precession = T(1) / moments.transverse;
  return {.precession = precession, .spin = T((moments.transverse - moments.axial) / moments.axial * precession)};
}

/// The attitude of a torque-free symmetric top after a time t: a rotation about L in the world, and one about the
/// symmetry axis in the body.
///
///     q(t) = exp(L t / I_t) q(0) exp(Bz L_z t (1/I_a − 1/I_t)),   L_z = L · q(0) Bz
///
/// Limits  L = 0, I_a = I_t, t <= 0: no special cases.   Proof  derivations/free_flight.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> free_rotation(const Quat<T>& q_WB, const Vec3<T>& L_W, const T& axial_momentum,
                                    const TopRates<T>& rates, const T& t) {
  const Quat<T> q = formula::reunited(q_WB);  // so that no chain of flights leaves the unit sphere
  const T half_spin = axial_momentum * (t * rates.spin) / T(2);
  const auto [s, c] = scalar::sincos(half_spin);
  const Quat<T> spun(T(c * q.w() - s * q.z()), T(c * q.x() + s * q.y()), T(c * q.y() - s * q.x()),
                     T(c * q.z() + s * q.w()));
  const T time = t * rates.precession;
  const Quat<T> precession = formula::rotation_exp(Vec3<T>(T(time * L_W.x()), T(time * L_W.y()), T(time * L_W.z())));
  return formula::product(precession, spun);
}

/// The momentum about the symmetry axis, L · q Bz   [kg m²/s].   Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] T axial_momentum(const Quat<T>& q_WB, const Vec3<T>& L_W) {
  const Vec3<T> u = formula::symmetry_axis(formula::reunited(q_WB));
  return L_W.x() * u.x() + L_W.y() * u.y() + L_W.z() * u.z();
}

/// Both: the whole state after a time t.   Proof  derivations/free_flight.cpp.
template <Elementary T>
[[nodiscard]] State<T> free_flight(const State<T>& state, const TopRates<T>& rates, const Vec3<T>& gravity,
                                   const T& t) {
  const T axial_momentum = formula::axial_momentum(state.q_WB, state.L_W);
  const Vec3<T> gain = t * gravity;
  return {.p_WB = state.p_WB + t * (state.v_WB + gain / T(2)),
          .q_WB = formula::free_rotation(state.q_WB, state.L_W, axial_momentum, rates, t),
          .v_WB = state.v_WB + gain,
          .L_W = state.L_W};
}

}  // namespace formula

namespace detail {

/// L_z for the spin. A needle (I_a below I_t/4) turns ε |L| of round-off in it into a large error of L_z/I_a, so there
/// it is taken in the next wider type.
template <Ordered T>
[[nodiscard]] T axial_momentum(const Quat<T>& q_WB, const Vec3<T>& L_W, const TopRates<T>& rates) {
  if (T(3) * rates.precession < rates.spin) {
    using Wide = scalar::wider_t<T>;
    return T(formula::axial_momentum(Quat<Wide>(q_WB.template cast<Wide>()), Vec3<Wide>(L_W.template cast<Wide>())));
  }
  return formula::axial_momentum(q_WB, L_W);
}

template <Ordered T>
void require_counted(const State<T>& state, const T& t) {
  const bool counted = scalar::is_finite(state.p_WB) && scalar::is_finite(state.v_WB);
  require(T(0) < state.q_WB.squaredNorm() && counted, "time", t,
          "must not take the body farther than its arithmetic can count");
}

}  // namespace detail

/// What of the motion a scene needs. The talk's dynamics demo shows the three of them.
enum class Freedom { linear, angular, both };

/// The rates of a body with a symmetry axis, to be kept where many of its flights are asked for.
/// Domain  0 < I_a <= 2 I_t, finite, and so the rates; else InvalidArgument.
template <Ordered T>
[[nodiscard]] TopRates<T> make_top_rates(const Moments<T>& moments) {
  require_physical(moments);
  TopRates<T> rates = formula::top_rates(moments);
  require(scalar::is_finite(T(rates.precession + rates.spin)), "axial", moments.axial,
          "must not be so small that its inverse is no number");
  return rates;
}

/// The state of a stone after it has flown freely for a time t, in closed form. Gravity is the vector in W
/// (`gravity_W()`).
///
/// Domain  a finite state whose attitude is a unit quaternion; rates of `make_top_rates`; finite gravity; any finite t,
///         negative ones too, with which position, velocity, t/I and the squares of the angles do not overflow (DOMAIN-5); else
///         InvalidArgument.
/// Error   attitude <= 8 ε (1 + |L| t / I_t + |ω_z t (1 − I_a/I_t)|) rad for I_a >= I_t/1000, thinner needles lose in
///         proportion (FLIGHT-1); |L| within 16 ε, energy of rotation within 16 ε √max(1, I_t/I_a), for every t (FLIGHT-2).
/// Cost    two pairs of sine and cosine, one root.
/// Proof   derivations/free_flight.cpp.
template <Ordered T>
[[nodiscard]] State<T> free_flight(const State<T>& state, const TopRates<T>& rates, const Vec3<T>& gravity, const T& t,
                                   Freedom freedom = Freedom::both) {
  require_state(state);
  require(scalar::is_finite(gravity), "gravity", gravity.transpose(), "must be finite");
  require(scalar::is_finite(t), "time", t, "must be finite");
  State<T> result = freedom == Freedom::angular ? state : formula::ballistic_flight(state, gravity, t);
  if (freedom != Freedom::linear) {
    const T axial_momentum = detail::axial_momentum(state.q_WB, state.L_W, rates);
    result.q_WB = formula::free_rotation(state.q_WB, state.L_W, axial_momentum, rates, t);
  }
  detail::require_counted(result, t);
  return result;
}

/// The same, from the moments.
template <Ordered T>
[[nodiscard]] State<T> free_flight(const State<T>& state, const Moments<T>& moments, const Vec3<T>& gravity, const T& t,
                                   Freedom freedom = Freedom::both) {
  return free_flight(state, make_top_rates(moments), gravity, t, freedom);
}

}  // namespace goishi
