#include "drop.hpp"

#include "drop_motion.hpp"
#include "drop_scene.hpp"
#include "drop_text.hpp"
#include "file.hpp"
#include "quantity.hpp"
#include "report.hpp"

namespace goishi::cli {

namespace {

/// At a time that was asked for: a stone at rest stays.
Sample sample_at(const DropScene& scene, const DropResult<double>& result, const std::string& text) {
  const double time = to_double("at", parse("at", text, measure::time), "a drop", drop_order);
  require(0 <= time, "at", time, "must not be before the start");
  const bool rests = result.status == DropStatus::rest || result.status == DropStatus::rest_leaning;
  require(rests || time <= result.time, "at", time, "is after the end of the drop, at ", result.time, " s");
  return samples_of(scene, {time}).front();
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
  const DropResult<double> result = followed(drop);
  std::optional<Sample> asked;
  if (options.at) {
    asked = sample_at(scene, result, *options.at);
  }
  if (0 < rows) {
    write_file("csv", *options.csv, to_csv(series_of(scene, result.time, rows)));
  }
  write_standard_output(options.format == "json" ? to_json(scene, result, asked) : to_block(scene, result, asked));
  const int status = exit_status(result.status);
  if (status != 0) {
    report("error: " + end_of(scene, result));
  }
  return status;
}

}  // namespace goishi::cli
