/// DROP: rolling. What it keeps, and published cases.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

// --- DROP-5

Measurement measure_rolling(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(6, 40); ++i) {
    const Pebble pebble = i % 2 == 0 ? size_33() : size_33(0.001);
    const Vec3<double> w(context.uniform(-5.0, 5.0), context.uniform(-5.0, 5.0), context.uniform(5.0, 25.0));
    const State<double> start = set_rolling(pebble, leaning(context.uniform(0.05, 0.35)), w);
    const Witnessed before = witnessed(pebble, start);
    for (const double time : {0.1, 0.5, 1.0}) {
      DropResult<double> dropped = drop(pebble, start, lossless(no_slip, 1e-12), time);
      dropped.state.L_W = context.produced(dropped.state.L_W);
      const Witnessed after = witnessed(pebble, dropped.state);
      const auto see = [&](Long error, const char* name) {
        checks[name].see(as_double(std::fabs(error)),
                         [&] { return fmt::format("ω = ({:a}, {:a}, {:a}) rad/s, {} s", w.x(), w.y(), w.z(), time); });
      };
      see(after.energy / before.energy - 1, "energy");
      see(after.jellett / before.jellett - 1, "Jellett's integral");
      see(routh(pebble, after) / routh(pebble, before) - 1, "Routh's integral");
      see(after.slip.norm() / std::sqrt(before.energy), "slip");
    }
  }
  return checks.measurement();
}

// --- DROP-12

Measurement measure_ball(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  for (int i = 0; i < context.samples(20, 200); ++i) {
    const bool published = i == 0;
    const double radius = published ? 0.01 : context.uniform(0.005, 0.05),
                 mu = published ? 0.5 : context.uniform(0.2, 1.0);
    const double g = published ? 9.81 : context.uniform(1.0, 20.0);
    const Stone<double> ball = make_stone(2.0 * radius, 2.0 * radius);
    const RigidBody<double> body = make_rigid_body(mass_properties(ball, Mass{0.01}));
    DropSettings<double> settings = lossless(mu, tight);
    settings.gravity = {0.0, 0.0, -g};
    State<double> start;
    start.q_WB = Quat<double>::Identity();
    start.p_WB = {0.0, 0.0, radius};
    start.v_WB = published ? Vec3<double>(5.0, 0.0, 0.0) : Vec3<double>(1.0, context.uniform(-1.0, 1.0), 0.0);
    Vec3<double> w = Vec3<double>::Zero();
    if (!published) {
      w = Vec3<double>(context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0)) * 4.0 /
          radius;
    }
    start.L_W = body.moments.x() * w;
    // Friction keeps its direction, against the slip s = v + ω × r, which it ends at rate 7μg/2.
    const Long3 v = start.v_WB.cast<Long>(), slip = v + w.cast<Long>().cross(Long3(0, 0, -static_cast<Long>(radius)));
    const Long speed = slip.norm(), stops = 2 * speed / (7 * static_cast<Long>(mu) * static_cast<Long>(g));
    settings.horizon = as_double(1.05L * stops);
    const DropResult<double> dropped = goishi::drop(ball, body, start, settings);
    const auto see = [&](Long error, const char* name) {
      checks[name].see(as_double(std::fabs(error)),
                       [&] { return fmt::format("μ = {:a}, slip {:a} m/s", mu, as_double(speed)); });
    };
    const Event<double>* const stick = first_event(dropped, EventKind::stick);
    see(stick == nullptr ? 1 : 0, "faults");
    if (stick == nullptr) {
      continue;
    }
    const Long3 rolls = v - 2 * slip / 7, place = v * stops - slip * stops / 7;
    const Long scale = std::max(v.norm(), speed);
    see(context.produced(stick->time) / stops - 1, "time");
    see((Long3(context.produced(stick->after.p_WB).cast<Long>() - Long3(0, 0, radius)) - place).norm() /
            (scale * stops),
        "place");
    see((context.produced(dropped.state.v_WB).cast<Long>() - rolls).norm() / scale, "velocity");
    if (published) {
      see(context.produced(stick->time) / 0.291247997670016 - 1.0, "as published");
      see(context.produced(stick->after.p_WB.x()) / 1.24820570430007 - 1.0, "as published");
      figures = {
          {"5 m/s, μ = 0.5, g = 9.81 m/s²", fmt::format("rolls from {:.15f} s, {:.14f} m, at {:.14f} m/s", stick->time,
                                                        stick->after.p_WB.x(), dropped.state.v_WB.x())}};
    }
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  return result;
}

