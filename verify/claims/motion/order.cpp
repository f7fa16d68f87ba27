/// ORDER: that each stepper has the order that it states, what it keeps, its floor of round-off, and how it fails.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/steppers.hpp>
#include <limits>
#include <string>
#include <vector>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/convergence.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

namespace {

std::string name_of(Scheme scheme) {
  return std::string(info(scheme).name);
}

// --- ORDER-1

/// One of the bodies that others printed, van Zon's and Schofield's, and a stone of size 33 in a wobbling throw.
Flight asymmetric_example() {
  const RigidBody<double> body = make_rigid_body(1.0, Vec3<double>(10.0, 20.0, 26.0));
  return {body,
          {Vec3<double>::Zero(), Quat<double>::Identity(), Vec3<double>::Zero(), Vec3<double>(10.0, 300.0, 26.0)}};
}
Flight stone_example() {
  const RigidBody<double> body = make_rigid_body(mass_properties(make_stone(0.022, 0.0092), Density{2800.0}));
  const Vec3<double> w_WB_B(10.0, 0.0, 20.0);
  return {body,
          {Vec3<double>::Zero(), Quat<double>::Identity(), Vec3<double>::Zero(), body.moments.cwiseProduct(w_WB_B)}};
}

/// One that wobbles: about a principal axis a scheme may be exact, and has no order to be seen.
Flight draw_wobble(Context& context, BodyKind kind) {
  while (true) {
    const Flight flight = draw_flight(context.random(), kind);
    const Vec3<double> L_B = flight.start.q_WB.conjugate() * flight.start.L_W;
    const Vec3<double> w_B = L_B.cwiseQuotient(flight.body.moments);
    if (0.01 * L_B.norm() * w_B.norm() < L_B.cross(w_B).norm()) {
      return flight;
    }
  }
}

void see_orders(const Context& context, Checks& checks, const Flight& flight) {
  const bool is_symmetric = flight.body.moments.x() == flight.body.moments.y();
  const std::vector<Attitude> truth = true_attitudes(flight), own = constantly_turned(flight);
  for (const SchemeInfo& scheme : schemes) {
    if (scheme.needs_symmetry && !is_symmetric) {
      continue;
    }
    see_position_order(checks, context, scheme.scheme, flight, truth);
    if (scheme.attitude_order == 0) {
      see_no_convergence(checks, context, scheme.scheme, flight, truth, own);
    } else if (scheme.attitude_order != exact_order) {
      see_attitude_order(checks, context, scheme.scheme, flight, truth, scheme.attitude_order);
    }
  }
  // The talk's loop, against its own equation; and about a principal axis, where that equation is the true one.
  see_attitude_order(checks, context, Scheme::published, flight, own, 2);
  for (int axis = 0; axis < 3; ++axis) {
    Flight about_axis = flight;
    about_axis.start.L_W = flight.start.q_WB * Vec3<double>(flight.start.L_W.norm() * Vec3<double>::Unit(axis));
    see_attitude_order(checks, context, Scheme::published, about_axis, constantly_turned(about_axis), 2);
  }
}

Measurement measure_orders(Context& context) {
  Checks checks;
  see_orders(context, checks, asymmetric_example());
  for (int i = 0; i < context.samples(1, 3); ++i) {
    for (const BodyKind kind : body_kinds) {
      see_orders(context, checks, draw_wobble(context, kind));
    }
  }
  Measurement result = checks.measurement();
  result.plots = {order_plot(context, "Error against step: two turns of a body without a symmetry axis (10 : 20 : 26)",
                             asymmetric_example()),
                  order_plot(context, "Error against step: two turns of a stone of size 33", stone_example())};
  return result;
}

// --- ORDER-2

/// All substeps of a symmetric composition, the mirrored half included.
template <std::size_t half_count>
std::vector<Digits50> unfolded(const Context& context, const formula::Substeps<Digits50, half_count>& half) {
  std::vector<Digits50> all;
  for (std::size_t i = 0; i < 2 * half_count - 1; ++i) {
    all.push_back(context.produced(half[i < half_count ? i : 2 * half_count - 2 - i]));
  }
  return all;
}

Measurement measure_coefficients(Context& context) {
  Worst worst;
  const auto see = [&](const Digits50& value, const Digits50& expected, const char* name) {
    worst.see(static_cast<double>(Digits50(fabs(value - expected))), [&] { return std::string(name); });
  };
  const auto power_sum = [](const std::vector<Digits50>& substeps, int exponent) {
    Digits50 sum = 0;
    for (const Digits50& substep : substeps) {
      sum += pow(substep, exponent);
    }
    return sum;
  };
  const std::vector<Digits50> two = unfolded(context, formula::composition_2<Digits50>());
  const std::vector<Digits50> four = unfolded(context, formula::composition_4<Digits50>());
  const std::vector<Digits50> six = unfolded(context, formula::composition_6<Digits50>());
  for (const auto& substeps : {two, four, six}) {
    see(power_sum(substeps, 1), 1, "Σγ = 1");
  }
  see(power_sum(four, 3), 0, "order 4: Σγ³ = 0");
  see(four.front(), 1 / (4 - cbrt(Digits50(4))), "order 4: γ = 1/(4 − 4^⅓)");
  see(power_sum(six, 3), 0, "order 6: Σγ³ = 0");
  see(power_sum(six, 5), 0, "order 6: Σγ⁵ = 0");
  // The one condition of order 6 that mixes: γ³ weighted by the square of the time at the substep's middle.
  Digits50 before = 0, mixed = 0;
  for (const Digits50& substep : six) {
    const Digits50 middle = before + substep / 2;
    mixed += pow(substep, 3) * middle * middle;
    before += substep;
  }
  see(mixed, 0, "order 6: Σγ³ (time at the middle)² = 0");
  return worst.measurement();
}

// --- ORDER-3

/// Of one body; the size of the splittings' error is that of the example.
void see_drift(Context& context, Checks& checks, std::vector<Figure>& figures, const Flight& flight, bool is_example) {
  const std::int64_t steps = context.samples(100'000, 1'000'000);
  constexpr double angle = 0.2;  // in a step, at most
  const double dt = angle / greatest_rate(flight);
  const double energy = formula::rotational_energy(flight.start, flight.body);
  const double momentum = flight.start.L_W.norm();
  for (const Scheme scheme : {Scheme::implicit_midpoint, Scheme::splitting_2, Scheme::splitting_4, Scheme::splitting_6,
                              Scheme::runge_kutta_4}) {
    const Stepper<double> stepper(scheme, flight.body, Vec3<double>::Zero());
    State<double> state = flight.start;
    double early = 0.0, late = 0.0, size = 0.0, momentum_error = 0.0;
    for (std::int64_t done = 0; done < steps; done += 10) {
      const Stepped<double> stepped = stepper.advance(state, dt, 10);
      see_choice(checks["steps"], stepped.status == StepStatus::completed, [&] { return name_of(scheme); });
      state = stepped.state;
      const double now = formula::rotational_energy(state, flight.body),
                   error = std::fabs(context.produced(now) / energy - 1.0);
      size = std::max(size, error);
      // What comes later is held against what came first, which therefore is as it was.
      double& part = done < steps / 10 ? early : late;
      part = std::max(part, done < steps / 10 ? std::fabs(now / energy - 1.0) : error);
      momentum_error = std::max(
          momentum_error, std::fabs(context.produced(formula::in_body(state.q_WB, state.L_W).norm()) / momentum - 1.0));
    }
    figures.push_back(
        {fmt::format("{}: energy off by at most", name_of(scheme)),
         fmt::format("{:.3g} in the first tenth, {:.3g} in all {} steps", early, std::max(early, late), steps)});
    if (scheme == Scheme::runge_kutta_4) {
      continue;  // it drifts: a figure to compare with
    }
    const auto describe_it = [&] { return name_of(scheme) + ", " + describe(flight); };
    checks["momentum"].see(momentum_error, epsilon, describe_it);
    const double walk = epsilon * std::sqrt(static_cast<double>(steps));
    if (scheme == Scheme::implicit_midpoint) {
      checks["energy of midpoint"].see(size, 4.0 * walk + 0.01 * epsilon * static_cast<double>(steps), describe_it);
      continue;
    }
    if (is_example) {
      const int order = info(scheme).attitude_order;
      checks[fmt::format("energy, order {}", order)].see(size, describe_it);
    }
    checks["drift"].see(std::max(late - early, 0.0), 0.01 * early + 4.0 * walk, describe_it);
  }
}

Measurement measure_drift(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  see_drift(context, checks, figures, asymmetric_example(), true);
  see_drift(context, checks, figures, draw_wobble(context, BodyKind::asymmetric), false);
  return checks.measurement(figures);
}

// --- ORDER-4

/// The same steps in long double.
Quat<long double> in_long_double(Scheme scheme, const Flight& flight, double dt, std::int64_t steps) {
  const auto wide = [](const Vec3<double>& v) { return Vec3<long double>(v.cast<long double>()); };
  const State<long double> start = {.p_WB = wide(flight.start.p_WB),
                                    .q_WB = flight.start.q_WB.cast<long double>().normalized(),
                                    .v_WB = wide(flight.start.v_WB),
                                    .L_W = wide(flight.start.L_W)};
  const RigidBody<long double> body = {.mass = flight.body.mass, .moments = wide(flight.body.moments)};
  return Stepper<long double>(scheme, body).advance(start, dt, steps).state.q_WB;
}

Measurement measure_round_off(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(1, 3); ++i) {
    for (const BodyKind kind : body_kinds) {
      const Flight flight = draw_flight(context.random(), kind);
      for (const SchemeInfo& scheme : schemes) {
        if (scheme.needs_symmetry && kind != BodyKind::symmetric) {
          continue;
        }
        const auto see = [&](int k, bool against_truth) {
          const std::int64_t steps = std::int64_t{1} << k;
          const double dt = 6.0 / greatest_rate(flight) / static_cast<double>(steps);
          const State<double> end = Stepper<double>(scheme.scheme, flight.body).advance(flight.start, dt, steps).state;
          const double error =
              attitude_difference(lengthened(context, end.q_WB),
                                  against_truth ? TrueAttitude(flight).at(static_cast<long double>(dt) * steps)
                                                : in_long_double(scheme.scheme, flight, dt, steps));
          checks[against_truth ? "truth" : "steps"].see(
              error, round_off(scheme.scheme, static_cast<double>(steps)),
              [&] { return fmt::format("{} steps of {}, {}", steps, scheme.name, describe(flight)); });
        };
        for (int k = 6; k <= context.samples(12, 15); k += 3) {
          see(k, false);
        }
        // So many steps that the scheme's own error is below.
        if (scheme.attitude_order >= 4) {
          see(scheme.attitude_order == 4 ? 14 : 10, true);
        }
      }
    }
  }
  return checks.measurement();
}

// --- ORDER-5

bool is_finite_and_unit(const State<double>& state) {
  return state.p_WB.allFinite() && state.v_WB.allFinite() && state.L_W.allFinite() &&
         std::fabs(state.q_WB.squaredNorm() - 1.0) < unit_tolerance<double>();
}

bool are_same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.v_WB == b.v_WB && a.L_W == b.L_W && a.q_WB.coeffs() == b.q_WB.coeffs();
}

