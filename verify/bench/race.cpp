#include "verify/bench/race.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "verify/bench/contact/contact.hpp"
#include "verify/bench/drop/drops.hpp"
#include "verify/bench/mass/mass.hpp"
#include "verify/bench/motion/motion.hpp"
#include "verify/bench/rivals/rivals.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench {

namespace {

/// Round-off, for the purpose of stopping: a step error seldom stays above half of the one before below this.
constexpr double small_error = 1e-9;

struct Running {
  Point* point;
  Entry entry;
  std::size_t next = 0;  // case
};

/// How far a point is from all targets, as a factor; at most 1: reached. NaN where there was no answer.
double excess(const Point& point, const std::vector<Target>& targets) {
  double most = 0;
  for (const auto& [quantity, value] : targets) {
    const double one = point.values[quantity] / value;
    most = std::isnan(most) || one <= most ? most : one;
  }
  return most;
}

/// A curve's points, judged, not yet timed.
void take_points(Curve& curve, std::size_t cases, const Effort& effort, std::vector<Running>& running) {
  if (!curve.enter) {
    return;
  }
  curve.points.reserve(curve.who.settings.size());  // `running` refers to them
  double best = 1;
  int stalled = 0;
  for (const double setting : curve.who.settings) {
    Entry entry = curve.enter(setting);
    const std::clock_t start = std::clock();
    entry.run(0, cases);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(cases);
    curve.points.push_back({.setting = setting, .cost = {}, .values = entry.judge()});
    running.push_back({.point = &curve.points.back(), .entry = std::move(entry)});
    if (const std::vector<double>& values = curve.points.back().values; !values.empty()) {
      stalled += values.front() < small_error && values.front() > best / 2 ? 1 : 0;
      best = std::fmin(best, values.front());
    }
    if (stalled == 2 || seconds > effort.dearest) {
      break;
    }
  }
}

/// Each case by itself: the median of its repeats counts.
void time_cases(std::vector<Running>& running, std::size_t cases, int repeats) {
  std::vector<std::function<void()>> calls;
  for (Running& one : running) {
    for (std::size_t i = 0; i < cases; ++i) {
      calls.emplace_back([&run = one.entry.run, i] { run(i, i + 1); });
    }
  }
  constexpr double once = 1e-9;
  const auto times = time_by_turns(calls, once, repeats);
  for (std::size_t k = 0; k < running.size(); ++k) {
    std::vector<double> medians;
    for (std::size_t i = 0; i < cases; ++i) {
      medians.push_back(quantile(times[k * cases + i], 0.5));
    }
    running[k].point->cost = summary(medians);
  }
}

/// A block of cases a call, round and round.
void time_blocks(std::vector<Running>& running, std::size_t cases, std::size_t block, const Effort& effort) {
  const auto block_of = [&](const Running& one) { return one.entry.at_once || block == 0 ? cases : block; };
  std::vector<std::function<void()>> calls;
  for (Running& one : running) {
    calls.emplace_back([&one, cases, size = block_of(one)] {
      one.entry.run(one.next, one.next + size);
      one.next = (one.next + size) % cases;
    });
  }
  auto times = time_by_turns(calls, effort.batch, effort.repeats);
  for (std::size_t k = 0; k < running.size(); ++k) {
    for (double& time : times[k]) {
      time /= static_cast<double>(block_of(running[k])) * running[k].entry.items;
    }
    running[k].point->cost = summary(times[k]);
  }
}

}  // namespace

std::string_view to_string(Kind kind) {
  constexpr std::string_view names[] = {"direct", "step", "tolerance", "vertices", "rings", "stones"};
  return names[static_cast<std::size_t>(kind)];
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {mass::subject(), motion::subject(), contact::subject(), drops::subject(),
                                           rivals::subject()};
  return all;
}

void run_race(Race& race, const Effort& usual_effort) {
  Effort effort = usual_effort;
  if (race.long_runs) {
    effort.repeats = std::min(effort.repeats, 3);
    effort.dearest = std::numeric_limits<double>::infinity();
  }
  std::vector<Running> running;
  for (Curve& curve : race.curves) {
    take_points(curve, race.cases, effort, running);
  }
  if (race.by_case) {
    time_cases(running, race.cases, effort.repeats);
  } else {
    time_blocks(running, race.cases, race.block, effort);
  }
}

const Curve* curve_named(const Race& race, std::string_view name) {
  const auto found =
      std::find_if(race.curves.begin(), race.curves.end(), [&](const Curve& curve) { return curve.who.name == name; });
  return found == race.curves.end() ? nullptr : &*found;
}

const Point* point_at(const Curve& curve, double setting) {
  const auto found = std::find_if(curve.points.begin(), curve.points.end(),
                                  [&](const Point& point) { return point.setting == setting; });
  return found == curve.points.end() ? nullptr : &*found;
}

std::optional<double> value_of(const Race& race, const Point& point, std::string_view quantity) {
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    if (race.quantities[i].name == quantity) {
      return point.values[i];
    }
  }
  return std::nullopt;
}

std::optional<Cost> cost_at(const Curve& curve, const std::vector<Target>& targets) {
  const std::vector<Point>& points = curve.points;
  const auto far = [&](std::size_t i) { return excess(points[i], targets); };
  // ln(cost) over ln(error), along the line through two points.
  const auto slope = [&](std::size_t i) {
    return std::log(points[i + 1].cost.median / points[i].cost.median) / std::log(far(i) / far(i + 1));
  };
  const auto along = [&](std::size_t from, double rise) {
    return points[from].cost.median * std::pow(far(from), rise);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (far(i) <= 1 && (i + 1 == points.size() || far(i + 1) <= 1)) {
      const bool has_coarser = i > 0 && std::isfinite(far(i - 1)) && far(i) > 0;
      return Cost{.time = has_coarser ? along(i - 1, slope(i - 1)) : points[i].cost.median, .reached = true};
    }
  }
  constexpr double least_order = 0.5;
  if (const std::size_t count = points.size(); count >= 2) {
    const double rise = slope(count - 2);
    if (0 < rise && rise < 1 / least_order) {
      return Cost{.time = along(count - 1, rise), .reached = false};
    }
  }
  return std::nullopt;
}

const Point* most_accurate(const Curve& curve) {
  const Point* best = nullptr;
  for (const Point& point : curve.points) {
    if (std::isfinite(point.values.front()) && !(best && best->values.front() <= point.values.front())) {
      best = &point;
    }
  }
  return best;
}

}  // namespace goishi::verify::bench
