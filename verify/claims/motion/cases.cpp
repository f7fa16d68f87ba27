/// CASE: rigid bodies in free flight whose numbers others have printed.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/steppers.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/convergence.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

// --- the production functions

/// Steps small enough that splitting-6 is at its round-off.
std::int64_t steps_of(double angle) {
  return static_cast<std::int64_t>(std::ceil(angle / 0.02));
}

State<double> by_steps(Scheme scheme, const Flight& flight, double time, std::int64_t steps) {
  const Stepper<double> stepper(scheme, flight.body, Vec3<double>::Zero());
  return stepper.advance(flight.start, time / static_cast<double>(steps), steps).state;
}

struct Route {
  std::string name;
  std::string check;
  std::function<State<double>(const Flight&, double)> fly;
  std::function<double(double)> allowed;  // error, relative and in rad, after turning by an angle [rad]
};

/// Both closed forms: the angle has four roundings, the components of the attitude another four of their own size.
Route closed_form(const char* name, std::function<State<double>(const Flight&, double)> fly) {
  return {name, "closed form", std::move(fly), [](double angle) { return epsilon * (1.0 + angle); }};
}

Route by_free_flight() {
  return closed_form("free_flight", [](const Flight& flight, double time) {
    const Vec3<double>& moments = flight.body.moments;
    return free_flight(flight.start, Moments<double>{.axial = moments.z(), .transverse = moments.x()},
                       Vec3<double>(Vec3<double>::Zero()), time);
  });
}

Route by_elliptic_flight() {
  return closed_form("elliptic_flight", [](const Flight& flight, double time) {
    return elliptic_flight(flight.start, flight.body, Vec3<double>(Vec3<double>::Zero()), time);
  });
}

/// The round-off of ORDER-4, which is that of one turn, sheared by all the others.
Route by_splitting() {
  return {"splitting-6, steps of 0.02 rad", "splitting-6",
          [](const Flight& flight, double time) {
            return by_steps(Scheme::splitting_6, flight, time, steps_of(greatest_rate(flight) * time));
          },
          [](double angle) {
            return round_off(Scheme::splitting_6, static_cast<double>(steps_of(angle))) * (1.0 + angle) / 7.0;
          }};
}

// --- the comparison

struct Print {
  double time;
  Vec3<double> vector;
  std::optional<Quat<double>> attitude = std::nullopt;
};

struct Case {
  Flight flight;
  std::function<Vec3<double>(const State<double>&)> vector;  // what is printed, of a state
  std::string unit;
  std::vector<Print> prints;
};

/// At rest, in unit attitude, with the momentum L_B.
Flight at_origin(const Vec3<double>& moments, const Vec3<double>& L_B) {
  return {.body = make_rigid_body(1.0, moments),
          .start = {Vec3<double>::Zero(), Quat<double>::Identity(), Vec3<double>::Zero(), L_B}};
}

/// Printed is ω_B, in a unit.
Case with_velocities(const Vec3<double>& moments, const Vec3<double>& w_B, double unit, const std::string& unit_name,
                     std::vector<Print> prints) {
  const Flight flight = at_origin(moments, moments.cwiseProduct(unit * w_B));
  return {.flight = flight,
          .vector =
              [flight, unit](const State<double>& state) {
                return Vec3<double>(formula::angular_velocity_B(state, flight.body) / unit);
              },
          .unit = unit_name,
          .prints = std::move(prints)};
}

/// The raw equations against the print: the witness of the other claims, judged by people's numbers.
double witness_error(const Case& printed) {
  double worst = 0.0;
  TrueAttitude truth(printed.flight);
  for (const Print& print : printed.prints) {
    State<double> state = printed.flight.start;
    state.q_WB = truth.at(static_cast<long double>(print.time)).cast<double>();
    worst = std::max(worst, (printed.vector(state) - print.vector).norm() / print.vector.norm());
  }
  return worst;
}