// --- DROP-13, DROP-14

/// A thin disc of radius a on its edge, rolling, in g = 9.81 m/s².
struct Disc {
  Stone<double> stone;
  RigidBody<double> body;
  double radius;

  explicit Disc(double a)
      : stone(make_stone(2.0 * a, 2e-8 * a)),
        body(make_rigid_body(0.01, Moments<double>{.axial = 0.01 * a * a / 2.0, .transverse = 0.01 * a * a / 4.0})),
        radius(a) {}

  /// From the centre to the lowest point of the edge: against ẑ, less its part along the axis.
  [[nodiscard]] Vec3<double> arm(const Quat<double>& q) const {
    const Vec3<double> u = q * Vec3<double>(0.0, 0.0, 1.0);
    return radius * Vec3<double>(u.z() * u - Vec3<double>(0.0, 0.0, 1.0)).normalized();
  }
  [[nodiscard]] DropResult<double> rolled(const Quat<double>& q, const Vec3<double>& p, const Vec3<double>& w,
                                          double time) const {
    DropSettings<double> settings = lossless(no_slip, tight);
    settings.gravity = {0.0, 0.0, -9.81};
    settings.horizon = time;
    State<double> start;
    start.q_WB = q;
    start.p_WB = p;
    start.v_WB = -w.cross(arm(q));
    const Vec3<double> w_B = q.conjugate() * w;
    start.L_W = q * Vec3<double>(body.moments.cwiseProduct(w_B));
    return goishi::drop(stone, body, start, settings);
  }
};

Measurement measure_coin(Context& context) {
  Worst worst;
  const Disc coin(0.01);
  const double lean = degree;
  const Quat<double> q = turn_between(Vec3<double>::UnitZ(), {std::cos(lean), 0.0, -std::sin(lean)});
  const Vec3<double> p(0.01 * std::sin(lean), 0.0, 0.01 * std::cos(lean));
  const DropResult<double> dropped = coin.rolled(q, p, {0.0, 0.0, 10.0 * std::numbers::pi}, 0.5);
  const Vec3<double> at = context.produced(dropped.state.p_WB) + coin.arm(dropped.state.q_WB);
  const double height = context.produced(dropped.state.p_WB.z());
  worst.see(std::fabs(at.x() - 0.00200494702076199) / 0.01, [] { return "x"; });
  worst.see(std::fabs(at.y() - 0.00259692310360237) / 0.01, [] { return "y"; });
  worst.see(std::fabs(height - 0.00976087384258172) / 0.01, [] { return "height"; });
  Measurement result = worst.measurement();
  result.figures = {{"contact point", fmt::format("({:.17f}, {:.17f}) m", at.x(), at.y())},
                    {"height of the centre", fmt::format("{:.17f} m", height)}};
  return result;
}

Measurement measure_euler_disc(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const Disc disc(0.0375);
  const auto see_disc = [&](double lean) {
    // Ω² sin α = 4 g/a: the centre rests, and ω = Ω (ẑ − u cos α) lies along the disc.
    const double rate = std::sqrt(4.0 * 9.81 / (disc.radius * std::sin(lean))), time = 0.5;
    const Quat<double> q = leaning(lean);
    const Vec3<double> u = q * Vec3<double>(0.0, 0.0, 1.0), up(0.0, 0.0, 1.0);
    const Vec3<double> p(0.0, 0.0, disc.radius * std::sin(lean));
    const DropResult<double> dropped = disc.rolled(q, p, Vec3<double>(rate * (up - std::cos(lean) * u)), time);
    const Vec3<double> axis = dropped.state.q_WB * up;
    const auto see = [&](double error, const char* name) {
      checks[name].see(std::fabs(error), [&] { return fmt::format("{:g} rad", lean); });
    };
    see((context.produced(dropped.state.p_WB) - p).norm() / disc.radius, "centre");
    see(context.produced(std::atan2(std::hypot(axis.x(), axis.y()), axis.z())) - lean, "inclination");
    // A turn with Ω about the vertical, before it one with −Ω cos α about the axis.
    const Quat<double> turned = Quat<double>(std::cos(rate * time / 2.0), 0.0, 0.0, std::sin(rate * time / 2.0)) *
                                Quat<double>(Eigen::AngleAxisd(-rate * std::cos(lean) * time, u)) * q;
    Quat<double> q_WB = dropped.state.q_WB;
    q_WB.w() = context.produced(q_WB.w());
    see(2.0 * (turned.conjugate() * q_WB).vec().norm() / (rate * time), "attitude");
    const double phase =
        std::remainder(std::atan2(context.produced(axis.y()), axis.x()) - rate * time, 2.0 * std::numbers::pi);
    see(phase / (rate * time), "phase");
    return rate;
  };
  for (const auto& [lean, published] : {std::pair(0.1, 102.379), {0.5, 46.7184}, {1.0, 35.2638}}) {
    const double rate = see_disc(lean);
    checks["faults"].see(std::fabs(rate / published - 1.0) < 5e-6 ? 0.0 : 1.0, [] { return "as published"; });
    figures.push_back({fmt::format("{} rad", lean), fmt::format("{:.4f} rad/s", rate)});
  }
  for (int i = 0; i < context.samples(5, 50); ++i) {
    see_disc(context.uniform(0.05, 1.4));
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  return result;
}

}  // namespace

