/// What is promised, for the machine that the README names.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/bench/report.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench {

namespace {

constexpr double any = std::numeric_limits<double>::infinity();
constexpr double width = 0.022;  // [m] of the stones of contact

struct PointBar {
  std::string_view race, who;
  double setting;
  double greatest_time;         // [ns]
  double greatest_error = any;  // the leading
  double greatest_late = any;   // the ninetieth percentile of the time, in medians
};
constexpr PointBar point_bars[] = {{"flight", "one-by-one", 1024, 40},
                                   {"flight", "batch", 1024, 8, 1e-13},
                                   {"flight", "batch", 100'000, 12, 1e-13},
                                   {"tessellation", "welded", 64, 10e6},
                                   {"region", "region", 0, 3},
                                   {"plane", "gap", 0, 15, 1e-13 * width},
                                   {"plane", "gap-batch", 0, 15, 1e-13 * width},
                                   {"plane", "double", 0, 15, 1e-13 * width},
                                   {"edge", "double", 0, 200, 1e-13 * width},
                                   {"edge-thin", "double", 0, 300, 1e-13 * width},
                                   {"corner", "double", 0, 200, 1e-13 * width},
                                   {"corner-thin", "double", 0, 300, 1e-13 * width},
                                   {"apart", "double", 0, 500, 1e-12 * width},
                                   {"apart-thin", "double", 0, 500, 1e-12 * width},
                                   {"bevels", "double", 0, 500, 1e-12 * width},
                                   {"cores", "double", 0, 5000, 1e-12 * width},
                                   {"impact", "double", 0, 500},
                                   {"drop-to-rest", "drop", 1e-4, 0.4e6, any, 4},
                                   {"drop-to-rest", "drop", 1e-6, 1e6, any, 4},
                                   {"drop-to-rest", "drop", 1e-9, 3e6, 1e-7, 4},
                                   {"drop-state-at", "ordered", 0, 150},
                                   {"drop-state-at", "mixed", 0, 250},
                                   {"drop-elastic", "drop", 0, 10e6},
                                   {"drop-impact-law", "chatterjee_ruina", 0, 50}};

/// How many times dearer others must be: with the same setting, or at each of these errors.
struct RatioBar {
  std::string_view race, who;
  std::string_view other;  // "": everyone who has settings
  double least;
  double setting = 0;
  std::vector<std::vector<Target>> targets = {};
};
const std::vector<RatioBar>& ratio_bars() {
  static const std::vector<RatioBar> all = [] {
    const std::vector<std::vector<Target>> steps = {{{0, 1e-3}}, {{0, 1e-5}}, {{0, 1e-7}}, {{0, 1e-9}}};
    const std::vector<std::vector<Target>> whole_drops = {{{0, 1e-5}, {1, 1e-4}}};  // they magnify errors
    std::vector<RatioBar> bars = {{"flight", "batch", "one-by-one", 4, 1024},       // half the lanes of AVX-512
                                  {"flight", "batch", "one-by-one", 1, 100'000},
                                  {"plane", "gap-batch", "gap", 1},
                                  {"spin", "exact", "", 1000, 0, {{{0, 1e-10}}}}};
    for (const char* const race : {"spin", "flat-spin", "brick", "flip", "tumble"}) {
      bars.push_back({race, "runge-kutta-4", "odeint-runge-kutta-4", 1, 0, steps});
    }
    for (const char* const race : {"drop-one-impact", "drop-two-impacts", "drop-half-second"}) {
      for (const char* const loop : {"published-loop", "published-loop-momentum"}) {
        bars.push_back({race, "drop", loop, 100, 0, whole_drops});
      }
    }
    return bars;
  }();
  return all;
}

std::string with_spread(const Timing& time) {
  return fmt::format("{} ({} … {})", time_text(time.median), time_text(time.lower), time_text(time.upper));
}

/// A point that is not there is not held: a batch, say, whose instructions this processor lacks.
void add_point_bars(const Race& race, const PointBar& wanted, const Curve& curve, std::vector<Bar>& bars) {
  const Point* point = point_at(curve, wanted.setting);
  const std::string name = fmt::format("{}: {}", race.name, point_name(curve.who, wanted.setting));
  bars.push_back({.name = name,
                  .wanted = fmt::format("at most {}", time_text(wanted.greatest_time)),
                  .measured = "not measured",
                  .held = false});
  if (point == nullptr) {
    return;
  }
  const double unanswered = value_of(race, *point, "unanswered").value_or(0);
  bars.back().measured =
      fmt::format("{}{}", with_spread(point->cost), unanswered > 0 ? fmt::format("; {} unanswered", unanswered) : "");
  bars.back().held = point->cost.median <= wanted.greatest_time && unanswered == 0;
  if (wanted.greatest_error < any) {
    const Quantity& quantity = race.quantities.front();
    bars.push_back({.name = fmt::format("{}, {}", name, quantity.name),
                    .wanted = fmt::format("at most {}", value_text(quantity, wanted.greatest_error)),
                    .measured = value_text(quantity, point->values.front()),
                    .held = point->values.front() <= wanted.greatest_error});
  }
  if (wanted.greatest_late < any) {
    const double late = point->cost.late / point->cost.median;
    bars.push_back({.name = name + ", ninetieth percentile",
                    .wanted = fmt::format("at most {} times the median", wanted.greatest_late),
                    .measured = fmt::format("{}, {:.2f} times", time_text(point->cost.late), late),
                    .held = late <= wanted.greatest_late});
  }
}

/// "1e-5 m, 1e-4 rad": what is wanted, or what a point has in its place.
std::string targets_text(const Race& race, const std::vector<Target>& targets, const Point* point = nullptr) {
  std::vector<std::string> values;
  for (const auto& [quantity, value] : targets) {
    values.push_back(value_text(race.quantities[quantity], point == nullptr ? value : point->values[quantity]));
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

struct Compared {
  std::string text;
  bool held;
};

/// A curve that does not reach the errors is infinitely dear; how far it came is said.
Compared compared_at(const Race& race, const Curve& ours, const Curve& other, const std::vector<Target>& targets,
                     double least) {
  const std::optional<Cost> mine = cost_at(ours, targets), theirs = cost_at(other, targets);
  if (!mine || !mine->reached) {
    return {"not reached", !(theirs && theirs->reached)};
  }
  if (theirs) {
    const double ratio = theirs->time / mine->time;
    return {plain_number(ratio) + (theirs->reached ? " times" : " times, by its order: it did not come so far"),
            ratio >= least};
  }
  const Point* best = most_accurate(other);
  if (best == nullptr) {
    return {"completed no run", true};
  }
  return {fmt::format("not reached: {} after {} times the run time", targets_text(race, targets, best),
                      plain_number(best->cost.median / mine->time)),
          true};
}

Bar ratio_bar(const Race& race, const RatioBar& wanted, const Curve& ours, const Curve& other) {
  const std::string who = wanted.targets.empty() ? point_name(ours.who, wanted.setting) : ours.who.label;
  Bar bar{.name = fmt::format("{}: {} against {}", race.name, who, other.who.label),
          .wanted = wanted.least == 1 ? "not dearer" : fmt::format("at least {} times cheaper", wanted.least),
          .measured = "",
          .held = true};
  std::vector<std::string> measured, where;
  for (const std::vector<Target>& targets : wanted.targets) {
    const auto [text, held] = compared_at(race, ours, other, targets, wanted.least);
    measured.push_back(text);
    where.push_back(targets_text(race, targets));
    bar.held = bar.held && held;
  }
  if (wanted.targets.empty()) {
    const Point *mine = point_at(ours, wanted.setting), *theirs = point_at(other, wanted.setting);
    const double ratio = mine && theirs ? theirs->cost.median / mine->cost.median : 0;
    measured.push_back(ratio > 0 ? plain_number(ratio) + " times" : "not measured");
    bar.held = ratio >= wanted.least;
  } else {
    bar.wanted += fmt::format(" at {}", fmt::join(where, "; "));
  }
  bar.measured = fmt::format("{}", fmt::join(measured, "; "));
  return bar;
}

}  // namespace

std::vector<Bar> bars_of(const Bench& bench) {
  std::vector<Bar> bars;
  for (const Race& race : bench.races) {
    for (const PointBar& wanted : point_bars) {
      if (const Curve* curve = wanted.race == race.name ? curve_named(race, wanted.who) : nullptr) {
        add_point_bars(race, wanted, *curve, bars);
      }
    }
    for (const RatioBar& wanted : ratio_bars()) {
      const Curve* ours = wanted.race == race.name ? curve_named(race, wanted.who) : nullptr;
      for (const Curve& other : race.curves) {
        const bool meant = wanted.other.empty() ? other.who.kind != Kind::direct : wanted.other == other.who.name;
        if (ours != nullptr && meant) {
          bars.push_back(ratio_bar(race, wanted, *ours, other));
        }
      }
    }
  }
  return bars;
}

}  // namespace goishi::verify::bench
