#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/report/number.hpp"
#include "verify/work_precision/bench.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench {

namespace {

// What is promised, for the machine that the README names.
constexpr double greatest_exact_flight = 40;  // [ns] a call
constexpr double greatest_batch_few = 8;      // [ns] a stone, in cache,
constexpr double greatest_batch_many = 12;    // and out of it
constexpr double least_speed_up = 4;          // of the batch over one stone after the other: half the lanes of AVX-512
constexpr double least_advantage = 1000;      // of the exact flight over every stepper,
constexpr double advantage_error = 1e-10;     // at this attitude error [rad],
constexpr std::string_view advantage_on = "spin";  // on this problem
constexpr double greatest_runge_kutta_ratio = 1;   // of our Runge–Kutta's cost over Odeint's, at equal error
constexpr double runge_kutta_errors[] = {1e-3, 1e-5, 1e-7, 1e-9};

std::string nanoseconds(double value) {
  return fmt::format("{} ns", plain_number(value));
}

void add_flight_bars(const FlightSpeed& speed, std::vector<Bar>& bars) {
  bars.push_back({.name = "exact flight, a call",
                  .wanted = fmt::format("at most {}", nanoseconds(greatest_exact_flight)),
                  .measured = with_spread(speed.scalar_few),
                  .held = speed.scalar_few.median <= greatest_exact_flight});
  const auto add_batch = [&](std::size_t count, const Timing& scalar, const std::optional<Timing>& batch,
                             double greatest, double least_ratio) {
    Bar bar{.name = fmt::format("batch of {} stones, a stone", count),
            .wanted = fmt::format("at most {}, at least {} times faster than one by one", nanoseconds(greatest),
                                  plain_number(least_ratio)),
            .measured = "not measured: this processor lacks what the batch was compiled for",
            .held = false};
    if (batch) {
      const double ratio = scalar.median / batch->median;
      bar.measured = fmt::format("{}, {} lanes; {} ns one by one: {} times faster", with_spread(*batch), speed.lanes,
                                 plain_number(scalar.median), plain_number(ratio));
      bar.held = batch->median <= greatest && ratio >= least_ratio;
    }
    bars.push_back(bar);
  };
  add_batch(few_stones, speed.scalar_few, speed.batch_few, greatest_batch_few, least_speed_up);
  add_batch(many_stones, speed.scalar_many, speed.batch_many, greatest_batch_many, 1.0);
}

const Curve* curve_named(const Race& race, std::string_view name) {
  const auto found = std::find_if(race.curves.begin(), race.curves.end(),
                                  [&](const Curve& curve) { return curve.contestant->name == name; });
  return found == race.curves.end() ? nullptr : &*found;
}

/// A curve that does not reach the error is infinitely dear; how far it came is said.
Bar advantage_over(const Curve& curve, double exact_cost) {
  Bar bar{.name = fmt::format("exact flight against {}", curve.contestant->label),
          .wanted = fmt::format("at least {} times cheaper at {} rad", least_advantage, advantage_error),
          .measured = "completed no run",
          .held = true};
  if (const std::optional<double> cost = cost_at(curve, advantage_error)) {
    const double ratio = *cost / exact_cost;
    bar.measured = fmt::format("{:.0f} times", ratio);
    bar.held = ratio >= least_advantage;
  } else if (const std::optional<Point> best = most_accurate(curve)) {
    bar.measured = fmt::format("not reached: {} rad after {:.0f} times the run time",
                               plain_number(best->errors.attitude, 2), best->cost.median / exact_cost);
  }
  return bar;
}

void add_advantage_bars(const Race& race, std::vector<Bar>& bars) {
  const Curve* exact = curve_named(race, "exact");
  if (race.problem->name != advantage_on || exact == nullptr) {
    return;
  }
  const std::optional<double> exact_cost = cost_at(*exact, advantage_error);
  for (const Curve& curve : race.curves) {
    if (curve.contestant->kind != Kind::closed_form) {
      bars.push_back(advantage_over(curve, exact_cost.value_or(std::numeric_limits<double>::infinity())));
    }
  }
}

void add_runge_kutta_bar(const Race& race, std::vector<Bar>& bars) {
  const Curve* ours = curve_named(race, "runge-kutta-4");
  const Curve* theirs = curve_named(race, "odeint-runge-kutta-4");
  if (ours == nullptr || theirs == nullptr) {
    return;
  }
  Bar bar{.name = fmt::format("our Runge–Kutta 4 against Odeint's, {}", race.problem->name),
          .wanted = "not dearer at equal error",
          .measured = "",
          .held = true};
  for (const double error : runge_kutta_errors) {
    const std::optional<double> mine = cost_at(*ours, error);
    const std::optional<double> other = cost_at(*theirs, error);
    if (other) {  // where Odeint's does not come, there is nothing to compare
      const double ratio = mine ? *mine / *other : std::numeric_limits<double>::infinity();
      bar.held = bar.held && ratio <= greatest_runge_kutta_ratio;
      bar.measured += fmt::format("{}{} at {}", bar.measured.empty() ? "" : ", ",
                                  mine ? fmt::format("{:.2f}", ratio) : "not reached", error);
    }
  }
  bars.push_back(bar);
}

}  // namespace

std::string with_spread(const Timing& time) {
  if (time.median >= 999.5) {
    return fmt::format("{} ({} … {})", time_text(time.median), time_text(time.lower), time_text(time.upper));
  }
  return fmt::format("{} ns ({} … {})", plain_number(time.median), plain_number(time.lower), plain_number(time.upper));
}

std::vector<Bar> bars_of(const Bench& bench) {
  std::vector<Bar> bars;
  add_flight_bars(bench.speed, bars);
  for (const Race& race : bench.races) {
    add_advantage_bars(race, bars);
  }
  for (const Race& race : bench.races) {
    add_runge_kutta_bar(race, bars);
  }
  contact::add_bars(bench.contact_races, bench.contact_speed, bars);
  if (bench.drops) {
    drops::add_bars(*bench.drops, bars);
  }
  return bars;
}

}  // namespace goishi::verify::bench
