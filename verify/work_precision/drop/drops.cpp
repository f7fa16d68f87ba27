#include "verify/work_precision/drop/drops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/number.hpp"

namespace goishi::verify::bench::drops {

namespace {

// What is promised, for the machine that the README names.
struct LevelBar {
  double tolerance;
  double greatest_time;  // [ns] median
};
constexpr LevelBar level_bars[] = {{1e-6, 1.5e6}, {1e-9, 4e6}};
constexpr double greatest_late = 4;             // of the median that was measured, the ninetieth percentile
constexpr double greatest_error = 1e-7;         // [m] median, of the place of rest
constexpr double exact_tolerance = 1e-9;        // at this tolerance
constexpr double greatest_elastic_time = 10e6;  // [ns]
constexpr double greatest_impact_time = 50;     // [ns]
constexpr double least_advantage = 100;         // over the talk's loop, at equal error

void add_level_bars(const Speed& speed, std::vector<Bar>& bars) {
  for (const auto& [tolerance, greatest_time] : level_bars) {
    for (const Level& level : speed.levels) {
      if (level.tolerance != tolerance) {
        continue;
      }
      bars.push_back({.name = fmt::format("drop to rest at tolerance {}, median", plain_number(tolerance)),
                      .wanted = fmt::format("at most {}", time_text(greatest_time)),
                      .measured = with_spread(level.time),
                      .held = level.time.median <= greatest_time && level.not_at_rest == 0});
      bars.push_back(
          {.name = fmt::format("drop to rest at tolerance {}, ninetieth percentile", plain_number(tolerance)),
           .wanted = fmt::format("at most {} times the median", greatest_late),
           .measured = fmt::format("{}, {:.2f} times", time_text(level.late), level.late / level.time.median),
           .held = level.late <= greatest_late * level.time.median});
    }
  }
}

void add_error_bar(const Speed& speed, std::vector<Bar>& bars) {
  for (const Level& level : speed.levels) {
    if (level.tolerance == exact_tolerance) {
      bars.push_back(
          {.name = fmt::format("place of rest at tolerance {}, median error", plain_number(exact_tolerance)),
           .wanted = fmt::format("at most {} m", plain_number(greatest_error)),
           .measured = fmt::format("{} m against {}", plain_number(level.error, 2), plain_number(reference_tolerance)),
           .held = level.error <= greatest_error});
    }
  }
}

Bar advantage_bar(const Race& race, const Curve& loop, const std::optional<Cost>& ours) {
  Bar bar{.name = fmt::format("{}: drop against {}", race.title, loop.label),
          .wanted = fmt::format("at least {} times cheaper at {} rad, {} µm", least_advantage,
                                plain_number(compared_attitude), plain_number(1e6 * compared_place)),
          .measured = "the drop does not reach it",
          .held = false};
  if (!ours || !ours->reached) {
    return bar;
  }
  if (const std::optional<Cost> cost = cost_of(loop)) {
    const double ratio = cost->time / ours->time;
    bar.measured = fmt::format("{:.0f} times{}", ratio, cost->reached ? "" : ", by its order: it did not come so far");
    bar.held = ratio >= least_advantage;
  } else {
    const Point& fine = loop.points.back();
    bar.measured = fmt::format("does not converge: {} rad, {} m with steps of 1/{:.0f} s",
                               plain_number(fine.attitude, 2), plain_number(fine.place, 2), 1.0 / fine.setting);
    bar.held = true;
  }
  return bar;
}

}  // namespace

Measured measure(const Effort& effort, const std::function<void()>& round_done) {
  const bool quick = effort.poses <= quick_effort.poses;
  const Scene scene = make_scene(effort.poses / 16);
  Measured measured;
  const std::vector<double> few = {1e-6, 1e-9};
  const std::vector<double> all = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  measured.speed = measure_speed(scene, quick ? few : all, quick ? 1 : 3, effort);
  round_done();
  measured.skips = measure_skips(scene, effort);
  round_done();
  measured.races = run_races(scene, quick ? 15360.0 : 245760.0, effort);
  round_done();
  return measured;
}

void add_bars(const Measured& measured, std::vector<Bar>& bars) {
  const Speed& speed = measured.speed;
  add_level_bars(speed, bars);
  add_error_bar(speed, bars);
  bars.push_back(
      {.name = fmt::format("{} elastic frictionless bounces", elastic_bounces),
       .wanted = fmt::format("at most {}", time_text(greatest_elastic_time)),
       .measured = fmt::format("{}, energy within {}", with_spread(speed.elastic), plain_number(speed.energy_error, 2)),
       .held = speed.elastic.median <= greatest_elastic_time});
  const LawSpeed& law = speed.laws.front();
  bars.push_back({.name = fmt::format("impact law, {}", law.name),
                  .wanted = fmt::format("at most {}", time_text(greatest_impact_time)),
                  .measured = with_spread(law.time),
                  .held = law.time.median <= greatest_impact_time});
  for (const Race& race : measured.races) {
    const std::optional<Cost> ours = cost_of(race.ours);
    for (const Curve& loop : race.loops) {
      bars.push_back(advantage_bar(race, loop, ours));
    }
  }
}

}  // namespace goishi::verify::bench::drops
