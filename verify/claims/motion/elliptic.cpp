/// ELLIPTIC: free flight of a body without a symmetry axis, in closed form.

#include <fmt/format.h>

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <goishi/motion/elliptic_flight.hpp>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/flight_errors.hpp"
#include "verify/oracles/motion/free_body.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/tumbling.hpp"

namespace goishi::verify {

namespace {

// --- the functions

Measurement measure_functions(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(100, 1000); ++i) {
    const auto decades = [&](double span) { return std::pow(10.0, -span * context.uniform(0.0, 1.0)); };
    const double x = i % 3 == 0 ? 0.0 : decades(8.0), y = decades(8.0), p = 1.0 + 1.0 / decades(4.0);
    const auto compare = [&](const char* name, double computed, const Digits50& expected, bool is_integral) {
      const double off = std::fabs(static_cast<double>(Digits50(Digits50(context.produced(computed)) - expected)));
      checks[is_integral ? "integrals" : "functions"].see(
          off, epsilon * (is_integral ? static_cast<double>(expected) : 1.0),
          [&] { return fmt::format("{}: x = {:a}, y = {:a}, p = {:a}", name, x, y, p); });
    };
    const Digits50 X(x), Y(y), one(1), P(p);
    const Digits50 rf = boost::math::ellint_rf(X, Y, one);
    compare("R_F", elliptic::carlson_f(x, y, 1.0), rf, true);
    const Digits50 rj = boost::math::ellint_rj(X, Y, one, P);
    compare("R_J", elliptic::carlson_j(x, y, 1.0, p), rj, true);

    // Here y is 1 − m, and u is within a quarter period.
    const elliptic::JacobiFunctions<double> jacobi(y);
    const double u = context.uniform(-1.0, 1.0) * jacobi.quarter_period();
    const elliptic::Jacobi<double> computed = jacobi(u);
    Digits50 cn, dn;
    const Digits50 sn = boost::math::jacobi_elliptic(Digits50(sqrt(one - Y)), Digits50(u), &cn, &dn);
    compare("sn", computed.sn, sn, false);
    compare("cn", computed.cn, cn, false);
    compare("dn", computed.dn, dn, false);
    const Digits50 quarter = boost::math::ellint_rf(Digits50(0), Y, one);
    compare("K", jacobi.quarter_period(), quarter, true);
  }
  return checks.measurement();
}

// --- the flight

Quat<Quad> attitude_in_quad(const Tumbling& problem) {
  const RigidBody<Quad> body{.mass = Quad(1), .moments = problem.body.moments.cast<Quad>()};
  return elliptic_flight<Quad>(in_quad(problem.start), body, Vec3<Quad>(Vec3<Quad>::Zero()), Quad(problem.time),
                               Freedom::angular)
      .q_WB;
}

/// The formula itself, in 34 digits: no round-off of double in the way.
Measurement measure_elliptic_formula(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(20, 40); ++i) {
    const Tumbling problem = draw_tumbling(context, i, 12.0);
    const State<Quad> start = in_quad(problem.start);
    const Vec3<Quad> spin =
        formula::in_body(start.q_WB, start.L_W).cwiseQuotient(Vec3<Quad>(problem.body.moments.cast<Quad>()));
    const Vec3<double>& I = problem.body.moments;
    const FreeBodyReference reference =
        integrate_free_body({.moments = {Quad(I.x()), Quad(I.y()), Quad(I.z())},
                             .attitude = {start.q_WB.w(), start.q_WB.x(), start.q_WB.y(), start.q_WB.z()},
                             .spin = {spin.x(), spin.y(), spin.z()}},
                            Quad(problem.time));
    Quat<Quad> computed = attitude_in_quad(problem);
    computed.x() = context.produced(computed.x());
    const auto& q = reference.attitude;
    worst.see(angle_between(computed, Quat<Quad>(q[0], q[1], q[2], q[3])), [&] { return problem.describe(); });
  }
  return worst.measurement();
}

State<double> produced_flight(Context& context, const Tumbling& problem) {
  State<double> state =
      elliptic_flight(problem.start, problem.body, gravity_W<double>(), problem.time, Freedom::angular);
  state.q_WB.x() = context.produced(state.q_WB.x());
  return state;
}

