#include "drop.hpp"

#include "drop_motion.hpp"
#include "drop_scene.hpp"
#include "drop_text.hpp"
#include "file.hpp"
#include "quantity.hpp"
#include "report.hpp"

namespace goishi::cli {

namespace {

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
  const Drop<double> drop = drop_of(scene);
  if (0 < rows) {
    write_file("csv", *options.csv, to_csv(series_of(scene, drop, rows)));
  }
  write_standard_output(options.format == "json" ? to_json(scene, drop) : to_block(scene, drop));
  const int status = exit_status(drop.status);
  if (status != 0) {
    report("error: " + end_of(scene, drop));
  }
  return status;
}

}  // namespace goishi::cli
