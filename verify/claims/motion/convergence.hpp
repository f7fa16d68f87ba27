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

#include "verify/claims/checks.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

using Attitude = Quat<long double>;
inline constexpr int instants = 8;

/// All of it relatively, its length too: `attitude_difference` sees that.
[[nodiscard]] inline Quat<double> lengthened(const Context& context, const Quat<double>& q_WB) {
  return Quat<double>(context.produced(q_WB.coeffs().eval()));
}

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
    error.attitude = std::max(error.attitude, attitude_difference(lengthened(context, state.q_WB), attitude));
  }
  const State<double> parabola = formula::ballistic_flight(flight.start, stepper.gravity(), duration);
  error.position = (context.produced(state.p_WB) - parabola.p_WB).norm();
  return error;
}

/// The halvings in which a scheme of this order is past its first terms and not yet at round-off: 2^k steps.
struct Halvings {
  int first, last;
};
[[nodiscard]] inline Halvings halvings_of(int order) {
  return order <= 1 ? Halvings{13, 16} : order == 2 ? Halvings{9, 12} : order == 4 ? Halvings{7, 10} : Halvings{5, 8};
}

/// Sees how far each halving's slope is off, unless the finer error is near round-off.
inline void see_slopes(Worst& worst, const std::vector<double>& errors, int order, const std::string& description) {
  constexpr double near_round_off = 1e-12;
  int seen = 0;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    if (!(errors[i] < near_round_off)) {
      ++seen;
      const double slope = std::log2(errors[i - 1] / errors[i]);
      worst.see(std::fabs(slope - order),
                [&] { return fmt::format("slope {:.4f} instead of {}: {}", slope, order, description); });
    }
  }
  worst.see(seen > 0 ? 0.0 : NAN, [&] { return "all errors are at round-off: " + description; });
}

inline void see_attitude_order(Checks& checks, const Context& context, Scheme scheme, const Flight& flight,
                               std::span<const Attitude> expected, int order) {
  const auto [first, last] = halvings_of(order);
  std::vector<double> errors;
  for (int k = first; k <= last; ++k) {
    errors.push_back(step_error(context, scheme, flight, expected, k).attitude);
  }
  see_slopes(checks[fmt::format("order {}", order)], errors, order,
             fmt::format("{}, {}", info(scheme).name, describe(flight)));
}

/// A scheme that converges to a motion of its own, a turn with the first angular velocity. Against the true one its error
/// ends at how far the two are apart, but for what each step of x rad turns too little: x − 2 atan(x/2) < x³/12.
inline void see_no_convergence(Checks& checks, const Context& context, Scheme scheme, const Flight& flight,
                               std::span<const Attitude> truth, std::span<const Attitude> own) {
  double apart = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    apart = std::max(apart, attitude_difference(truth[i], own[i]));
  }
  const auto describe_it = [&] { return fmt::format("{}, {}", info(scheme).name, describe(flight)); };
  const double angle = formula::angular_velocity_W(flight.start, flight.body).norm() * duration_of(flight);
  for (int k = 7; k <= 10; ++k) {
    const double x = angle / std::exp2(k);
    checks["no convergence"].see(std::fabs(step_error(context, scheme, flight, truth, k).attitude - apart),
                                 angle * x * x / 12.0, describe_it);
  }
  see_choice(checks["other motion"], apart > 1e-3, describe_it);
}

inline void see_position_order(Checks& checks, const Context& context, Scheme scheme, const Flight& flight,
                               std::span<const Attitude> expected) {
  std::vector<double> errors;
  for (int k = 6; k <= 8; ++k) {
    errors.push_back(step_error(context, scheme, flight, expected, k).position);
  }
  const std::string description = fmt::format("position, {}, {}", info(scheme).name, describe(flight));
  if (info(scheme).position_order != exact_order) {
    see_slopes(checks["position"], errors, info(scheme).position_order, description);
    return;
  }
  const double duration = duration_of(flight);
  const double gain = standard_gravity<double>() * duration;
  const double reach = flight.start.p_WB.norm() + (flight.start.v_WB.norm() + gain) * duration;
  checks["exact position"].see(errors.back(), epsilon * reach, [&] { return description; });
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
  return epsilon * (16.0 * std::sqrt(steps) + alike * steps);
}

}  // namespace goishi::verify
