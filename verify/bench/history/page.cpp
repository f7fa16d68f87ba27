#include <fmt/format.h>

#include "verify/bench/history/history.hpp"
#include "verify/bench/report.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench {

namespace {

using history::History;

struct Title {
  std::string_view problem, title;
};
constexpr Title titles[] = {
    {"thrown", "Let go at 5 cm in any attitude, with up to 30 rad/s"},
    {"set-down", "Set down: let go 1 mm over the board, tilted by up to 5°, moving by up to 1 cm/s"}};

std::string title_of(const history::Curve& curve) {
  for (const auto& [problem, title] : titles) {
    if (curve.problem == problem) {
      return std::string(title);
    }
  }
  return curve.problem;
}

std::string scheme_of(const History& all, std::string_view which) {
  const std::string name(which);
  return fmt::format("{} ({})", all.facts.at(name), all.facts.at(name + "-date"));
}

std::string measured_text(const History& all) {
  const auto fact = [&](const char* name) { return all.facts.at(name); };
  return fmt::format(
      "The drop of commit {} beside that of {}: {} drops of size 33 with a bevel of 1 mm, both compiled by the same "
      "compiler "
      "and run in turn {} times. Errors are of the place of rest, against the same scheme's run at tolerance 1e-12. "
      "Measured "
      "on {}, on {}, by {}.",
      scheme_of(all, "old"), scheme_of(all, "new"), fact("drops"), fact("rounds"), fact("measured"), fact("machine"),
      fact("compiler"));
}

Table table_of(const history::Curve& old, const history::Curve& now, const std::string& caption) {
  Table table{.caption = caption,
              .head = {"tolerance", fmt::format("{}: time", old.commit), "median error",
                       fmt::format("{}: time", now.commit), "median error", "share of the time"},
              .rows = {}};
  const auto metres = [](double error) { return plain_number(error, 2) + " m"; };
  for (std::size_t i = 0; i < old.points.size(); ++i) {
    const history::Point &a = old.points[i], &b = now.points[i];
    table.rows.push_back({.cells = {plain_number(a.tolerance), time_text(a.time), metres(a.error), time_text(b.time),
                                    metres(b.error), fmt::format("{:.2f}", b.time / a.time)},
                          .holds = {}});
  }
  return table;
}

Plot plot_of(const history::Curve& old, const history::Curve& now) {
  Plot plot{.title = "Median error of the place of rest: " + title_of(old),
            .x_label = "run time of a drop [ns]",
            .y_label = "median error [m]; lower left is better; grey is the old scheme",
            .log_x = true,
            .log_y = true,
            .equal_scale = false,
            .series = {},
            .labelled = true};
  for (const history::Curve* const curve : {&now, &old}) {
    Series series{.name = (curve == &now ? "new, " : "old, ") + curve->commit,
                  .points = {},
                  .line = true,
                  .look = curve == &now ? Look::usual : Look::foreign};
    for (const history::Point& point : curve->points) {
      series.points.emplace_back(point.time, point.error);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

Section history_section(const History& all) {
  Section section{.title = "The drop as it was, and as it is",
                  .paragraphs = {measured_text(all)},
                  .tables = {},
                  .plots = {},
                  .parts = {}};
  for (std::size_t i = 0; i < all.curves.size(); i += 2) {
    section.tables.push_back(table_of(all.curves[i], all.curves[i + 1], title_of(all.curves[i])));
    section.plots.push_back(plot_of(all.curves[i], all.curves[i + 1]));
  }
  return section;
}

std::string history_text(const History& all) {
  std::string out = measured_text(all) + "\n";
  for (std::size_t i = 0; i < all.curves.size(); i += 2) {
    out += "\n" + piped(table_of(all.curves[i], all.curves[i + 1], title_of(all.curves[i])));
  }
  return out;
}

}  // namespace goishi::verify::bench
