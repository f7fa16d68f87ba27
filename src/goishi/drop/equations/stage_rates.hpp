#pragma once
/// \file
/// The forces of rolling and of dry slip where nothing else is asked: at the inner stages of a step. They are those of
/// `rolling_force` and `slip_rate`, without the contact matrix, whose inverse is known. (Claim DROP-34 holds the two
/// against each other.)

#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/slip.hpp>

namespace goishi {

/// A motion in contact, and what the contact matrix is made of: W = λ 1 − r rᵀ/I_t + (1/I_a − 1/I_t) c cᵀ.
template <class T>
struct StageMotion : ContactTurn<T> {
  Vec3<T> torque, brake;  // of resistance, as in `Kinetics`
  Vec3<T> c;              // [m] r × u, which is horizontal
  T lambda;               // 1 + |r|²/I_t
  T lambda_c;             // lambda + (1/I_a − 1/I_t) |c|²
};

namespace formula {

/// Of a motion and the resistance against it.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline StageMotion<T> stage_motion(const Mobility<T>& mobility, const ContactTurn<T>& turn,
                                                 const Vec3<T>& torque, const Vec3<T>& brake) {
  StageMotion<T> at;
  static_cast<ContactTurn<T>&>(at) = turn;
  at.torque = torque;
  at.brake = brake;
  const Vec3<T>&r = turn.r, &u = turn.u;
  at.c = {T(r.y() * u.z() - r.z() * u.y()), T(r.z() * u.x() - r.x() * u.z()), T(0)};
  at.lambda = T(1) + mobility.transverse * formula::dot(r, r);
  at.lambda_c = at.lambda + mobility.axial * (scalar::sq(at.c.x()) + scalar::sq(at.c.y()));
  return at;
}

/// W_zz.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_stiffness(const Mobility<T>& mobility, const StageMotion<T>& at) {
  return at.lambda - mobility.transverse * scalar::sq(at.r.z());
}

/// W⁻¹ q = (q + (r · q) r/I_t − (1/I_a − 1/I_t)(c · q)/λ_c c)/λ.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> stage_solution(const Mobility<T>& mobility, const StageMotion<T>& at, const Vec3<T>& q) {
  const T over = T(1) / at.lambda, alpha = mobility.transverse * formula::dot(at.r, q);
  const T beta = mobility.axial / at.lambda_c * (at.c.x() * q.x() + at.c.y() * q.y());
  return {T(over * (q.x() + alpha * at.r.x() - beta * at.c.x())),
          T(over * (q.y() + alpha * at.r.y() - beta * at.c.y())), T(over * (q.z() + alpha * at.r.z()))};
}

/// λ (1 + ẑ · W⁻¹ b), b = J τ × r: the room that resistance leaves a normal force.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_room(const StageMotion<T>& at) {
  return at.lambda + at.brake.z();
}

/// λ ẑ · W⁻¹ need: the normal force of rolling, times that room.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_weight(const Mobility<T>& mobility, const StageMotion<T>& at) {
  return at.need.z() + mobility.transverse * formula::dot(at.r, at.need) * at.r.z();
}

/// The force that keeps the contact point at rest.
/// Domain  `stage_room` and `stage_weight` > 0: else the contact jams or pulls, and `rolling_force` has to say.
/// Proof   derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> stage_rolling_force(const Mobility<T>& mobility, const StageMotion<T>& at) {
  const T N = formula::stage_weight(mobility, at) / formula::stage_room(at);
  return formula::stage_solution(mobility, at, formula::plus(at.need, T(-N), at.brake));
}

/// The rates of the slip under dry friction: p = W (−μ c, −μ s, 1) + b, and how it changes with φ.
/// Domain  as `slip_rate`.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline SlipRate<T> stage_slip(const Mobility<T>& mobility, const StageMotion<T>& at, const T& mu,
                                            const T& c, const T& s) {
  const T &t = mobility.transverse, &a = mobility.axial;
  const Vec3<T>& r = at.r;
  const T mu_c = mu * c, mu_s = mu * s;
  const T pressed = t * (r.z() - (r.x() * mu_c + r.y() * mu_s)), rubbed = a * (at.c.x() * mu_c + at.c.y() * mu_s);
  const Vec3<T> p(T(at.brake.x() - at.lambda * mu_c - pressed * r.x() - rubbed * at.c.x()),
                  T(at.brake.y() - at.lambda * mu_s - pressed * r.y() - rubbed * at.c.y()),
                  T(at.brake.z() + at.lambda - pressed * r.z()));
  const T turned = t * (r.x() * mu_s - r.y() * mu_c), crossed = a * (at.c.x() * mu_s - at.c.y() * mu_c);
  const Vec3<T> p_slope(T(at.lambda * mu_s - turned * r.x() + crossed * at.c.x()),
                        T(-(at.lambda * mu_c) - turned * r.y() + crossed * at.c.y()), T(-(turned * r.z())));
  return formula::slip_under(p, p_slope, at.need, c, s);
}

}  // namespace formula

namespace detail {

template <Ordered T>
[[nodiscard]] inline StageMotion<T> stage_motion(const ContactBody<T>& body, Feature feature, const Variables<T>& y) {
  const Vec3<T> u = axis_of(y);
  const ContactTurn<T> turn =
      formula::contact_turn(body.mobility, body.gravity, geometry_of(body.stone, feature, u), u, momentum_of(y));
  const Vec3<T> torque = body.resists ? resistance_torque(body, turn.w) : Vec3<T>(Vec3<T>::Zero());
  return formula::stage_motion(body.mobility, turn, torque, formula::turned_point(body.mobility, u, turn.r, torque));
}

}  // namespace detail
}  // namespace goishi
