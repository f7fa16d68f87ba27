/// PUBLISHED: the talk's loops of motion, reproduced with their errors, and what is right beside them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/steppers.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double frame = 1.0 / 60.0;  // [s]
constexpr double duration = 10.0;     // [s]

/// Size 33 per unit of mass, lengths in cm.
Moments<double> published_moments() {
  return mass_properties(make_stone(2.2, 0.92), Density{1.0}).moments_per_mass;
}

State<double> published_start() {
  return {Vec3<double>::Zero(), Quat<double>::Identity(), Vec3<double>::Zero(), Vec3<double>(1.0, 2.0, 8.0)};
}

Stepper<double> stepper_of(Scheme scheme, const Moments<double>& moments) {
  return Stepper<double>(scheme, make_rigid_body(1.0, moments), Vec3<double>::Zero());
}

/// Between the symmetry axis and L   [deg].
double tilt(const State<double>& state) {
  const Vec3<double> axis = formula::symmetry_axis(state.q_WB);
  return std::atan2(axis.cross(state.L_W).norm(), axis.dot(state.L_W)) / degree;
}

// --- PUBLISHED-7

/// One frame about the symmetry axis at 75 rad/s.
void see_turn(Checks& checks, std::vector<Figure>& figures, const Context& context) {
  constexpr double rate = 75.0;  // [rad/s]
  const Moments<double> moments = published_moments();
  State<double> start = published_start();
  start.L_W = Vec3<double>(0.0, 0.0, rate * moments.axial);
  const auto angle = [&](const State<double>& state) {
    return 2.0 * std::atan2(context.produced(state.q_WB.z()), state.q_WB.w());
  };
  const double published = angle(stepper_of(Scheme::published, moments).step(start, frame).state);
  const double right = angle(free_flight(start, moments, Vec3<double>(Vec3<double>::Zero()), frame));
  const double percent = 100.0 * (published / right - 1.0);
  checks["digits"].see(std::fabs(percent + 10.6), 0.1, [] { return "−10.6 % at 75 rad/s and 60 Hz"; });
  checks["turn"].see(std::fabs(published / (2.0 * std::atan(rate * frame / 2.0)) - 1.0), epsilon,
                     [] { return "2 atan(ωΔt/2)"; });
  checks["turn"].see(std::fabs(right / (rate * frame) - 1.0), epsilon, [] { return "ωΔt"; });
  figures.push_back({"published: a step at 75 rad/s and 60 Hz turns by",
                     fmt::format("{:.6f} rad, {:+.1f} %; right is {:.6f} rad", published, percent, right)});
}

