/// ELLIPTIC: free flight of a body without a symmetry axis, in closed form.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <goishi/motion/elliptic_flight.hpp>

#include "verify/claims/claims.hpp"
#include "verify/oracles/free_body.hpp"
#include "verify/oracles/multiprecision.hpp"
#include "verify/samples.hpp"

namespace goishi::verify {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// --- the functions

Measurement measure_functions(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(100, 1000); ++i) {
    const auto decades = [&](double span) { return std::pow(10.0, -span * context.uniform(0.0, 1.0)); };
    const double x = i % 3 == 0 ? 0.0 : decades(8.0), y = decades(8.0), p = 1.0 + 1.0 / decades(4.0);
    const auto compare = [&](const char* name, double computed, const Digits50& expected, double scale) {
      const Digits50 difference = Digits50(context.produced(computed)) - expected;
      worst.see(std::fabs(static_cast<double>(difference)) / scale / epsilon,
                [&] { return fmt::format("{}: x = {:a}, y = {:a}, p = {:a}", name, x, y, p); });
    };
    const Digits50 X(x), Y(y), one(1), P(p);
    const Digits50 rf = boost::math::ellint_rf(X, Y, one);
    compare("R_F", elliptic::carlson_f(x, y, 1.0), rf, static_cast<double>(rf));
    const Digits50 rj = boost::math::ellint_rj(X, Y, one, P);
    compare("R_J", elliptic::carlson_j(x, y, 1.0, p), rj, static_cast<double>(rj));

    // Here y is 1 − m, and u is within a quarter period.
    const elliptic::JacobiFunctions<double> jacobi(y);
    const double u = context.uniform(-1.0, 1.0) * jacobi.quarter_period();
    const elliptic::Jacobi<double> computed = jacobi(u);
    Digits50 cn, dn;
    const Digits50 sn = boost::math::jacobi_elliptic(Digits50(sqrt(one - Y)), Digits50(u), &cn, &dn);
    compare("sn", computed.sn, sn, 1.0);
    compare("cn", computed.cn, cn, 1.0);
    compare("dn", computed.dn, dn, 1.0);
    const Digits50 quarter = boost::math::ellint_rf(Digits50(0), Y, one);
    compare("K", jacobi.quarter_period(), quarter, static_cast<double>(quarter));
  }
  return worst.measurement();
}

// --- the flight

struct Problem {
  RigidBody<double> body;
  State<double> start;
  double time;
  std::string stratum;

  [[nodiscard]] Vec3<double> momentum() const { return formula::in_body(start.q_WB, start.L_W); }
  /// Radians turned, at the most.
  [[nodiscard]] double turned() const { return start.L_W.norm() / body.moments.minCoeff() * std::fabs(time); }
  /// |1 − 2 E I_b / L²|: 0 on the separatrix.
  [[nodiscard]] double separation() const {
    Vec3<double> sorted = body.moments;
    std::sort(sorted.begin(), sorted.end());
    const Vec3<double> L = momentum();
    return std::fabs(1.0 - L.cwiseProduct(L).cwiseQuotient(body.moments).sum() * sorted[1] / L.squaredNorm());
  }
  /// The round-off that a good method may show in the attitude: ε of the angle turned, and of the distance from the
  /// separatrix.
  [[nodiscard]] double round_off() const { return epsilon * (1.0 + turned()) * (1.0 + 1e-3 / separation()); }
  [[nodiscard]] std::string describe() const {
    return fmt::format("{}: I = ({:a}, {:a}, {:a}), q = ({:a}, {:a}, {:a}, {:a}), L = ({:a}, {:a}, {:a}), t = {:a}",
                       stratum, body.moments.x(), body.moments.y(), body.moments.z(), start.q_WB.w(), start.q_WB.x(),
                       start.q_WB.y(), start.q_WB.z(), start.L_W.x(), start.L_W.y(), start.L_W.z(), time);
  }
};

