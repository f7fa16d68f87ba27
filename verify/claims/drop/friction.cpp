/// DROP: laws of friction on a stone that spins and slides.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

// --- DROP-4

Measurement measure_jellett(Context& context) {
  Checks checks;
  const Pebble pebble = size_33();
  std::array<DropSettings<double>, 3> laws = {slip_proportional(0.3, 1e-12), lossless(0.02, 1e-12),
                                              lossless(0.05, 1e-12)};
  laws[2].friction_model = FrictionModel::coulomb_contensou;
  Figure lost{"energy lost in the second", ""};
  for (int i = 0; i < context.samples(6, 24); ++i) {
    const DropSettings<double>& settings = laws[static_cast<std::size_t>(i) % 3];
    const double tilt = context.uniform(0.1, 0.3);
    const Vec3<double> w(context.uniform(-3.0, 3.0), context.uniform(-3.0, 3.0), context.uniform(30.0, 50.0));
    const State<double> start = set_on_cap(pebble, leaning(tilt), w, {context.uniform(0.3, 0.5), 0.1, 0.0});
    const Witnessed before = witnessed(pebble, start);
    Long energy = before.energy;
    const auto see = [&](double error, const char* check, const char* what = "") {
      checks[check].see(error, [&] {
        return fmt::format("{}{}, ω = ({:a}, {:a}, {:a}) rad/s, {:a} rad", what, to_string(settings.friction_model),
                           w.x(), w.y(), w.z(), tilt);
      });
    };
    for (int k = 1; k <= 10; ++k) {
      DropResult<double> dropped = drop(pebble, start, settings, k / 10.0L);
      dropped.state.L_W = context.produced(dropped.state.L_W);
      const Witnessed after = witnessed(pebble, dropped.state);
      see(as_double(std::fabs(after.jellett / before.jellett - 1)), "Jellett's integral");
      see(after.energy < energy ? 0.0 : 1.0, "faults", "energy does not fall: ");
      see(after.slip.norm() > 1e-6L ? 0.0 : 1.0, "faults", "does not slip: ");
      energy = after.energy;
    }
    if (i < 3) {
      lost.value += fmt::format("{}{:.1f} % ({})", i == 0 ? "" : ", ", as_double(100 * (1 - energy / before.energy)),
                                to_string(settings.friction_model));
    }
  }
  Measurement result = checks.measurement();
  result.figures = {lost};
  return result;
}

// --- DROP-23

