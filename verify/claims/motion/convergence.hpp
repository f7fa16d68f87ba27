#pragma once
/// \file
/// How the error of a stepper falls as its step is halved.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/steppers.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "verify/samples/motion.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify {

using Attitude = Quat<long double>;
inline constexpr int instants = 8;

/// Some two turns.
[[nodiscard]] inline double duration_of(const Flight& flight) {
  return 12.0 / greatest_rate(flight);
}

[[nodiscard]] inline std::vector<Attitude> true_attitudes(const Flight& flight) {
  TrueAttitude truth(flight);
  std::vector<Attitude> attitudes;
  for (int i = 1; i <= instants; ++i) {
    attitudes.push_back(truth.at(static_cast<long double>(duration_of(flight)) * i / instants));
  }
  return attitudes;
}

/// What the talk's loop converges to: the angular velocity of the start, for ever.
[[nodiscard]] inline std::vector<Attitude> constantly_turned(const Flight& flight) {
  const Vec3<double> w_WB = formula::angular_velocity_W(flight.start, flight.body);
  std::vector<Attitude> attitudes;
  for (int i = 1; i <= instants; ++i) {
    const double angle = w_WB.norm() * duration_of(flight) * i / instants;
    attitudes.push_back(
        (Quat<double>(Eigen::AngleAxisd(angle, w_WB.normalized())) * flight.start.q_WB).cast<long double>());
  }
  return attitudes;
}

/// Position and attitude after 2^k steps in all: the worst of the attitude at eight instants, the position at the end.
struct StepError {
  double attitude = 0.0;
  double position = 0.0;
};

[[nodiscard]] inline StepError step_error(const Context& context, Scheme scheme, const Flight& flight,
                                          std::span<const Attitude> expected, int k) {
  const Stepper<double> stepper(scheme, flight.body);
  const std::int64_t steps = std::int64_t{1} << k;
  const double duration = duration_of(flight);
  const double dt = duration / static_cast<double>(steps);
  State<double> state = flight.start;
  StepError error;
  for (const Attitude& attitude : expected) {
    const Stepped<double> stepped = stepper.advance(state, dt, steps / instants);
    if (stepped.status != StepStatus::completed) {
      return {NAN, NAN};
    }
    state = stepped.state;
    const Quat<double> q_WB(context.produced(state.q_WB.coeffs().eval()));
    error.attitude = std::max(error.attitude, attitude_difference(q_WB, attitude));
  }
  const State<double> parabola = formula::ballistic_flight(flight.start, stepper.gravity(), duration);
  error.position = (context.produced(state.p_WB) - parabola.p_WB).norm();
  return error;
}

/// The halvings in which a scheme of this order is past its first terms and not yet at round-off: 2^k steps.
struct Halvings {
  int first, last;
  double tolerance;  // of the slope
};
[[nodiscard]] inline Halvings halvings_of(int order) {
  return order <= 1   ? Halvings{13, 16, 0.05}
         : order == 2 ? Halvings{9, 12, 0.05}
         : order == 4 ? Halvings{7, 10, 0.1}
                      : Halvings{5, 8, 0.2};
}

/// Sees each halving's slope, unless the finer error is near round-off.
inline void see_slopes(Worst& worst, const std::vector<double>& errors, int order, double tolerance,
                       const std::string& description) {
  constexpr double near_round_off = 1e-12;
  int seen = 0;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    if (!(errors[i] < near_round_off)) {
      ++seen;
      const double slope = std::log2(errors[i - 1] / errors[i]);
      worst.see(std::fabs(slope - order), tolerance,
                [&] { return fmt::format("slope {:.4f} instead of {}: {}", slope, order, description); });
    }
  }
  worst.see(seen > 0 ? 0.0 : NAN, [&] { return "all errors are at round-off: " + description; });
}

inline void see_attitude_order(Worst& worst, const Context& context, Scheme scheme, const Flight& flight,
                               std::span<const Attitude> expected, int order) {
  const Halvings halvings = halvings_of(order);
  std::vector<double> errors;
  for (int k = halvings.first; k <= halvings.last; ++k) {
    errors.push_back(step_error(context, scheme, flight, expected, k).attitude);
  }
  see_slopes(worst, errors, order, halvings.tolerance, std::string(info(scheme).name) + ", " + describe(flight));
}

inline void see_position_order(Worst& worst, const Context& context, Scheme scheme, const Flight& flight,
                               std::span<const Attitude> expected) {
  std::vector<double> errors;
  for (int k = 6; k <= 8; ++k) {
    errors.push_back(step_error(context, scheme, flight, expected, k).position);
  }
  if (info(scheme).position_order != exact_order) {
    see_slopes(worst, errors, info(scheme).position_order, 0.05, "position by " + std::string(info(scheme).name));
    return;
  }
  // Each of 256 steps rounds a velocity and a position, of a size that neither leaves.
  const double duration = duration_of(flight);
  const double gain = standard_gravity<double>() * duration;
  const double reach = flight.start.p_WB.norm() + (flight.start.v_WB.norm() + gain) * duration;
  worst.see(errors.back(), 256.0 * std::numeric_limits<double>::epsilon() * reach,
            [&] { return "an exact position by " + std::string(info(scheme).name) + ", " + describe(flight); });
}

[[nodiscard]] inline Plot order_plot(const Context& context, const std::string& title, const Flight& flight) {
  Plot plot{.title = title,
            .x_label = "step, as the greatest angle turned in it [rad]",
            .y_label = "greatest error of the attitude [rad]",
            .log_x = true,
            .log_y = true,
            .series = {}};
  const std::vector<Attitude> truth = true_attitudes(flight);
  for (const SchemeInfo& scheme : schemes) {
    if (scheme.needs_symmetry && flight.body.moments.x() != flight.body.moments.y()) {
      continue;
    }
    const std::string order = scheme.attitude_order == exact_order ? "no step error"
                              : scheme.attitude_order == 0         ? "does not converge"
                                                                   : fmt::format("slope {}", scheme.attitude_order);
    Series series{.name = fmt::format("{}: {}", scheme.name, order), .points = {}};
    for (int k = 4; k <= 14; ++k) {
      const double error = step_error(context, scheme.scheme, flight, truth, k).attitude;
      if (error > 0.0) {
        series.points.emplace_back(12.0 / std::exp2(k), error);
      }
    }
    plot.series.push_back(series);
  }
  return plot;
}

/// Products of the attitude with a cosine near 1 in a step. Such a product rounds alike step after step.
[[nodiscard]] inline double cosine_products(Scheme scheme) {
  switch (scheme) {
    case Scheme::explicit_euler:
    case Scheme::runge_kutta_4:
    case Scheme::published:
      return 0.0;
    case Scheme::splitting_2:
      return 5.0;
    case Scheme::splitting_4:
      return 21.0;
    case Scheme::splitting_6:
      return 37.0;
    default:
      return 1.0;
  }
}

/// What round-off adds to the attitude in so many steps of one turn in all: the bound of claim ORDER-4   [rad].
[[nodiscard]] inline double round_off(Scheme scheme, double steps) {
  const double alike = cosine_products(scheme) / 16.0 + (scheme == Scheme::published ? 16.0 : 0.0);
  return std::numeric_limits<double>::epsilon() * (16.0 * std::sqrt(steps) + alike * steps);
}

}  // namespace goishi::verify