Quat<Quad> flight_in_float(Context& context, const Tumbling& problem) {
  const Vec3<float> none = Vec3<float>::Zero();
  const State<float> start{
      .p_WB = none, .q_WB = problem.start.q_WB.cast<float>(), .v_WB = none, .L_W = problem.start.L_W.cast<float>()};
  const RigidBody<float> body{.mass = 1.0F, .moments = problem.body.moments.cast<float>()};
  Quat<float> q = elliptic_flight(start, body, none, static_cast<float>(problem.time)).q_WB;
  q.x() = context.produced(q.x());
  return q.cast<Quad>();
}

Measurement measure_rounding(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(500, 5000); ++i) {
    const Tumbling problem = foreseeable(draw_tumbling(context, i, std::pow(10.0, context.uniform(0.0, 4.0))));
    const double error = angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), attitude_in_quad(problem));
    worst.see(error, problem.round_off(), [&] { return problem.describe(); });
    const Tumbling rounded = in_float(problem);
    worst.see(angle_between(flight_in_float(context, rounded), attitude_in_quad(rounded)), rounded.round_off<float>(),
              [&] { return "float: " + rounded.describe(); });
  }
  return worst.measurement();
}

/// Exactly along an axis: the turn about it.
Measurement measure_axes(Context& context) {
  Worst worst;
  for (int i = 0; i < 12 * 3 * 2 * 2 * 2 * 6; ++i) {
    for (const double time : {0.0, 1e-300, 1e-3, 1.0, 40.0, 1e4, 1e9}) {
      const Tumbling problem = exact_tumbling(i, 0.0, time);
      Eigen::Index k = 0;
      const Vec3<Quad> L_B = problem.momentum();
      static_cast<void>(L_B.cwiseAbs().maxCoeff(&k));
      const Quad half = L_B[k] * Quad(problem.time) / (2 * Quad(problem.body.moments[k]));
      Quat<Quad> turn(cos(half), Quad(0), Quad(0), Quad(0));
      turn.vec()[k] = sin(half);
      const Quat<Quad> right = problem.start.q_WB.cast<Quad>() * turn;
      worst.see(angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), right), problem.round_off(),
                [&] { return problem.describe(); });
      if (time == 0.0 || time > 1e-30) {
        worst.see(angle_between(flight_in_float(context, problem), right), problem.round_off<float>(),
                  [&] { return "float: " + problem.describe(); });
      }
    }
  }
  return worst.measurement();
}

/// The rotation leaves L_W alone; what the attitude makes of it in the body must keep |L| and the energy.
Measurement measure_elliptic_invariants(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(5000, 50000); ++i) {
    const Tumbling problem = draw_tumbling(context, i, std::pow(10.0, context.uniform(0.0, 9.0)));
    const State<double> end = produced_flight(context, problem);
    const auto energy = [&](const State<double>& state) {
      const RigidBody<Quad> body{.mass = Quad(1), .moments = problem.body.moments.cast<Quad>()};
      return formula::rotational_energy<Quad>(in_quad(state), body);
    };
    // The energy of a rod changes by ε L²/I_least for an error of ε in the attitude.
    const double scale = problem.start.L_W.squaredNorm() / problem.body.moments.minCoeff();
    const double gain = static_cast<double>(Quad(energy(end) - energy(problem.start))) / scale;
    checks["energy"].see(std::fabs(gain), epsilon, [&] { return problem.describe(); });
    const double norm = static_cast<double>(Quad(end.q_WB.cast<Quad>().squaredNorm() - Quad(1)));
    checks["length"].see(std::fabs(norm), epsilon, [&] { return problem.describe(); });
  }
  return checks.measurement();
}

