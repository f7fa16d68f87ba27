#include "drop.hpp"

#include "drop_motion.hpp"
#include "drop_scene.hpp"
#include "drop_text.hpp"
#include "file.hpp"
#include "quantity.hpp"
#include "report.hpp"

namespace goishi::cli {

namespace {

/// Of motion that is kept, of some 800 bytes each.
constexpr std::size_t most_stretches = 4'000'000;

/// At a time that was asked for: a stone at rest stays.
DropSample sample_at(const DropScene& scene, Drop<double>& drop, const std::string& text) {
  const double time = to_double("at", parse("at", text, measure::time), "a drop", drop_order);
  require(0 <= time, "at", time, "must not be before the start");
  if (drop.time() < time && (drop.status() == DropStatus::rest || drop.status() == DropStatus::rest_leaning)) {
    drop.advance_to(time);
  }
  require(time <= drop.time(), "at", time, "is after the end of the drop, at ", drop.time(), " s");
  return sample_of(scene, time, drop.state_at(time));
}

int exit_status(DropStatus status) {
  switch (status) {
    case DropStatus::start_inside:
      return 3;
    case DropStatus::too_many_events:
    case DropStatus::too_many_steps:
    case DropStatus::not_converged:
      return 1;
    case DropStatus::rest:
    case DropStatus::rest_leaning:
    case DropStatus::moving:
    case DropStatus::flies_on:
      break;
  }
  return 0;
}

}  // namespace

int run_drop(const DropOptions& options) {
  const DropScene scene = scene_of(options);
  const int rows = options.series ? parse_whole("series", *options.series, 2, most_drop_rows) : 0;
  Drop<double> drop = drop_of(scene);
  if (0 < rows || options.at) {
    drop.keep_motion(most_stretches);
  }
  const DropResult<double> result = followed(drop);
  std::optional<DropSample> asked;
  if (options.at) {
    asked = sample_at(scene, drop, *options.at);
  }
  if (0 < rows) {
    write_file("csv", *options.csv, to_csv(series_of(scene, drop, rows)));
  }
  write_standard_output(options.format == "json" ? to_json(scene, result, asked) : to_block(scene, result, asked));
  const int status = exit_status(result.status);
  if (status != 0) {
    report("error: " + end_of(scene, result));
  }
  return status;
}

}  // namespace goishi::cli
