/// LAW: what must hold for any right formula, whatever it looks like.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

using std::numbers::pi;

MassProperties<double> unit_density(const Stone<double>& stone) {
  return mass_properties(stone, Density{1.0});
}

Measurement measure_ball(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const double w = context.uniform(0.5, 2.0);
    const double b = i % 4 == 0 ? 0.0 : w * context.uniform(0.0, 1.0) * std::pow(10.0, -context.uniform(0.0, 12.0));
    for (const Stone<double>& stone : {make_stone(w, w, b), make_measured_stone(w, w, b)}) {
      const MassProperties<double> ball = unit_density(stone);
      const auto see = [&](double computed, double expected, const char* name, const char* check = "mass") {
        checks[check].see(relative(context.produced(computed), expected),
                          [&] { return fmt::format("{} of the ball w = h = {:a}, b = {:a}", name, w, b); });
      };
      see(ball.volume, pi * w * w * w / 6.0, "V");
      see(ball.surface_area, pi * w * w, "area");
      see(ball.moments_per_mass.axial, w * w / 10.0, "I_a/m");
      see(ball.moments_per_mass.transverse, w * w / 10.0, "I_t/m");
      see(outer_width(stone), w, "outer width", "width");
    }
  }
  return checks.measurement();
}

Measurement measure_disc(Context& context) {
  // In q = (h/w)² the per-mass moments are w² (10 + 5q + q²)/(40 (3 + q)) and so on: the first neglected term is below
  // q.
  Worst worst;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const double w = context.uniform(0.5, 2.0);
    const double h = w * std::pow(10.0, -context.uniform(8.5, 9.0));
    const MassProperties<double> disc = unit_density(make_stone(w, h));
    const auto see = [&](double computed, double expected, const char* name) {
      worst.see(relative(context.produced(computed), expected),
                [&] { return fmt::format("{} of w = {:a}, h = {:a}", name, w, h); });
    };
    see(disc.volume, pi * h * w * w / 8.0, "V");
    see(disc.surface_area, pi * w * w / 2.0, "area");
    see(disc.moments_per_mass.axial, w * w / 12.0, "I_a/m");
    see(disc.moments_per_mass.transverse, w * w / 24.0, "I_t/m");
  }
  return worst.measurement();
}

Measurement measure_scaling(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const double lambda = context.uniform(1.0, 3.0) * std::pow(10.0, context.uniform(-6.0, 6.0));
    const MassProperties<double> one = unit_density(make_stone(shape.width, shape.height, shape.bevel));
    // λw, λh, λb are rounded: a stone with sides changed by up to ε/2 each. Near h = w or b = h that changes its
    // shape, so the factor is a power of two there.
    const bool well_conditioned = shape.height < 0.9 * shape.width && shape.bevel < 0.9 * shape.height;
    const double factor = well_conditioned ? lambda : std::exp2(std::round(std::log2(lambda)));
    const MassProperties<double> other =
        unit_density(make_stone(factor * shape.width, factor * shape.height, factor * shape.bevel));
    const double square = factor * factor;
    const auto see = [&](double computed, double expected, const char* name) {
      checks[well_conditioned ? "any factor" : "powers of two"].see(
          relative(context.produced(computed), expected),
          [&] { return fmt::format("{}, λ = {:a}, {}", name, factor, describe(shape)); });
    };
    see(other.surface_area, square * one.surface_area, "area");
    see(other.volume, square * factor * one.volume, "V");
    see(other.moments.axial, square * square * factor * one.moments.axial, "I_a");
    see(other.moments.transverse, square * square * factor * one.moments.transverse, "I_t");
    see(other.moments_per_mass.axial, square * one.moments_per_mass.axial, "I_a/m");
  }
  return checks.measurement();
}

/// How far `value` is outside [low, high], relatively.
double beyond(double value, double low, double high) {
  if (!(low <= value)) {
    return relative(value, low);
  }
  return value <= high ? 0.0 : relative(value, high);
}

