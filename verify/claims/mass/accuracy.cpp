/// SHAPE, MASS: how many ulps the float and double versions are off, inputs taken as exact. The witness evaluates the
/// same formula templates on Arb balls of 256 bits, so the error is of the rounding alone, and proved.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <map>
#include <string_view>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

enum class Parametrisation { sharp, published, measured };

constexpr const char* area_name = "surface area";

template <class T>
Stone<T> produce(Parametrisation kind, const ShapeSample<T>& shape) {
  switch (kind) {
    case Parametrisation::sharp:
      return make_stone(shape.width, shape.height);
    case Parametrisation::published:
      return make_stone(shape.width, shape.height, shape.bevel);
    case Parametrisation::measured:
      break;
  }
  return make_measured_stone(shape.width, shape.height, shape.bevel);
}

template <class T>
Stone<Ball> exact(Parametrisation kind, const ShapeSample<T>& shape) {
  const Ball w(shape.width), h(shape.height), b(shape.bevel);
  if (kind == Parametrisation::sharp) {
    return formula::sharp_stone(w, h);
  }
  if (kind == Parametrisation::published) {
    return formula::bevelled_stone(w, h, b, formula::sphere_offset(w, h));
  }
  const Ball offset = formula::measured_sphere_offset(w, h, b);
  // w = h is the ball, and so is its generating lens.
  return formula::bevelled_stone(formula::generating_width(h, offset), h, b, offset);
}

/// Worst ulps by quantity, over both scalars.
class UlpTable {
 public:
  /// Of the sharp lens the area has a check of its own.
  explicit UlpTable(bool area_apart) : area_apart_(area_apart) {}

  template <class T>
  void see(const Context& context, const char* scalar, const char* quantity, T computed, const Ball& expected,
           const ShapeSample<T>& shape) {
    // d and r₁ of the ball are exactly zero.
    const double error = ulps(context.produced(computed), expected);
    const bool is_area = std::string_view(quantity) == area_name;
    const char* check = !area_apart_ ? "" : is_area ? "area" : "volume and moments";
    checks_[check].see(error, [&] { return fmt::format("{} {}, {}", scalar, quantity, describe(shape)); });
    double& entry = by_quantity_[fmt::format("{}, {}", quantity, scalar)];
    entry = error <= entry ? entry : error;
  }
  [[nodiscard]] Measurement measurement() const {
    Measurement result = checks_.measurement();
    for (const auto& [name, error] : by_quantity_) {
      result.figures.push_back({name, fmt::format("{:.3f} ulp", error)});
    }
    return result;
  }

 private:
  bool area_apart_;
  Checks checks_;
  std::map<std::string, double> by_quantity_;
};

template <class T>
void see_shape(UlpTable& table, const Context& context, const char* scalar, Parametrisation kind,
               const ShapeSample<T>& shape) {
  const Stone<T> stone = produce(kind, shape);
  const Stone<Ball> right = exact(kind, shape);
  table.see(context, scalar, "r", stone.sphere_radius, right.sphere_radius, shape);
  table.see(context, scalar, "d", stone.sphere_offset, right.sphere_offset, shape);
  table.see(context, scalar, "cos α", stone.joint_cosine, right.joint_cosine, shape);
  table.see(context, scalar, "sin α", stone.joint_sine, right.joint_sine, shape);
  table.see(context, scalar, "P_x", stone.joint_radius, right.joint_radius, shape);
  if (kind != Parametrisation::sharp) {
    table.see(context, scalar, "w of the lens", stone.width, right.width, shape);
    table.see(context, scalar, "r₁", stone.bevel_major_radius, right.bevel_major_radius, shape);
    table.see(context, scalar, "r₂", stone.bevel_minor_radius, right.bevel_minor_radius, shape);
    table.see(context, scalar, "r − r₂", stone.core_sphere_radius, right.core_sphere_radius, shape);
  }
}

template <class T>
void see_width(UlpTable& table, const Context& context, const char* scalar, Parametrisation kind,
               const ShapeSample<T>& shape) {
  table.see(context, scalar, "outer width", outer_width(produce(kind, shape)), outer_width(exact(kind, shape)), shape);
}

