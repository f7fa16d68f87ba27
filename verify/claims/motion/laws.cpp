/// MOTION: what free flight and its steppers must obey, whatever they look like inside.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/motion/invariants.hpp>
#include <vector>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/movers.hpp"

namespace goishi::verify {

namespace {

bool same_bits(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

// --- MOTION-1

State<double> reversed(const State<double>& state) {
  return {.p_WB = state.p_WB, .q_WB = state.q_WB, .v_WB = -state.v_WB, .L_W = -state.L_W};
}

/// What so many pieces of a path round to, each by ε   [of the way].
double walk(int pieces) {
  return epsilon * std::sqrt(static_cast<double>(pieces));
}

Measurement measure_time_reversal(Context& context) {
  Checks checks;
  const Vec3<double> gravity = gravity_W<double>();
  constexpr double angle = 0.2;  // in a step, at most
  double without_symmetry = 0.0, with_symmetry = 0.0;
  for (int i = 0; i < context.samples(100, 1000); ++i) {
    const Flight flight = draw_flight(context.random(), i % 2 == 0 ? BodyKind::symmetric : BodyKind::asymmetric);
    const auto see = [&](const State<double>& back, double allowed, double t, int pieces, std::string_view name) {
      const auto describe_it = [&] { return fmt::format("{}, t = {:a}, {}", name, t, describe(flight)); };
      checks["attitude"].see(attitude_difference(lengthened(context, back.q_WB), flight.start.q_WB), allowed,
                             describe_it);
      checks["position"].see((context.produced(back.p_WB) - flight.start.p_WB).norm(),
                             walk(2 * pieces) * reach(flight, gravity, t), describe_it);
    };
    if (i % 2 == 0) {
      const double t = context.uniform(-100.0, 100.0);
      const State<double> there = free_flight(flight.start, top_moments(flight), gravity, t);
      see(free_flight(there, top_moments(flight), gravity, -t), flight_error(flight, t), t, 1, "free_flight");
    }
    const double dt = angle / greatest_rate(flight);
    for (const Scheme scheme : {Scheme::implicit_midpoint, Scheme::splitting_2, Scheme::splitting_4,
                                Scheme::splitting_6, Scheme::runge_kutta_4}) {
      const Stepper<double> stepper(scheme, flight.body, gravity);
      const State<double> there = stepper.advance(flight.start, dt, steps).state;
      const State<double> back = stepper.advance(reversed(there), dt, steps).state;
      const double off = attitude_difference(back.q_WB, flight.start.q_WB);
      (scheme == Scheme::runge_kutta_4 ? without_symmetry : with_symmetry) =
          std::max(scheme == Scheme::runge_kutta_4 ? without_symmetry : with_symmetry, off);
      if (scheme != Scheme::runge_kutta_4) {
        const double shear = (1.0 + angle * steps) / 7.0;
        see(back, round_off(scheme, steps) * shear, dt * steps, steps, info(scheme).name);
      }
    }
  }
  return checks.measurement(
      {{"implicit midpoint and splittings come back to", fmt::format("{:.2g} rad", with_symmetry)},
       {"runge-kutta-4, which is not symmetric in time, to", fmt::format("{:.2g} rad", without_symmetry)}});
}

// --- MOTION-2

Flight turned(const Quat<double>& q_VW, const Flight& flight) {
  const State<double>& state = flight.start;
  return {.body = flight.body,
          .start = {.p_WB = q_VW * state.p_WB,
                    .q_WB = (q_VW * state.q_WB).normalized(),
                    .v_WB = q_VW * state.v_WB,
                    .L_W = q_VW * state.L_W}};
}

Measurement measure_rotated_world(Context& context) {
  Checks checks;
  for_each_motion(context, context.samples(200, 1000), [&](const Flight& flight, const Mover& mover) {
    const Quat<double> q_VW = draw_attitude(context.random());
    const Vec3<double> gravity = draw_vector(context.random(), 10.0);
    const double dt = 0.1 / greatest_rate(flight);
    const State<double> here = mover.move(flight, gravity, dt, Freedom::both);
    const State<double> expected = turned(q_VW, {flight.body, here}).start;
    const State<double> there = mover.move(turned(q_VW, flight), q_VW * gravity, dt, Freedom::both);
    const auto describe_it = [&] { return fmt::format("{}, {}", mover.name, describe(flight)); };
    checks["attitude"].see(attitude_difference(lengthened(context, there.q_WB), expected.q_WB),
                           mover.attitude_error(flight, dt), describe_it);
    checks["position"].see((context.produced(there.p_WB) - expected.p_WB).norm(),
                           walk(mover.pieces) * reach(flight, gravity, steps * dt), describe_it);
  });
  return checks.measurement();
}

// --- MOTION-3

/// Units of mass, length and time that are powers of two.
Measurement measure_rescaling(Context& context) {
  Worst worst;
  for_each_motion(context, context.samples(200, 1000), [&](const Flight& flight, const Mover& mover) {
    const auto power = [&] { return std::exp2(std::round(context.uniform(-20.0, 20.0))); };
    const double mass = power(), length = power(), time = power();
    const double moment = mass * length * length;
    const auto scaled = [&](const State<double>& state) -> State<double> {
      return {.p_WB = length * state.p_WB,
              .q_WB = state.q_WB,
              .v_WB = length / time * state.v_WB,
              .L_W = moment / time * state.L_W};
    };
    const Flight there = {.body = {.mass = mass * flight.body.mass, .moments = moment * flight.body.moments},
                          .start = scaled(flight.start)};
    const Vec3<double> gravity = gravity_W<double>();
    const double dt = 0.3 / greatest_rate(flight);
    const State<double> moved = mover.move(flight, gravity, dt, Freedom::both);
    const State<double> moved_there = mover.move(there, length / (time * time) * gravity, time * dt, Freedom::both);
    worst.see(same_bits(moved_there, scaled(moved)) ? 0.0 : 1.0, [&] {
      return fmt::format("{}, units {:a}, {:a}, {:a}, {}", mover.name, mass, length, time, describe(flight));
    });
  });
  return worst.measurement();
}

// --- MOTION-4

Measurement measure_composition(Context& context) {
  Checks checks;
  const Vec3<double> gravity = gravity_W<double>();
  for (int i = 0; i < context.samples(5000, 50000); ++i) {
    const Flight flight = draw_flight(context.random(), BodyKind::symmetric);
    const Moments<double> moments = top_moments(flight);
    const double t1 = context.uniform(-100.0, 100.0), t2 = context.uniform(-100.0, 100.0);
    const State<double> halfway = free_flight(flight.start, moments, gravity, t1);
    const State<double> twice = free_flight(halfway, moments, gravity, t2);
    const State<double> once = free_flight(flight.start, moments, gravity, t1 + t2);
    const double time = std::fabs(t1) + std::fabs(t2);
    const auto describe_it = [&] { return fmt::format("t = {:a} and {:a}, {}", t1, t2, describe(flight)); };
    checks["attitude"].see(attitude_difference(lengthened(context, twice.q_WB), once.q_WB), flight_error(flight, time),
                           describe_it);
    checks["position"].see((context.produced(twice.p_WB) - once.p_WB).norm(), epsilon * reach(flight, gravity, time),
                           describe_it);
  }
  return checks.measurement();
}

// --- MOTION-5

Measurement measure_frames(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Flight flight = draw_flight(context.random(), BodyKind::symmetric);
    const RigidBody<double>& body = flight.body;
    const State<double>& state = flight.start;
    // V: any inertial frame. P: any fixed point of W, seen from V where V is now.
    const Vec3<double> p_WV = draw_vector(context.random(), 2.0), v_WV = draw_vector(context.random(), 5.0);
    const Quat<double> q_WV = draw_attitude(context.random()), q_VW = q_WV.conjugate();
    const Vec3<double> p_WP = draw_vector(context.random(), 2.0), p_VP = q_VW * Vec3<double>(p_WP - p_WV);
    const Vec3<double> gravity = gravity_W<double>(), gravity_V = q_VW * gravity;
    const State<double> seen = formula::seen_from(p_WV, q_WV, v_WV, state);
    const auto see = [&](double difference, double scale, const char* check, const char* what) {
      checks[check].see(difference, epsilon * scale, [&] { return fmt::format("{}, {}", what, describe(flight)); });
    };
    const double speed = state.v_WB.norm() + v_WV.norm();
    const double momentum = body.mass * speed;
    see(std::fabs(context.produced(formula::translational_energy(seen, body)) -
                  body.mass * (state.v_WB - v_WV).squaredNorm() / 2.0),
        momentum * speed, "energy", "of translation");
    // A momentum turned by δ changes the energy by |ω| |L| δ.
    const double rotational = formula::angular_velocity_B(state, body).norm() * state.L_W.norm();
    see(std::fabs(context.produced(formula::rotational_energy(seen, body)) - formula::rotational_energy(state, body)),
        rotational, "energy", "of rotation");
    see((context.produced(formula::linear_momentum(seen, body)) -
         q_VW * Vec3<double>(formula::linear_momentum(state, body) - body.mass * v_WV))
            .norm(),
        momentum, "momentum", "linear");
    const Vec3<double> arm = state.p_WB - p_WP;
    const Vec3<double> about_P = formula::angular_momentum_about(p_WP, state, body) - body.mass * arm.cross(v_WV);
    see((context.produced(formula::angular_momentum_about(p_VP, seen, body)) - q_VW * about_P).norm(),
        state.L_W.norm() + (arm.norm() + p_WV.norm()) * momentum, "momentum", "angular, about a point");
    // To fly and to change the frame commute, the frame moving on.
    const double t = context.uniform(-10.0, 10.0);
    const State<double> then = formula::seen_from(Vec3<double>(p_WV + t * v_WV), q_WV, v_WV,
                                                  free_flight(state, top_moments(flight), gravity, t));
    const State<double> flown =
        free_flight({seen.p_WB, seen.q_WB.normalized(), seen.v_WB, seen.L_W}, top_moments(flight), gravity_V, t);
    checks["attitude"].see(attitude_difference(lengthened(context, flown.q_WB), then.q_WB), flight_error(flight, t),
                           [&] { return describe(flight); });
    const double far = reach(flight, gravity, t) + p_WV.norm() + v_WV.norm() * std::fabs(t);
    see((context.produced(flown.p_WB) - then.p_WB).norm(), far, "position", "then");
    // Energy is kept in V as well; its terms are larger than it.
    const double weight = body.mass * gravity.norm();
    see(std::fabs(context.produced(formula::energy(then, body, gravity_V)) - formula::energy(seen, body, gravity_V)),
        rotational + weight * far + body.mass * (seen.v_WB.squaredNorm() + then.v_WB.squaredNorm()), "energy",
        "in the moving frame");
  }
  return checks.measurement();
}

// --- MOTION-6

Measurement measure_conserved(Context& context) {
  Checks checks;
  for_each_motion(context, context.samples(200, 1000), [&](const Flight& flight, const Mover& mover) {
    const Vec3<double> gravity = gravity_W<double>();
    const double dt = context.uniform(0.001, 0.3) / greatest_rate(flight);
    const State<double> end = mover.move(flight, gravity, dt, Freedom::both);
    const auto describe_it = [&] { return fmt::format("{}, {}", mover.name, describe(flight)); };
    if (mover.keeps_momentum) {
      see_choice(checks["bits of L"], end.L_W == flight.start.L_W, describe_it);
    }
    checks["size of L"].see(
        std::fabs(context.produced(formula::in_body(end.q_WB, end.L_W).norm()) / flight.start.L_W.norm() - 1.0),
        mover.keeps_momentum ? epsilon : steps * epsilon, describe_it);
    if (mover.name != "exact" && mover.name != "free_flight") {
      return;
    }
    const double energy = formula::energy(flight.start, flight.body, gravity);
    checks["energy"].see(std::fabs(context.produced(formula::energy(end, flight.body, gravity)) - energy),
                         walk(mover.pieces) * (formula::rotational_energy(flight.start, flight.body) +
                                               formula::translational_energy(flight.start, flight.body) +
                                               2.0 * formula::translational_energy(end, flight.body) +
                                               flight.body.mass * gravity.norm() * reach(flight, gravity, steps * dt)),
                         describe_it);
    // About a fixed point, L changes by the moment of weight: ∫ arm dt × m g.
    const Vec3<double> p_WP = draw_vector(context.random(), 2.0);
    const double t = steps * dt;
    const Vec3<double> swept = t * (flight.start.p_WB - p_WP) + t * t / 2.0 * flight.start.v_WB;
    const Vec3<double> impulse = flight.body.mass * swept.cross(gravity);
    const Vec3<double> gained = formula::angular_momentum_about(p_WP, end, flight.body) -
                                formula::angular_momentum_about(p_WP, flight.start, flight.body);
    const double far = reach(flight, gravity, t) + p_WP.norm();
    checks["gain of L"].see(
        (context.produced(gained) - impulse).norm(),
        walk(mover.pieces) *
            (flight.start.L_W.norm() + flight.body.mass * far * (flight.start.v_WB.norm() + gravity.norm() * t)),
        describe_it);
  });
  return checks.measurement();
}

// --- MOTION-7

Measurement measure_freedom(Context& context) {
  Worst worst;
  for_each_motion(context, context.samples(200, 1000), [&](const Flight& flight, const Mover& mover) {
    const Vec3<double> gravity = draw_vector(context.random(), 10.0);
    const double dt = 0.1 / greatest_rate(flight);
    const State<double> both = mover.move(flight, gravity, dt, Freedom::both);
    const State<double> linear = mover.move(flight, gravity, dt, Freedom::linear);
    const State<double> angular = mover.move(flight, gravity, dt, Freedom::angular);
    const State<double>& start = flight.start;
    const State<double> only_moved = {both.p_WB, start.q_WB, both.v_WB, start.L_W};
    const State<double> only_turned = {start.p_WB, both.q_WB, start.v_WB, both.L_W};
    worst.see(same_bits(linear, only_moved) ? 0.0 : 1.0,
              [&] { return fmt::format("linear, {}, {}", mover.name, describe(flight)); });
    worst.see(same_bits(angular, only_turned) ? 0.0 : 1.0,
              [&] { return fmt::format("angular, {}, {}", mover.name, describe(flight)); });
    worst.see(same_bits(both, start) ? 1.0 : 0.0, [&] { return fmt::format("{} does not move", mover.name); });
  });
  return worst.measurement();
}

// --- MOTION-8

Measurement measure_midpoint(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(300, 3000); ++i) {
    const Flight flight = draw_flight(context.random(), body_kinds[static_cast<std::size_t>(i) % body_kinds.size()]);
    const double angle = std::pow(10.0, -context.uniform(0.0, 3.0));
    const Stepper<double> stepper(Scheme::implicit_midpoint, flight.body, Vec3<double>::Zero());
    const auto [end, status, good] = stepper.advance(flight.start, angle / greatest_rate(flight), steps);
    see_choice(checks["middles"], status == StepStatus::completed, [&] {
      return fmt::format("{} after {} steps of {} rad, {}", to_string(status), good, angle, describe(flight));
    });
    const double change = context.produced(formula::rotational_energy(end, flight.body)) /
                              formula::rotational_energy(flight.start, flight.body) -
                          1.0;
    checks["energy"].see(std::fabs(change), walk(steps),
                         [&] { return fmt::format("steps of {} rad, {}", angle, describe(flight)); });
  }
  return checks.measurement();
}

Claim law(const char* id, const char* statement, const char* function, const char* oracle, std::vector<Check> checks,
          Measurement (*measure)(Context&)) {
  return {.id = id,
          .statement = statement,
          .function = function,
          .family = OracleFamily::relation,
          .oracle = oracle,
          .checks = std::move(checks),
          .measure = measure};
}

Check attitude(const char* reason) {
  return within("attitude", 2.0, "of FLIGHT-1's bound, or of ORDER-4's", reason);
}

Check rounded(const char* name, double bound, const char* unit, const char* reason) {
  return within(name, bound, unit, reason, 0.25);
}

}  // namespace

