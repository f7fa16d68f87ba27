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

/// A state in contact in the witness's coordinates.
[[nodiscard]] inline TouchingState coordinates_of(const Subject& subject, const State<double>& state) {
  const Quat<Long> q = state.q_WB.cast<Long>().normalized();
  const Long3 L = state.L_W.cast<Long>() / static_cast<Long>(subject.body.mass), u = q * Long3(0, 0, 1);
  const Long radial = std::hypot(u.x(), u.y());
  const Long3 nodes(-u.y() / radial, u.x() / radial, 0), down = nodes.cross(u), e = q * Long3(1, 0, 0);
  return {state.p_WB.x(),
          state.p_WB.y(),
          std::atan2(radial, u.z()),
          std::atan2(u.y(), u.x()),
          std::atan2(e.dot(nodes), e.dot(down)),
          state.v_WB.x(),
          state.v_WB.y(),
          L.dot(nodes) / subject.witness.transverse,
          L.z(),
          L.dot(u)};
}

/// The end as the witness has it: place, axis and a point of the equator (attitude), momentum per mass.
struct End {
  Long3 p, u, e, L;
};

[[nodiscard]] inline End end_of(const TouchingBody& body, const TouchingState& y) {
  const auto [x, z, theta, phi, psi] = std::array<Long, 5>{y[0], y[1], y[2], y[3], y[4]};
  const Long s = std::sin(theta), c = std::cos(theta), sp = std::sin(phi), cp = std::cos(phi);
  const Long3 u(s * cp, s * sp, c), down(c * cp, c * sp, -s), nodes(-sp, cp, 0);
  const Long precession_rate = (y[8] - y[9] * c) / (body.transverse * s * s);
  return {Long3(x, z, height_of(body, theta)), u, std::cos(psi) * down + std::sin(psi) * nodes,
          body.transverse * (y[7] * nodes - precession_rate * s * down) + y[9] * u};
}

/// How far a state is from the witness's.
[[nodiscard]] inline Long difference(const Context& context, const Subject& subject, const State<double>& state,
                                     const TouchingState& then) {
  const TouchingBody& body = subject.witness;
  const End end = end_of(body, then);
  const Long R = static_cast<Long>(outer_width(subject.specimen.stone)) / 2;
  const Quat<Long> q = state.q_WB.cast<Long>();
  const Long3 L = state.L_W.cast<Long>() / static_cast<Long>(subject.body.mass);
  Long3 p = state.p_WB.cast<Long>();
  p.x() = context.produced(state.p_WB.x());
  const Long turned = std::sqrt(static_cast<Long>(g_earth) / R) * body.transverse;
  return std::max({(p - end.p).norm() / R, (q * Long3(0, 0, 1) - end.u).norm(), (q * Long3(1, 0, 0) - end.e).norm(),
                   (L - end.L).norm() / (end.L.norm() + turned)});
}

struct Located {
  int phases = 0, left_out = 0;
  int feature = 0, slip = 0, stick = 0;
};

[[nodiscard]] inline std::string describe(const Located& located) {
  return fmt::format("{}, {} of them left out; {} changes of feature, {} slips, {} sticks", located.phases,
                     located.left_out, located.feature, located.slip, located.stick);
}

/// A stretch of a drop in contact, held against the witness, who starts where it started.
inline void see_stretch(const Context& context, const Subject& subject, const Event<double>& from,
                        const Event<double>& to, Worst& worst, Located& located) {
  const double duration = to.time - from.time;
  const double longest = 0.25;  // [s] then the witness's own errors grow
  if (!(1e-4 < duration && duration < longest)) {
    return;
  }
  ++located.phases;
  const TouchingPath path = follow(subject.witness, coordinates_of(subject, from.after), duration);
  if (path.gave_up) {
    ++located.left_out;
    return;
  }
  const Long error = path.lifted && path.time < 0.999999L * static_cast<Long>(duration)
                         ? Long(1)
                         : difference(context, subject, to.before, path.end);
  worst.see(as_double(error), [&] {
    return fmt::format("{}, {} at {} s to {} at {} s, μ = {:a}, {}", describe(subject.specimen), to_string(from.kind),
                       from.time, to_string(to.kind), to.time, subject.settings.friction,
                       to_string(subject.settings.friction_model));
  });
  for (const TouchingEvent& event : path.events) {
    ++(event.kind == "feature" ? located.feature : event.kind == "slip" ? located.slip : located.stick);
  }
}

/// A drop that gave up has stretches that nobody sees.
inline void see_status(const Subject& subject, const Drop<double>& drop, Worst& worst) {
  worst.see(drop.status == DropStatus::rest || drop.status == DropStatus::moving ? 0.0 : 1.0, [&] {
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
inline void see_phases(const Context& context, const Subject& subject, const Drop<double>& drop, Worst& worst,
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
    see_stretch(context, subject, drop.events[i], drop.events[last], worst, located);
  }
}

/// The first stretches of a drop in contact, from event to event.
inline void see_stretches(const Context& context, const Subject& subject, const Drop<double>& drop, Worst& worst,
                          Located& located) {
  const int most = located.phases + 12;
  for (std::size_t i = 0; i + 1 < drop.events.size() && located.phases < most; ++i) {
    if (stays(drop.events[i].kind) && drop.events[i + 1].kind != EventKind::rest) {
      see_stretch(context, subject, drop.events[i], drop.events[i + 1], worst, located);
    }
  }
}

}  // namespace goishi::verify
