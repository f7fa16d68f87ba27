#pragma once
/// \file
/// How far a computed flight is off: attitude, what it must keep, path. All differences in more digits.

#include <algorithm>
#include <cmath>
#include <goishi/motion/free_flight.hpp>

#include "verify/claims/checks.hpp"
#include "verify/oracles/motion/free_body.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/flight.hpp"

namespace goishi::verify {

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
  return formula::free_rotation<Real>(q, L, formula::axial_momentum(q, L), formula::mobility(moments), Real(top.time));
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

/// The relative errors of |L| after a flight, in ε, and of the energy of rotation, in ε √max(1, I_t/I_a).
template <class T, class Describe>
void see_kept(const Context& context, Checks& checks, const Top<T>& top, const State<T>& after, Describe&& describe) {
  const Kept right = kept(top.state.q_WB.template cast<Quad>().normalized(), top.state.L_W, top.moments);
  const Kept left = kept(Quat<Quad>(produced(context, after.q_WB).template cast<Quad>()), after.L_W, top.moments);
  const double slender = std::max(1.0, static_cast<double>(top.moments.transverse / top.moments.axial));
  const auto see = [&](const char* check, const Quad& now, const Quad& before, double allowed) {
    const double error = static_cast<double>(before == 0 ? now : Quad(abs(Quad(now / before - 1))));
    checks[check].see(error, allowed, describe);
  };
  see("momentum", left.momentum, right.momentum, epsilon_of<T>);
  see("energy", left.energy, right.energy, epsilon_of<T> * std::sqrt(slender));
}

/// Position and velocity, coordinate by coordinate, in ε (|p| + |v t| + |g t²/2|) and ε (|v| + |g t|).
template <class T, class Describe>
void see_path(const Context& context, Checks& checks, const State<T>& start, const Vec3<T>& gravity, T time,
              const State<T>& after, Describe&& describe) {
  for (int i = 0; i < 3; ++i) {
    const Quad p = start.p_WB[i], v = start.v_WB[i], g = gravity[i], t = time;
    const auto see = [&](const char* check, const T& computed, const Quad& right, const Quad& parts) {
      const Quad off = abs(Quad(Quad(context.produced(computed)) - right));
      checks[check].see(static_cast<double>(off == 0 ? off : Quad(off / parts)), epsilon_of<T>, describe);
    };
    see("place", after.p_WB[i], Quad(p + v * t + g * t * t / 2), Quad(abs(p) + abs(v * t) + abs(g * t * t / 2)));
    see("velocity", after.v_WB[i], Quad(v + g * t), Quad(abs(v) + abs(g * t)));
  }
}

}  // namespace goishi::verify
