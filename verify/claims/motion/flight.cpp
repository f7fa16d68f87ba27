/// FLIGHT, BATCH: the exact flight against Odeint on the raw Newton–Euler equations, its rounding against 34 digits,
/// and what it keeps. That the formula evaluated in 34 digits may judge long flights is what FLIGHT-3 shows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/tensor.hpp>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/flight_errors.hpp"
#include "verify/oracles/motion/free_body.hpp"
#include "verify/samples/flight.hpp"

namespace goishi::verify {

namespace {

template <class T>
State<T> fly(const Top<T>& top) {
  return free_flight(top.state, top.moments, Vec3<T>(Vec3<T>::Zero()), top.time);
}

/// The body's raw equations, integrated; ω_B from L_W in `Quad`.
FreeBodyReference integrate(const Top<double>& top) {
  const auto& [moments, state, time] = top;
  const Quat<Quad> q = state.q_WB.cast<Quad>().normalized();
  const Vec3<Quad> L_B = q.conjugate() * Vec3<Quad>(state.L_W.cast<Quad>());
  const Quad a = moments.axial, t = moments.transverse;
  return integrate_free_body(
      {.moments = {t, t, a}, .attitude = {q.w(), q.x(), q.y(), q.z()}, .spin = {L_B.x() / t, L_B.y() / t, L_B.z() / a}},
      time);
}

Quat<Quad> attitude(const FreeBodyReference& reference) {
  const auto& [w, x, y, z] = reference.attitude;
  return {w, x, y, z};
}

Measurement measure_attitude(Context& context) {
  Checks checks;
  const auto see = [&](auto top) {
    checks["any body"].see(attitude_error(produced(context, fly(top).q_WB), exact_attitude<Quad>(top), top),
                           [&] { return describe(top); });
  };
  for (int i = 0; i < context.samples(4000, 30'000); ++i) {
    see(draw_top<double>(context.random(), i));
    see(draw_top<float>(context.random(), i));
  }
  int i = 0;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const Moments<double> moments = mass_properties(make_stone<double>(entry), Density{2800.0}).moments;
    const Top<double> top = draw_short(context.random(), moments, i++, context.tier() == Tier::quick ? 1.0 : 4.0);
    checks["catalogue"].see(attitude_error(produced(context, fly(top).q_WB), attitude(integrate(top)), top),
                            [&] { return name + ": " + describe(top); });
  });
  return checks.measurement();
}

Measurement measure_kept(Context& context) {
  Checks checks;
  const auto see = [&](auto top) { see_kept(context, checks, top, fly(top), [&] { return describe(top); }); };
  for (int i = 0; i < context.samples(5000, 50'000); ++i) {
    see(draw_top<double>(context.random(), i));
    see(draw_top<float>(context.random(), i));
  }
  return checks.measurement();
}

Measurement measure_formula(Context& context) {
  Worst worst;
  double disagreement = 0.0;
  for (int i = 0; i < context.samples(24, 48); ++i) {
    const Top<double> top = draw_short(context.random(), draw_moments<double>(context.random(), i), i / 2, 3.0);
    const FreeBodyReference right = integrate(top);
    worst.see(angle_between(produced(context, exact_attitude<Quad>(top)), attitude(right)),
              [&] { return describe(top); });
    disagreement = std::max(disagreement, right.disagreement);
  }
  Measurement result = worst.measurement();
  result.figures.push_back(
      {"largest disagreement of Bulirsch–Stoer and Fehlberg 7(8)", fmt::format("{:.2g}", disagreement)});
  return result;
}

/// One after the other, each refused unless the attitude that it starts from is a unit quaternion.
template <class T>
void see_chain(Worst& worst, Context& context, int kind, int count) {
  const Moments<T> moments = draw_moments<T>(context.random(), kind);
  const Mobility<T> mobility = make_mobility(moments);
  const Vec3<T> w_B = T(50) * draw_direction<T>(context.random(), 0);
  State<T> state = spinning<T>(draw_attitude(context.random()).template cast<T>().normalized(), moments, w_B);
  for (int i = 0; i < count; ++i) {
    state = free_flight(state, mobility, Vec3<T>(Vec3<T>::Zero()), static_cast<T>(context.uniform(-0.1, 1.0)),
                        Freedom::angular);
    const double defect =
        static_cast<double>(context.produced(state.q_WB.template cast<long double>().squaredNorm()) - 1.0L);
    worst.see(std::fabs(defect) / epsilon_of<T>, [&] { return fmt::format("flight {}, body of kind {}", i, kind); });
  }
}

Measurement measure_chain(Context& context) {
  Worst worst;
  const int count = context.samples(100'000, 1'000'000);
  see_chain<double>(worst, context, 0, count);  // as a stone
  see_chain<float>(worst, context, 0, count);
  see_chain<double>(worst, context, 2, count);  // a needle
  return worst.measurement();
}

Measurement measure_path(Context& context) {
  Checks checks;
  const auto see = [&](auto one) {
    using T = decltype(one);
    const State<T> start = draw_thrown<T>(context.random(), Quat<T>::Identity());
    const Vec3<T> gravity = Vec3<T>(start.v_WB.reverse()) + gravity_W<T>();
    const T time = static_cast<T>(draw_decades(context.random(), -3.0, 3.0));
    const State<T> after = free_flight(start, Moments<T>{.axial = T(2), .transverse = T(1)}, gravity, time);
    see_path(context, checks, start, gravity, time, after, [&] {
      return fmt::format("p, v = {:a}, {:a}, g = {:a}, t = {:a} (first coordinates)", start.p_WB[0], start.v_WB[0],
                         gravity[0], time);
    });
  };
  for (int i = 0; i < context.samples(10'000, 100'000); ++i) {
    see(1.0);
    see(1.0F);
  }
  return checks.measurement();
}

Measurement measure_exponential(Context& context) {
  Worst worst;
  const auto see = [&](auto one, double low, double high, int i) {
    using T = decltype(one);
    const Vec3<T> theta =
        static_cast<T>(draw_decades(context.random(), low, high)) * draw_direction<T>(context.random(), i);
    const Vec3<Quad> exact = theta.template cast<Quad>();
    const Quat<Quad> computed = produced(context, formula::rotation_exp(theta)).template cast<Quad>();
    const Quad angle = exact.norm();
    const Vec3<Quad> part = exact * Quad(sin(Quad(angle / 2)) / angle);
    const double off = angle_between(computed, Quat<Quad>(cos(Quad(angle / 2)), part.x(), part.y(), part.z()));
    worst.see(off, epsilon_of<T> * static_cast<double>(angle),
              [&] { return fmt::format("θ = ({:a}, {:a}, {:a})", theta.x(), theta.y(), theta.z()); });
  };
  for (int i = 0; i < context.samples(3'000, 30'000); ++i) {
    see(1.0, -280.0, 9.0, i);
    see(1.0F, -30.0, 5.0, i);
    see(1.0, -3.0, 3.0, i);
    see(1.0F, -3.0, 3.0, i);
  }
  const Quat<double> none = formula::rotation_exp(Vec3<double>(Vec3<double>::Zero()));
  worst.see(none.w() == 1.0 && none.vec().norm() == 0.0 ? 0.0 : std::nan(""), [] { return "θ = 0"; });
  return worst.measurement();
}

Measurement measure_batch(Context& context) {
  Checks checks;
  const auto see = [&](const auto& top, const auto& lane, const auto& alone, const auto& gravity) {
    const auto describe_it = [&] { return describe(top); };
    const auto q = produced(context, lane.q_WB);
    checks["as alone"].see(attitude_error(q, Quat<Quad>(alone.q_WB.template cast<Quad>()), top), describe_it);
    checks["attitude"].see(attitude_error(q, exact_attitude<Quad>(top), top), describe_it);
    see_path(context, checks, top.state, gravity, top.time, lane, describe_it);
  };
  over_batches<double>(context.random(), context.samples(300, 2000), see);
  over_batches<float>(context.random(), context.samples(300, 2000), see);
  return checks.measurement();
}

Measurement measure_batch_kept(Context& context) {
  Checks checks;
  const auto see = [&](const auto& top, const auto& lane, const auto&, const auto&) {
    see_kept(context, checks, top, lane, [&] { return describe(top); });
  };
  over_batches<double>(context.random(), context.samples(300, 2000), see);
  over_batches<float>(context.random(), context.samples(300, 2000), see);
  return checks.measurement();
}

}  // namespace

std::vector<Claim> flight_claims() {
  const std::vector<Check> path = {
      within("place", 2.0, "ε (|p| + |v t| + |g t²/2|)", "at most 4 roundings in each term", 0.5),
      within("velocity", 2.0, "ε (|v| + |g t|)", "a product and a sum, rounded once each", 0.5)};
  const std::vector<Check> kept = {
      within("momentum", 8.0, "ε", "|q|² is 1 within FLIGHT-4's 8 ε", 1.0),
      within("energy", 16.0, "ε √max(1, I_t/I_a)",
             "|q|² enters it squared; the rest is the axis, off by two quaternion products of 4 roundings a "
             "component",
             1.0)};
  return {
      {.id = "FLIGHT-1",
       .statement = "The attitude after any free flight is right within round-off: to 1e9 rad, at 1e-6 to 1000 rad/s, "
                    "forwards and backwards, stones, near the ball, thin, and needles to I_a = I_t/1000.",
       .function = "free_flight",
       .family = OracleFamily::rounding,
       .oracle = "every catalogue stone: Odeint on the raw Newton–Euler equations; all others: the formula, which "
                 "FLIGHT-3 shows right, in 34 digits",
       .checks =
           {within("any body", 8.0, "ε (1 + phase)",
                   "2.5 ε of each angle, 3 ε for the products; L_z is off by up to 2.5 ε |L|, which counts three times "
                   "where 4 I_a = I_t: 6.4 measured there, 2026-11-21, 500 000 bodies",
                   0.5),
            within("catalogue", 5.5, "ε (1 + phase)", "2.5 ε of each angle, 3 ε for the products", 0.5)},
       .measure = measure_attitude},
      {.id = "FLIGHT-2",
       .statement =
           "Free flight keeps energy of rotation and |L| to a few ε for any time; a needle's energy to ε √(I_t/I_a).",
       .function = "free_flight",
       .family = OracleFamily::invariant,
       .oracle = "the values before, both from the given quaternions in 34 digits",
       .checks = kept,
       .measure = measure_kept},
      {.id = "FLIGHT-3",
       .statement = "The closed form is the solution of the Newton–Euler equations: of stones, near-balls, thin bodies "
                    "and needles, at any speed.",
       .function = "formula::free_rotation, formula::mobility, formula::axial_momentum",
       .family = OracleFamily::integration,
       .oracle = "Odeint on the raw equations in 34 digits, Bulirsch–Stoer confirmed by Fehlberg 7(8); the formula in "
                 "34 digits, too",
       .checks = {within(
           "", 1e-25, "rad",
           "the integrators are asked for 1e-25 a step; measured 2026-11-30 with 40 seeds: up to 1.2e-26")},
       .measure = measure_formula},
      {.id = "FLIGHT-4",
       .statement =
           "However many flights follow each other, the attitude stays a unit quaternion, and each is accepted.",
       .function = "free_flight, formula::reunited",
       .family = OracleFamily::invariant,
       .oracle = "|q|² = 1",
       .checks = {within(
           "", 8.0, "ε",
           "4 ε, from scale and components; twice that where g++ 12 with -mfma fuses two copies of one component "
           "differently (measured 2026-11-21: 4.4 ε, and 2.3 ε without)",
           1.0)},
       .measure = measure_chain},
      {.id = "FLIGHT-5",
       .statement = "The centre of mass follows p + v t + g t²/2 with v + g t, for any gravity and time.",
       .function = "free_flight",
       .family = OracleFamily::exact,
       .oracle = "the parabola in 34 digits",
       .checks = path,
       .measure = measure_path},
      {.id = "FLIGHT-6",
       .statement = "A rotation vector's quaternion is right within round-off from 1e-280 to 1e9 rad (float: 1e-30 to "
                    "1e5), and at zero it is the identity.",
       .function = "formula::rotation_exp",
       .family = OracleFamily::other_formula,
       .oracle = "cosine and sine of half the vector's length in 34 digits",
       .checks = {within("", 2.0, "ε |θ|",
                         "half from the root of a sum of squares, half from sine, quotient and product", 0.5)},
       .measure = measure_exponential},
      {.id = "BATCH-1",
       .statement = "Every stone of a batch flies as it would alone, whatever its lane and the batch's size.",
       .function = "StoneBatch::fly",
       .family = OracleFamily::rounding,
       .oracle =
           "free_flight of the same stone, and the formula, which FLIGHT-3 shows right, in 34 digits; the parabola",
       .checks = {within("attitude", 8.0, "ε (1 + phase)",
                         "as FLIGHT-1: the batch's sine and cosine are as good, and 4 I_a >= I_t", 0.5),
                  within("as alone", 8.0, "ε (1 + phase)", "the attitude's and that of the stone alone", 0.5), path[0],
                  path[1]},
       .measure = measure_batch},
      {.id = "BATCH-2",
       .statement = "Every stone of a batch keeps energy of rotation and |L|.",
       .function = "StoneBatch::fly",
       .family = OracleFamily::invariant,
       .oracle = "the values before, both from the given quaternions in 34 digits",
       .checks = kept,
       .measure = measure_batch_kept},
  };
}

}  // namespace goishi::verify