/// A step from 1e-3 to 1e308, or the largest there is; a body and a momentum of any kind, about a principal axis too.
Measurement measure_too_large(Context& context) {
  Worst worst;
  std::array<int, 3> ended{};
  for (int i = 0; i < context.samples(3000, 30000); ++i) {
    const SchemeInfo& scheme = schemes[static_cast<std::size_t>(i) % schemes.size()];
    Flight flight =
        draw_flight(context.random(),
                    scheme.needs_symmetry ? BodyKind::symmetric : body_kinds[static_cast<std::size_t>(i / 9) % 3]);
    if (i % 4 == 0) {
      flight.start.L_W = flight.start.q_WB * Vec3<double>(Vec3<double>::Unit(i / 4 % 3));
    }
    const double dt = i % 50 == 0 ? std::numeric_limits<double>::max() : std::pow(10.0, context.uniform(-3.0, 308.0));
    const Freedom freedom = i % 2 == 0 ? Freedom::angular : Freedom::both;
    const Stepper<double> stepper(scheme.scheme, flight.body, gravity_W<double>(), freedom);
    const std::int64_t steps = 1 + i % 5;
    const auto [state, status, good] = stepper.advance(flight.start, dt, steps);
    ++ended[static_cast<std::size_t>(status)];
    const auto see = [&](bool holds, const char* what) {
      worst.see(holds ? 0.0 : 1.0, [&] {
        return fmt::format("{}: {} steps of {:a} by {} ended as {}, {}", what, steps, dt, scheme.name,
                           to_string(status), describe(flight));
      });
    };
    see(is_finite_and_unit(state), "a state that is not finite, or an attitude that is not a unit quaternion");
    see((status == StepStatus::completed) == (good == steps), "the count of good steps");
    // A hundred turns of the slowest axis in a step: Runge–Kutta's polynomial leaves the unit sphere.
    const double least_rate = flight.start.L_W.norm() / flight.body.moments.maxCoeff();
    see(scheme.scheme != Scheme::runge_kutta_4 || !(dt * least_rate > 600.0) || status != StepStatus::completed,
        "a step far too large, not noticed");
    see(are_same(state, stepper.advance(flight.start, dt, good).state), "not the last good state");
  }
  Measurement result = worst.measurement();
  for (const StepStatus status : {StepStatus::completed, StepStatus::diverged, StepStatus::not_converged}) {
    result.figures.push_back(
        {std::string(to_string(status)), fmt::format("{} of the runs", ended[static_cast<std::size_t>(status)])});
  }
  return result;
}

}  // namespace

