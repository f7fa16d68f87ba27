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
#include "verify/claims/motion/flight_errors.hpp"
#include "verify/oracles/motion/free_body.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/stone.hpp"

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
      worst.see(std::fabs(static_cast<double>(difference)), scale * epsilon,
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

Quat<Quad> unit(const Quat<double>& q) {
  return q.cast<Quad>().normalized();
}

struct Problem {
  RigidBody<double> body;
  State<double> start;
  double time;
  std::string stratum;

  [[nodiscard]] Vec3<Quad> momentum() const {
    return formula::in_body(unit(start.q_WB), Vec3<Quad>(start.L_W.cast<Quad>()));
  }
  /// Radians turned, at the most.
  [[nodiscard]] double turned() const { return start.L_W.norm() / body.moments.minCoeff() * std::fabs(time); }
  /// By how much an error of the start may grow: min(1/s, exp λ|t|), s = |1 − 2 E I_b/L²|, which is 0 on the separatrix;
  /// nothing where the start is an axis itself, and not rounded.
  [[nodiscard]] double growth() const {
    std::array<std::size_t, 3> order = {0, 1, 2};
    const auto I = [&](std::size_t k) { return Quad(body.moments[static_cast<Eigen::Index>(order[k])]); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return body.moments[static_cast<Eigen::Index>(i)] < body.moments[static_cast<Eigen::Index>(j)];
    });
    const Vec3<Quad> L_B = momentum();
    const Quad size = L_B.norm();
    if ((L_B.array() != Quad(0)).count() < 2) {
      return 0.0;
    }
    const auto part = [&](std::size_t k) {
      const Quad along = L_B[static_cast<Eigen::Index>(order[k])] / size;
      return Quad(along * along * (1 - I(1) / I(k)));
    };
    const Quad rate = size / I(1) * sqrt(Quad((I(1) - I(0)) * (I(2) - I(1)) / (I(0) * I(2))));
    const double by_time = std::exp(static_cast<double>(rate) * std::fabs(time));
    const double separation = std::fabs(static_cast<double>(Quad(part(0) + part(2))));
    return std::min(by_time, 1.0 / separation);
  }
  /// The round-off that a good method may show in the attitude: ε of the angle turned; and a share of what that of the
  /// start becomes.
  template <class T = double>
  [[nodiscard]] double round_off(double share = 1e-3) const {
    return epsilon_of<T> * (1.0 + turned()) * (1.0 + share * growth());
  }
  [[nodiscard]] std::string describe() const {
    return fmt::format("{}: I = ({:a}, {:a}, {:a}), q = ({:a}, {:a}, {:a}, {:a}), L = ({:a}, {:a}, {:a}), t = {:a}",
                       stratum, body.moments.x(), body.moments.y(), body.moments.z(), start.q_WB.w(), start.q_WB.x(),
                       start.q_WB.y(), start.q_WB.z(), start.L_W.x(), start.L_W.y(), start.L_W.z(), time);
  }
};

/// All orders of three moments; two that are equal, or are so but for an ulp; three; a lamina.
const std::array<Vec3<double>, 12> exact_moments = {Vec3<double>(1.0, 2.0, 3.0),
                                                    Vec3<double>(1.0, 3.0, 2.0),
                                                    Vec3<double>(2.0, 1.0, 3.0),
                                                    Vec3<double>(2.0, 3.0, 1.0),
                                                    Vec3<double>(3.0, 1.0, 2.0),
                                                    Vec3<double>(3.0, 2.0, 1.0),
                                                    Vec3<double>(2.0, 2.0, 3.0),
                                                    Vec3<double>(2.0, 1.0, 2.0),
                                                    Vec3<double>(1.0, 2.0, 2.0),
                                                    Vec3<double>(2.0, 2.0, 2.0),
                                                    Vec3<double>(2.0, 2.0 + 2.0 * epsilon, 3.0),
                                                    Vec3<double>(2.0, 3.0, 5.0)};

