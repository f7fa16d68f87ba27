/// DROP: rocking and rolling, held against quadrature, invariants and an integration in the plane.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

/// Tilt with its sign, of a stone that moves in the plane of x and z, and its rate.
struct Tilt {
  Long angle, rate;
};

Tilt tilt_of(const Pebble& pebble, const State<double>& state) {
  const Witnessed seen = witnessed(pebble, state);
  return {std::atan2(seen.u.x(), seen.u.z()), seen.w.y()};
}

// --- DROP-3

/// A stone at rest, leaning, on cap or rim.
State<double> let_go(const Pebble& pebble, double tilt) {
  State<double> start = set_on_cap(pebble, leaning(tilt), {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  if (static_cast<Long>(tilt) > pebble.rocker().joint()) {
    start.p_WB.z() = pebble.shape.torus_radius * std::sin(tilt) + pebble.shape.tube_radius;
  }
  return start;
}

/// The period by a drop: after nine quarters of what is expected the stone is nearly upright, and its rate tells when
/// it is so.
Long dropped_period(const Pebble& pebble, Footing footing, double tilt, Long expected, double tolerance) {
  const double friction = footing == Footing::rolling ? no_slip : 0.0;
  const DropResult<double> dropped =
      drop(pebble, let_go(pebble, tilt), lossless(friction, tolerance), 9 * expected / 4);
  const Tilt then = tilt_of(pebble, dropped.state);
  return (static_cast<Long>(dropped.time) - then.angle / then.rate) * 4 / 9;
}

Plot frequency_plot(const Context& context, const Pebble& pebble) {
  Plot plot{.title = "Rocking of size 33, bevelled: the contact passes from cap to bevel at 41.7°",
            .x_label = "greatest tilt [°]",
            .y_label = "frequency [Hz]",
            .series = {}};
  for (const auto& [footing, name] :
       {std::pair(Footing::frictionless, "frictionless"), {Footing::rolling, "rolling"}}) {
    Series curve{.name = fmt::format("{}, by quadrature", name), .points = {}};
    Series points{.name = fmt::format("{}, dropped", name), .points = {}, .line = false, .look = Look::star};
    for (int i = 2; i <= 80; i += 2) {
      const Long period = rocking_period(pebble.rocker(), footing, i * degree);
      curve.points.emplace_back(i, as_double(1 / period));
      if (i % 10 == 0) {
        const Long found = dropped_period(pebble, footing, i * degree, period, 1e-9);
        points.points.emplace_back(i, as_double(1 / context.produced(found)));
      }
    }
    plot.series.push_back(curve);
    plot.series.push_back(points);
  }
  return plot;
}

Measurement measure_periods(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const Pebble sharp = size_33(), bevelled = size_33(0.001);
  const auto see = [&](const Pebble& pebble, Footing footing, double tilt) {
    const Long expected = rocking_period(pebble.rocker(), footing, tilt);
    const Long found = context.produced(dropped_period(pebble, footing, tilt, expected, 1e-12));
    checks["period"].see(as_double(std::fabs(found / expected - 1)) * tilt, [&] {
      return fmt::format("{}, b = {:g}, from {:g} rad", footing == Footing::rolling ? "rolling" : "frictionless",
                         pebble.shape.bevel, tilt);
    });
    return found;
  };
  for (const Footing footing : {Footing::rolling, Footing::frictionless}) {
    for (const double tilt : {0.1, 1.0, 10.0, 25.0}) {
      const Long period = see(sharp, footing, tilt * degree);
      figures.push_back({fmt::format("{} from {:g}°", footing == Footing::rolling ? "rolling" : "frictionless", tilt),
                         fmt::format("{:.9f} s, {:.6f} Hz", as_double(period), as_double(1 / period))});
    }
    for (const double tilt : {41.0, 42.0, 60.0, 80.0}) {
      see(bevelled, footing, tilt * degree);
    }
    for (int i = 0; i < context.samples(6, 40); ++i) {
      const double h = context.uniform(0.005, 0.015);
      const Pebble other = make_pebble(0.022, h, h * context.uniform(0.05, 0.5));
      see(other, footing, context.uniform(0.002, 0.8 * as_double(other.rocker().joint())));
    }
    // The frequencies of very small rocking that are printed.
    const double printed = footing == Footing::rolling ? 7.6869 : 10.4976, small = 0.01 * degree;
    const Long found = dropped_period(sharp, footing, small, rocking_period(sharp.rocker(), footing, small), 1e-12);
    checks["as printed"].see(std::fabs(context.produced(as_double(1 / found)) - printed),
                             [&] { return fmt::format("{} Hz", printed); });
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  result.plots = {frequency_plot(context, bevelled)};
  return result;
}

// --- DROP-6

constexpr double decay_tolerance = 1e-12;

/// Where each half swing ends, and where and when the stone rests.
void see_decay(Context& context, Checks& checks, const Pebble& pebble, double tilt, double delta, Series* swings) {
  DropSettings<double> settings = lossless(no_slip, decay_tolerance);
  settings.rolling_resistance = delta;
  const Losses losses{.rolling_resistance = delta};
  const std::vector<PlanarMotion> turns = turning_points(pebble.rocker(), Footing::rolling, losses, tilt);
  const State<double> start = set_on_cap(pebble, leaning(tilt), {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  const auto see = [&](double error, const char* check, const std::string& what = "") {
    checks[check].see(error, [&] { return fmt::format("{}from {:g} rad, δ = {:g} m", what, tilt, delta); });
  };
  const Drop<double> motion = moved(pebble, start, settings, as_double(turns.back().time));
  for (const PlanarMotion& turn : turns) {
    if (&turn == &turns.back()) {
      break;
    }
    const Tilt found = tilt_of(pebble, motion.state_at(as_double(turn.time)));
    see(as_double(std::fabs(context.produced(found.angle) - turn.tilt)), "turns",
        fmt::format("at {} s, ", as_double(turn.time)));
    if (swings != nullptr) {
      swings->points.emplace_back(as_double(turn.time), as_double(std::fabs(found.angle)) / degree);
    }
  }
  const DropResult<double> dropped = drop(pebble, start, settings, 100);
  see(dropped.status == DropStatus::rest ? 0.0 : 1.0, "faults", "rests: ");
  const Long rest = tilt_of(pebble, dropped.state).angle;
  see(as_double(std::fabs(context.produced(rest) - turns.back().tilt)), "tilt of rest");
  see(std::fabs(as_double(rest)) <= delta / pebble.shape.sphere_offset ? 0.0 : 1.0, "faults", "holds: ");
  see(as_double(std::fabs(static_cast<Long>(context.produced(dropped.time)) / turns.back().time - 1)), "time of rest");
}

Measurement measure_decay(Context& context) {
  Checks checks;
  const Pebble pebble = size_33();
  constexpr double tilt = 0.4, delta = 1e-4;
  Series swings{.name = "turns, dropped", .points = {{0.0, tilt / degree}}, .line = false, .look = Look::star};
  see_decay(context, checks, pebble, tilt, delta, &swings);
  for (int i = 0; i < context.samples(1, 3); ++i) {
    see_decay(context, checks, pebble, context.uniform(0.02, 0.5), std::pow(10.0, context.uniform(-4.5, -3.7)),
              nullptr);
  }
  Measurement result = checks.measurement();
  const double drop_of_swing = 2.0 * delta / pebble.shape.sphere_offset / degree;
  Series line{.name = "2δ/d per half swing", .points = {}, .look = Look::foreign};
  for (std::size_t i = 0; i < swings.points.size(); ++i) {
    line.points.emplace_back(swings.points[i].first, tilt / degree - drop_of_swing * static_cast<double>(i));
  }
  const std::vector<PlanarMotion> small =
      turning_points(pebble.rocker(), Footing::rolling, {.rolling_resistance = 1e-6}, 0.01L);
  result.figures = {{"drop in a half swing over 2δ/d",
                     fmt::format("{:.4f} from {:g} rad; {:.6f} from 0.01 rad with δ = 1e-6 m",
                                 (swings.points[0].second - swings.points[1].second) / drop_of_swing, tilt,
                                 (0.01 - as_double(std::fabs(small[0].tilt))) * pebble.shape.sphere_offset / 2e-6)}};
  result.plots = {{.title = "Rolling resistance of 1e-4 m: the tilt at each turn falls linearly",
                   .x_label = "time [s]",
                   .y_label = "tilt [°]",
                   .series = {line, swings}}};
  return result;
}

// --- DROP-16

Measurement measure_damping(Context& context) {
  Checks checks;
  const Pebble pebble = size_33();
  for (int i = 0; i < context.samples(5, 20); ++i) {
    const double c = context.uniform(0.5, 5.0), tilt = context.uniform(0.01, 0.4), time = context.uniform(0.1, 1.0);
    const auto see = [&](Long error, const char* name) {
      checks[name].see(as_double(std::fabs(error)), [&] { return fmt::format("c = {:a} 1/s, {:a} rad", c, tilt); });
    };
    for (const Footing footing : {Footing::rolling, Footing::frictionless}) {
      DropSettings<double> settings = lossless(footing == Footing::rolling ? no_slip : 0.0, 1e-12);
      settings.damping = c;
      const State<double> start = set_on_cap(pebble, leaning(tilt), {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
      const Tilt found = tilt_of(pebble, drop(pebble, start, settings, time).state);
      const PlanarMotion expected = rocked(pebble.rocker(), footing, {.damping = c}, {.tilt = tilt}, time);
      see(context.produced(found.angle) - expected.tilt, "rocking");
      see((context.produced(found.rate) - expected.rate) / 60, "rocking");
      // Flat: a spin rolls on the spot, a slide has nothing to stop it. After 20/c it still moves.
      const double spin = context.uniform(10.0, 60.0), speed = footing == Footing::rolling ? 0.0 : 0.3;
      const State<double> flat = set_on_cap(pebble, leaning(0.0), {0.0, 0.0, spin}, {speed, 0.0, 0.0});
      see(drop(pebble, flat, settings, 20 / c).status == DropStatus::moving ? 0 : 1, "faults");
      const DropResult<double> late = drop(pebble, flat, settings, 2 / c);
      const Long left = std::exp(-static_cast<Long>(c) * static_cast<Long>(late.time));
      see(context.produced(witnessed(pebble, late.state).w.z()) / spin - left, "spin");
      const Vec3<double> heading = late.state.q_WB * Vec3<double>(1.0, 0.0, 0.0);
      const Long turned = static_cast<Long>(spin) * (1 - left) / static_cast<Long>(c);
      see(std::remainder(std::atan2(context.produced(heading.y()), heading.x()) - turned,
                         2 * std::numbers::pi_v<Long>) /
              turned,
          "turn");
      see(context.produced(late.state.v_WB.x()) - static_cast<Long>(speed) * left, "slide");
    }
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> drop_rocking_claims() {
  return {
      {.id = "DROP-3",
       .statement = "Rocking has the exact period, rolling and without friction: from 0.1° to 25° on the cap, up to "
                    "80° where the contact passes over the bevel, and for other stones. Very small rocking of size 33 "
                    "has 7.6869 and 10.4976 Hz.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "the quadrature of dθ/θ̇ by the rule of Gauss and Kronrod, in long double",
       .checks = {within("period", 5e-12, "of the period, times the tilt [rad]",
                         "tolerance 1e-12 in the tilt; measured 2026-11-30 with 26 seeds: up to 4.8e-13"),
                  within("as printed", 0.5e-4, "Hz", "half a unit of the last digit that is printed")},
       .measure = measure_periods},
      {.id = "DROP-6",
       .statement = "Under rolling resistance δ alone each half swing takes the amplitude down by what the equation in "
                    "the plane says, 2δ/d where it is small; the stone stops in finite time, at |sin θ| <= δ/d, where "
                    "and when it says.",
       .function = "drop",
       .family = OracleFamily::integration,
       .oracle = "the equation of planar rocking, Fehlberg 7(8) in long double with fixed steps, turn by turn",
       .checks = {within("turns", 5e-13, "rad",
                         "some hundred steps of tolerance 1e-12, whose errors the turns hardly see; measured "
                         "2026-11-30 with 25 seeds: up to 9.4e-14"),
                  within("tilt of rest", 5e-13, "rad", "the same; measured 2026-11-30 with 25 seeds: up to 1.2e-13",
                         1e-14),
                  within("time of rest", 1e-9, "relative",
                         "the last stretch ends where the rate, which falls slowly, is zero; measured 2026-11-30 "
                         "with 100 seeds: 7.8e-10 once, else up to 1.1e-10",
                         2e-11),
                  none("faults", "faults")},
       .measure = measure_decay},
      {.id = "DROP-16",
       .statement = "The talk's exponential damping takes both momenta down at its rate c: rocking by the equation in "
                    "the plane, a flat spin and a slide by exp(−ct). After 20/c the stone still moves.",
       .function = "drop",
       .family = OracleFamily::integration,
       .oracle = "the equation of planar rocking, Fehlberg 7(8) in long double with fixed steps; exp(−ct)",
       .checks = {within("rocking", 2e-11, "rad, and of 60 rad/s",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 4.5e-12"),
                  within("spin", 1e-13, "relative", "after 2/c; measured 2026-11-30 with 12 seeds: up to 2.5e-14"),
                  within("turn", 5e-13, "relative",
                         "the integral of that; measured 2026-11-30 with 12 seeds: up to 1.0e-13"),
                  within("slide", 2e-14, "m/s", "as the spin; measured 2026-11-30 with 12 seeds: up to 4.2e-15"),
                  none("faults", "faults")},
       .measure = measure_damping},
  };
}

}  // namespace goishi::verify
