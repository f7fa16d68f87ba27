#pragma once
/// \file
/// Drops whose contact phases Lagrange's equations can follow: the stone and its laws as both sides see them, and each
/// contact phase of a drop held against the witness.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/oracles/drop/touching_body.hpp"
#include "verify/samples/contact.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

/// A stone, its laws, and the same for the witness.
struct Subject {
  Specimen specimen;
  RigidBody<double> body;
  DropSettings<double> settings;
  TouchingBody witness;
};

[[nodiscard]] inline Subject draw_subject(Context& context, int i) {
  Subject drawn{draw_stone(context, i % 2 == 0 ? 0 : 5), {}, {}, {}};
  const MassProperties<double> properties = mass_properties(drawn.specimen.stone, Density{2800.0});
  drawn.body = make_rigid_body(properties);

  DropSettings<double>& set = drawn.settings;
  set.tolerance = 1e-12;
  const FrictionModel models[] = {FrictionModel::dry, FrictionModel::dry, FrictionModel::dry,
                                  FrictionModel::slip_proportional, FrictionModel::coulomb_contensou};
  set.friction_model = models[i % 5];
  set.friction = i % 5 == 2 ? no_slip : context.uniform(0.05, 0.8);
  set.slip_coefficient = context.uniform(0.1, 3.0);
  set.patch_radius = 1e-3;
  if (i % 4 == 3) {
    set.rolling_resistance = set.pivot_radius = 0.0;
  }
  set = filled(set, drawn.specimen.stone);

  TouchingBody& witness = drawn.witness;
  witness.hull = narrow(hull_of(drawn.specimen));
  witness.axial = properties.moments_per_mass.axial;
  witness.transverse = properties.moments_per_mass.transverse;
  witness.gravity = g_earth;
  const TouchingBody::Law laws[] = {TouchingBody::Law::dry, TouchingBody::Law::slip_proportional,
                                    TouchingBody::Law::patch};
  witness.law = laws[static_cast<int>(set.friction_model)];
  witness.mu = set.friction;
  witness.coefficient = *set.slip_coefficient;
  witness.patch = 8 * static_cast<Long>(*set.patch_radius) / (3 * std::numbers::pi_v<Long>);
  witness.creep = *set.creep_speed;
  witness.rolling_resistance = *set.rolling_resistance;
  witness.pivot_radius = *set.pivot_radius;
  return drawn;
}

/// A state in contact as the witness takes it.
[[nodiscard]] inline TouchingPose pose_of(const Subject& subject, const State<double>& state) {
  const auto triple_of = [](const Long3& v) { return std::array<Long, 3>{v.x(), v.y(), v.z()}; };
  const Quat<Long> q = state.q_WB.cast<Long>().normalized();
  return {.p = triple_of(state.p_WB.cast<Long>()),
          .u = triple_of(q * Long3(0, 0, 1)),
          .e = triple_of(q * Long3(1, 0, 0)),
          .v = {state.v_WB.x(), state.v_WB.y()},
          .L = triple_of(state.L_W.cast<Long>() / static_cast<Long>(subject.body.mass))};
}

/// How far a state is from the witness's: place, axis and a point of the equator, momentum.
[[nodiscard]] inline std::array<Long, 3> differences(const Context& context, const Subject& subject,
                                                     const State<double>& state, const TouchingPose& end) {
  const TouchingBody& body = subject.witness;
  const auto vector = [](const std::array<Long, 3>& v) { return Long3(v[0], v[1], v[2]); };
  const Long R = static_cast<Long>(outer_width(subject.specimen.stone)) / 2;
  const Quat<Long> q = state.q_WB.cast<Long>();
  const Long3 L = context.produced(state.L_W).cast<Long>() / static_cast<Long>(subject.body.mass);
  const Long3 p = context.produced(state.p_WB).cast<Long>();
  const Long turned = std::sqrt(static_cast<Long>(g_earth) / R) * body.transverse;
  const Long axis = (context.produced(Long3(q * Long3(0, 0, 1))) - vector(end.u)).norm();
  return {(p - vector(end.p)).norm() / R, std::max(axis, (q * Long3(1, 0, 0) - vector(end.e)).norm()),
          (L - vector(end.L)).norm() / (vector(end.L).norm() + turned)};
}

struct Located {
  int phases = 0, left_out = 0;
  double seconds = 0.0, judged = 0.0;  // in contact, and of that those that are not left out
  int feature = 0, slip = 0, stick = 0;
};

[[nodiscard]] inline std::string describe(const Located& located) {
  return fmt::format("{}, {} of them left out; {} changes of feature, {} slips, {} sticks; {:.3g} of {:.3g} s",
                     located.phases, located.left_out, located.feature, located.slip, located.stick, located.judged,
                     located.seconds);
}