/// A ball slides and turns about the vertical, which it goes on to do: ṡ = −(7/2) μ g s/√(s² + k²), whose time from s₀
/// to s is [F(s₀) − F(s)]/(7 μ g/2), F = √(s² + k²) − k arsinh(k/s).
Measurement measure_patch(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(80, 400); ++i) {
    const double mu = context.uniform(0.1, 0.5), spin = context.uniform(10.0, 200.0),
                 patch = context.uniform(1e-4, 3e-3);
    const Stone<double> ball = make_stone(0.022, 0.022);
    const RigidBody<double> body = make_rigid_body(mass_properties(ball, Mass{0.015}));
    DropSettings<double> settings = lossless(mu, 1e-11);
    settings.friction_model = FrictionModel::coulomb_contensou;
    settings.patch_radius = patch;
    State<double> start;
    start.q_WB = Quat<double>::Identity();
    start.p_WB = {0.0, 0.0, 0.011};
    start.v_WB = {0.6, 0.8, 0.0};
    start.L_W = {0.0, 0.0, spin * body.moments.z()};
    const Long turning = 8 * static_cast<Long>(patch) * spin / (3 * std::numbers::pi_v<Long>);
    const Long k = std::hypot(turning, static_cast<Long>(*filled(settings, ball).creep_speed));
    const auto F = [&](Long s) { return std::sqrt(s * s + k * k) - k * std::asinh(k / s); };
    const Long rate = 3.5L * mu * static_cast<Long>(g_earth);
    const Long all = (F(1) - F(0.05L)) / rate;
    settings.horizon = as_double(all) * context.uniform(0.1, 1.0);
    const DropResult<double> dropped = goishi::drop(ball, body, start, settings);
    const Long3 w = dropped.state.L_W.cast<Long>() / static_cast<Long>(body.moments.z());
    const Long3 slip = context.produced(dropped.state.v_WB).cast<Long>() + w.cross(Long3(0, 0, -0.011L));
    const auto describe_case = [&] { return fmt::format("μ = {:a}, {:a} rad/s, patch {:a} m", mu, spin, patch); };
    checks["slip"].see(as_double(std::fabs((F(1) - F(slip.norm())) / rate / static_cast<Long>(*settings.horizon) - 1)),
                       describe_case);
    checks["spin"].see(as_double(std::fabs(context.produced(w.z()) / spin - 1)), describe_case);
  }
  // Without a patch: dry, bit by bit. With one, a spun stone rises.
  const Pebble pebble = size_33();
  const State<double> start = spun(pebble, 0.02, 60.0);
  DropSettings<double> patch = lossless(0.3, 1e-9);
  const DropResult<double> dry = drop(pebble, start, patch, 3);
  patch.friction_model = FrictionModel::coulomb_contensou;
  patch.patch_radius = 0.0;
  const DropResult<double> point = drop(pebble, start, patch, 3);
  const bool same = dry.state.p_WB == point.state.p_WB && dry.state.L_W == point.state.L_W &&
                    dry.state.q_WB.coeffs() == point.state.q_WB.coeffs() && dry.events.size() == point.events.size();
  checks["faults"].see(same ? 0.0 : 1.0, [] { return "without a patch it is not dry friction"; });
  patch.patch_radius = 1e-4;
  const double dry_tilt = as_double(witnessed(pebble, dry.state).tilt) / degree;
  const double tilt = as_double(witnessed(pebble, drop(pebble, start, patch, 3).state).tilt) / degree;
  checks["faults"].see(tilt > 10.0 && dry_tilt < 1.2 ? 0.0 : 1.0, [] { return "rises with a patch, not without"; });
  Measurement result = checks.measurement();
  result.figures = {{"size 33 after 3 s at 60 rad/s, from 1.15°",
                     fmt::format("dry {:.3f}°, with a patch of 0.1 mm {:.3f}°", dry_tilt, tilt)}};
  return result;
}

}  // namespace

std::vector<Claim> drop_friction_claims() {
  return {
      {.id = "DROP-4",
       .statement = "Jellett's integral L · r is constant while a stone spins and slides on its cap for a second, "
                    "under slip-proportional, dry and Coulomb–Contensou friction, and energy falls all the time.",
       .function = "drop",
       .family = OracleFamily::invariant,
       .oracle = "the start; the integral from the state, in long double",
       .checks = {within("Jellett's integral", 7e-11, "relative",
                         "tolerance 1e-12; measured 2026-11-30 with 26 seeds: up to 1.6e-11"),
                  none("faults", "faults")},
       .measure = measure_jellett},
      {.id = "DROP-23",
       .statement = "Coulomb–Contensou friction stops the slip of a ball that turns about the vertical when its "
                    "equation says. A patch of no size is dry friction, bit by bit; with one of 0.1 mm a spun stone "
                    "rises, which it does not under dry friction.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "the closed form of time by slip in long double; the dry drop",
       .checks = {within("slip", 5e-12, "of the time",
                         "some ten steps of tolerance 1e-11; measured 2026-11-30 with 26 seeds: up to 1.2e-12", 1e-13),
                  within("spin", 1e-13, "relative",
                         "nothing brakes it but what the energy balance takes from all velocities alike; measured "
                         "2026-11-30 with 26 seeds: up to 1.4e-14",
                         std::numeric_limits<double>::epsilon()),
                  none("faults", "faults")},
       .measure = measure_patch},
  };
}

}  // namespace goishi::verify
