#include "scene/scene.hpp"

#include <stdexcept>

#include "file.hpp"
#include "quantity.hpp"
#include "report.hpp"
#include "scene/text.hpp"
#include "subject.hpp"

namespace goishi::cli {

namespace {

constexpr std::size_t most_bytes = 64 << 20;  // of a scene's file

SceneFile file_of(const SceneOptions& options) {
  if (!options.file) {
    throw std::runtime_error("a scene is needed: goishi scene FILE");
  }
  require_with("series", options.series, "csv", options.csv);
  require_with("csv", options.csv, "series", options.series);
  if (options.format && *options.format != "text" && *options.format != "json") {
    throw InvalidArgument("format", *options.format, "must be text or json");
  }
  const std::string text = read_file("file", *options.file, most_bytes);
  require(text.size() < most_bytes, "file", *options.file, "must be smaller than ", most_bytes, " bytes");
  return read_scene(*options.file, text);
}

int rows_of(const SceneOptions& options, const ScenePlay& end) {
  if (!options.series) {
    return 0;
  }
  const auto stones = static_cast<long long>(end.count());
  const long long most = most_scene_rows / std::max(stones, 1LL);
  return parse_whole("series", *options.series, 2, static_cast<int>(std::max(most, 2LL)));
}

}  // namespace

int run_scene(const SceneOptions& options) {
  if (options.schema) {
    write_standard_output(scene_schema());
    return 0;
  }
  const SceneFile file = file_of(options);
  report_notes(file.notes);
  ScenePlay play(file);
  const int times = rows_of(options, play);
  SceneSummary summary(play);
  std::optional<SceneJson> json;
  if (options.format == "json") {
    json.emplace(file);
  }
  const auto tell = [&](const SceneEvent<double>& event) {
    summary.tell(event);
    if (json) {
      json->tell(play, event);
    }
  };
  const bool rests = play.advance_to_end(tell);
  if (0 < times) {
    write_file("csv", *options.csv, series_of(file, play.scene().time(), times));
  }
  write_standard_output(json ? json->text(play, rests) : summary.text(file, play, rests));
  if (file.to_rest && !rests) {
    report("error: " + end_of(play, rests));
    return 1;
  }
  return 0;
}

}  // namespace goishi::cli
