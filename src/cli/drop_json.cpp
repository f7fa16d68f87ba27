#include <fmt/format.h>

#include <goishi/error.hpp>
#include <iterator>

#include "drop_text.hpp"
#include "json.hpp"

namespace goishi::cli {

namespace {

class DropWriter {
 public:
  explicit DropWriter(const DropScene& scene) : scene_(scene), writer_(buffer_) { writer_.SetIndent(' ', 2); }

  [[nodiscard]] std::string text(const DropResult<double>& drop, const std::optional<DropSample>& asked) {
    writer_.StartObject();
    write_key(writer_, "events");
    writer_.StartArray();
    for (const Event<double>& event : drop.events) {
      write(event);
    }
    writer_.EndArray();
    if (asked) {
      write_key(writer_, "at");
      writer_.StartObject();
      member("time", asked->time);
      write_sample(*asked);
      writer_.EndObject();
    }
    write_key(writer_, "final");
    write_end(drop);
    writer_.EndObject();
    return std::string(buffer_.GetString(), buffer_.GetSize()) + "\n";
  }

 private:
  void member(std::string_view key, std::string_view value) {
    write_key(writer_, key);
    write_string(writer_, value);
  }
  void member(std::string_view key, double value) {
    write_key(writer_, key);
    write_number(writer_, Number(value));
  }
  void member(std::string_view key, int value) {
    write_key(writer_, key);
    writer_.Int(value);
  }
  void member(std::string_view key, std::initializer_list<double> values) {
    write_key(writer_, key);
    writer_.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    writer_.StartArray();
    for (const double value : values) {
      write_number(writer_, Number(value));
    }
    writer_.EndArray();
    writer_.SetFormatOptions(rapidjson::kFormatDefault);
  }
  void member(std::string_view key, const Vec3<double>& v) { member(key, {v.x(), v.y(), v.z()}); }

  void write_sample(const DropSample& sample) {
    const Quat<double>& q = sample.state.q_WB;
    member("position", sample.state.p_WB);
    member("attitude", {q.w(), q.x(), q.y(), q.z()});
    member("velocity", sample.state.v_WB);
    member("spin_body", sample.w_WB_B);
    member("energy", sample.energy);
  }

  void write(const Event<double>& event) {
    writer_.StartObject();
    member("time", event.time);
    member("kind", to_string(event.kind));
    write_sample(sample_of(scene_, event.time, event.after));
    const State<double>& before = event.before;
    if (before.v_WB != event.after.v_WB || before.L_W != event.after.L_W) {
      member("velocity_before", before.v_WB);
      member("spin_body_before", formula::angular_velocity_B(before, scene_.body));
    }
    if (event.impulse_W != Vec3<double>::Zero()) {
      member("impulse", event.impulse_W);
    }
    const Touched touched = touched_at(scene_, event);
    if (touched != Touched::nothing) {
      member("contact_point", event.contact_W);
      member("normal", event.normal_W);
      member("feature", to_string(event.feature));
      member("touched", to_string(touched));
      member("touched_feature", to_string(event.other_feature));
    }
    writer_.EndObject();
  }

  void write_end(const DropResult<double>& drop) {
    writer_.StartObject();
    member("status", to_string(drop.status));
    member("touched", to_string(touched_last(scene_, drop)));
    member("time", drop.time);
    write_sample(sample_of(scene_, drop.time, drop.state));
    if (drop.status == DropStatus::start_inside) {
      member("depth", drop.depth);
    }
    write_key(writer_, "lower_order");
    writer_.Bool(drop.lower_order);
    write_key(writer_, "counters");
    writer_.StartObject();
    const DropCounters& counters = drop.counters;
    member("impacts", counters.impacts);
    member("root_steps", counters.root_steps);
    member("separations", counters.separations);
    member("contact_evaluations", counters.contact_evaluations);
    member("steps_accepted", counters.steps_accepted);
    member("steps_rejected", counters.steps_rejected);
    member("evaluations_located", counters.evaluations_located);
    member("edge_impacts", counters.edge_impacts);
    writer_.EndObject();
    writer_.EndObject();
  }

  const DropScene& scene_;
  rapidjson::StringBuffer buffer_;
  JsonWriter writer_;
};

}  // namespace

std::string to_json(const DropScene& scene, const DropResult<double>& drop, const std::optional<DropSample>& asked) {
  return DropWriter(scene).text(drop, asked);
}

std::string to_csv(const std::vector<DropSample>& samples) {
  std::string text =
      "time_s,position_x_m,position_y_m,position_z_m,attitude_w,attitude_x,attitude_y,attitude_z,"
      "velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,spin_body_x_rad_s,spin_body_y_rad_s,spin_body_z_rad_s,"
      "height_m,tilt_deg,energy_J\n";
  for (const DropSample& sample : samples) {
    const State<double>& s = sample.state;
    const Vec3<double>& w = sample.w_WB_B;
    const double numbers[] = {s.p_WB.x(), s.p_WB.y(), s.p_WB.z(),  s.q_WB.w(),   s.q_WB.x(), s.q_WB.y(),
                              s.q_WB.z(), s.v_WB.x(), s.v_WB.y(),  s.v_WB.z(),   w.x(),      w.y(),
                              w.z(),      s.p_WB.z(), sample.tilt, sample.energy};
    fmt::format_to(std::back_inserter(text), "{:.17g}", sample.time);
    for (const double number : numbers) {
      fmt::format_to(std::back_inserter(text), ",{:.17g}", number);
    }
    text += "\n";
  }
  return text;
}

}  // namespace goishi::cli
