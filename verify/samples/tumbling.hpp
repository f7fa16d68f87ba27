#pragma once
/// \file
/// Bodies without a symmetry axis in free flight: along an axis to the bit, beside it, near the separatrix, any.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <goishi/motion/state.hpp>
#include <limits>
#include <string>

#include "verify/oracles/motion/free_body.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify {

[[nodiscard]] inline Quat<Quad> unit_in_quad(const Quat<double>& q) {
  return q.cast<Quad>().normalized();
}

struct Tumbling {
  RigidBody<double> body;
  State<double> start;
  double time;
  std::string stratum;

  [[nodiscard]] Vec3<Quad> momentum() const {
    return formula::in_body(unit_in_quad(start.q_WB), Vec3<Quad>(start.L_W.cast<Quad>()));
  }
  /// Radians turned, at the most.
  [[nodiscard]] double turned() const { return start.L_W.norm() / body.moments.minCoeff() * std::fabs(time); }
  /// By how much an error of the start may grow: min(1/s, exp λ|t|), s = |1 − 2 E I_b/L²|, which is 0 on the separatrix;
  /// nothing where the start is an axis itself, and not rounded.
  [[nodiscard]] double growth() const {
    std::array<std::size_t, 3> order = {0, 1, 2};
    const auto I = [&](std::size_t k) { return Quad(body.moments[static_cast<Eigen::Index>(order[k])]); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return body.moments[static_cast<Eigen::Index>(i)] < body.moments[static_cast<Eigen::Index>(j)];
    });
    const Vec3<Quad> L_B = momentum();
    const Quad size = L_B.norm();
    if ((L_B.array() != Quad(0)).count() < 2) {
      return 0.0;
    }
    const auto part = [&](std::size_t k) {
      const Quad along = L_B[static_cast<Eigen::Index>(order[k])] / size;
      return Quad(along * along * (1 - I(1) / I(k)));
    };
    const Quad rate = size / I(1) * sqrt(Quad((I(1) - I(0)) * (I(2) - I(1)) / (I(0) * I(2))));
    const double by_time = std::exp(static_cast<double>(rate) * std::fabs(time));
    const double separation = std::fabs(static_cast<double>(Quad(part(0) + part(2))));
    return std::min(by_time, 1.0 / separation);
  }
  /// The round-off that a good method may show in the attitude: ε of the angle turned; and a share of what that of the
  /// start becomes.
  template <class T = double>
  [[nodiscard]] double round_off(double share = 1e-3) const {
    return static_cast<double>(std::numeric_limits<T>::epsilon()) * (1.0 + turned()) * (1.0 + share * growth());
  }
  [[nodiscard]] std::string describe() const {
    return fmt::format("{}: I = ({:a}, {:a}, {:a}), q = ({:a}, {:a}, {:a}, {:a}), L = ({:a}, {:a}, {:a}), t = {:a}",
                       stratum, body.moments.x(), body.moments.y(), body.moments.z(), start.q_WB.w(), start.q_WB.x(),
                       start.q_WB.y(), start.q_WB.z(), start.L_W.x(), start.L_W.y(), start.L_W.z(), time);
  }
};

/// All orders of three moments; two that are equal, or are so but for an ulp; three; a lamina.
inline const std::array<Vec3<double>, 12> exact_moments = {
    Vec3<double>(1.0, 2.0, 3.0),
    Vec3<double>(1.0, 3.0, 2.0),
    Vec3<double>(2.0, 1.0, 3.0),
    Vec3<double>(2.0, 3.0, 1.0),
    Vec3<double>(3.0, 1.0, 2.0),
    Vec3<double>(3.0, 2.0, 1.0),
    Vec3<double>(2.0, 2.0, 3.0),
    Vec3<double>(2.0, 1.0, 2.0),
    Vec3<double>(1.0, 2.0, 2.0),
    Vec3<double>(2.0, 2.0, 2.0),
    Vec3<double>(2.0, 2.0 + 2.0 * std::numeric_limits<double>::epsilon(), 3.0),
    Vec3<double>(2.0, 3.0, 5.0)};

/// Along an axis of the body to the bit, in every case; and, where `off` is not 0, as far beside it.
[[nodiscard]] inline Tumbling exact_tumbling(int i, double off, double time) {
  const auto take = [&](std::size_t count) {
    const std::size_t place = static_cast<std::size_t>(i) % count;
    i /= static_cast<int>(count);
    return place;
  };
  Tumbling problem;
  problem.stratum = "exact";
  problem.body = {.mass = 1.0, .moments = exact_moments[take(exact_moments.size())]};
  const auto axis = static_cast<Eigen::Index>(take(3));
  Vec3<double> L_B(off, off, off);
  L_B[axis] = take(2) == 0 ? 1.0 : -1.0;
  L_B[(axis + 1) % 3] *= take(2) == 0 ? 1.0 : 0.0;
  problem.time = take(2) == 0 ? time : -time;
  const Quat<double> q = exact_attitudes[take(exact_attitudes.size())];
  problem.start = {.p_WB = {0.0, 0.0, 0.0}, .q_WB = q, .v_WB = {0.0, 0.0, 0.0}, .L_W = q * L_B};
  return problem;
}

