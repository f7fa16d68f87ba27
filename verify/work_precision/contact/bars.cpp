#include <fmt/format.h>

#include <cmath>

#include "verify/report/number.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench::contact {

namespace {

// What is promised, for the machine that the README names; `problems` has the rest.
constexpr double greatest_region = 3;  // [ns] a stone
constexpr double greatest_gap = 15;

Bar time_bar(std::string name, const Timing& time, double greatest) {
  return {.name = std::move(name),
          .wanted = fmt::format("at most {}", time_text(greatest)),
          .measured = with_spread(time),
          .held = time.median <= greatest};
}

Bar error_bar(const Problem& problem, const Errors& errors) {
  const double width = problem.shape.width;
  const std::string missing = errors.unanswered == 0 ? "" : fmt::format("; {} unanswered", errors.unanswered);
  return {.name = fmt::format("{}, greatest error", problem.title),
          .wanted = fmt::format("at most {} of the width", plain_number(problem.greatest_error)),
          .measured = fmt::format("{} of the width{}", plain_number(errors.greatest / width, 2), missing),
          .held = errors.greatest <= problem.greatest_error * width && errors.unanswered == 0};
}

/// Everything that is told of many stones.
void add_scene_bars(const Speed& speed, std::vector<Bar>& bars) {
  bars.push_back(time_bar("region of the board, a stone", speed.region, greatest_region));
  bars.push_back(time_bar("gap to the surface, a stone", speed.gap, greatest_gap));
  Bar bar{.name = fmt::format("gaps of {} stones in a batch, a stone", speed.stones),
          .wanted = "less than one by one",
          .measured = "not measured: this processor lacks what the batch was compiled for",
          .held = false};
  if (speed.batch) {
    bar.measured = fmt::format("{}, {} lanes; {} ns one by one", with_spread(*speed.batch), speed.lanes,
                               plain_number(speed.gap.median));
    bar.held = speed.batch->median < speed.gap.median;
  }
  bars.push_back(bar);
}

}  // namespace

void add_bars(const std::vector<Race>& races, const Speed& speed, std::vector<Bar>& bars) {
  add_scene_bars(speed, bars);
  for (const Race& race : races) {
    const Curve* ours = curve_named(race, "double");
    if (ours == nullptr || ours->points.empty()) {
      continue;
    }
    const Point& point = ours->points.front();
    bars.push_back(time_bar(fmt::format("{}, a query", race.problem->title), point.cost, race.problem->greatest_time));
    if (std::isfinite(race.problem->greatest_error)) {
      bars.push_back(error_bar(*race.problem, point.errors));
    }
  }
}

}  // namespace goishi::verify::bench::contact