std::vector<Claim> motion_law_claims() {
  return {
      law("MOTION-1",
          "Back in time: flown for t and for −t, or stepped on with L and v reversed, a body is where it was.",
          "free_flight; Stepper, implicit midpoint and splittings", "the start",
          {attitude("there and back; the round-off of the steps is sheared by the angle turned"),
           rounded("position", 4.0, "ε √pieces of the way", "each step rounds a velocity and a position")},
          measure_time_reversal),
      law("MOTION-2", "Turning the world, gravity included, turns the motion: free flight and every scheme.",
          "free_flight, Stepper", "the same body in the turned world",
          {attitude("here and there"),
           rounded("position", 4.0, "ε √pieces of the way", "each step rounds a velocity and a position")},
          measure_rotated_world),
      law("MOTION-3", "In other units of mass, length and time, powers of two, every motion has the same bits.",
          "free_flight, Stepper", "the same motion in the other units", {none("", "motions of other bits")},
          measure_rescaling),
      law("MOTION-4", "A flight for t₁ and then t₂ is a flight for t₁ + t₂.", "free_flight", "the flight in one piece",
          {attitude("one for each piece, and the rounded sum of the times"),
           rounded("position", 8.0, "ε of the way",
                   "three flights, two roundings each of a term, and the sum of the times")},
          measure_composition),
      law("MOTION-5",
          "Seen from any inertial frame, momentum and energy are those of that frame, the energy is kept, and to fly "
          "commutes with changing the frame.",
          "seen_from, energy, linear_momentum, angular_momentum_about", "the laws of Galilei and König",
          {attitude("here and there"), rounded("position", 16.0, "ε of the way", "three rotations of 4 ε, and sums"),
           rounded("momentum", 16.0, "ε of the parts", "three rotations of 4 ε, and sums"),
           rounded("energy", 16.0, "ε of the parts", "three rotations of 4 ε, and sums")},
          measure_frames),
      law("MOTION-6",
          "L_W keeps its bits in free flight and in every scheme but the published one, |L_B| its size; free flight "
          "keeps the energy in gravity, and about a fixed point gains the moment of weight.",
          "free_flight, Stepper, energy, angular_momentum_about", "the start, and the impulse of weight by hand",
          {none("bits of L", "motions that change a bit of L_W"),
           rounded("size of L", 16.0, "ε; of the published loop ε in each step", "a dozen roundings"),
           rounded("energy", 4.0, "ε √pieces of the parts",
                   "two roundings of position and velocity in each, and of each term"),
           rounded("gain of L", 4.0, "ε √pieces of the parts", "as the energy")},
          measure_conserved),
      law("MOTION-7",
          "The talk's demo: with linear freedom alone attitude and momentum keep their bits, with angular "
          "freedom alone position and velocity; together they are both.",
          "free_flight, Stepper", "the two motions apart",
          {none("", "motions of other bits, and bodies that do not move")}, measure_freedom),
      law("MOTION-8",
          "Implicit midpoint keeps the energy of any body to round-off with steps of up to 1 rad, and always finds its "
          "middle.",
          "Stepper, implicit midpoint", "the energy at the start",
          {rounded("energy", 6.0, "ε √steps",
                   "a random walk of steps of about ε: six deviations; measured 2026-11-30 with 60 seeds: up to 4.25"),
           none("middles", "steps without a middle")},
          measure_midpoint),
  };
}

}  // namespace goishi::verify