/// Moments of a brick of random edges, in three strata, and momenta in any direction, near an axis, near the separatrix.
Problem draw_problem(Context& context, int i, double longest) {
  const auto decades = [&](double span) { return std::pow(10.0, -span * context.uniform(0.0, 1.0)); };
  constexpr std::array<const char*, 4> names = {"brick", "nearly round", "lamina", "rod"};
  std::array<double, 3> edge = {context.uniform(0.3, 1.0), context.uniform(0.3, 1.0), context.uniform(0.3, 1.0)};
  if (i % 4 == 1) {
    edge[1] = edge[0] * (1.0 + decades(7.0));
  } else if (i % 4 == 2) {
    edge[1] = decades(5.0);
  } else if (i % 4 == 3) {
    edge[0] = decades(2.0), edge[2] = edge[0] * context.uniform(0.3, 1.0);
  }
  const auto square = [&](std::size_t k) { return edge[k] * edge[k]; };
  Problem problem;
  problem.stratum = names[static_cast<std::size_t>(i % 4)];
  problem.body =
      make_rigid_body(1.0, Vec3<double>(square(1) + square(2), square(2) + square(0), square(0) + square(1)));
  Vec3<double> L_B(context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0));
  if (i % 5 == 1) {  // near the middle axis, that is, near the separatrix
    Vec3<double> sorted = problem.body.moments;
    std::sort(sorted.begin(), sorted.end());
    for (int k = 0; k < 3; ++k) {
      L_B[k] = problem.body.moments[k] == sorted[1] ? 1.0 : L_B[k] * decades(3.0);
    }
  } else if (i % 5 == 2) {  // near an axis, or on it
    L_B[i % 3] = 1.0;
    L_B[(i + 1) % 3] *= i % 7 == 0 ? 0.0 : decades(12.0);
    L_B[(i + 2) % 3] *= i % 7 == 0 ? 0.0 : decades(12.0);
  }
  const Quat<double> q = draw_attitude(context.random());
  problem.start = {.p_WB = {0.0, 0.0, 0.0}, .q_WB = q, .v_WB = {0.0, 0.0, 0.0}, .L_W = q * L_B};
  const double rate = problem.start.L_W.norm() / problem.body.moments.minCoeff();
  problem.time = (i % 2 == 0 ? 1.0 : -1.0) * longest * context.uniform(0.1, 1.0) / rate;
  return problem;
}

Quat<Quad> unit(const Quat<double>& q) {
  return q.cast<Quad>().normalized();
}

State<Quad> in_quad(const State<double>& state) {
  return {.p_WB = state.p_WB.cast<Quad>(),
          .q_WB = unit(state.q_WB),
          .v_WB = state.v_WB.cast<Quad>(),
          .L_W = state.L_W.cast<Quad>()};
}

Quat<Quad> attitude_in_quad(const Problem& problem) {
  const RigidBody<Quad> body{.mass = Quad(1), .moments = problem.body.moments.cast<Quad>()};
  return elliptic_flight<Quad>(in_quad(problem.start), body, Vec3<Quad>(Vec3<Quad>::Zero()), Quad(problem.time),
                               Freedom::angular)
      .q_WB;
}

double angle_between(const Quat<Quad>& q, const Quat<Quad>& p) {
  const Quat<Quad> difference = q.conjugate() * p;
  return 2.0 * static_cast<double>(Quad(difference.vec().norm() / difference.norm()));
}

/// The formula itself, in 34 digits: no round-off of double in the way.
Measurement measure_formula(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(20, 40); ++i) {
    const Problem problem = draw_problem(context, i, 12.0);
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

State<double> produced_flight(Context& context, const Problem& problem) {
  State<double> state =
      elliptic_flight(problem.start, problem.body, gravity_W<double>(), problem.time, Freedom::angular);
  state.q_WB.x() = context.produced(state.q_WB.x());
  return state;
}

Measurement measure_rounding(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(500, 5000); ++i) {
    const Problem problem = draw_problem(context, i, std::pow(10.0, context.uniform(0.0, 4.0)));
    const double error = angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), attitude_in_quad(problem));
    worst.see(error / problem.round_off(), [&] { return problem.describe(); });
  }
  return worst.measurement();
}

/// The rotation leaves L_W alone; what the attitude makes of it in the body must keep |L| and the energy.
Measurement measure_invariants(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(5000, 50000); ++i) {
    const Problem problem = draw_problem(context, i, std::pow(10.0, context.uniform(0.0, 9.0)));
    const State<double> end = produced_flight(context, problem);
    const auto energy = [&](const State<double>& state) {
      const RigidBody<Quad> body{.mass = Quad(1), .moments = problem.body.moments.cast<Quad>()};
      return formula::rotational_energy<Quad>(in_quad(state), body);
    };
    // The energy of a rod changes by ε L²/I_least for an error of ε in the attitude.
    const double scale = problem.start.L_W.squaredNorm() / problem.body.moments.minCoeff();
    const double gain = static_cast<double>(Quad(energy(end) - energy(problem.start))) / scale;
    worst.see(std::fabs(gain) / epsilon, [&] { return problem.describe(); });
    const double norm = static_cast<double>(Quad(end.q_WB.cast<Quad>().squaredNorm() - Quad(1)));
    worst.see(std::fabs(norm) / epsilon, [&] { return "|q|: " + problem.describe(); });
  }
  return worst.measurement();
}