Measurement measure_sandwich(Context& context) {
  // Rim radius c, half height a: double cone 2/3 π c² a and ellipsoid 4/3 π c² a. The moments of the latter are
  // m 2c²/5 and m (a² + c²)/5, of the former m 3c²/10 and m (3c²/20 + a²/10).
  Worst worst;
  for (int i = 0; i < context.samples(5000, 50000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const double c = shape.width / 2.0;
    const double a = shape.height / 2.0;
    const double cone = 2.0 / 3.0 * pi * c * c * a;
    const double ellipsoid = 2.0 * cone;
    const MassProperties<double> lens = unit_density(make_stone(shape.width, shape.height));
    const auto see = [&](double computed, double low, double high, const char* name) {
      worst.see(beyond(context.produced(computed), low, high),
                [&] { return fmt::format("{} of {}", name, describe(shape)); });
    };
    see(lens.volume, cone, ellipsoid, "V");
    see(lens.moments.axial, cone * 0.3 * c * c, ellipsoid * 0.4 * c * c, "I_a");
    see(lens.moments.transverse, cone * (3.0 * c * c / 20.0 + a * a / 10.0), ellipsoid * (a * a + c * c) / 5.0, "I_t");
    // A bevel takes away: the bevelled stone is inside its lens.
    const MassProperties<double> stone = unit_density(make_stone(shape.width, shape.height, shape.bevel));
    see(stone.volume, 0.0, lens.volume, "V, bevelled");
    see(stone.moments.axial, 0.0, lens.moments.axial, "I_a, bevelled");
    see(stone.moments.transverse, 0.0, lens.moments.transverse, "I_t, bevelled");
    see(stone.surface_area, 0.0, lens.surface_area, "area, bevelled");
  }
  return worst.measurement();
}

Measurement measure_steiner(Context& context) {
  // V(K ⊕ ρ) = V + S ρ + M ρ² + 4π ρ³/3 and S(K ⊕ ρ) = S + 2 M ρ + 4π ρ². The integral of mean curvature M of the core
  // lens is S/R of its two caps plus, at its sharp rim of length 2π r₁, half the angle 2α between the normals: 2π r₁ α.
  Worst worst;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    if (shape.height > 0.999 * shape.width) {
      continue;  // the core of a near-ball is a near-point: its own lens would be known to no digit
    }
    const Stone<double> stone = make_stone(shape.width, shape.height, shape.bevel);
    const double core_radius = stone.core_sphere_radius;
    const double rim = stone.bevel_major_radius;
    // Pole height of the core, R − d = rim²/(R + d), as rim² = R² − d².
    const double pole = rim * (rim / (core_radius + stone.sphere_offset));
    const MassProperties<double> core = unit_density(make_stone(2.0 * rim, 2.0 * pole));
    const double angle = std::atan2(stone.sphere_offset, rim);
    const double curvature = core.surface_area / core_radius + 2.0 * pi * rim * angle;
    const double rho = stone.bevel_minor_radius;
    const MassProperties<double> body = unit_density(stone);
    worst.see(relative(context.produced(body.volume),
                       core.volume + rho * (core.surface_area + rho * (curvature + 4.0 / 3.0 * pi * rho))),
              [&] { return "V of " + describe(shape); });
    worst.see(
        relative(context.produced(body.surface_area), core.surface_area + rho * (2.0 * curvature + 4.0 * pi * rho)),
        [&] { return "area of " + describe(shape); });
  }
  return worst.measurement();
}

Measurement measure_measured_width(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(20000, 200000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const Stone<double> stone = make_measured_stone(shape.width, shape.height, shape.bevel);
    worst.see(relative(context.produced(outer_width(stone)), shape.width), [&] { return describe(shape); });
  }
  return worst.measurement();
}

Measurement measure_vanishing_bevel(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const double w = context.uniform(0.5, 2.0);
    const double h = w * context.uniform(0.05, 0.95);
    // What the bevel takes away is of order b² near the rim; at b = 1e-12 h it is below round-off.
    const MassProperties<double> bevelled = unit_density(make_stone(w, h, 1e-12 * h));
    const MassProperties<double> sharp = unit_density(make_stone(w, h));
    const auto see = [&](double computed, double expected, const char* name) {
      worst.see(relative(context.produced(computed), expected),
                [&] { return fmt::format("{} of w = {:a}, h = {:a}", name, w, h); });
    };
    see(bevelled.volume, sharp.volume, "V");
    see(bevelled.moments.axial, sharp.moments.axial, "I_a");
    see(bevelled.moments.transverse, sharp.moments.transverse, "I_t");
    see(bevelled.moments_per_mass.axial, sharp.moments_per_mass.axial, "I_a/m");
  }
  return worst.measurement();
}

}  // namespace