/// Along an axis of the body to the bit, in every case; and, where `off` is not 0, as far beside it.
Problem exact_problem(int i, double off, double time) {
  const auto take = [&](std::size_t count) {
    const std::size_t place = static_cast<std::size_t>(i) % count;
    i /= static_cast<int>(count);
    return place;
  };
  Problem problem;
  problem.stratum = "exact";
  problem.body = {.mass = 1.0, .moments = exact_moments[take(exact_moments.size())]};
  const auto axis = static_cast<Eigen::Index>(take(3));
  Vec3<double> L_B(off, off, off);
  L_B[axis] = take(2) == 0 ? 1.0 : -1.0;
  L_B[(axis + 1) % 3] *= take(2) == 0 ? 1.0 : 0.0;
  problem.time = take(2) == 0 ? time : -time;
  const Quat<double> q = exact_attitudes[take(exact_attitudes.size())];
  problem.start = {.p_WB = {0.0, 0.0, 0.0}, .q_WB = q, .v_WB = {0.0, 0.0, 0.0}, .L_W = q * L_B};
  return problem;
}

/// Moments of a brick of random edges, in three strata, and momenta in any direction, near an axis, near the separatrix;
/// and beside the axes at attitudes where that is exact, from 1e-300 to 1e-3.
Problem draw_problem(Context& context, int i, double longest) {
  const auto decades = [&](double span) { return std::pow(10.0, -span * context.uniform(0.0, 1.0)); };
  if (i % 5 == 3) {
    return exact_problem(i / 5, decades(i % 2 == 0 ? 300.0 : 20.0), longest * context.uniform(0.1, 1.0));
  }
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
  } else if (i % 5 == 2) {  // near an axis, or on it but for round-off
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

/// The same for a time in which the start still tells where it ends.
Problem foreseeable(Problem problem) {
  while (problem.growth() > 1e6) {
    problem.time /= 2.0;
  }
  return problem;
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

/// A call: in line, g++ 12 leaves out a vector's cast to float and back.
[[gnu::noinline]] Vec3<float> nearest(const Vec3<double>& v) {
  return v.cast<float>();
}

/// The nearest numbers of float, which are then exact.
Problem in_float(const Problem& problem) {
  Problem result = problem;
  result.body.moments = nearest(problem.body.moments).cast<double>();
  Eigen::Index most = 0;
  const double greatest = result.body.moments.maxCoeff(&most);
  if (greatest > result.body.moments.sum() - greatest) {  // a lamina's
    result.body.moments[most] = static_cast<double>(std::nextafter(static_cast<float>(greatest), 0.0F));
  }
  result.start.q_WB = problem.start.q_WB.cast<float>().normalized().cast<double>();
  result.start.L_W = nearest(problem.start.L_W).cast<double>();
  result.time = static_cast<double>(static_cast<float>(problem.time));
  return result;
}

Quat<Quad> flight_in_float(Context& context, const Problem& problem) {
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
    const Problem problem = foreseeable(draw_problem(context, i, std::pow(10.0, context.uniform(0.0, 4.0))));
    const double error = angle_between(produced_flight(context, problem).q_WB.cast<Quad>(), attitude_in_quad(problem));
    worst.see(error, problem.round_off(), [&] { return problem.describe(); });
    const Problem rounded = in_float(problem);
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
      const Problem problem = exact_problem(i, 0.0, time);
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
    worst.see(std::fabs(gain), epsilon, [&] { return problem.describe(); });
    const double norm = static_cast<double>(Quad(end.q_WB.cast<Quad>().squaredNorm() - Quad(1)));
    worst.see(std::fabs(norm), epsilon, [&] { return "|q|: " + problem.describe(); });
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
    const Problem problem = foreseeable(draw_problem(context, i, 100.0));
    Problem renamed = problem;
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
       .checks = {{.unit = "ε",
                   .bound = 12.0,
                   .reason = "up to ten duplications, which shrink earlier errors by four, and five Landen steps with "
                             "six roundings each",
                   .resolution = 1.0}},
       .mutants = {{"motion/elliptic.hpp", "T(9) * e2 * e3 / T(52)", "T(9) * e2 * e3 / T(51)"},
                   {"motion/elliptic.hpp", "e3 / T(14)", "e3 / T(13)"},
                   {"motion/elliptic.hpp", "T(6) * sum", "T(5) * sum"},
                   {"motion/elliptic.hpp", "d = less * over", "d = over"}},
       .measure = measure_functions},
      {.id = "ELLIPTIC-2",
       .statement =
           "The closed form of the asymmetric body is the motion of Newton and Euler, near the separatrix and 1e-300 "
           "beside the axes too.",
       .function = "elliptic_flight (in 113 bits)",
       .family = OracleFamily::integration,
       .oracle = "Odeint, two integrators in __float128",
       .checks = {{.unit = "rad",
                   .bound = 1e-21,
                   .reason = "the references agree to 1e-22; ten times that for the problem's own growth of errors",
                   .resolution = 1e-22}},
       .mutants = {{"motion/elliptic_flight.hpp", "- longitude;", "+ longitude;"},
                   {"motion/elliptic_flight.hpp", "size / C * ratio * third", "size / C / ratio * third"},
                   {"motion/elliptic_flight.hpp", "frame.R_BF << f1, f3.cross(f1), f3",
                    "frame.R_BF << f1, f1.cross(f3), f3"}},
       .measure = measure_formula},
      {.id = "ELLIPTIC-3",
       .statement =
           "In float and double the attitude is right to round-off: bricks, laminas, rods, nearly round bodies, up "
           "to 10⁴ rad, and from 1e-300 beside the axes; as long as the start's own errors grow by less than 1e6.",
       .function = "elliptic_flight",
       .family = OracleFamily::rounding,
       .oracle = "the same closed form in 113 bits (judges rounding)",
       .checks = {{.unit = "ε(1 + turned)(1 + growth/1000)",
                   .bound = 4.0,
                   .reason =
                       "evaluated in the next wider type and rounded; measured 2026-11-29, seeds 1 to 30: up to 0.7",
                   .resolution = 1.0}},
       .mutants = {{"motion/elliptic_flight.hpp", "half - T(floor(half)) < T(1) / T(4)", "T(0) < T(1)"},
                   {"motion/elliptic_flight.hpp", "T(floor(T(v / (T(2) * K) + T(1) / T(2))))",
                    "T(floor(T(v / (T(2) * K))))"}},
       .measure = measure_rounding},
      {.id = "ELLIPTIC-4",
       .statement = "Energy and the attitude's length are kept for any time.",
       .function = "elliptic_flight",
       .family = OracleFamily::invariant,
       .oracle = "the energy before, in 113 bits",
       .checks = {{.unit = "ε L²/I_least",
                   .bound = 8.0,
                   .reason =
                       "the rounded attitude's own 2 ε, and the start's; measured 2026-11-21, seeds 1 to 20: up to 1.6",
                   .resolution = 1.0}},
       .mutants = {{"motion/elliptic_flight.hpp", "T(flip * B * sn)", "T(-flip * B * sn)"},
                   {"motion/elliptic_flight.hpp", "* end_S * q_BF.conjugate()", "* start_S * q_BF.conjugate()"}},
       .measure = measure_invariants},
      {.id = "ELLIPTIC-5",
       .statement = "Which axis of the body is called x does not matter.",
       .function = "elliptic_flight",
       .family = OracleFamily::relation,
       .oracle = "the same body with its axes renamed in turn",
       .checks = {{.unit = "ε(1 + turned)(1 + growth)",
                   .bound = 4.0,
                   .reason = "renaming rounds the start to ε; measured 2026-11-29, seeds 1 to 30: up to 0.9",
                   .resolution = 1.0}},
       .mutants = {{"motion/elliptic_flight.hpp", "sort(b, c);", "sort(a, c);"},
                   {"motion/elliptic_flight.hpp", "if (moments[j] < moments[i])", "if (moments[i] < moments[j])"}},
       .measure = measure_relabelling},
      {.id = "ELLIPTIC-6",
       .statement =
           "A body that turns exactly about one of its axes, the middle one too, goes on turning about it: all "
           "orders of the axes, both senses, two or three equal moments, up to 1e9 rad, float and double.",
       .function = "elliptic_flight",
       .family = OracleFamily::exact,
       .oracle = "the turn about the axis by L t/I, in 113 bits",
       .checks = {{.unit = "ε(1 + turned)", .bound = 4.0, .reason = "as ELLIPTIC-3", .resolution = 1.0}},
       .mutants = {{"motion/elliptic_flight.hpp", "(Wide(2) * I[k])", "(Wide(2) * I.minCoeff())"},
                   {"motion/elliptic_flight.hpp", "< scalar::sq(std::numeric_limits<Wide>::epsilon()) * across",
                    "< scalar::tiny<Wide>() + across"}},
       .measure = measure_axes},
  };
}

}  // namespace goishi::verify