/// A state on the way, and when.
struct Moment {
  double time;
  const State<double>& state;
};

inline constexpr double longest_stretch = 0.25;  // [s] then the witness's own errors grow

/// A stretch of a drop in contact, held against the witness, who starts where it started.
inline void see_stretch(const Context& context, const Subject& subject, const Moment& from, const Moment& to,
                        Checks& checks, Located& located) {
  const double duration = to.time - from.time;
  if (!(1e-4 < duration && duration <= longest_stretch)) {
    return;
  }
  ++located.phases;
  const TouchingPath path = follow(subject.witness, pose_of(subject, from.state), duration);
  if (path.gave_up) {
    ++located.left_out;
    return;
  }
  const auto describe_case = [&] {
    return fmt::format("{}, {} s to {} s, μ = {:a}, {}", describe(subject.specimen), from.time, to.time,
                       subject.settings.friction, to_string(subject.settings.friction_model));
  };
  located.judged += duration;
  const bool lifts_before = path.lifted && path.time < 0.999999L * static_cast<Long>(duration);
  checks["faults"].see(lifts_before ? 1.0 : 0.0, [&] { return "it lifts off before: " + describe_case(); });
  if (!lifts_before) {
    const auto [place, attitude, momentum] = differences(context, subject, to.state, path.pose);
    checks["place"].see(as_double(place), describe_case);
    checks["attitude"].see(as_double(attitude), describe_case);
    checks["momentum"].see(as_double(momentum), describe_case);
  }
  for (const TouchingEvent& event : path.events) {
    ++(event.kind == "feature" ? located.feature : event.kind == "slip" ? located.slip : located.stick);
  }
}

/// A drop that gave up has stretches that nobody sees.
inline void see_status(const Subject& subject, const DropResult<double>& drop, Checks& checks) {
  checks["faults"].see(drop.status == DropStatus::rest || drop.status == DropStatus::moving ? 0.0 : 1.0, [&] {
    return fmt::format("{}: the drop ends as '{}' after {} s", describe(subject.specimen), to_string(drop.status),
                       drop.time);
  });
}

/// Whether the contact goes on after an event of this kind.
[[nodiscard]] inline bool stays(EventKind kind) {
  return kind == EventKind::contact || kind == EventKind::stick || kind == EventKind::slip ||
         kind == EventKind::feature;
}

/// The contact phases of a drop, each as a whole: all that the witness has is where it began.
inline void see_phases(const Context& context, const Subject& subject, const DropResult<double>& drop, Checks& checks,
                       Located& located) {
  for (std::size_t i = 0; i < drop.events.size(); ++i) {
    if (drop.events[i].kind != EventKind::contact) {
      continue;
    }
    std::size_t last = i;
    while (last + 1 < drop.events.size() && stays(drop.events[last].kind) &&
           drop.events[last + 1].kind != EventKind::rest) {
      ++last;
    }
    const Event<double>&from = drop.events[i], &to = drop.events[last];
    located.seconds += to.time - from.time;
    see_stretch(context, subject, {from.time, from.after}, {to.time, to.before}, checks, located);
  }
}

/// The first twelve stretches of a drop in contact, from event to event, and the last three. Long ones, and the one that
/// comes to rest but for its last hundredth, in parts, up to what its motion was then.
inline void see_stretches(const Context& context, const Subject& subject, const Drop<double>& motion,
                          const DropResult<double>& drop, Checks& checks, Located& located) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i + 1 < drop.events.size(); ++i) {
    if (stays(drop.events[i].kind)) {
      begins.push_back(i);
      located.seconds += drop.events[i + 1].time - drop.events[i].time;
    }
  }
  for (std::size_t k = 0; k < begins.size(); ++k) {
    if (12 <= k && k + 3 < begins.size()) {
      continue;
    }
    const Event<double>&from = drop.events[begins[k]], &to = drop.events[begins[k] + 1];
    const bool rests = to.kind == EventKind::rest;
    const double end = rests ? to.time - 0.01 * (to.time - from.time) : to.time;
    State<double> state = from.after;
    double time = from.time;
    while (rests ? time < end : longest_stretch < end - time) {
      const double next = std::min(time + longest_stretch, end);
      const State<double> there = motion.state_at(next);
      see_stretch(context, subject, {time, state}, {next, there}, checks, located);
      state = there;
      time = next;
    }
    if (!rests) {
      see_stretch(context, subject, {time, state}, {to.time, to.before}, checks, located);
    }
  }
}

}  // namespace goishi::verify