std::vector<Claim> order_claims() {
  const std::string next = "the next term of the error, in the smallest steps that are not at round-off";
  const std::string size = "of van Zon's and Schofield's body; four times what was measured 2026-11-30";
  const std::string floor =
      "a step rounds the attitude by about 2 ε, which shears by up to 1 + 6 rad until the end: 16 ε √n as a random "
      "walk; "
      "c: an eighth of the half ulp, 1/16, for each product with a cosine that is a few ulps below 1, and 16 for "
      "`published`, which makes momentum of velocity and back in every step with an attitude that is off the sphere by "
      "ε";
  return {
      {.id = "ORDER-1",
       .statement =
           "Each scheme converges with the order that it states, neither faster nor slower; the published loop "
           "with order 2 to a motion of its own, and not to the true one unless L is along a principal axis.",
       .function = "Stepper",
       .family = OracleFamily::integration,
       .oracle = "the raw Newton–Euler equations by Taylor series of order 24 in long double; slopes of the error by "
                 "step halving",
       .checks = {within("order 1", 0.01, "of the slope", next), within("order 2", 0.002, "of the slope", next),
                  within("order 4", 0.15, "of the slope", next, 0.003), within("order 6", 0.2, "of the slope", next),
                  within("position", 1e-11, "of the slope",
                         "the error is g t Δt/2 and nothing else; round-off over it"),
                  within("exact position", 16.0, "ε of the way",
                         "a random walk of 256 steps, each rounding a velocity and a position"),
                  within("no convergence", 1.0, "of what the steps turn too little", "the triangle's inequality"),
                  none("other motion", "loops whose own motion is the true one")},
       .measure = measure_orders},
      {.id = "ORDER-2",
       .statement = "The substeps of the compositions obey the conditions of their order, to the 27 digits that they "
                    "are given with.",
       .function = "composition_2, composition_4, composition_6",
       .family = OracleFamily::exact,
       .oracle = "the order conditions of symmetric compositions, in 50 digits",
       .checks = {within(
           "", 1e-26, "absolute",
           "half a unit of the 27th digit in each substep, times up to 9 substeps and derivatives of up to 3", 5e-28)},
       .measure = measure_coefficients},
      {.id = "ORDER-3",
       .statement =
           "In 100 000 steps (a million in the full tier) of 0.2 rad the splittings' energy does not leave the "
           "range of its first tenth, implicit midpoint keeps it to round-off, and all keep |L|.",
       .function = "Stepper, rotational_energy",
       .family = OracleFamily::invariant,
       .oracle = "energy and |L| at the start, on a body without a symmetry axis",
       .checks = {within("momentum", 16.0, "ε", "through the attitude: a dozen roundings, none accumulating"),
                  within("energy of midpoint", 1.0, "of 4 ε √n + ε n/100",
                         "a random walk of some 4 ε a step, and what rounds alike in every step (ORDER-4): measured "
                         "2026-11-30 with seed 31, ε/160",
                         0.02),
                  within("energy, order 2", 5e-4, "relative", size), within("energy, order 4", 6e-8, "relative", size),
                  within("energy, order 6", 6e-11, "relative", size),
                  within("drift", 1.0, "of 1 % and 4 ε √n",
                         "a quasi-periodic error, whose maximum is met to 1 % in the first tenth, and the random walk",
                         0.02),
                  none("steps", "steps that fail")},
       .measure = measure_drift},
      {.id = "ORDER-4",
       .statement = "Below their own error the schemes have a floor that grows as round-off predicts: like ε √n, and "
                    "like ε n where a product rounds alike in every step.",
       .function = "Stepper",
       .family = OracleFamily::relation,
       .oracle = "the same steps in long double; the truth, by Taylor series, where the scheme's own error is below "
                 "round-off",
       .checks = {within("steps", 1.0, "of ε (16 √n + c n)", floor, 0.05),
                  within("truth", 1.0, "of ε (16 √n + c n)", floor, 0.05)},
       .measure = measure_round_off},
      {.id = "ORDER-5",
       .statement = "A step too large, up to the largest number, never ends in silence: the state that comes back is "
                    "finite with a unit attitude, or it is the last good one and the status says so.",
       .function = "Stepper",
       .family = OracleFamily::invariant,
       .oracle = "finite numbers, |q| = 1, and the good steps alone",
       .checks = {{.unit = "count", .bound = 0.0, .reason = "exact", .counts = true}},
       .measure = measure_too_large},
  };
}

}  // namespace goishi::verify
