#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/number.hpp"
#include "verify/work_precision/bench.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench {

namespace {

/// Zero has no place on a logarithmic axis.
constexpr double least_drawn = 1e-17;

struct Quantity {
  std::string_view name;
  std::string_view unit;
  double Errors::*error;
};
constexpr Quantity quantities[] = {{"Attitude", "rad", &Errors::attitude},
                                   {"Energy", "relative to the kinetic energy", &Errors::energy},
                                   {"|L|", "relative", &Errors::momentum}};

/// Without points for who did not take part: so each keeps its colour in all plots.
Series series_of(const Contestant& who, const Race& race, const Quantity& quantity) {
  Series series{.name = who.label,
                .points = {},
                .line = true,
                .look = who.family == Family::odeint    ? Look::foreign
                        : who.kind == Kind::closed_form ? Look::star
                                                        : Look::usual};
  for (const Curve& curve : race.curves) {
    for (const Point& point : curve.points) {
      const double error = point.errors.*quantity.error;
      if (curve.contestant == &who && error == error) {  // a run that did not complete is no point
        series.points.emplace_back(point.cost.median, std::max(error, least_drawn));
      }
    }
  }
  return series;
}

bool has_zeros(const Race& race, const Quantity& quantity) {
  return std::any_of(race.curves.begin(), race.curves.end(), [&](const Curve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(),
                       [&](const Point& point) { return point.errors.*quantity.error < least_drawn; });
  });
}

Plot plot_of(const Race& race, const Quantity& quantity) {
  Plot plot{.title = fmt::format("{}: {}", quantity.name, race.problem->title),
            .x_label = "run time per simulated second [ns]",
            .y_label = fmt::format("error at the end [{}]; lower left is better; grey is Odeint{}", quantity.unit,
                                   has_zeros(race, quantity) ? "; zero is drawn at 10⁻¹⁷" : ""),
            .log_x = true,
            .log_y = true,
            .equal_scale = false,
            .series = {},
            .labelled = true};
  for (const Contestant& who : contestants()) {
    plot.series.push_back(series_of(who, race, quantity));
  }
  return plot;
}

Table cost_table(const Race& race) {
  Table table{
      .caption = "Run time per simulated second at equal attitude error", .head = {"attitude error [rad]"}, .rows = {}};
  for (const int exponent : compared_errors) {
    table.head.push_back(power_of_ten(exponent));
  }
  table.head.emplace_back("least error reached");
  for (const Curve& curve : race.curves) {
    Table::Row row{.cells = {curve.contestant->label}, .holds = {}};
    for (const int exponent : compared_errors) {
      const std::optional<double> cost = cost_at(curve, std::pow(10.0, exponent));
      row.cells.push_back(cost ? time_text(*cost) : "–");
    }
    const std::optional<Point> best = most_accurate(curve);
    row.cells.push_back(best ? plain_number(best->errors.attitude, 2) : "–");
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table bar_table(const Bench& bench) {
  Table table{.caption = "", .head = {"bar", "wanted", "measured", "held"}, .rows = {}};
  for (const Bar& bar : bars_of(bench)) {
    table.rows.push_back({.cells = {bar.name, bar.wanted, bar.measured}, .holds = bar.held});
  }
  return table;
}

}  // namespace

Section page_section(const Bench& bench) {
  Section section{
      .title = "Run time against error",
      .paragraphs =
          {"Lower left is better. Thick and coloured is what Goishi ships; thin, grey and dashed are others. Run times "
           "are medians of processor time."},
      .tables = {bar_table(bench)},
      .plots = {},
      .parts = {}};
  if (!bench.races.empty()) {
    section.paragraphs.push_back(
        "Motion: each curve is one way to compute the same motion in double, from coarse to as fine as round-off or "
        "patience allow. Grey are Odeint's steppers on the raw Newton–Euler equations; a star is a closed form, which "
        "takes one call and has no step. Odeint's quaternion is normalised before its error is taken. Compare at equal "
        "error: the tables interpolate each curve there, and a dash means that it never comes so far.");
  }
  if (!bench.contact_races.empty()) {
    section.paragraphs.push_back(contact::page_paragraph());
  }
  for (const Race& race : bench.races) {
    Section part{.title = race.problem->title,
                 .paragraphs = {fmt::format("Right answer: {}.", race.witness)},
                 .tables = {cost_table(race)},
                 .plots = {},
                 .parts = {}};
    for (const Quantity& quantity : quantities) {
      part.plots.push_back(plot_of(race, quantity));
    }
    section.parts.push_back(std::move(part));
  }
  for (const contact::Race& race : bench.contact_races) {
    section.parts.push_back(contact::page_part(race));
  }
  if (bench.drops) {
    for (Section& part : drops::page_parts(*bench.drops)) {
      section.parts.push_back(std::move(part));
    }
  }
  return section;
}

}  // namespace goishi::verify::bench