Measurement compare(const Context& context, const Case& printed, const std::vector<Route>& routes) {
  Checks checks;
  std::vector<Figure> figures;
  for (const Route& route : routes) {
    double greatest = 0.0;
    for (const Print& print : printed.prints) {
      const State<double> state = route.fly(printed.flight, print.time);
      const double allowed = route.allowed(greatest_rate(printed.flight) * print.time);
      const double error = (context.produced(printed.vector(state)) - print.vector).norm();
      greatest = std::max(greatest, error);
      checks[route.check].see(error, print.vector.norm() * allowed,
                              [&] { return fmt::format("{}, the vector at t = {}", route.name, print.time); });
      if (print.attitude) {
        checks[route.check].see(attitude_difference(lengthened(context, state.q_WB), *print.attitude), allowed,
                                [&] { return fmt::format("{}, the attitude at t = {}", route.name, print.time); });
      }
    }
    figures.push_back({route.name + " differs from the print by", fmt::format("{:.2g} {}", greatest, printed.unit)});
  }
  figures.push_back({"the raw equations by Taylor series, relatively", fmt::format("{:.2g}", witness_error(printed))});
  return checks.measurement(figures);
}

// --- the cases

Measurement measure_symmetric_top(Context& context) {
  const Vec3<double> moments(0.04, 0.04, 0.02);
  const Print print = {10.0,
                       {-3.64362359659628, 2.59306904773606, 6.0},
                       Quat<double>(-0.185871916511538, 0.195938189833834, -0.785967065292867, -0.556161513134347)};
  return compare(context, with_velocities(moments, {2.0, 4.0, 6.0}, 1.0, "rad/s", {print}),
                 {by_free_flight(), by_elliptic_flight(), by_splitting()});
}

Measurement measure_asymmetric_top(Context& context) {
  const Print one = {1.0,
                     {-3.8281667458526425, -14.380317074202409, 3.1229978852152591},
                     Quat<double>(0.090466756119096, -0.684062733928862, 0.123205638525778, 0.713228093054749)};
  const Print five = {5.0,
                      {-1.0089881330718245, 14.999197442855411, 1.0057708654405737},
                      Quat<double>(-0.266686478682097, 0.000210639988172, -0.960892599552610, -0.074590145756432)};
  return compare(context, with_velocities({10.0, 20.0, 26.0}, {1.0, 15.0, 1.0}, 1.0, "rad/s", {one, five}),
                 {by_elliptic_flight(), by_splitting()});
}

/// y' = (y₂y₃, −y₁y₃, −0.51 y₁y₂) is a body's motion: with L_B = (10 y₁, 7 y₂, 10 y₃), L̇ = L × I⁻¹L asks of the inverse
/// moments J that J₃ − J₂ = 10/(7·10), J₁ − J₃ = −7/(10·10), J₂ − J₁ = −0.51·10/(10·7). These sum to zero, so J₁ is free:
/// it adds a turn about L, which L_B does not see. J₁ = 0.3 makes moments that a body can have.
Measurement measure_detest(Context& context) {
  const Vec3<double> J(0.3, 0.37 - 1.0 / 7.0, 0.37);
  const Vec3<double> scale(10.0, 7.0, 10.0);
  const Case printed = {.flight = at_origin(J.cwiseInverse(), scale.cwiseProduct(Vec3<double>(0.0, 1.0, 1.0))),
                        .vector =
                            [scale](const State<double>& state) {
                              return Vec3<double>(formula::in_body(state.q_WB, state.L_W).cwiseQuotient(scale));
                            },
                        .unit = "(of y)",
                        .prints = {{20.0, {-0.939657079872920396, -0.342117775400074907, 0.741412659619995301}}}};
  return compare(context, printed, {by_elliptic_flight(), by_splitting()});
}

