#pragma once
/// \file
/// The rates of a contact where nothing else is asked: at the inner stages of a step. They are those of `contact_rates`
/// under `rolling_force` or `slip_rate`, put together so that what does not reach a rate is not computed, no matrix is
/// built, and few divisions are left. (Claim DROP-34 holds the two against each other.)

#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/slip.hpp>

namespace goishi {

/// What these rates are made of. With ν = (δ² ω_h, κ² ω_z), a normal force N, and M = N/root, the torque of
/// resistance is −M ν and what it does to the contact point −M J ν × r.
template <class T>
struct StageMotion {
  Vec3<T> u, L, w, u_rate, r, need;  // as in `ContactMotion`
  Vec3<T> c;                         // [m] r × u
  Vec3<T> nu;                        // [m²/s] ν
  Vec3<T> braked;                    // [m/s] J ν × r, per unit of mass
  T root;                            // [m/s] √(ν · ω + floor); 1 without resistance
  T spin_rate;                       // [1/s] ω · u
  T lambda;                          // 1 + |r|²/I_t
  T lambda_c;                        // lambda + (1/I_a − 1/I_t) |c|²
};

namespace formula {

/// Domain  as `contact_motion`; δ² = κ² = 0 without resistance.   Proof  derivations/stage_rates.cpp.
template <Elementary T>
[[nodiscard]] inline StageMotion<T> stage_motion(const Mobility<T>& mobility, const Vec3<T>& gravity,
                                                 const ContactGeometry<T>& geometry, const Vec3<T>& u, const Vec3<T>& L,
                                                 bool resists, const T& delta_square, const T& kappa_square,
                                                 const T& floor) {
  StageMotion<T> at;
  const T &t = mobility.transverse, &a = mobility.axial;
  at.u = u;
  at.L = L;
  const T momentum = formula::dot(u, L), along = a * momentum;
  at.w = formula::combination(t, L, along, u);
  at.spin_rate = (t + a) * momentum;
  at.u_rate = formula::scaled(t, formula::cross(L, u));
  at.r = {T(-(geometry.slope * u.x())), T(-(geometry.slope * u.y())), T(-geometry.height)};
  const T turn = geometry.curvature * at.u_rate.z();
  const Vec3<T> r_rate(T(-(turn * u.x() + geometry.slope * at.u_rate.x())),
                       T(-(turn * u.y() + geometry.slope * at.u_rate.y())), T(-(geometry.slope * at.u_rate.z())));
  const Vec3<T> gyration = formula::cross(at.u_rate, at.r), swept = formula::cross(at.w, r_rate);
  at.need = {T(-(gravity.x() + along * gyration.x() + swept.x())), T(-(gravity.y() + along * gyration.y() + swept.y())),
             T(-(gravity.z() + along * gyration.z() + swept.z()))};
  const T lever = geometry.height - geometry.slope * u.z();
  at.c = {T(lever * u.y()), T(-(lever * u.x())), T(0)};
  at.lambda = T(1) + t * formula::dot(at.r, at.r);
  at.lambda_c = at.lambda + a * (scalar::sq(at.c.x()) + scalar::sq(at.c.y()));
  at.nu = {T(delta_square * at.w.x()), T(delta_square * at.w.y()), T(kappa_square * at.w.z())};
  at.root = resists ? scalar::sqrt(T(formula::dot(at.nu, at.w) + floor)) : T(1);
  at.braked = formula::combination(t, formula::cross(at.nu, at.r), T(-(a * formula::dot(u, at.nu))), at.c);
  return at;
}

/// λ root (1 + ẑ · W⁻¹ b), b = J τ × r: the room that resistance leaves a normal force.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_room(const StageMotion<T>& at) {
  return at.lambda * at.root - at.braked.z();
}

/// W_zz.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_stiffness(const Mobility<T>& mobility, const StageMotion<T>& at) {
  return at.lambda - mobility.transverse * scalar::sq(at.r.z());
}