std::vector<Claim> drop_rolling_claims() {
  return {
      {.id = "DROP-5",
       .statement = "Rolling on the cap keeps Jellett's integral L · r and Routh's, ω_u² (I_t I_a + I_t r² "
                    "sin² θ + I_a (d − r cos θ)²), its energy and its contact point at rest.",
       .function = "drop",
       .family = OracleFamily::invariant,
       .oracle = "the start; integrals from the state, in long double",
       .checks = {{.name = "Jellett's integral",
                   .unit = "relative",
                   .bound = 3e-10,
                   .reason = "some thousand steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 6.1e-11",
                   .resolution = 5e-12},
                  within("Routh's integral", 1e-9, "relative",
                         "the same, of twice the spin; measured 2026-11-30 with 25 seeds: up to 1.9e-10"),
                  {.name = "slip",
                   .unit = "of √(2 E)",
                   .bound = 2e-15,
                   .reason =
                       "velocities are made of L, by some roundings; measured 2026-11-30 with 25 seeds: up to 2.6e-16",
                   .resolution = epsilon},
                  within("energy", 2e-15, "relative",
                         "the integration takes what energy is off out of the velocities: this says that it does, "
                         "and no more; measured 2026-11-30 with 25 seeds: up to 2.9e-16",
                         epsilon)},
       .measure = measure_rolling},
      {.id = "DROP-12",
       .statement = "A ball that slides rolls from t = 2 s/(7μg) on, s its slip, with v − 2s/7: 5/7 of its speed if it "
                    "did not turn; at the place that follows.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "the closed form in long double; published: 0.291247997670016 s, 1.24820570430007 m",
       .checks = {within("time", 2e-13, "relative",
                         "some ten steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 4.5e-14"),
                  within("place", 2e-13, "relative", "the same; measured 2026-11-30 with 25 seeds: up to 4.1e-14"),
                  within("velocity", 2e-13, "relative", "the same; measured 2026-11-30 with 25 seeds: up to 4.0e-14"),
                  within("as published", 1e-14, "relative", "the last of its 15 digits"), none("faults", "faults")},
       .measure = measure_ball},
      {.id = "DROP-13",
       .statement = "A coin that rolls on its edge, leaning by 1°, is after 0.5 s where it was published to be.",
       .function = "drop",
       .family = OracleFamily::published,
       .oracle = "its contact point and height in double, confirmed in quadruple precision",
       .checks = {{.unit = "radii",
                   .bound = 5e-13,
                   .reason =
                       "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 23 seeds: up to 3.2e-14"}},
       .measure = measure_coin},
      {.id = "DROP-14",
       .statement = "Euler's disc rolls round with its centre at rest and Ω² sin α = 4g/a, at any inclination; "
                    "102.379, 46.7184 and 35.2638 rad/s as published.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "the steady motion itself, half a second on",
       .checks = {within("centre", 1e-12, "radii",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 1.0e-13"),
                  within("inclination", 1e-12, "rad",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 9.5e-14"),
                  within("attitude", 1e-12, "of the angle turned",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 8.4e-14"),
                  within("phase", 1e-12, "of the angle turned",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 1.5e-13"),
                  none("faults", "faults")},
       .measure = measure_euler_disc},
  };
}

}  // namespace goishi::verify
