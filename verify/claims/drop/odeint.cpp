/// DROP: the contact phase against Lagrange's equations, integrated by Odeint.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/touching.hpp"

namespace goishi::verify {

namespace {

/// Tilted or nearly upright, close over the plane, turning and moving.
State<double> draw_state(Context& context, const Subject& subject, int i) {
  const double tilt = i % 3 == 0 ? context.uniform(0.1, 1.3) : context.uniform(0.0, i % 3 == 1 ? 0.1 : 0.5);
  State<double> state;
  state.q_WB = (Quat<double>(Eigen::AngleAxisd(context.uniform(-3.0, 3.0), Vec3<double>::UnitZ())) *
                Quat<double>(Eigen::AngleAxisd(tilt, Vec3<double>::UnitY())) *
                Quat<double>(Eigen::AngleAxisd(context.uniform(-3.0, 3.0), Vec3<double>::UnitZ())))
                   .normalized();
  const Long height = height_of(subject.witness, static_cast<Long>(tilt));
  state.p_WB = {context.uniform(-0.1, 0.1), context.uniform(-0.1, 0.1), as_double(height) + 1e-5};
  state.v_WB = {context.uniform(-0.3, 0.3), context.uniform(-0.3, 0.3), 0.0};
  state.L_W = formula::angular_momentum_W(state.q_WB, subject.body,
                                          Vec3<double>(context.uniform(1.0, 40.0) * draw_unit(context)));
  return state;
}

/// Rolling on the cap, up to where friction runs out: upright it takes none, at the turn at half a radian three times as much
/// as there is.
State<double> draw_start_of_slip(Context& context, Subject& subject) {
  subject.settings.friction = context.uniform(0.02, 0.04);
  subject.witness.mu = subject.settings.friction;
  const double tilt = context.uniform(0.05, 0.2), azimuth = context.uniform(-3.0, 3.0);
  const Vec3<double> nodes(-std::sin(azimuth), std::cos(azimuth), 0.0);
  const Hull<Long>& hull = subject.witness.hull;
  State<double> state;
  state.q_WB = (Quat<double>(Eigen::AngleAxisd(tilt, nodes)) *
                Quat<double>(Eigen::AngleAxisd(context.uniform(-3.0, 3.0), Vec3<double>::UnitZ())))
                   .normalized();
  const Vec3<double> u = formula::symmetry_axis(state.q_WB);
  const Vec3<double> arm = as_double(hull.sphere_offset) * u - as_double(hull.sphere_radius) * Vec3<double>::UnitZ();
  const Vec3<double> w(context.uniform(20.0, 24.0) * nodes + context.uniform(-3.0, 3.0) * Vec3<double>::UnitZ());
  state.p_WB = {0.0, 0.0, -arm.z()};
  state.v_WB = -w.cross(arm);
  state.L_W = formula::angular_momentum_W(state.q_WB, subject.body, Vec3<double>(state.q_WB.conjugate() * w));
  return state;
}

Measurement measure_contact(Context& context) {
  Checks checks;
  Located located;
  for (int i = 0; i < context.samples(40, 150); ++i) {
    Subject subject = draw_subject(context, i);
    subject.settings.horizon = context.uniform(0.02, 0.1);
    const State<double> start = i % 10 == 6 ? draw_start_of_slip(context, subject) : draw_state(context, subject, i);
    const DropResult<double> drop = goishi::drop(subject.specimen.stone, subject.body, start, subject.settings);
    see_status(subject, drop, checks);
    see_phases(context, subject, drop, checks, located);
  }
  checks["faults"].see(located.slip > 0 && located.stick > 0 && located.feature > 0 ? 0.0 : 1.0,
                       [&] { return "a change that never is: " + describe(located); });
  Measurement result = checks.measurement();
  result.figures = {{"contact phases", describe(located)}};
  return result;
}

}  // namespace

std::vector<Claim> drop_odeint_claims() {
  return {
      {.id = "DROP-17",
       .statement =
           "A contact phase ends where Lagrange's equations end: rolling and sliding on cap and rim, from one to the "
           "other as slip ends and as friction runs out, upright and leaning; dry, slip-proportional and patch "
           "friction, with and without resistance",
       .function = "drop",
       .family = OracleFamily::integration,
       .oracle = "Euler angles and multipliers in long double, Odeint's Fehlberg 7(8) at 1e-15, its events bisected",
       .checks = {within("place", 1e-10, "of half the width",
                         "tolerance 1e-12 over some thousand steps, magnified by what follows a change; measured "
                         "2026-11-30 with 12 seeds: up to 1.5e-11; in the full tier 9.3e-11 with one of six"),
                  within("attitude", 1e-10, "rad", "the same; measured 2026-11-30 with 12 seeds: up to 1.3e-11"),
                  within("momentum", 2e-10, "relative",
                         "the same; measured 2026-11-30 with 12 seeds: up to 5.6e-12; in the full tier 1.4e-10 with "
                         "one of six, a bevel that rolls under infinite friction",
                         3e-12),
                  none("faults", "faults")},
       .measure = measure_contact}};
}

}  // namespace goishi::verify