Measurement measure_constant_velocity(Context& context) {
  const Moments<double> moments = published_moments();
  const Stepper<double> loop = stepper_of(Scheme::published, moments);
  const State<double> start = published_start();
  const Vec3<double> w_WB = formula::angular_velocity_W(start, loop.body());
  const double energy = formula::rotational_energy(start, loop.body());
  const double size = start.L_W.norm();
  // L is carried round by a constant ω, at an angle β with it: |L(t) − L(0)| / |L| = 2 sin β |sin(φ/2)|.
  const double wander = 2.0 * w_WB.cross(start.L_W).norm() / (w_WB.norm() * size);
  const double turn = 2.0 * std::atan(w_WB.norm() * frame / 2.0);
  const int steps = static_cast<int>(std::lround(duration / frame));
  // Velocity is made of momentum and back in every step, a random walk; the phase goes with it.
  const double walk = epsilon * std::sqrt(steps), phase_walk = walk * turn * steps;
  Checks checks;
  State<double> state = start;
  double greatest = 0.0, sum = 0.0;
  for (int i = 1; i <= steps; ++i) {
    state = loop.step(state, frame).state;
    const double wandered = context.produced((state.L_W - start.L_W).norm()) / size;
    greatest = std::max(greatest, wandered);
    sum += wandered;
    const auto describe_it = [&] { return fmt::format("after {} steps", i); };
    checks["momentum"].see(std::fabs(wandered - wander * std::fabs(std::sin(turn * i / 2.0))), phase_walk, describe_it);
    checks["energy"].see(std::fabs(context.produced(formula::rotational_energy(state, loop.body())) / energy - 1.0),
                         walk, describe_it);
  }
  // A ball that starts with the same angular velocity turns alike.
  const Stepper<double> ball = stepper_of(Scheme::published, {.axial = 0.3, .transverse = 0.3});
  State<double> ball_start = start;
  ball_start.L_W = formula::angular_momentum_W(start.q_WB, ball.body(), w_WB);
  const Quat<double> ball_end(context.produced(ball.advance(ball_start, frame, steps).state.q_WB.coeffs().eval()));
  checks["ball"].see(attitude_difference(ball_end, state.q_WB), phase_walk, [] { return "its attitude"; });
  const State<double> right = free_flight(start, moments, Vec3<double>(Vec3<double>::Zero()), duration);
  std::vector<Figure> turn_figure;
  see_turn(checks, turn_figure, context);
  Measurement result = checks.measurement();
  result.figures = {
      turn_figure.front(),
      {"published: L wanders from its start by", fmt::format("{:.1f} % of |L| on average, {:.1f} % at most, in {} s",
                                                             100.0 * sum / steps, 100.0 * greatest, duration)},
      {"right", fmt::format("{:.1f} %: L is what stays", 100.0 * (right.L_W - start.L_W).norm() / size)},
      {"the same angular velocity on a ball: attitudes differ by",
       fmt::format("{:.1g} rad, the shape has no effect", attitude_difference(ball_end, state.q_WB))},
      {"right: stone and ball differ by",
       fmt::format(
           "{:.2f} rad",
           attitude_difference(right.q_WB, free_flight(ball_start, Moments<double>{.axial = 0.3, .transverse = 0.3},
                                                       Vec3<double>(Vec3<double>::Zero()), duration)
                                               .q_WB))}};
  return result;
}

// --- PUBLISHED-8

Measurement measure_parabola(Context& context) {
  // In cm, as the talk: gravity as printed, and as it is.
  const Vec3<double> printed_gravity = gravity_W(9.8 * 10.0);
  const Vec3<double> right_gravity = gravity_W(980.0);
  const RigidBody<double> body = make_rigid_body(1.0, published_moments());
  Checks checks;
  double late = 0.0;
  for (int i = 0; i < context.samples(200, 2000); ++i) {
    State<double> start = published_start();
    start.p_WB = draw_vector(context.random(), 10.0);
    start.v_WB = draw_vector(context.random(), 100.0);
    const int steps = 1 + i % 120;
    const double t = steps * frame;
    const State<double> published =
        Stepper<double>(Scheme::published, body, printed_gravity).advance(start, frame, steps).state;
    const State<double> parabola = formula::ballistic_flight(start, printed_gravity, t);
    const Vec3<double> off = context.produced(published.p_WB) - parabola.p_WB;
    const double reach = start.p_WB.norm() + (start.v_WB.norm() + printed_gravity.norm() * t) * t;
    checks["parabola"].see((off - t * frame / 2.0 * printed_gravity).norm(), epsilon * std::sqrt(steps) * reach,
                           [&] { return fmt::format("after {} steps", steps); });
    // √10 times as long, under a tenth of gravity: the same fall from rest.
    start.v_WB.setZero();
    const Vec3<double> fall = formula::ballistic_flight(start, right_gravity, t).p_WB - start.p_WB;
    const Vec3<double> slow_fall =
        formula::ballistic_flight(start, printed_gravity, std::sqrt(10.0) * t).p_WB - start.p_WB;
    checks["fall"].see((context.produced(slow_fall) - fall).norm(), epsilon * (fall.norm() + start.p_WB.norm()),
                       [&] { return fmt::format("√10 times as long as {} s", t); });
    late = std::max(late, off.norm());
  }
  Measurement result = checks.measurement();
  const auto fall_time = [](double g) { return std::sqrt(2.0 * 100.0 / g); };
  result.figures = {
      {"published: below the parabola of its own gravity by", fmt::format("{:.4f} cm at most in 2 s", late)},
      {"published: a fall of 1 m takes", fmt::format("{:.4f} s, with 9.8·10 cm/s²", fall_time(98.0))},
      {"right", fmt::format("{:.4f} s, with {} cm/s²", fall_time(100.0 * standard_gravity<double>()),
                            100.0 * standard_gravity<double>())}};
  return result;
}

