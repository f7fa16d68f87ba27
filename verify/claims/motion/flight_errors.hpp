#pragma once
/// \file
/// How far a computed flight is off: attitude, what it must keep, path. All differences in more digits.

#include <algorithm>
#include <cmath>
#include <goishi/motion/free_flight.hpp>
#include <limits>

#include "verify/oracles/motion/free_body.hpp"
#include "verify/samples/flight.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify {

template <class T>
inline constexpr double epsilon_of = static_cast<double>(std::numeric_limits<T>::epsilon());

/// NaN if either is: std::max may lose one.
[[nodiscard]] inline double larger(double a, double b) {
  return a <= b ? b : b <= a ? a : std::numeric_limits<double>::quiet_NaN();
}

/// The vector part changed relatively: of the length 1 it would only be another quaternion of the same attitude.
template <class T>
[[nodiscard]] Quat<T> produced(const Context& context, const Quat<T>& q) {
  const auto part = [&](const T& coordinate) { return context.produced(coordinate); };
  return {q.w(), part(q.x()), part(q.y()), part(q.z())};
}

/// The production formula in more digits, q/|q| for q.
template <class Real, class T>
[[nodiscard]] Quat<Real> exact_attitude(const Top<T>& top) {
  const Quat<Real> q = top.state.q_WB.template cast<Real>().normalized();
  const Vec3<Real> L = top.state.L_W.template cast<Real>();
  const Moments<Real> moments{.axial = Real(top.moments.axial), .transverse = Real(top.moments.transverse)};
  return formula::free_rotation<Real>(q, L, formula::axial_momentum(q, L), formula::top_rates(moments), Real(top.time));
}

/// The angle of the rotation between two attitudes, as 2 sin(angle/2); neither needs to be of length 1.
template <class Real>
[[nodiscard]] double angle_between(const Quat<Real>& one, const Quat<Real>& other) {
  const Real w = one.w(), x = one.x(), y = one.y(), z = one.z();
  const Real w_ = other.w(), x_ = other.x(), y_ = other.y(), z_ = other.z();
  const Vec3<Real> turn(Real(w * x_ - x * w_ - y * z_ + z * y_), Real(w * y_ - y * w_ - z * x_ + x * z_),
                        Real(w * z_ - z * w_ - x * y_ + y * x_));
  return static_cast<double>(Real(Real(2) * turn.norm() / (one.norm() * other.norm())));
}

/// The angle between a computed and the true attitude, in ε (1 + phase).
template <class Real, class T>
[[nodiscard]] double attitude_error(const Quat<T>& computed, const Quat<Real>& expected, const Top<T>& top) {
  return part_of(angle_between(Quat<Real>(computed.template cast<Real>()), expected),
                 epsilon_of<T> * (1.0 + phase(top)));
}

/// Energy of rotation and momentum in B, from q* L q as the quaternion is: if it is not of length 1, that is an error.
struct Kept {
  Quad momentum;
  Quad energy;
};

template <class T>
[[nodiscard]] Kept kept(const Quat<Quad>& q, const Vec3<T>& L_W, const Moments<T>& moments) {
  const Quat<Quad> L(Quad(0), Quad(L_W.x()), Quad(L_W.y()), Quad(L_W.z()));
  const Quat<Quad> L_B = q.conjugate() * L * q;
  const Quad across = L_B.x() * L_B.x() + L_B.y() * L_B.y();
  const Quad along = L_B.z() * L_B.z();
  return {.momentum = sqrt(Quad(across + along)),
          .energy = across / (2 * Quad(moments.transverse)) + along / (2 * Quad(moments.axial))};
}

/// The relative errors of energy of rotation and |L| after a flight, in ε √max(1, I_t/I_a).
template <class T>
[[nodiscard]] double loss(const Context& context, const Top<T>& top, const State<T>& after) {
  const Kept right = kept(top.state.q_WB.template cast<Quad>().normalized(), top.state.L_W, top.moments);
  const Kept left = kept(Quat<Quad>(produced(context, after.q_WB).template cast<Quad>()), after.L_W, top.moments);
  if (right.momentum == 0) {
    return static_cast<double>(left.momentum);
  }
  const double momentum = static_cast<double>(Quad(left.momentum / right.momentum - 1));
  const double energy = static_cast<double>(Quad(left.energy / right.energy - 1));
  const double slender = std::max(1.0, static_cast<double>(top.moments.transverse / top.moments.axial));
  return larger(std::fabs(momentum), std::fabs(energy) / std::sqrt(slender)) / epsilon_of<T>;
}

/// Position and velocity, coordinate by coordinate, in ε (|p| + |v t| + |g t²/2|) and ε (|v| + |g t|).
template <class T>
[[nodiscard]] double path_error(const Context& context, const State<T>& start, const Vec3<T>& gravity, T time,
                                const State<T>& after) {
  double error = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Quad p = start.p_WB[i], v = start.v_WB[i], g = gravity[i], t = time;
    const Quad p_off = Quad(context.produced(after.p_WB[i])) - (p + v * t + g * t * t / 2);
    const Quad v_off = Quad(context.produced(after.v_WB[i])) - (v + g * t);
    error = larger(error, static_cast<double>(Quad(abs(p_off) / (abs(p) + abs(v * t) + abs(g * t * t / 2)))));
    error = larger(error, static_cast<double>(Quad(abs(v_off) / (abs(v) + abs(g * t)))));
  }
  return error / epsilon_of<T>;
}

}  // namespace goishi::verify
