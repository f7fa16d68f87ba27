/// DROP: a stone that spins on its cap, a tippe-top.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

// --- DROP-7

/// How fast the logarithm of a small tilt grows   [1/s].
double growth(const Pebble& pebble, double spin, double coefficient) {
  const DropSettings<double> settings = slip_proportional(coefficient, 1e-10);
  const State<double> start = spun(pebble, 1e-4, spin);
  const Drop<double> motion = moved(pebble, start, settings, 20.0);
  const auto tilt_at = [&](double time) { return witnessed(pebble, motion.state_at(time)).tilt; };
  return as_double(std::log(tilt_at(20.0) / tilt_at(10.0)) / 10);
}

Measurement measure_threshold(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const auto see = [&](const Pebble& pebble, double coefficient) {
    const double expected = as_double(pebble.cap().threshold());
    const double below = growth(pebble, 0.9998 * expected, coefficient);
    const double above = growth(pebble, 1.0002 * expected, coefficient);
    const double found = below < 0.0 && above > 0.0 ? expected * (0.9998 - 0.0004 * below / (above - below)) : NAN;
    checks["threshold"].see(std::fabs(context.produced(found) / expected - 1.0), [&] {
      return fmt::format("h = {:a} m, c = {} s/m: growth {:.3e} below, {:.3e} above", pebble.shape.height, coefficient,
                         below, above);
    });
    return found;
  };
  for (const double coefficient : {1.0, 3.0}) {
    figures.push_back(
        {fmt::format("size 33, c = {} s/m", coefficient), fmt::format("{:.4f} rad/s", see(size_33(), coefficient))});
  }
  checks["faults"].see(std::fabs(as_double(size_33().cap().threshold()) - 27.930) < 5e-4 ? 0.0 : 1.0,
                       [] { return "27.930 rad/s"; });
  for (int i = 0; i < context.samples(1, 6); ++i) {
    see(make_pebble(0.022, context.uniform(0.008, 0.012)), 2.0);
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  return result;
}

// --- DROP-8

struct Settled {
  double expected, found;  // [rad]
};

Settled settle(const Context& context, const Pebble& pebble, double spin, double tolerance, double seconds) {
  const State<double> start = spun(pebble, 1e-3, spin);
  const DropResult<double> dropped = drop(pebble, start, slip_proportional(3.0, tolerance), seconds);
  const Long z = settling_height(pebble.cap(), witnessed(pebble, start).jellett);
  return {as_double(std::acos(z)), context.produced(as_double(witnessed(pebble, dropped.state).tilt))};
}

Measurement measure_settling(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const Pebble pebble = size_33();
  const auto see = [&](double spin) {
    const Settled settled = settle(context, pebble, spin, 1e-10, 40.0);
    checks["tilt"].see(std::fabs(settled.found - settled.expected) / degree,
                       [&] { return fmt::format("{:a} rad/s", spin); });
    return settled.found / degree;
  };
  for (const auto& [spin, expected] : {std::pair(30.0, 9.116), {40.0, 22.035}, {60.0, 35.970}}) {
    const double found = see(spin);
    checks["as printed"].see(std::fabs(found - expected), [&] { return fmt::format("{} rad/s", spin); });
    figures.push_back({fmt::format("{} rad/s", spin), fmt::format("{:.6f}°", found)});
  }
  for (int i = 0; i < context.samples(1, 8); ++i) {
    see(context.uniform(32.0, 70.0));
  }
  Plot plot{.title = "A flat spin rises: where size 33 settles under slip-proportional friction",
            .x_label = "spin [rad/s]",
            .y_label = "tilt [°]",
            .series = {{.name = "by Jellett's integral", .points = {}},
                       {.name = "dropped", .points = {}, .line = false, .look = Look::star}}};
  const SpinningCap<Long> cap = pebble.cap();
  for (int spin = 20; spin <= 70; ++spin) {
    const Long z = cap.threshold() < spin ? settling_height(cap, cap.axial * spin * (cap.d - cap.r)) : 1;
    plot.series[0].points.emplace_back(spin, as_double(std::acos(z)) / degree);
    if (spin % 10 == 0) {
      plot.series[1].points.emplace_back(spin, settle(context, pebble, spin, 1e-7, 20.0).found / degree);
    }
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  result.plots = {plot};
  return result;
}

// --- DROP-9

Measurement measure_no_rise(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const Pebble pebble = size_33();
  for (int i = 0; i < context.samples(4, 20); ++i) {
    const double tilt = context.uniform(0.01, 0.5), spin = i % 2 == 0 ? 60.0 : context.uniform(5.0, 60.0);
    const State<double> start = spun(pebble, tilt, spin);
    const auto see = [&](Long error, const char* check) {
      checks[check].see(as_double(std::fabs(error)), [&] { return fmt::format("{:a} rad, {:a} rad/s", tilt, spin); });
    };
    const auto see_that = [&](bool right, const char* what) {
      checks["faults"].see(right ? 0.0 : 1.0,
                           [&] { return fmt::format("{}: {:a} rad, {:a} rad/s", what, tilt, spin); });
    };
    // Without friction it swings between two tilts, the greater of which is where it starts.
    const Long z0 = witnessed(pebble, start).u.z();
    const FrictionlessSwing swing(pebble.cap(), z0, spin);
    const Long pi = std::numbers::pi_v<Long>, half = swing.time(pi);
    see_that(swing.other() >= z0, "the witness rises");
    for (int k = 1; k <= 12; ++k) {
      const Long phase = k * pi / 12, time = (k % 2 == 0 ? 10 * half : 0) + swing.time(phase);
      const Witnessed seen = witnessed(pebble, drop(pebble, start, lossless(0.0, 1e-12), time).state);
      const double found = context.produced(as_double(seen.tilt)), expected = as_double(std::acos(swing.height(phase)));
      see(found - expected, "swing");
      see_that(found <= tilt + 1e-9, "rises without friction");
    }
    // Dry, and leaning less: slip ends soon, and rolling keeps what is left.
    const State<double> upright = spun(pebble, tilt / 20.0, spin);
    const DropResult<double> dry = drop(pebble, upright, lossless(0.3, 1e-12), 1);
    const Event<double>* const stick = first_event(dry, EventKind::stick);
    const bool rolls_on = stick != nullptr && first_event(dry, EventKind::slip) == nullptr;
    see_that(rolls_on, "slip does not turn into rolling");
    if (!rolls_on) {
      continue;
    }
    const Witnessed rolls = witnessed(pebble, stick->after);
    State<double> end = dry.state;
    end.L_W = context.produced(end.L_W);
    const Witnessed rolled = witnessed(pebble, end);
    see(rolled.jellett / rolls.jellett - 1, "Jellett's integral");
    see(routh(pebble, rolled) / routh(pebble, rolls) - 1, "Routh's integral");
    see(rolled.energy / rolls.energy - 1, "energy");
    see_that(rolls.energy < witnessed(pebble, upright).energy, "slip takes energy");
    see_that(rolled.tilt < 1.5L * tilt / 20, "rises under dry friction");
    if (i == 0) {
      figures = {
          {"spin, tilt", fmt::format("{} rad/s, {:.3f}°", spin, tilt / degree)},
          {"without friction it comes up to", fmt::format("{:.3f}°", as_double(std::acos(swing.other())) / degree)},
          {"dry, μ = 0.3",
           fmt::format("slip ends after {:.2f} ms and {:.3f} % of the energy; {:.3f}° after 1 s", 1e3 * stick->time,
                       as_double(100 * (1 - rolls.energy / witnessed(pebble, upright).energy)),
                       as_double(rolled.tilt) / degree)}};
    }
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  return result;
}

}  // namespace

std::vector<Claim> drop_spin_claims() {
  return {
      {.id = "DROP-7",
       .statement = "Under slip-proportional friction a flat spin is unstable above ω² = m g d (1 − α)²/(I_t − I_a (1 "
                    "− α)), 27.930 rad/s for sharp size 33, whatever the coefficient: a tilt of 1e-4 rad decays 0.02 % "
                    "below it and grows 0.02 % above.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "the formula, in long double",
       .checks = {within("threshold", 4e-5, "relative",
                         "steps of tolerance 1e-10 on a tilt of 1e-4 take some 4e-5 of it a second, and the rate "
                         "grows by 3.6 of the spin; measured 2026-11-30 with 12 seeds: up to 1.0e-05"),
                  none("faults", "faults")},
       .measure = measure_threshold},
      {.id = "DROP-8",
       .statement = "A flat spin above it rises and settles at the tilt that Jellett's integral says: at 9.116°, "
                    "22.035° and 35.970° from 30, 40 and 60 rad/s.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "m g d D² = J² [I_t r² z + I_a r (d − r z)] by bisection, in long double",
       .checks = {within("tilt", 1e-5, "°",
                         "what is left of the nutation after 40 s, which slip damps slowly; measured 2026-11-30 "
                         "with 25 seeds: up to 2.5e-06"),
                  within("as printed", 0.5e-3, "°", "half a unit of the last digit that is printed")},
       .measure = measure_settling},
      {.id = "DROP-9",
       .statement = "Without friction a spun stone does not rise: its tilt swings between where it started and a "
                    "smaller one, and is where the quadrature says. Under dry friction slip ends in milliseconds, "
                    "rolling keeps Jellett's and Routh's integrals and the energy that is left, and the stone stays as "
                    "upright as it was.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "roots of the cubic and quadrature of the swing in long double; the integrals where slip ends",
       .checks = {{.name = "swing",
                   .unit = "rad",
                   .bound = 1e-10,
                   .reason =
                       "some thousand steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 2.0e-11"},
                  within("Jellett's integral", 2e-11, "relative",
                         "the same, while it rolls; measured 2026-11-30 with 25 seeds: up to 4.2e-12"),
                  within("Routh's integral", 6e-11, "relative",
                         "the same; measured 2026-11-30 with 25 seeds: up to 1.1e-11"),
                  within("energy", 2e-15, "relative",
                         "the integration takes what energy is off out of the velocities: this says that it does, "
                         "and no more; measured 2026-11-30 with 25 seeds: up to 5.4e-16",
                         epsilon),
                  none("faults", "faults")},
       .measure = measure_no_rise},
  };
}

}  // namespace goishi::verify