template <class T>
void see_mass(UlpTable& table, const Context& context, const char* scalar, Parametrisation kind,
              const ShapeSample<T>& shape) {
  // A density and a mass with as many digits as T has.
  const T given = shape.width * T(1000) / T(3);
  const Ball exact_given(given);
  const MassProperties<T> body = mass_properties(produce(kind, shape), Density<T>{given});
  const MassProperties<T> weighed = mass_properties(produce(kind, shape), Mass<T>{given});
  const Stone<Ball> right = exact(kind, shape);
  const bool sharp = kind == Parametrisation::sharp;
  const auto terms = formula::bevel_terms(right, scalar::atan2(right.joint_sine, right.joint_cosine));
  const Ball volume = sharp ? formula::lens_volume(right.width, right.height) : formula::bevelled_volume(right, terms);
  const Ball surface =
      sharp ? formula::lens_surface_area(right.width, right.height) : formula::bevelled_surface_area(right, terms);
  const Moments<Ball> moments =
      sharp ? formula::lens_moments(right.width, right.height) : formula::bevelled_moments(right, terms);
  table.see(context, scalar, "V", body.volume, volume, shape);
  table.see(context, scalar, area_name, body.surface_area, surface, shape);
  table.see(context, scalar, "m = ρ V", body.mass, exact_given * volume, shape);
  table.see(context, scalar, "I_a", body.moments.axial, exact_given * moments.axial, shape);
  table.see(context, scalar, "I_t", body.moments.transverse, exact_given * moments.transverse, shape);
  table.see(context, scalar, "ρ = m/V", weighed.density, exact_given / volume, shape);
  table.see(context, scalar, "I_a of given m", weighed.moments.axial, exact_given * moments.axial / volume, shape);
  table.see(context, scalar, "I_t of given m", weighed.moments.transverse, exact_given * moments.transverse / volume,
            shape);
  table.see(context, scalar, "I_a/m", body.moments_per_mass.axial, moments.axial / volume, shape);
  table.see(context, scalar, "I_t/m", body.moments_per_mass.transverse, moments.transverse / volume, shape);
}

template <class See>
Measurement over_samples(Context& context, int count, See&& see, bool area_apart = false) {
  UlpTable table(area_apart);
  for (int i = 0; i < count; ++i) {
    see(table, "float", draw_shape<float>(context.random(), i));
    see(table, "double", draw_shape<double>(context.random(), i));
  }
  return table.measurement();
}

auto shape_measure(Parametrisation kind) {
  return [kind](Context& context) {
    return over_samples(context, context.samples(10'000, 100'000),
                        [&](UlpTable& table, const char* scalar, const auto& shape) {
                          see_shape(table, context, scalar, kind, shape);
                        });
  };
}

Measurement measure_solved_width(Context& context) {
  return over_samples(context, context.samples(10'000, 100'000),
                      [&](UlpTable& table, const char* scalar, const auto& shape) {
                        see_width(table, context, scalar, Parametrisation::published, shape);
                        see_width(table, context, scalar, Parametrisation::measured, shape);
                      });
}

auto mass_measure(std::vector<Parametrisation> kinds) {
  return [kinds](Context& context) {
    return over_samples(
        context, context.samples(10'000, 30'000),
        [&](UlpTable& table, const char* scalar, const auto& shape) {
          for (const Parametrisation kind : kinds) {
            see_mass(table, context, scalar, kind, shape);
          }
        },
        kinds.front() == Parametrisation::sharp);
  };
}

