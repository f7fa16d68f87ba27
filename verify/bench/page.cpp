#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/bench/report.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench {

namespace {

std::string with_unit(const Quantity& quantity) {
  return quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

std::string number_text(const Quantity& quantity, double value) {
  if (std::isnan(value)) {
    return "–";
  }
  return quantity.unit.empty() ? plain_number(std::round(value), 9) : plain_number(value, 2);
}

/// Zero has no place on a logarithmic axis: a power of ten below all others stands for it.
double zero_on_axis(const Race& race, std::size_t quantity) {
  double least = 1;
  for (const Curve& curve : race.curves) {
    for (const Point& point : curve.points) {
      const double value = point.values[quantity];
      least = 0 < value && value < least ? value : least;
    }
  }
  return std::pow(10.0, std::floor(std::log10(least)) - 1);
}

/// Without points for who did not take part: so each keeps its colour in all plots.
Plot plot_of(const Race& race, std::size_t quantity) {
  const double zero = zero_on_axis(race, quantity);
  bool has_zeros = false;
  Plot plot{.title = fmt::format("{}: {}", race.quantities[quantity].name, race.title),
            .x_label = race.cost + " [ns]",
            .y_label = with_unit(race.quantities[quantity]) + "; lower left is better",
            .log_x = true,
            .log_y = true,
            .equal_scale = false,
            .series = {},
            .labelled = true};
  plot.title.front() = static_cast<char>(std::toupper(plot.title.front()));
  for (const Curve& curve : race.curves) {
    const Who& who = curve.who;
    Series series{.name = who.label,
                  .points = {},
                  .line = true,
                  .look = who.family != "ours"       ? Look::foreign
                          : who.kind == Kind::direct ? Look::star
                                                     : Look::usual};
    for (const Point& point : curve.points) {
      if (const double value = point.values[quantity]; value == value) {
        has_zeros = has_zeros || value == 0;
        series.points.emplace_back(point.cost.median, value == 0 ? zero : value);
      }
    }
    plot.series.push_back(std::move(series));
  }
  if (!race.others.empty()) {
    plot.y_label += "; " + race.others;
  }
  if (has_zeros) {
    plot.y_label += "; zero is drawn at " + power_of_ten(static_cast<int>(std::lround(std::log10(zero))));
  }
  return plot;
}

/// What the leading error costs.
Table cost_table(const Race& race) {
  Table table{.caption = race.cost + " at equal " + race.quantities.front().name,
              .head = {with_unit(race.quantities.front())},
              .rows = {}};
  for (const int exponent : race.compared) {
    table.head.push_back(power_of_ten(exponent));
  }
  table.head.emplace_back("least reached");
  for (const Curve& curve : race.curves) {
    if (curve.points.empty()) {
      continue;
    }
    Table::Row row{.cells = {curve.who.label}, .holds = {}};
    for (const int exponent : race.compared) {
      const std::optional<Cost> cost = cost_at(curve, {{0, std::pow(10.0, exponent)}});
      row.cells.push_back(cost && cost->reached ? time_text(cost->time) : "–");
    }
    const Point* best = most_accurate(curve);
    row.cells.push_back(best ? plain_number(best->values.front(), 2) : "–");
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// All points. Where nobody has a setting, also how many times dearer each is than the first.
Table point_table(const Race& race) {
  Table table{.caption = "", .head = {"", race.cost}, .rows = {}};
  const bool has_times =
      race.curves.size() > 1 &&
      std::all_of(race.curves.begin(), race.curves.end(), [](const Curve& c) { return c.who.kind == Kind::direct; });
  if (race.by_case) {
    table.head.emplace_back("ninetieth percentile");
  }
  if (has_times) {
    table.head.emplace_back("times");
  }
  for (const Quantity& quantity : race.quantities) {
    table.head.push_back(with_unit(quantity));
  }
  double first = 0;
  for (const Curve& curve : race.curves) {
    for (const auto& [setting, cost, values] : curve.points) {
      first = first > 0 ? first : cost.median;
      Table::Row row{.cells = {point_name(curve.who, setting), time_text(cost.median)}, .holds = {}};
      if (race.by_case) {
        row.cells.push_back(time_text(cost.late));
      }
      if (has_times) {
        row.cells.push_back(plain_number(cost.median / first));
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        row.cells.push_back(number_text(race.quantities[i], values[i]));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Section part_of(const Race& race) {
  Section part{.title = race.title,
               .paragraphs = {race.note},
               .tables = {race.compared.empty() ? point_table(race) : cost_table(race)},
               .plots = {},
               .parts = {}};
  for (std::size_t i = 0; i < race.quantities.size(); ++i) {
    if (race.quantities[i].plotted && !race.quantities[i].unit.empty()) {
      part.plots.push_back(plot_of(race, i));
    }
  }
  return part;
}

}  // namespace

std::string time_text(double nanoseconds) {
  const auto& [unit, name] = nanoseconds < 999.5     ? std::pair(1.0, "ns")
                             : nanoseconds < 999.5e3 ? std::pair(1e3, "µs")
                                                     : std::pair(1e6, "ms");
  return fmt::format("{} {}", plain_number(nanoseconds / unit), name);
}

std::string point_name(const Who& who, double setting) {
  switch (who.kind) {
    case Kind::vertices:
      return fmt::format("{} of {} points", who.label, setting);
    case Kind::rings:
      return fmt::format("{}, {} rings", who.label, setting);
    case Kind::tolerance:
      return fmt::format("{}, tolerance {}", who.label, plain_number(setting));
    case Kind::step:
      return fmt::format("{}, steps of 1/{:.0f} s", who.label, 1 / setting);
    case Kind::stones:
      return fmt::format("{}, {} stones", who.label, setting);
    case Kind::direct:
      break;
  }
  return who.label;
}

std::string value_text(const Quantity& quantity, double value) {
  return number_text(quantity, value) + (quantity.unit.empty() ? "" : " " + quantity.unit);
}

Section page_section(const Bench& bench) {
  Table bars{.caption = "", .head = {"bar", "wanted", "measured", "held"}, .rows = {}};
  for (const Bar& bar : bars_of(bench)) {
    bars.rows.push_back({.cells = {bar.name, bar.wanted, bar.measured}, .holds = bar.held});
  }
  Section section{
      .title = "Run time against error",
      .paragraphs =
          {"Lower left is better. Thick and coloured is what Goishi ships; thin, grey and dashed are others. Run times "
           "are medians of processor time."},
      .tables = {std::move(bars)},
      .plots = {},
      .parts = {}};
  for (const Subject& subject : subjects()) {
    const auto is_raced = [&](const Problem& problem) {
      return std::any_of(bench.races.begin(), bench.races.end(),
                         [&](const Race& race) { return race.name == problem.name; });
    };
    if (std::any_of(subject.problems.begin(), subject.problems.end(), is_raced)) {
      section.paragraphs.push_back(subject.note);
    }
  }
  for (const Race& race : bench.races) {
    section.parts.push_back(part_of(race));
  }
  if (std::ranges::any_of(bench.races, [](const Race& race) { return race.name == "drop-to-rest"; })) {
    section.parts.push_back(history_section(history::read(history::recorded())));
  }
  return section;
}

}  // namespace goishi::verify::bench