// --- PUBLISHED-9

struct Printed {
  int rate;        // steps per second
  double gain;     // of energy, in percent
  double digit;    // the last of it
  double degrees;  // from the symmetry axis to L
};

Measurement measure_explicit_euler(Context& context) {
  const Moments<double> moments = published_moments();
  const Stepper<double> euler = stepper_of(Scheme::explicit_euler, moments);
  const State<double> start = published_start();
  const double energy = formula::rotational_energy(start, euler.body());
  Worst worst;
  Measurement figures;
  const State<double> right = free_flight(start, moments, Vec3<double>(Vec3<double>::Zero()), duration);
  for (const Printed& printed :
       std::array<Printed, 3>{{{60, 61.7, 0.1, 90.0}, {600, 61.4, 0.1, 86.0}, {960, 56.0, 1.0, 73.0}}}) {
    const State<double> end =
        euler.advance(start, 1.0 / printed.rate, static_cast<std::int64_t>(duration) * printed.rate).state;
    const double gain = 100.0 * (context.produced(formula::rotational_energy(end, euler.body())) / energy - 1.0);
    const double degrees = context.produced(tilt(end));
    worst.see(std::fabs(gain - printed.gain), printed.digit,
              [&] { return fmt::format("energy, 1/{} s", printed.rate); });
    worst.see(std::fabs(degrees - printed.degrees), [&] { return fmt::format("axis, 1/{} s", printed.rate); });
    figures.figures.push_back({fmt::format("published, steps of 1/{} s", printed.rate),
                               fmt::format("energy {:+.2f} %, axis at {:.2f}° to L", gain, degrees)});
  }
  // At a given |L| the energy is least with the axis along L, |L|²/(2 I_a), greatest with the axis across, |L|²/(2 I_t).
  const double across = start.L_W.squaredNorm() / (2.0 * moments.transverse);
  worst.see(std::fabs(100.0 * (across / energy - 1.0) - 61.7) / 0.1,
            [] { return "the energy with the axis across L"; });
  worst.see(std::fabs(100.0 * (moments.axial / moments.transverse - 1.0) - 69.9) / 0.1, [] { return "I_a/I_t − 1"; });
  Measurement result = worst.measurement();
  result.figures = figures.figures;
  result.figures.push_back(
      {"right", fmt::format("energy {:+.0e} %, axis at {:.2f}° to L, for ever",
                            100.0 * (formula::rotational_energy(right, euler.body()) / energy - 1.0), tilt(right))});
  result.figures.push_back(
      {"limits of the gain",
       fmt::format("{:+.2f} % from here, {:+.2f} % = I_a/I_t − 1 from a spin about the axis: the axis "
                   "ends across L, where the energy of that |L| is greatest",
                   100.0 * (across / energy - 1.0), 100.0 * (moments.axial / moments.transverse - 1.0))});
  return result;
}

// --- PUBLISHED-10

Measurement measure_exact(Context& context) {
  const Moments<double> moments = published_moments();
  const State<double> start = published_start();
  const RigidBody<double> body = make_rigid_body(1.0, moments);
  const Flight flight = {body, start};
  TrueAttitude truth(flight);
  Checks checks;
  State<double> end;
  for (int i = 1; i <= 100; ++i) {
    const double t = duration * i / 100;
    end = free_flight(start, moments, Vec3<double>(Vec3<double>::Zero()), t);
    const Quat<double> q_WB(context.produced(end.q_WB.coeffs().eval()));
    const double angle =
        start.L_W.norm() / moments.transverse + start.L_W.z() * (1.0 / moments.transverse - 1.0 / moments.axial);
    const auto describe_it = [&] { return fmt::format("at {} s", t); };
    checks["attitude"].see(attitude_difference(q_WB, truth.at(static_cast<long double>(t))),
                           epsilon * (1.0 + angle * t), describe_it);
    checks["energy"].see(
        std::fabs(context.produced(formula::rotational_energy(end, body)) / formula::rotational_energy(start, body) -
                  1.0),
        epsilon, describe_it);
    checks["tilt"].see(std::fabs(context.produced(tilt(end)) - tilt(start)) * degree, epsilon, describe_it);
  }
  Measurement result = checks.measurement();
  const Vec3<double> axis = formula::symmetry_axis(end.q_WB);
  result.figures = {
      {"right: attitude after 10 s (w, x, y, z)",
       fmt::format("({:.12f}, {:.12f}, {:.12f}, {:.12f})", end.q_WB.w(), end.q_WB.x(), end.q_WB.y(), end.q_WB.z())},
      {"right: symmetry axis after 10 s", fmt::format("({:.12f}, {:.12f}, {:.12f})", axis.x(), axis.y(), axis.z())},
      {"right: axis to L", fmt::format("{:.6f}°, energy {:.12f}", tilt(end), formula::rotational_energy(end, body))},
      {"right: the axis goes round L",
       fmt::format("{:.6f} times a second", start.L_W.norm() / moments.transverse / (2.0 * std::numbers::pi))}};
  return result;
}

}  // namespace