Measurement measure_tumbling_brick(Context& context) {
  const Case printed = with_velocities({0.001894220, 0.006211019, 0.007194665}, {10.0, 20.0, 30.0}, degree, "deg/s",
                                       {{1.0, {4.258841898653454, 23.119942897497332, 28.379817775082763}},
                                        {10.0, {-2.418902221692877, -23.552569519560503, 28.128592630041435}},
                                        {30.0, {12.618390775914220, -17.397474761611392, 31.119588886944346}}});
  Measurement result = compare(context, printed, {by_elliptic_flight(), by_splitting()});
  result.figures.push_back(
      {"the seven simulations of the check-case", "3.3e-10 … 4.7e-3 deg/s, the second best 3.6e-10"});
  // With steps that a game could take, 10 ms.
  for (const Scheme scheme :
       {Scheme::runge_kutta_4, Scheme::splitting_6, Scheme::implicit_midpoint, Scheme::published}) {
    double greatest = 0.0;
    for (const Print& print : printed.prints) {
      const State<double> state =
          by_steps(scheme, printed.flight, print.time, static_cast<std::int64_t>(std::lround(100.0 * print.time)));
      greatest = std::max(greatest, (printed.vector(state) - print.vector).cwiseAbs().maxCoeff());
    }
    result.figures.push_back(
        {fmt::format("{} with steps of 10 ms", info(scheme).name), fmt::format("{:.2g} deg/s", greatest)});
  }
  return result;
}

/// No rigid body has the moments (3, 5, 9) of the print, 9 > 3 + 5. A constant added to all inverse moments is a turn
/// about L, which L_B does not see; with 1/10 they are those of a body.
Measurement measure_dzhanibekov(Context& context) {
  const Vec3<double> moments(3.0, 5.0, 9.0);
  const Vec3<double> J = moments.cwiseInverse().array() + 0.1;
  const Case printed = {.flight = at_origin(J.cwiseInverse(), {0.0, 2.0, 0.01}),
                        .vector =
                            [moments](const State<double>& state) {
                              return Vec3<double>(formula::in_body(state.q_WB, state.L_W).cwiseQuotient(moments));
                            },
                        .unit = "rad/s",
                        .prints = {{100.0, {0.069698087609925, 0.394497096218929, 0.028475810857311}}}};
  return compare(context, printed, {by_elliptic_flight(), by_splitting()});
}

Claim case_claim(const char* id, const char* statement, const char* function, const char* oracle, double splitting,
                 Measurement (*measure)(Context&)) {
  return {.id = id,
          .statement = statement,
          .function = function,
          .family = OracleFamily::published,
          .oracle = oracle,
          .checks =
              {within("closed form", 0.5, "ε (1 + the angle turned)",
                      "the printed digits go further; the angle has four roundings, the attitude's components four of "
                      "their own size, seldom all to one side: measured 2026-11-30, 0.06 to 0.25"),
               within("splitting-6", splitting, "of the round-off of its steps (ORDER-4), sheared by the angle turned",
                      "the printed digits go further; four times what was measured 2026-11-30")},
          .measure = measure};
}

}  // namespace

std::vector<Claim> case_claims() {
  return {
      case_claim("CASE-1",
                 "A symmetric top, 10 s: the velocity and the attitude that Drake prints for Kane's solution.",
                 "free_flight, elliptic_flight, Stepper", "Drake's numbers (Kane, Likins, Levinson)", 0.01,
                 measure_symmetric_top),
      case_claim("CASE-2", "A body without a symmetry axis, 1 s and 5 s: the numbers of van Zon and Schofield.",
                 "elliptic_flight, Stepper", "van Zon and Schofield's numbers", 0.3, measure_asymmetric_top),
      case_claim("CASE-3", "DETEST's problem B5, Euler's equations in disguise, at t = 20.", "elliptic_flight, Stepper",
                 "DETEST's numbers", 0.05, measure_detest),
      case_claim("CASE-4",
                 "NASA's check-case 2, a tumbling brick for 30 s: closer to the truth than the seven simulations "
                 "that NASA compares.",
                 "elliptic_flight, Stepper", "the NESC's check-case in quadruple precision", 0.1,
                 measure_tumbling_brick),
      case_claim("CASE-5", "Principia's Dzhanibekov wingnut after 100 s of flips about the middle axis.",
                 "elliptic_flight, Stepper", "Principia's numbers", 0.1, measure_dzhanibekov),
  };
}

}  // namespace goishi::verify
