#pragma once
/// \file
/// Bodies with a symmetry axis in free flight, over the corners of the domain.

#include <cmath>
#include <goishi/motion/batch.hpp>
#include <goishi/motion/free_flight.hpp>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "verify/samples/stone.hpp"

namespace goishi::verify {

/// Values in T's own grid, to be taken as exact; the attitude is that of q/|q|.
template <class T>
struct Top {
  Moments<T> moments;
  State<T> state;
  T time;
};

/// In unit attitude q_WB, turning with ω_B, at the origin, at rest.
template <class T>
[[nodiscard]] State<T> spinning(const Quat<T>& q_WB, const Moments<T>& moments, const Vec3<T>& w_B) {
  const Vec3<T> L_B(moments.transverse * w_B.x(), moments.transverse * w_B.y(), moments.axial * w_B.z());
  return {.p_WB = Vec3<T>::Zero(), .q_WB = q_WB, .v_WB = Vec3<T>::Zero(), .L_W = q_WB * L_B};
}

/// Moments with I_t near 1e-5 kg m²: as of stones, near the ball (|1 − I_a/I_t| from 1e-9, or one ulp of T), needles
/// (I_a/I_t to 1e-3), thin (I_a = 2 I_t), any, the ball. Not `with_needles`: 4 I_a >= I_t.
template <class T>
[[nodiscard]] Moments<T> draw_moments(std::mt19937_64& random, int i, bool with_needles = true) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const T transverse = static_cast<T>(1e-5 * (1.0 + unit(random)));
  const double u = unit(random);
  switch (i % 6) {
    case 0:
      return {.axial = transverse * static_cast<T>(1.2 + 0.7 * u), .transverse = transverse};
    case 1: {
      const T off = static_cast<T>(std::pow(10.0, -9.0 * u));
      return {.axial = transverse * (i % 4 < 2 ? T(1) + off : T(1) - off / T(2)), .transverse = transverse};
    }
    case 2:
      return {.axial = transverse * static_cast<T>(with_needles ? std::pow(10.0, -3.0 * u) : 0.25 + 0.75 * u),
              .transverse = transverse};
    case 3:
      return {.axial = T(2) * transverse, .transverse = transverse};
    case 4:
      return {.axial = transverse * static_cast<T>(0.25 + 1.75 * u), .transverse = transverse};
    default:
      return {.axial = transverse, .transverse = transverse};
  }
}

/// A unit direction in B: any, along the axis (to 1e-12), across it.
template <class T>
[[nodiscard]] Vec3<T> draw_direction(std::mt19937_64& random, int i) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Vec3<double> direction(normal(random), normal(random), normal(random));
  const double small = i % 2 == 0 ? 0.0 : std::pow(10.0, -12.0 * unit(random));
  if (i % 4 == 1) {
    direction = Vec3<double>(small * direction.x(), small * direction.y(), direction.z());
  } else if (i % 4 == 2) {
    direction.z() *= small;
  }
  return direction.normalized().cast<T>();
}

/// ± 10^low … 10^high.
[[nodiscard]] inline double draw_decades(std::mt19937_64& random, double low, double high) {
  const double size = std::pow(10.0, std::uniform_real_distribution<double>(low, high)(random));
  return random() % 2 == 0 ? size : -size;
}

/// From rest and 1e-6 rad/s to 1000 rad/s, for up to ±1e6 s (float: ±100 s); moments of any size, down to momenta of
/// 1e-300 (float: 1e-36); at exact attitudes and any. Sample i visits the strata in turn.
template <class T>
[[nodiscard]] Top<T> draw_top(std::mt19937_64& random, int i) {
  constexpr bool single = std::numeric_limits<T>::digits < 30;
  Top<T> top;
  top.moments = draw_moments<T>(random, i);
  double low = -6.0;
  if (i % 7 == 6) {
    const T tiny = single ? T(1e-25F) : T(1e-285);
    top.moments.axial *= tiny;
    top.moments.transverse *= tiny;
    low = single ? -5.0 : -9.0;
  }
  const T speed = i % 41 == 40 ? T(0) : static_cast<T>(std::fabs(draw_decades(random, low, 3.0)));
  const Vec3<T> w_B = speed * draw_direction<T>(random, i / 6);
  Quat<T> q_WB = draw_attitude(random).template cast<T>().normalized();
  if (i % 11 == 5) {
    q_WB = exact_attitudes[static_cast<std::size_t>(i / 11) % exact_attitudes.size()].template cast<T>();
  }
  if (i % 3 == 1) {  // as far off the unit sphere as is let through, or nearly
    q_WB.coeffs() *= T(1) + (i % 2 == 0 ? T(30) : T(-30)) * std::numeric_limits<T>::epsilon();
  }
  top.state = spinning(q_WB, top.moments, w_B);
  top.time = i % 43 == 42 ? T(0) : static_cast<T>(draw_decades(random, -6.0, single ? 2.0 : 6.0));
  return top;
}

