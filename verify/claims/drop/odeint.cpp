/// DROP: the contact phase against Lagrange's equations, integrated by Odeint.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>

#include "verify/claims/claims.hpp"
#include "verify/samples/touching.hpp"

namespace goishi::verify {

namespace {

/// Tilted, close over the plane, turning and moving.
State<double> draw_state(Context& context, const Subject& subject, int i) {
  const double tilt = context.uniform(0.1, i % 3 == 0 ? 1.3 : 0.5);
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

Measurement measure_contact(Context& context) {
  Worst worst;
  Located located;
  for (int i = 0; i < context.samples(40, 150); ++i) {
    Subject subject = draw_subject(context, i);
    subject.settings.horizon = context.uniform(0.02, 0.1);
    const State<double> start = draw_state(context, subject, i);
    const Drop<double> drop = goishi::drop(subject.specimen.stone, subject.body, start, subject.settings);
    see_status(subject, drop, worst);
    see_phases(context, subject, drop, worst, located);
  }
  Measurement result = worst.measurement();
  result.figures = {{"contact phases", describe(located)}};
  return result;
}

}  // namespace

std::vector<Claim> drop_odeint_claims() {
  return {
      {.id = "DROP-17",
       .statement = "A contact phase ends where Lagrange's equations end: rolling and sliding on cap and rim, dry, "
                    "slip-proportional and patch friction, with and without resistance",
       .function = "drop",
       .family = OracleFamily::integration,
       .oracle = "Euler angles and multipliers in long double, Odeint's Fehlberg 7(8) at 1e-15, its events bisected",
       .checks = {{.unit = "of half the width, rad, and of the momentum",
                   .bound = 4e-10,
                   .reason = "tolerance 1e-12 over some thousand steps, magnified by what follows a change",
                   .resolution = 5e-12}},
       .mutants = {{"drop/contact_motion.hpp", "along * gyration.x()", "along * gyration.y()"},
                   {"drop/slip.hpp", "rate.across = a_y * c - a_x * s;", "rate.across = a_y * c;"},
                   {"drop/kinetics.hpp", "T(moment.y() + N * k.torque.y()", "T(moment.y() + k.torque.y()"}},
       .measure = measure_contact}};
}

}  // namespace goishi::verify