/// The rates of the slip under dry friction; `denominator` is that of `slip_rate`.
/// Domain  as `slip_rate`.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline SlipRate<T> stage_slip(const Mobility<T>& mobility, const StageMotion<T>& at, const T& mu,
                                            const T& c, const T& s) {
  const T &t = mobility.transverse, &a = mobility.axial;
  const T over_root = T(1) / at.root;
  const Vec3<T>& r = at.r;
  const T r_along = r.x() * c + r.y() * s, r_across = r.x() * s - r.y() * c;
  const T c_along = a * (at.c.x() * c + at.c.y() * s), c_across = a * (at.c.x() * s - at.c.y() * c);
  const T pressed = t * (r.z() - mu * r_along), rubbed = mu * c_along;
  SlipRate<T> rate;
  rate.denominator = at.lambda - pressed * r.z() - at.braked.z() * over_root;
  const T over = T(1) / rate.denominator;
  rate.N = at.need.z() * over;
  // W (−μ c, −μ s, 1) + b, and how it changes with φ.
  const T p_x = -(mu * at.lambda * c) - pressed * r.x() - rubbed * at.c.x() - at.braked.x() * over_root;
  const T p_y = -(mu * at.lambda * s) - pressed * r.y() - rubbed * at.c.y() - at.braked.y() * over_root;
  const T turned = mu * t * r_across, crossed = mu * c_across;
  const T q_x = mu * at.lambda * s - turned * r.x() + crossed * at.c.x();
  const T q_y = -(mu * at.lambda * c) - turned * r.y() + crossed * at.c.y();
  const T N_slope = rate.N * over * turned * r.z();
  const T a_x = rate.N * p_x - at.need.x(), a_y = rate.N * p_y - at.need.y();
  rate.along = a_x * c + a_y * s;
  rate.across = a_y * c - a_x * s;
  const T b_x = N_slope * p_x + rate.N * q_x, b_y = N_slope * p_y + rate.N * q_y;
  rate.across_slope = b_y * c - b_x * s - rate.along;
  return rate;
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

/// All rates but the slip's, of a contact point that slips with (s_x, s_y) under a force F, F_z = M root.
/// Domain  as `contact_rates`.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline detail::Variables<T> stage_rates(const Mobility<T>& mobility, const StageMotion<T>& at,
                                                      const T& damping, const Vec3<T>& force, const T& M, const T& s_x,
                                                      const T& s_y, const Vec3<T>& origin) {
  const Vec3<T> moment = formula::cross(at.r, force);
  const T v_x = s_x - (at.w.y() * at.r.z() - at.w.z() * at.r.y());
  const T v_y = s_y - (at.w.z() * at.r.x() - at.w.x() * at.r.z());
  const T v_z = at.w.y() * at.r.x() - at.w.x() * at.r.y();
  // a · (u × u̇) = (a · L − (u · L)(a · u))/I_t
  const T facing = formula::dot(origin, at.u);
  const T swing = mobility.transverse * (formula::dot(origin, at.L) - formula::dot(at.u, at.L) * facing);
  const T moves = formula::dot(at.L, at.w) + scalar::sq(v_x) + scalar::sq(v_y) + scalar::sq(v_z);
  const T lost = M * formula::dot(at.nu, at.w) - (force.x() * s_x + force.y() * s_y) + damping * moves;
  return {at.u_rate.x(),
          at.u_rate.y(),
          at.u_rate.z(),
          v_x,
          v_y,
          T(at.spin_rate + swing / (T(1) + facing)),
          lost,
          T(moment.x() - M * at.nu.x() - damping * at.L.x()),
          T(moment.y() - M * at.nu.y() - damping * at.L.y()),
          T(moment.z() - M * at.nu.z() - damping * at.L.z()),
          T(0),
          T(0)};
}

/// λ ẑ · W⁻¹ need: the normal force of rolling, times `stage_room`/root.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline T stage_weight(const Mobility<T>& mobility, const StageMotion<T>& at) {
  return at.need.z() + mobility.transverse * formula::dot(at.r, at.need) * at.r.z();
}

/// The rates of rolling.
/// Domain  `stage_room` and `stage_weight` > 0: else the contact jams or pulls, and `rolling_force` has to say.   Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline detail::Variables<T> stage_rolling(const Mobility<T>& mobility, const StageMotion<T>& at,
                                                        const T& damping, const Vec3<T>& origin) {
  const T M = formula::stage_weight(mobility, at) / formula::stage_room(at);
  const Vec3<T> force = formula::stage_solution(mobility, at, formula::plus(at.need, M, at.braked));
  return formula::stage_rates<T>(mobility, at, damping, force, M, T(0), T(0), origin);
}

/// The rates under dry friction in the direction (c, s), of a slip σ   [m/s], but the slip's own.
/// Proof  derivations/stage_rates.cpp.
template <Field T>
[[nodiscard]] inline detail::Variables<T> stage_sliding(const Mobility<T>& mobility, const StageMotion<T>& at,
                                                        const SlipRate<T>& slip, const T& mu, const T& c, const T& s,
                                                        const T& sigma, const T& damping, const Vec3<T>& origin) {
  const T drag = mu * slip.N;
  return formula::stage_rates<T>(mobility, at, damping, formula::friction_force(slip.N, drag, c, s),
                                 T(slip.N / at.root), T(sigma * c), T(sigma * s), origin);
}

}  // namespace formula

namespace detail {

template <Ordered T>
[[nodiscard]] inline StageMotion<T> stage_motion(const ContactBody<T>& body, Feature feature, const Variables<T>& y) {
  const Vec3<T> u = axis_of(y);
  return formula::stage_motion<T>(body.mobility, body.gravity, geometry_of(body.stone, feature, u), u, momentum_of(y),
                                  body.resists, body.resists ? scalar::sq(body.rolling_resistance) : T(0),
                                  body.resists ? scalar::sq(body.pivot_radius) : T(0), resistance_floor(body));
}

}  // namespace detail
}  // namespace goishi
