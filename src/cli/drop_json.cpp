#include <fmt/format.h>

#include <iterator>

#include "drop_text.hpp"
#include "json.hpp"

namespace goishi::cli {

namespace {

void write_end(JsonText& json, const DropScene& scene, const DropResult<double>& drop) {
  json.member("status", to_string(drop.status));
  json.member("touched", to_string(touched_last(scene, drop)));
  json.member("time", drop.time);
  write_sample(json, sample_of(scene, drop.time, drop.state));
  if (drop.status == DropStatus::start_inside) {
    json.member("depth", drop.depth);
  }
  json.member("lower_order", drop.lower_order);
  json.begin_object("counters");
  const DropCounters& counters = drop.counters;
  json.count("impacts", counters.impacts);
  json.count("root_steps", counters.root_steps);
  json.count("separations", counters.separations);
  json.count("contact_evaluations", counters.contact_evaluations);
  json.count("steps_accepted", counters.steps_accepted);
  json.count("steps_rejected", counters.steps_rejected);
  json.count("evaluations_located", counters.evaluations_located);
  json.count("edge_impacts", counters.edge_impacts);
  json.end_object();
}

}  // namespace

std::string to_json(const DropScene& scene, const DropResult<double>& drop, const std::optional<Sample>& asked) {
  JsonText json;
  json.begin_array("events");
  for (const Event<double>& event : drop.events) {
    json.begin_object();
    write_event(json, event, scene.solid.body, scene.settings.gravity, to_string(touched_at(scene, event)));
    json.end_object();
  }
  json.end_array();
  if (asked) {
    json.begin_object("at");
    json.member("time", asked->time);
    write_sample(json, *asked);
    json.end_object();
  }
  json.begin_object("final");
  write_end(json, scene, drop);
  json.end_object();
  return json.text();
}

std::string to_csv(const std::vector<Sample>& samples) {
  std::string text = fmt::format("time_s,{}\n", sample_columns);
  for (const Sample& sample : samples) {
    fmt::format_to(std::back_inserter(text), "{:.17g}", sample.time);
    append_cells(text, sample);
    text += "\n";
  }
  return text;
}

}  // namespace goishi::cli
