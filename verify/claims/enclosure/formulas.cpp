/// ENCLOSURE: the formula templates on Arb balls contain the 50-digit values, and are narrow. What certifies the table
/// rests on it.

#include <fmt/format.h>

#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

template <class T>
struct Named {
  const char* name;
  T value;
};

/// Every quantity of a stone that the formulas give, in a scalar of many digits.
template <class T>
std::vector<Named<T>> all_quantities(const ShapeSample<double>& shape, bool measured) {
  const T w(shape.width), h(shape.height), b(shape.bevel);
  const T offset = measured ? formula::measured_sphere_offset(w, h, b) : formula::sphere_offset(w, h);
  const Stone<T> stone = formula::bevelled_stone(measured ? formula::generating_width(h, offset) : w, h, b, offset);
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const Moments<T> moments = formula::bevelled_moments(stone, terms);
  const Moments<T> lens_moments = formula::lens_moments(w, h);
  const Moments<T> per_mass = formula::lens_moments_per_mass(w, h);
  return {{"r", stone.sphere_radius},
          {"d", stone.sphere_offset},
          {"r₁", stone.bevel_major_radius},
          {"r₂", stone.bevel_minor_radius},
          {"r − r₂", stone.core_sphere_radius},
          {"P_x", stone.joint_radius},
          {"V", formula::bevelled_volume(stone, terms)},
          {"surface area", formula::bevelled_surface_area(stone, terms)},
          {"I_a", moments.axial},
          {"I_t", moments.transverse},
          {"V of the lens", formula::lens_volume(w, h)},
          {"area of the lens", formula::lens_surface_area(w, h)},
          {"I_a of the lens", lens_moments.axial},
          {"I_t of the lens", lens_moments.transverse},
          {"I_a/m of the lens", per_mass.axial},
          {"I_t/m of the lens", per_mass.transverse}};
}

/// A ball formula_ball a 50-digit value: itself ± 1e-45 of it, for the roundings of the 50-digit evaluation.
Ball formula_ball(const Digits50& value) {
  Ball ball = Ball::from_decimal(value.str(55, std::ios_base::scientific));
  Ball error = Ball::from_decimal("1e-45") * ball;
  arb_add_error(ball.get(), error.get());
  return ball;
}

template <class See>
void for_each_quantity(Context& context, int count, See&& see) {
  for (int i = 0; i < count; ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    for (const bool measured : {false, true}) {
      const auto enclosures = all_quantities<Ball>(shape, measured);
      see(shape, measured, enclosures);
    }
  }
}

Measurement measure_containment(Context& context) {
  Worst worst;
  for_each_quantity(context, context.samples(200, 2000), [&](const auto& shape, bool measured, const auto& enclosures) {
    const auto values = all_quantities<Digits50>(shape, measured);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool met = enclosures[k].value.is_finite() &&
                       formula_ball(context.produced(values[k].value)).overlaps(enclosures[k].value);
      worst.see(met ? 0.0 : 1.0, [&] { return fmt::format("{}, {}", values[k].name, describe(shape)); });
    }
  });
  return worst.measurement();
}

Measurement measure_width(Context& context) {
  Worst worst;
  for_each_quantity(context, context.samples(2000, 20000), [&](const auto& shape, bool, const auto& enclosures) {
    for (const auto& enclosure : enclosures) {
      if (arb_is_zero(enclosure.value.get()) == 0) {  // d and r₁ of the ball
        worst.see(enclosure.value.relative_radius(),
                  [&] { return fmt::format("{}, {}", enclosure.name, describe(shape)); });
      }
    }
  });
  return worst.measurement();
}

}  // namespace

std::vector<Claim> enclosure_claims() {
  return {
      {.id = "ENCLOSURE-1",
       .statement = "The formulas on balls meet the formulas in 50 digits, over the whole domain.",
       .function = "goishi::formula, every scalar",
       .family = OracleFamily::rounding,
       .oracle = "Boost.Multiprecision, 50 digits, ± 1e-45 for its own roundings",
       .checks = {within("", 0.0, "enclosures missed", "an enclosure meets the 50-digit value or it does not")},
       .measure = measure_containment},
      {.id = "ENCLOSURE-2",
       .statement = "The enclosures are narrow: no formula cancels, over the whole domain.",
       .function = "goishi::formula on Arb balls",
       .family = OracleFamily::rounding,
       .oracle = "the balls' own radii",
       .checks =
           {{.unit = "relative radius",
             .bound = 1e-74,
             .reason =
                 "2⁻²⁵⁶ = 9e-78 a step, some hundred steps to a moment, amplified by its degree 5: 5e-75; differences "
                 "of the data are exact",
             .resolution = 1e-77,
             .counts = true}},
       .measure = measure_width},
  };
}

}  // namespace goishi::verify
