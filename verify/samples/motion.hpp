#pragma once
/// \file
/// Bodies in flight for the claims about motion, and how far apart two attitudes are.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <goishi/motion/state.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "verify/oracles/motion/taylor_body.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

/// A body, and how it starts.
struct Flight {
  RigidBody<double> body;
  State<double> start;
};

/// The greatest angular velocity that the momentum allows, |L| / I_min   [rad/s].
[[nodiscard]] inline double greatest_rate(const Flight& flight) {
  return flight.start.L_W.norm() / flight.body.moments.minCoeff();
}

[[nodiscard]] inline Vec3<double> draw_vector(std::mt19937_64& random, double reach) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

enum class BodyKind { symmetric, asymmetric, near_separatrix };
inline constexpr std::array body_kinds = {BodyKind::symmetric, BodyKind::asymmetric, BodyKind::near_separatrix};

/// Moments and momentum of order 1, none of the axes favoured. Symmetric bodies have I_a/I_t from 0.2 to 1.9. One in eight starts at the
/// origin, at an exact attitude, turning about an axis to the bit. Near the
/// separatrix the momentum is 10⁻¹ … 10⁻² off the axis of the middle moment, about which the body tumbles.
[[nodiscard]] inline Flight draw_flight(std::mt19937_64& random, BodyKind kind) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double mass = uniform(0.5, 2.0);
  const Quat<double> q_WB = draw_attitude(random);
  Vec3<double> moments;
  Vec3<double> L_B = draw_attitude(random) * Vec3<double>(uniform(0.5, 2.0), 0.0, 0.0);
  if (kind == BodyKind::symmetric) {
    const double transverse = uniform(0.5, 2.0);
    const bool flat = uniform(0.0, 1.0) < 0.5;
    moments = {transverse, transverse, transverse * (flat ? uniform(1.2, 1.9) : uniform(0.2, 0.8))};
  } else {
    // Any second moments along the axes that differ by a fifth at least.
    const double x = uniform(0.2, 0.5), y = x * uniform(1.3, 2.0), z = y * uniform(1.3, 2.0);
    moments = {y + z, x + z, x + y};
    std::shuffle(moments.data(), moments.data() + 3, random);
  }
  if (kind == BodyKind::near_separatrix) {
    const auto is_middle = [&](int i) { return moments[i] < moments.maxCoeff() && moments[i] > moments.minCoeff(); };
    const int middle = is_middle(0) ? 0 : is_middle(1) ? 1 : 2;
    const double size = L_B.norm();
    L_B *= std::pow(10.0, -uniform(1.0, 2.0));
    L_B[middle] = size;
  }
  if (kind != BodyKind::near_separatrix && random() % 8 == 0) {  // about an axis to the bit, but not the middle one
    int axis = 0;
    static_cast<void>(random() % 2 == 0 ? moments.maxCoeff(&axis) : moments.minCoeff(&axis));
    const Quat<double>& q = exact_attitudes[random() % exact_attitudes.size()];
    L_B = (random() % 2 == 0 ? 1.0 : -1.0) * L_B.norm() * Vec3<double>::Unit(axis);
    return {.body = make_rigid_body(mass, moments),
            .start = {.p_WB = Vec3<double>::Zero(), .q_WB = q, .v_WB = draw_vector(random, 2.0), .L_W = q * L_B}};
  }
  return {
      .body = make_rigid_body(mass, moments),
      .start = {.p_WB = draw_vector(random, 1.0), .q_WB = q_WB, .v_WB = draw_vector(random, 2.0), .L_W = q_WB * L_B}};
}

[[nodiscard]] inline std::string describe(const Flight& flight) {
  std::ostringstream text;
  text << std::hexfloat << "moments = (" << flight.body.moments.transpose() << "), q = ("
       << flight.start.q_WB.coeffs().transpose() << ") as x y z w, L = (" << flight.start.L_W.transpose() << ')';
  return text.str();
}

/// The angle between two attitudes   [rad], twice the chord: q and −q are the same.
template <class T, class U>
[[nodiscard]] double attitude_difference(const Quat<T>& q, const Quat<U>& p) {
  using Wide = Eigen::Matrix<long double, 4, 1>;
  const Wide a = q.coeffs().template cast<long double>(), b = p.coeffs().template cast<long double>();
  return static_cast<double>(2.0L * std::min((a - b).norm(), (a + b).norm()));
}

/// The true attitude after a time, by Taylor series.
class TrueAttitude {
 public:
  explicit TrueAttitude(const Flight& flight) : moments_{}, now_{} {
    const Quat<long double> q = flight.start.q_WB.cast<long double>().normalized();
    const Eigen::Matrix<long double, 3, 1> w_B =
        (q.conjugate() * flight.start.L_W.cast<long double>()).cwiseQuotient(flight.body.moments.cast<long double>());
    now_ = {{q.w(), q.x(), q.y(), q.z()}, {w_B.x(), w_B.y(), w_B.z()}};
    std::copy_n(flight.body.moments.data(), 3, moments_.begin());
  }
  /// Times that go up.
  [[nodiscard]] Quat<long double> at(long double time) {
    now_ = taylor_turning(moments_, now_, time - time_);
    time_ = time;
    const auto& q = now_.attitude;
    return Quat<long double>(q[0], q[1], q[2], q[3]).normalized();
  }

 private:
  std::array<double, 3> moments_;
  Turning now_;
  long double time_ = 0.0L;
};

}  // namespace goishi::verify