/// Moments of a brick of random edges, in three strata, and momenta in any direction, near an axis, near the separatrix;
/// and beside the axes at attitudes where that is exact, from 1e-300 to 1e-3.
[[nodiscard]] inline Tumbling draw_tumbling(Context& context, int i, double longest) {
  const auto decades = [&](double span) { return std::pow(10.0, -span * context.uniform(0.0, 1.0)); };
  if (i % 5 == 3) {
    return exact_tumbling(i / 5, decades(i % 2 == 0 ? 300.0 : 20.0), longest * context.uniform(0.1, 1.0));
  }
  constexpr std::array<const char*, 4> names = {"brick", "nearly round", "lamina", "rod"};
  std::array<double, 3> edge = {context.uniform(0.3, 1.0), context.uniform(0.3, 1.0), context.uniform(0.3, 1.0)};
  if (i % 4 == 1) {
    edge[1] = edge[0] * (1.0 + decades(7.0));
  } else if (i % 4 == 2) {
    edge[1] = decades(5.0);
  } else if (i % 4 == 3) {
    edge[0] = decades(2.0), edge[2] = edge[0] * context.uniform(0.3, 1.0);
  }
  const auto square = [&](std::size_t k) { return edge[k] * edge[k]; };
  Tumbling problem;
  problem.stratum = names[static_cast<std::size_t>(i % 4)];
  problem.body =
      make_rigid_body(1.0, Vec3<double>(square(1) + square(2), square(2) + square(0), square(0) + square(1)));
  Vec3<double> L_B(context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0));
  if (i % 5 == 1) {  // near the middle axis, that is, near the separatrix
    Vec3<double> sorted = problem.body.moments;
    std::sort(sorted.begin(), sorted.end());
    for (int k = 0; k < 3; ++k) {
      L_B[k] = problem.body.moments[k] == sorted[1] ? 1.0 : L_B[k] * decades(3.0);
    }
  } else if (i % 5 == 2) {  // near an axis, or on it but for round-off
    L_B[i % 3] = 1.0;
    L_B[(i + 1) % 3] *= i % 7 == 0 ? 0.0 : decades(12.0);
    L_B[(i + 2) % 3] *= i % 7 == 0 ? 0.0 : decades(12.0);
  }
  const Quat<double> q = draw_attitude(context.random());
  problem.start = {.p_WB = {0.0, 0.0, 0.0}, .q_WB = q, .v_WB = {0.0, 0.0, 0.0}, .L_W = q * L_B};
  const double rate = problem.start.L_W.norm() / problem.body.moments.minCoeff();
  problem.time = (i % 2 == 0 ? 1.0 : -1.0) * longest * context.uniform(0.1, 1.0) / rate;
  return problem;
}

/// The same for a time in which the start still tells where it ends.
[[nodiscard]] inline Tumbling foreseeable(Tumbling problem) {
  while (problem.growth() > 1e6) {
    problem.time /= 2.0;
  }
  return problem;
}

[[nodiscard]] inline State<Quad> in_quad(const State<double>& state) {
  return {.p_WB = state.p_WB.cast<Quad>(),
          .q_WB = unit_in_quad(state.q_WB),
          .v_WB = state.v_WB.cast<Quad>(),
          .L_W = state.L_W.cast<Quad>()};
}

/// A call: in line, g++ 12 leaves out a vector's cast to float and back.
[[gnu::noinline, nodiscard]] inline Vec3<float> nearest(const Vec3<double>& v) {
  return v.cast<float>();
}

/// The nearest numbers of float, which are then exact.
[[nodiscard]] inline Tumbling in_float(const Tumbling& problem) {
  Tumbling result = problem;
  result.body.moments = nearest(problem.body.moments).cast<double>();
  Eigen::Index most = 0;
  const double greatest = result.body.moments.maxCoeff(&most);
  if (greatest > result.body.moments.sum() - greatest) {  // a lamina's
    result.body.moments[most] = static_cast<double>(std::nextafter(static_cast<float>(greatest), 0.0F));
  }
  result.start.q_WB = problem.start.q_WB.cast<float>().normalized().cast<double>();
  result.start.L_W = nearest(problem.start.L_W).cast<double>();
  result.time = static_cast<double>(static_cast<float>(problem.time));
  return result;
}

}  // namespace goishi::verify
