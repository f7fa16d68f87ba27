#include <fmt/format.h>

#include <algorithm>

#include "verify/report/number.hpp"
#include "verify/work_precision/drop/drops.hpp"

namespace goishi::verify::bench::drops {

namespace {

/// Zero has no place on a logarithmic axis.
constexpr double least_drawn = 1e-17;

Plot empty_plot(std::string title, std::string y_label) {
  return {.title = std::move(title),
          .x_label = "run time of a drop [ns]",
          .y_label = std::move(y_label),
          .log_x = true,
          .log_y = true,
          .equal_scale = false,
          .series = {},
          .labelled = true};
}

Plot level_plot(const Speed& speed) {
  Plot plot = empty_plot("Place of rest", "error [m]; lower left is better");
  Series middle{.name = "median", .points = {}}, late{.name = "ninetieth percentile", .points = {}};
  for (const Level& level : speed.levels) {
    middle.points.emplace_back(level.time.median, std::max(level.error, least_drawn));
    late.points.emplace_back(level.late, std::max(level.late_error, least_drawn));
  }
  plot.series = {middle, late};
  return plot;
}

Section speed_part(const Speed& speed) {
  Section part{
      .title = "A stone dropped from 5 cm, to rest",
      .paragraphs = {fmt::format(
          "{} drops of size 33, bevel 1 mm, in random attitude with random spin up to 30 rad/s, under the "
          "default settings. The error of the place of rest is against runs at tolerance {}. Counts are medians.",
          speed.drops, plain_number(reference_tolerance))},
      .tables = {},
      .plots = {level_plot(speed)},
      .parts = {}};
  Table levels{.caption = "",
               .head = {"tolerance", "a drop", "ninetieth percentile", "error [m]", "ninetieth percentile [m]",
                        "evaluations in contact", "steps", "rejected", "impacts"},
               .rows = {}};
  for (const Level& level : speed.levels) {
    levels.rows.push_back(
        {.cells = {plain_number(level.tolerance), time_text(level.time.median), time_text(level.late),
                   plain_number(level.error, 2), plain_number(level.late_error, 2),
                   std::to_string(level.counters.contact_evaluations), std::to_string(level.counters.steps_accepted),
                   std::to_string(level.counters.steps_rejected), std::to_string(level.counters.impacts)},
         .holds = {}});
  }
  Table laws{.caption = "Impact laws, on contacts in random attitude", .head = {"law", "an impact"}, .rows = {}};
  for (const LawSpeed& law : speed.laws) {
    laws.rows.push_back({.cells = {law.name, with_spread(law.time)}, .holds = {}});
  }
  part.tables = {levels, laws};
  return part;
}

/// A time that stays on one line.
std::string unbroken(const Timing& time) {
  std::string text = time_text(time.median);
  return text.replace(text.find(' '), 1, "\u00a0");
}

Section skip_part(const std::vector<Skip>& skips) {
  Section part{
      .title = "What a drop skips",
      .paragraphs = {"Each pair was measured in one run, by turns; the last column says how many times dearer "
                     "it is not to skip."},
      .tables = {{.caption = "", .head = {"", "what is done", "takes", "instead of", "takes", "times"}, .rows = {}}},
      .plots = {},
      .parts = {}};
  for (const Skip& skip : skips) {
    part.tables.front().rows.push_back({.cells = {skip.name, skip.ours, unbroken(skip.time), skip.instead,
                                                  unbroken(skip.time_instead), plain_number(skip.worth())},
                                        .holds = {}});
  }
  return part;
}

Plot race_plot(const Race& race, const char* quantity, const char* unit, double Point::*error) {
  Plot plot = empty_plot(
      fmt::format("{}: {}", quantity, race.title),
      fmt::format("median error [{}]; lower left is better; grey is the loop; zero is drawn at 10⁻¹⁷", unit));
  const auto add = [&](const Curve& curve) {
    Series series{.name = curve.label, .points = {}, .line = true, .look = curve.ours ? Look::usual : Look::foreign};
    for (const Point& point : curve.points) {
      series.points.emplace_back(point.time.median, std::max(point.*error, least_drawn));
    }
    plot.series.push_back(std::move(series));
  };
  add(race.ours);
  for (const Curve& loop : race.loops) {
    add(loop);
  }
  return plot;
}

Section race_part(const Race& race) {
  Section part{
      .title = fmt::format("{}: the talk's loop beside the drop", race.title),
      .paragraphs = {fmt::format(
          "{} drops, simulated for {:.3f} s in the median, under the same rules for both: the published law, no "
          "resistance, no damping. The talk's loop holds the angular velocity; the original program kept L. Right "
          "answer: the drop at tolerance {}, to which the loop with L kept converges.",
          race.drops, race.time, plain_number(reference_tolerance))},
      .tables = {{.caption = "", .head = {"", "a drop", "median error [m]", "median error [rad]"}, .rows = {}}},
      .plots = {race_plot(race, "Attitude", "rad", &Point::attitude), race_plot(race, "Place", "m", &Point::place)},
      .parts = {}};
  const auto add = [&](const Curve& curve) {
    for (const Point& point : curve.points) {
      const std::string setting = curve.ours ? fmt::format("tolerance {}", plain_number(point.setting))
                                             : fmt::format("1/{:.0f} s", 1.0 / point.setting);
      part.tables.front().rows.push_back(
          {.cells = {fmt::format("{}, {}", curve.label, setting), time_text(point.time.median),
                     plain_number(point.place, 2), plain_number(point.attitude, 2)},
           .holds = {}});
    }
  };
  add(race.ours);
  for (const Curve& loop : race.loops) {
    add(loop);
  }
  return part;
}

}  // namespace

std::vector<Section> page_parts(const Measured& measured) {
  std::vector<Section> parts = {speed_part(measured.speed), skip_part(measured.skips)};
  for (const Race& race : measured.races) {
    parts.push_back(race_part(race));
  }
  return parts;
}

}  // namespace goishi::verify::bench::drops