std::vector<Claim> law_claims() {
  return {
      {.id = "LAW-1",
       .statement = "With h = w every stone is the ball of that diameter, whatever its bevel.",
       .function = "make_stone, make_measured_stone, mass_properties",
       .family = OracleFamily::exact,
       .oracle = "the ball: π w³/6, π w², w²/10",
       .checks = {within("mass", 10.0 * epsilon, "relative",
                         "8 ulp of production, 2 of the ball's own formula in double", epsilon),
                  within("width", 2.0 * epsilon, "relative", "r₁ and r₂ are each rounded once, and so is their sum",
                         epsilon)},
       .measure = measure_ball},
      {.id = "LAW-2",
       .statement = "As h goes to 0 the lens becomes a parabolic disc: π h w²/8, w²/12, w²/24.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::exact,
       .oracle = "the leading term in h/w, at h/w of 1e-9 … 3e-9",
       .checks = {within(
           "", 4.0 * epsilon, "relative",
           "(h/w)² < 1e-16 is neglected; 1 ulp of production (3 of the area, whose formula is the limit's), 2½ "
           "of the limit's formula in double",
           epsilon)},
       .measure = measure_disc},
      {.id = "LAW-3",
       .statement = "A stone λ times as large has λ² the area, λ³ the volume and λ⁵ the moments.",
       .function = "mass_properties",
       .family = OracleFamily::relation,
       .oracle = "the same stone, larger",
       .checks = {within(
                      "any factor", 60.0 * epsilon, "relative",
                      "8 ulp twice, five roundings of λ⁵, and three of the scaled sides, to the fifth power and up to "
                      "ten times amplified where h is within 10 % of w or b of h",
                      epsilon),
                  within("powers of two", 0.0, "relative", "they are exact; taken where h is nearer to w, or b to h")},
       .measure = measure_scaling},
      {.id = "LAW-4",
       .statement = "The lens lies between the double cone and the ellipsoid of the same rim and poles, the bevelled "
                    "stone inside the lens.",
       .function = "mass_properties",
       .family = OracleFamily::exact,
       .oracle = "inequalities of volume, moments and area",
       .checks = {within(
           "", 12.0 * epsilon, "relative excess",
           "8 ulp of production and 4 of the bounds in double, where a bound is attained (the ball, the thinnest "
           "bevel)",
           epsilon)},
       .measure = measure_sandwich},
      {.id = "LAW-5",
       .statement =
           "Volume and area of the bevelled stone follow from its core lens by Steiner's formula for core ⊕ ball.",
       .function = "mass_properties, bevelled",
       .family = OracleFamily::relation,
       .oracle = "Steiner's formula, with the mean curvature of the core's sharp rim",
       .checks = {within(
           "", 24.0 * epsilon, "relative",
           "8 ulp of production; the core's lens is made from four rounded fields, its rim angle has an atan2, "
           "the sum six terms; measured 2026-11-30 with 40 seeds: up to 4.5 ε",
           epsilon)},
       .measure = measure_steiner},
      {.id = "LAW-6",
       .statement = "The measured stone has the width that was measured: 2(r₁ + r₂) = w.",
       .function = "make_measured_stone, outer_width",
       .family = OracleFamily::invariant,
       .oracle = "the width that was asked for",
       .checks = {within("", 2.0 * epsilon, "relative", "r₁ and r₂ are each rounded once, and so is their sum",
                         epsilon)},
       .measure = measure_measured_width},
      {.id = "LAW-7",
       .statement = "A vanishing bevel leaves the sharp lens: two different closed forms meet.",
       .function = "mass_properties",
       .family = OracleFamily::relation,
       .oracle = "the lens' own closed form",
       .checks = {within("", 10.0 * epsilon, "relative", "8 ulp of the one, 1 of the other, 1e-12 squared of the bevel",
                         epsilon)},
       .measure = measure_vanishing_bevel},
  };
}

}  // namespace goishi::verify