/// Turning with 1e-6 to 1000 rad/s for a time in which |ω| t is about `angle`, forwards or backwards.
[[nodiscard]] inline Top<double> draw_short(std::mt19937_64& random, const Moments<double>& moments, int i,
                                            double angle) {
  const double speed = std::fabs(draw_decades(random, -6.0, 3.0));
  const Vec3<double> direction = draw_direction<double>(random, i);
  const double time = std::uniform_real_distribution<double>(0.5, 1.0)(random) * angle / speed;
  return {.moments = moments,
          .state = spinning<double>(draw_attitude(random), moments, speed * direction),
          .time = i % 3 == 0 ? -time : time};
}

/// At 1e-3 to 1000 in every coordinate of position and velocity.
template <class T>
[[nodiscard]] State<T> draw_thrown(std::mt19937_64& random, const Quat<T>& q_WB) {
  const auto draw = [&] {
    return Vec3<T>(static_cast<T>(draw_decades(random, -3.0, 3.0)), static_cast<T>(draw_decades(random, -3.0, 3.0)),
                   static_cast<T>(draw_decades(random, -3.0, 3.0)));
  };
  return {.p_WB = draw(), .q_WB = q_WB, .v_WB = draw(), .L_W = Vec3<T>::Zero()};
}

/// Batches of 1 to 19 stones of all sizes, thin and round ones too, but no needles, each with its own spin. Calls
/// see(top, what the batch gives, what the scalar gives, gravity).
template <class T, class See>
void over_batches(std::mt19937_64& random, int count, See&& see) {
  constexpr double longest = std::numeric_limits<T>::digits < 30 ? 2.0 : 6.0;
  for (int batch = 0; batch < count; ++batch) {
    const std::size_t size = 1 + random() % 19;
    const T time = static_cast<T>(draw_decades(random, -6.0, longest));
    const Vec3<T> gravity = draw_thrown<T>(random, Quat<T>::Identity()).v_WB;
    StoneBatch<T> stones(size);
    std::vector<Top<T>> tops;
    for (std::size_t i = 0; i < size; ++i) {
      const int kind = static_cast<int>(random() % 120);
      const Moments<T> moments = draw_moments<T>(random, kind, false);
      const State<T> thrown = draw_thrown<T>(random, draw_attitude(random).template cast<T>().normalized());
      const T speed = static_cast<T>(std::fabs(draw_decades(random, -6.0, 3.0)));
      const Vec3<T> w_B = speed * draw_direction<T>(random, kind / 6);
      tops.push_back({.moments = moments, .state = thrown, .time = time});
      tops.back().state.L_W = spinning<T>(thrown.q_WB, moments, w_B).L_W;
      stones.set(i, tops.back().state, moments);
    }
    stones.fly(gravity, time);
    for (std::size_t i = 0; i < size; ++i) {
      see(tops[i], stones.get(i), free_flight(tops[i].state, tops[i].moments, gravity, time), gravity);
    }
  }
}

/// By how much it turns, in both of its rotations   [rad]: |L| t / I_t + |ω_z t (1 − I_a/I_t)|.
template <class T>
[[nodiscard]] double phase(const Top<T>& top) {
  using Real = long double;
  const Quat<Real> q = top.state.q_WB.template cast<Real>();
  const Vec3<Real> L = top.state.L_W.template cast<Real>();
  const Real a = top.moments.axial, t = top.moments.transverse;
  const Real axial = L.dot(Vec3<Real>(q * Vec3<Real>::UnitZ()));
  return static_cast<double>(std::fabs(Real(top.time)) * (L.norm() / t + std::fabs(axial / a * ((t - a) / t))));
}

template <class T>
[[nodiscard]] std::string describe(const Top<T>& top) {
  const auto& [moments, state, time] = top;
  std::ostringstream text;
  text << std::hexfloat << "I_a = " << moments.axial << ", I_t = " << moments.transverse << ", q = (" << state.q_WB.w()
       << ' ' << state.q_WB.x() << ' ' << state.q_WB.y() << ' ' << state.q_WB.z() << "), L = (" << state.L_W.x() << ' '
       << state.L_W.y() << ' ' << state.L_W.z() << "), t = " << time << std::defaultfloat
       << " (I_a/I_t = " << moments.axial / moments.transverse << ", phase " << phase(top) << " rad)";
  return text.str();
}

}  // namespace goishi::verify