/// The same body with its axes renamed in turn moves as before.
Measurement measure_relabelling(Context& context) {
  Worst worst;
  Mat3<double> turn = Mat3<double>::Zero();
  turn(1, 0) = turn(2, 1) = turn(0, 2) = 1.0;  // new axes x, y, z are the old y, z, x
  const Quat<double> q_BC(turn);
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Problem problem = draw_problem(context, i, 100.0);
    Problem renamed = problem;
    renamed.body.moments = turn.transpose() * problem.body.moments;
    renamed.start.q_WB = problem.start.q_WB * q_BC;
    const Quat<double> other =
        elliptic_flight(renamed.start, renamed.body, gravity_W<double>(), renamed.time).q_WB * q_BC.conjugate();
    const double error = angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), other.cast<Quad>());
    worst.see(error / problem.round_off(), [&] { return problem.describe(); });
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
       .family = OracleFamily::independent,
       .oracle = "Boost.Math in 50 digits",
       .unit = "ε",
       .bound = 12.0,
       .reason =
           "up to ten duplications, which shrink earlier errors by four, and five Landen steps with six roundings each",
       .resolution = 1.0,
       .mutants = {{"motion/elliptic.hpp", "T(9) * e2 * e3 / T(52)", "T(9) * e2 * e3 / T(51)"},
                   {"motion/elliptic.hpp", "e3 / T(14)", "e3 / T(13)"},
                   {"motion/elliptic.hpp", "T(6) * sum", "T(5) * sum"},
                   {"motion/elliptic.hpp", "d = (T(1) - ks2) * over", "d = over"}},
       .measure = measure_functions},
      {.id = "ELLIPTIC-2",
       .statement =
           "The closed form of the asymmetric body is the motion of Newton and Euler, near the separatrix too.",
       .function = "elliptic_flight (in 113 bits)",
       .family = OracleFamily::independent,
       .oracle = "Odeint, two integrators in __float128",
       .unit = "rad",
       .bound = 1e-21,
       .reason = "the references agree to 1e-22; ten times that for the problem's own growth of errors",
       .resolution = 1e-22,
       .mutants = {{"motion/elliptic_flight.hpp", "- longitude;", "+ longitude;"},
                   {"motion/elliptic_flight.hpp", "size / C * ratio * third", "size / C / ratio * third"},
                   {"motion/elliptic_flight.hpp", "frame.R_BF << f1, f3.cross(f1), f3",
                    "frame.R_BF << f1, f1.cross(f3), f3"}},
       .measure = measure_formula},
      {.id = "ELLIPTIC-3",
       .statement = "In double the attitude is right to round-off: bricks, laminas, rods, nearly round bodies, up to "
                    "10⁴ rad.",
       .function = "elliptic_flight",
       .family = OracleFamily::exact,
       .oracle = "the same closed form in 113 bits (judges rounding)",
       .unit = "ε(1 + turned)(1 + 0.001/separation)",
       .bound = 4.0,
       .reason = "evaluated in long double and rounded; measured 2026-11-21, seeds 1 to 20: up to 0.51",
       .resolution = 1.0,
       .mutants = {{"motion/elliptic_flight.hpp", "(half - T(floor(half)) < T(1) / T(4))", "(T(0) < T(1))"},
                   {"motion/elliptic_flight.hpp", "T(floor(T(u / (T(2) * K) + T(1) / T(2))))",
                    "T(floor(T(u / (T(2) * K))))"}},
       .measure = measure_rounding},
      {.id = "ELLIPTIC-4",
       .statement = "Energy and the attitude's length are kept for any time.",
       .function = "elliptic_flight",
       .family = OracleFamily::invariant,
       .oracle = "the energy before, in 113 bits",
       .unit = "ε L²/I_least",
       .bound = 8.0,
       .reason = "the rounded attitude's own 2 ε, and the start's; measured 2026-11-21, seeds 1 to 20: up to 1.6",
       .resolution = 1.0,
       .mutants = {{"motion/elliptic_flight.hpp", "T(flip * B * now.sn)", "T(-flip * B * now.sn)"},
                   {"motion/elliptic_flight.hpp", "* end_S * q_BF.conjugate()", "* start_S * q_BF.conjugate()"}},
       .measure = measure_invariants},
      {.id = "ELLIPTIC-5",
       .statement = "Which axis of the body is called x does not matter.",
       .function = "elliptic_flight",
       .family = OracleFamily::metamorphic,
       .oracle = "the same body with its axes renamed in turn",
       .unit = "ε(1 + turned)(1 + 0.001/separation)",
       .bound = 16.0,
       .reason =
           "twice ELLIPTIC-3, and two products of quaternions in double; measured 2026-11-21, seeds 1 to 20: up to 4.1",
       .resolution = 1.0,
       .mutants = {{"motion/elliptic_flight.hpp", "sort(b, c);", "sort(a, c);"},
                   {"motion/elliptic_flight.hpp", "if (moments[j] < moments[i])", "if (moments[i] < moments[j])"}},
       .measure = measure_relabelling},
  };
}

}  // namespace goishi::verify
