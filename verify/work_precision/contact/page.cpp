#include <fmt/format.h>

#include <algorithm>

#include "verify/report/number.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench::contact {

namespace {

/// Zero has no place on a logarithmic axis.
constexpr double least_drawn = 1e-20;

struct Quantity {
  std::string_view name;
  double Errors::*error;
};
constexpr Quantity quantities[] = {{"Greatest error", &Errors::greatest}, {"Median error", &Errors::median}};

bool has_zeros(const Race& race, const Quantity& quantity) {
  return std::any_of(race.curves.begin(), race.curves.end(), [&](const Curve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(),
                       [&](const Point& point) { return point.errors.*quantity.error < least_drawn; });
  });
}

bool has_rivals() {
  return std::any_of(contestants().begin(), contestants().end(), [](const Contestant& who) { return !who.ours; });
}

Plot plot_of(const Race& race, const Quantity& quantity) {
  Plot plot{
      .title = fmt::format("{}: {}", quantity.name, race.problem->title),
      .x_label = "run time of a query [ns]",
      .y_label = fmt::format("error [m]; lower left is better{}{}", has_rivals() ? "; grey are libccd and FCL" : "",
                             has_zeros(race, quantity) ? "; zero is drawn at 10⁻²⁰" : ""),
      .log_x = true,
      .log_y = true,
      .equal_scale = false,
      .series = {},
      .labelled = true};
  for (const Curve& curve : race.curves) {
    Series series{.name = curve.contestant->label,
                  .points = {},
                  .line = true,
                  .look = curve.contestant->ours ? Look::star : Look::foreign};
    for (const Point& point : curve.points) {
      const double error = point.errors.*quantity.error;
      if (error == error) {
        series.points.emplace_back(point.cost.median, std::max(error, least_drawn));
      }
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Table table_of(const Race& race) {
  Table table{.caption = fmt::format("Over {} random poses", race.poses),
              .head = {"", "a query", "greatest error [m]", "median error [m]", "unanswered"},
              .rows = {}};
  for (const Curve& curve : race.curves) {
    for (const Point& point : curve.points) {
      table.rows.push_back({.cells = {point_name(*curve.contestant, point.setting), time_text(point.cost.median),
                                      plain_number(point.errors.greatest, 2), plain_number(point.errors.median, 2),
                                      std::to_string(point.errors.unanswered)},
                            .holds = {}});
    }
  }
  return table;
}

/// What the stone is, and how near.
std::string shape_text(const Problem& problem) {
  const auto millimetres = [](double metres) { return plain_number(1e3 * metres); };
  return fmt::format("{} × {} mm, bevel {} mm", millimetres(problem.shape.width), millimetres(problem.shape.height),
                     millimetres(problem.shape.bevel));
}

}  // namespace

std::string page_paragraph() {
  std::string text =
      "Contact: the error is that of the gap (of a time of impact: times the speed of approach), over the same random "
      "poses near contact for all. Stars are Goishi's queries, which have no setting, and the talk's test with its "
      "fixed "
      "axes; in float the rounding of the pose counts too. ";
  if (!has_rivals()) {
    return text + "libccd and FCL were not there when this was built.";
  }
  return text +
         "libccd and FCL are asked about the convex hull of 64 to 4096 points of the stone's surface, and libccd about "
         "the exact support function too, with falling tolerances. libccd knows no distance of bodies that are apart, "
         "so "
         "there the stone has a margin of 3 mm, which is taken off its depth. For a time of impact their gaps advance "
         "the "
         "flight, never farther than the stone could have come, to 1 µm of contact. Unanswered are those poses that a "
         "library gave up, or did not see within the margin, or to which the fixed axes have nothing to say.";
}

Section page_part(const Race& race) {
  Section part{.title = race.problem->title,
               .paragraphs = {fmt::format("Stone of {}. Right answer: {}.", shape_text(*race.problem), race.witness)},
               .tables = {table_of(race)},
               .plots = {},
               .parts = {}};
  for (const Quantity& quantity : quantities) {
    part.plots.push_back(plot_of(race, quantity));
  }
  return part;
}

}  // namespace goishi::verify::bench::contact