std::vector<Claim> published_motion_claims() {
  return {
      {.id = "PUBLISHED-7",
       .statement = "The talk's loop keeps the angular velocity, and with it the energy, but not L: its direction goes "
                    "round, the stone's shape has no effect, and a step turns by 2 atan(ωΔt/2) instead of ωΔt.",
       .function = "Stepper, published",
       .family = OracleFamily::published,
       .oracle = "the loop's own motion in closed form, at L = (1, 2, 8), 60 Hz, 10 s; −10.6 % at 75 rad/s",
       .checks = {within("digits", 0.5, "last digits of −10.6 %", "half a unit of the last printed digit", 0.1),
                  within("turn", 4.0, "ε", "an arctangent, a root and two quotients", 0.5),
                  within("energy", 8.0, "ε √n", "a random walk: four roundings in each step"),
                  within("momentum", 0.5, "ε √n of the angle turned",
                         "the energy's random walk, half of it in the rate; "
                         "measured 2026-11-30: 0.09"),
                  within("ball", 3.0, "ε √n of the angle turned", "two such walks; measured 2026-11-30: 0.6")},
       .measure = measure_constant_velocity},
      {.id = "PUBLISHED-8",
       .statement =
           "The talk's parabola is off by g t Δt/2, and its gravity, 9.8·10 with lengths in cm, makes every fall "
           "√10 times too long.",
       .function = "Stepper, published; ballistic_flight",
       .family = OracleFamily::exact,
       .oracle = "the sum of the loop's series; the scaling of a fall",
       .checks = {within("parabola", 4.0, "ε √n of the way",
                         "a random walk: each step rounds a velocity and a position", 0.25),
                  within("fall", 16.0, "ε of the fall and its height",
                         "the time is rounded, squared and multiplied, and the fall added to a height, twice", 0.5)},
       .measure = measure_parabola},
      {.id = "PUBLISHED-9",
       .statement =
           "With L as state and an explicit Euler attitude the stone gains energy until its axis lies across L: "
           "+61.7 % and 90° with steps of 1/60 s, +61.4 % and 86° with 1/600 s, +56 % and 73° with 1/960 s, in "
           "10 s from L = (1, 2, 8).",
       .function = "Stepper, explicit_euler",
       .family = OracleFamily::published,
       .oracle = "the numbers of the original program's second scheme, and the limit I_a/I_t − 1 = 69.9 %",
       .checks = {within("", 0.5, "last printed digits", "half a unit of the last printed digit", 0.5)},
       .measure = measure_explicit_euler},
      {.id = "PUBLISHED-10",
       .statement =
           "What is right in the talk's case: the exact flight keeps the energy and the angle from axis to L for "
           "10 s, with the attitude that the raw equations give.",
       .function = "free_flight",
       .family = OracleFamily::integration,
       .oracle = "the raw Newton–Euler equations by Taylor series in long double; energy and angle at the start",
       .checks = {within("attitude", 5.5, "ε (1 + phase)", "FLIGHT-1's: 2.5 ε of each angle, 3 ε for the products",
                         0.5),
                  within("energy", 16.0, "ε", "a dozen roundings", 1.0),
                  within("tilt", 8.0, "ε", "the axis is off by two products of four roundings each", 0.5)},
       .measure = measure_exact},
  };
}

}  // namespace goishi::verify
