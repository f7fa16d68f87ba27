#include <fmt/format.h>

#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"
#include "verify/work_precision/drop/drops.hpp"

namespace goishi::verify::bench::drops {

namespace {

constexpr std::size_t number_width = 12;

std::string level_table(const Speed& speed) {
  std::string out = fmt::format("\n{}: {} drops to rest, the error of the place against tolerance {}\n  {}", name,
                                speed.drops, plain_number(reference_tolerance), padded("tolerance", number_width));
  for (const char* head : {"median", "p90", "error [m]", "p90 [m]", "evaluations", "steps", "rejected"}) {
    out += right_aligned(head, number_width);
  }
  out += "\n";
  for (const Level& level : speed.levels) {
    out += "  " + padded(plain_number(level.tolerance), number_width);
    for (const std::string& cell :
         {time_text(level.time.median), time_text(level.late), plain_number(level.error, 2),
          plain_number(level.late_error, 2), std::to_string(level.counters.contact_evaluations),
          std::to_string(level.counters.steps_accepted), std::to_string(level.counters.steps_rejected)}) {
      out += right_aligned(cell, number_width);
    }
    out += "\n";
  }
  out += "  Impact laws:";
  for (const LawSpeed& law : speed.laws) {
    out += fmt::format(" {} {}{}", law.name, time_text(law.time.median), &law == &speed.laws.back() ? "\n" : ",");
  }
  return out;
}

std::string skip_table(const std::vector<Skip>& skips) {
  std::string out = "\nWhat a drop skips: medians, and how many times dearer it would be\n";
  for (const Skip& skip : skips) {
    out += fmt::format("  {}{}  {}{}  {}{}\n", padded(skip.name, 34), right_aligned(time_text(skip.time.median), 9),
                       padded(skip.ours, 46), right_aligned(time_text(skip.time_instead.median), 9),
                       padded(skip.instead, 58), right_aligned(plain_number(skip.worth()), 7));
  }
  return out;
}

std::string race_table(const Race& race) {
  std::string out = fmt::format("\n{}: {}; {} drops, {:.3f} s, the published law, no resistance\n  {}", race.name,
                                race.title, race.drops, race.time, padded("", 34));
  for (const char* head : {"a drop", "error [m]", "error [rad]"}) {
    out += right_aligned(head, number_width);
  }
  out += "\n";
  const auto add = [&](const Curve& curve) {
    for (const Point& point : curve.points) {
      const std::string setting = curve.ours ? fmt::format("tolerance {}", plain_number(point.setting))
                                             : fmt::format("1/{:.0f} s", 1.0 / point.setting);
      out += "  " + padded(fmt::format("{}, {}", curve.label, setting), 34);
      for (const std::string& cell :
           {time_text(point.time.median), plain_number(point.place, 2), plain_number(point.attitude, 2)}) {
        out += right_aligned(cell, number_width);
      }
      out += "\n";
    }
  };
  add(race.ours);
  for (const Curve& loop : race.loops) {
    add(loop);
  }
  return out;
}

}  // namespace

std::string text_tables(const Measured& measured) {
  std::string out = level_table(measured.speed) + skip_table(measured.skips);
  for (const Race& race : measured.races) {
    out += race_table(race);
  }
  return out;
}

std::string csv_rows(const Measured& measured) {
  std::string out;
  for (const Level& level : measured.speed.levels) {
    out += fmt::format("{},drop,ours,tolerance,{},{},,,,,,,,,,,,,{:.5g},{:.5g},{:.5g},{:.5g},{:.4g},{:.4g}\n", name,
                       level.tolerance, level.counters.contact_evaluations, level.time.median, level.time.lower,
                       level.time.upper, level.late, level.error, level.late_error);
  }
  const auto add = [&](const Race& race, const Curve& curve) {
    for (const Point& point : curve.points) {
      out += fmt::format("{},{},{},{},{},,,,,{:.4g},,,,,,,,,{:.5g},{:.5g},{:.5g},,{:.4g},\n", race.name, curve.name,
                         curve.ours ? "ours" : "published", curve.ours ? "tolerance" : "step", point.setting,
                         point.attitude, point.time.median, point.time.lower, point.time.upper, point.place);
    }
  };
  for (const Race& race : measured.races) {
    add(race, race.ours);
    for (const Curve& loop : race.loops) {
      add(race, loop);
    }
  }
  return out;
}

}  // namespace goishi::verify::bench::drops