/// The same body with its axes renamed in turn moves as before.
Measurement measure_relabelling(Context& context) {
  Worst worst;
  Mat3<double> turn = Mat3<double>::Zero();
  turn(1, 0) = turn(2, 1) = turn(0, 2) = 1.0;  // new axes x, y, z are the old y, z, x
  const Quat<double> q_BC(turn);
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Tumbling problem = foreseeable(draw_tumbling(context, i, 100.0));
    Tumbling renamed = problem;
    renamed.body.moments = turn.transpose() * problem.body.moments;
    renamed.start.q_WB = problem.start.q_WB * q_BC;
    const Quat<double> other =
        elliptic_flight(renamed.start, renamed.body, gravity_W<double>(), renamed.time).q_WB * q_BC.conjugate();
    const double error = angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), other.cast<Quad>());
    worst.see(error, problem.round_off(1.0), [&] { return problem.describe(); });
  }
  return worst.measurement();
}

}  // namespace

std::vector<Claim> elliptic_claims() {
  return {
      {.id = "ELLIPTIC-1",
       .statement = "Carlson's integrals and Jacobi's functions, 1 − m from 1 to 1e-8: integrals relative, functions "
                    "absolute.",
       .function = "elliptic::carlson_f, carlson_j, JacobiFunctions",
       .family = OracleFamily::other_formula,
       .oracle = "Boost.Math in 50 digits",
       .checks = {within("integrals", 12.0, "ε of each", "up to ten duplications, which shrink earlier errors by four",
                         1.0),
                  within("functions", 12.0, "ε", "five Landen steps with six roundings each", 1.0)},
       .measure = measure_functions},
      {.id = "ELLIPTIC-2",
       .statement =
           "The closed form of the asymmetric body is the motion of Newton and Euler, near the separatrix and 1e-300 "
           "beside the axes too.",
       .function = "elliptic_flight (in 113 bits)",
       .family = OracleFamily::integration,
       .oracle = "Odeint, two integrators in __float128",
       .checks = {within(
           "", 1e-24, "rad",
           "the integrators are asked for 1e-25 a step; measured 2026-11-30 with 40 seeds: up to 7.5e-26")},
       .measure = measure_elliptic_formula},
      {.id = "ELLIPTIC-3",
       .statement =
           "In float and double the attitude is right to round-off: bricks, laminas, rods, nearly round bodies, up "
           "to 10⁴ rad, and from 1e-300 beside the axes; as long as the start's own errors grow by less than 1e6.",
       .function = "elliptic_flight",
       .family = OracleFamily::rounding,
       .oracle = "the same closed form in 113 bits (judges rounding)",
       .checks = {within("", 4.0, "ε(1 + turned)(1 + growth/1000)",
                         "evaluated in the next wider type and rounded; measured 2026-11-29, seeds 1 to 30: up to 0.7",
                         1.0)},
       .measure = measure_rounding},
      {.id = "ELLIPTIC-4",
       .statement = "Energy and the attitude's length are kept for any time.",
       .function = "elliptic_flight",
       .family = OracleFamily::invariant,
       .oracle = "the energy before, in 113 bits",
       .checks = {within("energy", 4.0, "ε L²/I_least", "the rounded attitude's own ε, and the start's", 0.25),
                  within("length", 4.0, "ε, of |q|²", "the attitude is rounded once", 0.5)},
       .measure = measure_elliptic_invariants},
      {.id = "ELLIPTIC-5",
       .statement = "Which axis of the body is called x does not matter.",
       .function = "elliptic_flight",
       .family = OracleFamily::relation,
       .oracle = "the same body with its axes renamed in turn",
       .checks = {within("", 4.0, "ε(1 + turned)(1 + growth)",
                         "renaming rounds the start to ε; measured 2026-11-29, seeds 1 to 30: up to 0.9", 1.0)},
       .measure = measure_relabelling},
      {.id = "ELLIPTIC-6",
       .statement =
           "A body that turns exactly about one of its axes, the middle one too, goes on turning about it: all "
           "orders of the axes, both senses, two or three equal moments, up to 1e9 rad, float and double.",
       .function = "elliptic_flight",
       .family = OracleFamily::exact,
       .oracle = "the turn about the axis by L t/I, in 113 bits",
       .checks = {within("", 4.0, "ε(1 + turned)", "as ELLIPTIC-3", 1.0)},
       .measure = measure_axes},
  };
}

}  // namespace goishi::verify