/// r₂ by the difference form and by the shipped one, against h/w: a picture of why the form matters.
Measurement measure_cancellation(Context& context) {
  Series difference{.name = "r − √(d² + r₁²), the talk's form", .points = {}};
  Series shipped{.name = "r (b/2) / (d + b/2), shipped", .points = {}};
  Worst worst;
  double worst_difference = 0.0;
  for (int i = 0; i <= 90; ++i) {
    const double thinness = std::pow(10.0, -0.1 * i);
    double error_difference = 0.0;
    double error_shipped = 0.0;
    for (int k = 0; k < context.samples(20, 100); ++k) {
      const double w = context.uniform(0.5, 2.0);
      const double h = w * thinness;
      const double b = h * context.uniform(0.05, 0.3);
      const ShapeSample<double> shape{w, h, b};
      const Stone<double> stone = make_stone(w, h, b);
      const Ball right = exact(Parametrisation::published, shape).bevel_minor_radius;
      const double by_difference = stone.sphere_radius - std::sqrt(stone.sphere_offset * stone.sphere_offset +
                                                                   stone.bevel_major_radius * stone.bevel_major_radius);
      error_difference = std::max(error_difference, ulps(by_difference, right));
      const double error = ulps(context.produced(stone.bevel_minor_radius), right);
      error_shipped = std::max(error_shipped, error);
      worst.see(error, [&] { return describe(shape); });
    }
    difference.points.emplace_back(thinness, std::max(error_difference, 0.5));
    shipped.points.emplace_back(thinness, std::max(error_shipped, 0.25));
    worst_difference = std::max(worst_difference, error_difference);
  }
  Measurement result = worst.measurement();
  result.figures.push_back(
      {"worst of the difference form", fmt::format("{:.3g} ulp: not one digit right", worst_difference)});
  result.plots.push_back({.title = "Error of the bevel's minor radius r₂ in double",
                          .x_label = "h/w",
                          .y_label = "error [ulp]",
                          .log_x = true,
                          .log_y = true,
                          .series = {difference, shipped}});
  return result;
}

}  // namespace

std::vector<Claim> accuracy_claims() {
  const std::string arb = "the formula templates on Arb balls of 256 bits (77 digits), inputs exact";
  const std::string once =
      "evaluated in the next wider type (11 or 29 more bits) and rounded once: ½ ulp, plus less than 1/100";
  const Check rounded_once = within("", 1.0, "ulp", once, 1.0);
  return {
      {.id = "SHAPE-1",
       .statement = "Radius r, offset d and joint of a sharp stone are right to one ulp, float and double, from h/w = "
                    "1e-9 to the ball.",
       .function = "make_stone(width, height)",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {rounded_once},
       .measure = shape_measure(Parametrisation::sharp)},
      {.id = "SHAPE-2",
       .statement = "Every length of a bevelled stone, as published, is right to one ulp, thin, near-ball and b/h "
                    "from 1e-12 to 1 − 1e-9.",
       .function = "make_stone(width, height, bevel)",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {rounded_once},
       .measure = shape_measure(Parametrisation::published)},
      {.id = "SHAPE-3",
       .statement = "The same when the finished stone has the given width, thickness and bevel.",
       .function = "make_measured_stone(outer_width, height, bevel)",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {rounded_once},
       .measure = shape_measure(Parametrisation::measured)},
      {.id = "SHAPE-4",
       .statement =
           "The minor radius r₂ keeps its digits on thin stones, where the talk's difference form loses all of them.",
       .function = "formula::bevel",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {rounded_once},
       .measure = measure_cancellation},
      {.id = "SHAPE-5",
       .statement = "The finished stone's width 2(r₁ + r₂) is right to two ulps, as published and as measured.",
       .function = "outer_width",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {within("", 2.0, "ulp", "two terms rounded to ½ ulp each, and their sum: 1½ ulp", 1.0)},
       .measure = measure_solved_width},
      {.id = "MASS-1",
       .statement =
           "Volume, moments and moments per mass of a sharp lens are right to one ulp, float and double, the area "
           "to four.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {within("volume and moments", 1.0, "ulp", once, 1.0),
                  within("area", 4.0, "ulp", "in T: four roundings and that of π, 4½ ε/2 of relative error or fewer",
                         1.0)},
       .measure = mass_measure({Parametrisation::sharp})},
      {.id = "MASS-2",
       .statement =
           "Volume, area, moments and moments per mass of a bevelled stone are right to eight ulps, float and double, "
           "in both parametrisations.",
       .function = "mass_properties, bevelled",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {within(
           "", 8.0, "ulp",
           "I is of degree 5 in lengths that were each rounded once, a relative error of ε/2 at most: 5 ε/2, 5 "
           "ulp at most; "
           "the angle by atan2 in T (1 ulp), a rounding at the end and one for ρ or m",
           1.0)},
       .measure = mass_measure({Parametrisation::published, Parametrisation::measured})},
  };
}

}  // namespace goishi::verify
