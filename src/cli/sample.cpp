#include "sample.hpp"

#include <fmt/format.h>

#include <cmath>
#include <goishi/motion/invariants.hpp>
#include <iterator>
#include <numbers>

#include "json.hpp"

namespace goishi::cli {

Sample sample_of(double time, const State<double>& state, const RigidBody<double>& body, const Vec3<double>& gravity) {
  const Vec3<double> u = formula::symmetry_axis(state.q_WB);
  return {.time = time,
          .state = state,
          .w_WB_B = formula::angular_velocity_B(state, body),
          .tilt = std::atan2(std::hypot(u.x(), u.y()), u.z()) * 180 / std::numbers::pi,
          .energy = formula::energy(state, body, gravity)};
}

void append_cells(std::string& text, const Sample& sample) {
  const State<double>& s = sample.state;
  const Vec3<double>& w = sample.w_WB_B;
  const double numbers[] = {s.p_WB.x(), s.p_WB.y(), s.p_WB.z(),  s.q_WB.w(),   s.q_WB.x(), s.q_WB.y(),
                            s.q_WB.z(), s.v_WB.x(), s.v_WB.y(),  s.v_WB.z(),   w.x(),      w.y(),
                            w.z(),      s.p_WB.z(), sample.tilt, sample.energy};
  for (const double number : numbers) {
    fmt::format_to(std::back_inserter(text), ",{:.17g}", number);
  }
}

void write_sample(JsonText& json, const Sample& sample) {
  const Quat<double>& q = sample.state.q_WB;
  json.member("position", sample.state.p_WB);
  json.member("attitude", {q.w(), q.x(), q.y(), q.z()});
  json.member("velocity", sample.state.v_WB);
  json.member("spin_body", sample.w_WB_B);
  json.member("energy", sample.energy);
}

void write_event(JsonText& json, const Event<double>& event, const RigidBody<double>& body, const Vec3<double>& gravity,
                 std::string_view touched) {
  json.member("time", event.time);
  json.member("kind", to_string(event.kind));
  write_sample(json, sample_of(event.time, event.after, body, gravity));
  const State<double>& before = event.before;
  if (before.v_WB != event.after.v_WB || before.L_W != event.after.L_W) {
    json.member("velocity_before", before.v_WB);
    json.member("spin_body_before", formula::angular_velocity_B(before, body));
  }
  if (event.impulse_W != Vec3<double>::Zero()) {
    json.member("impulse", event.impulse_W);
  }
  if (event.contact_W.allFinite()) {
    json.member("contact_point", event.contact_W);
    json.member("normal", event.normal_W);
    json.member("feature", to_string(event.feature));
    json.member("touched", touched);
    json.member("touched_feature", to_string(event.other_feature));
  }
}

bool is_on_floor(const Board<double>& board, const Vec3<double>& contact_W, OtherFeature feature) {
  return contact_W.z() < board.floor / 2 && feature == OtherFeature::surface;
}

}  // namespace goishi::cli
