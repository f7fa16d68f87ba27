/// PUBLISHED: the talk's numbers, reproduced by the recipe that made them, and refuted.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/published/bevel.hpp>
#include <goishi/published/inertia.hpp>
#include <goishi/shape/catalogue.hpp>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"

namespace goishi::verify {

namespace {

using std::numbers::pi;

// The published example: size 33, lengths in cm, mass 1.
constexpr double published_width = 2.2;
constexpr double published_height = 0.92;
constexpr double printed_closed_form = 0.303588;
constexpr double printed_transverse = 0.177721;
constexpr double printed_axial = 0.304776;

double lens_radius(double w, double h) {
  return (w * w + h * h) / (4.0 * h);
}

double volume_of(double w, double h) {
  const double r = lens_radius(w, h);
  return published_volume(r, r - h / 2.0);
}

/// What production gives for the same stone, in cm² per unit mass.
MassProperties<double> right_properties() {
  return mass_properties(make_stone(published_width, published_height), Density{1.0});
}

Measurement measure_closed_form(Context& context) {
  const double h = published_height;
  const double r = lens_radius(published_width, h);
  const double volume = volume_of(published_width, h);
  const double per_density = h * h * h * (3.0 * h * h - 30.0 * h * r + 80.0 * r * r) / 480.0 * pi;
  const MassProperties<double> right = right_properties();
  Worst worst;
  // To the last printed digit: the difference is half a unit of it at most.
  worst.see(std::fabs(per_density / volume - printed_closed_form) / 1e-6, [] { return "0.303588"; });
  // The closed form for I_a is right, only its density is not. Same number, from the shipped formula.
  worst.see(std::fabs(context.produced(right.moments.axial) / volume - printed_closed_form) / 1e-6,
            [] { return "production's I_a over the published volume"; });
  return worst.measurement({{"published volume V'", fmt::format("{:.7f} \"cm³\"", volume)},
                            {"right volume", fmt::format("{:.7f} cm³", right.volume)},
                            {"I_a/m with V'", fmt::format("{:.6f} cm², as printed", per_density / volume)},
                            {"right I_a/m", fmt::format("{:.6f} cm²", right.moments_per_mass.axial)}});
}

Measurement measure_dimensions(Context& context) {
  // A volume grows by 8 when lengths double. V' does not.
  const double growth =
      volume_of(2.0 * published_width, 2.0 * published_height) / volume_of(published_width, published_height);
  const double right = mass_properties(make_stone(2.0 * published_width, 2.0 * published_height), Density{1.0}).volume /
                       right_properties().volume;
  Checks checks;
  checks["volume"].see(std::fabs(context.produced(right) - 8.0), [] { return "lengths doubled"; });
  see_choice(checks["V'"], growth < 4.0, [] { return "lengths doubled: it grows like an area at most"; });
  return checks.measurement({{"V' grows by", fmt::format("{:.4f} when lengths double", growth)},
                             {"a volume grows by", fmt::format("{:.4f}", right)}});
}

Measurement measure_grid(Context& context) {
  const PublishedTensor sum = published_tensor(2.2f, 0.92f);
  Checks checks;
  const auto see = [&](double summed, double printed, const char* name) {
    checks["digits"].see(std::fabs(context.produced(summed) - printed), 1e-6, [&] { return name; });
  };
  see(sum.x, printed_transverse, "I_x");
  see(sum.y, printed_axial, "I_y");
  see(sum.z, printed_transverse, "I_z");
  see_choice(checks["nodes"], sum.nodes == 2176, [&] { return fmt::format("{}", sum.nodes); });
  return checks.measurement({{"grid sum", fmt::format("diag({:.6f}, {:.6f}, {:.6f}) cm²", sum.x, sum.y, sum.z)},
                             {"nodes inside", fmt::format("{}", sum.nodes)}});
}

Measurement measure_low(Context& context) {
  const MassProperties<double> right = right_properties();
  const double axial = context.produced(right.moments_per_mass.axial);
  const double transverse = context.produced(right.moments_per_mass.transverse);
  Checks checks;
  checks["digits"].see(std::fabs(axial - 0.415607), 1e-6, [] { return "I_a/m"; });
  checks["digits"].see(std::fabs(transverse - 0.244624), 1e-6, [] { return "I_t/m"; });
  // "27 % low": the deficits are 26.7, 27.0 and 27.3 %.
  for (const double deficit :
       {1.0 - printed_axial / axial, 1.0 - printed_closed_form / axial, 1.0 - printed_transverse / transverse}) {
    checks["deficit"].see(std::fabs(deficit - 0.27), 0.01, [&] { return fmt::format("{:.2f} %", 100.0 * deficit); });
  }
  // With the right volume both prints of I_a come right, the grid's to half a percent: they share the density, no more.
  const double density = volume_of(published_width, published_height) / right.volume;
  for (const double print : {printed_axial, printed_closed_form}) {
    checks["density"].see(std::fabs(print * density / axial - 1.0), 0.01, [&] { return fmt::format("{}", print); });
  }
  return checks.measurement(
      {{"printed", fmt::format("diag({}, {}, {}) cm²", printed_transverse, printed_axial, printed_transverse)},
       {"right", fmt::format("diag({0:.6f}, {1:.6f}, {0:.6f}) cm²", transverse, axial)},
       {"printed I_a/m is low by", fmt::format("{:.1f} %", 100.0 * (1.0 - printed_axial / axial))},
       {"the closed form's I_a/m is low by", fmt::format("{:.1f} %", 100.0 * (1.0 - printed_closed_form / axial))},
       {"printed I_t/m is low by", fmt::format("{:.1f} %", 100.0 * (1.0 - printed_transverse / transverse))}});
}

Measurement measure_bevel(Context& context) {
  // In mm.
  const double r = lens_radius(22.0, 9.2);
  const double d = r - 4.6;
  const PublishedBevel<double> wrong = published_bevel(r, d, 1.0);
  const Stone<double> right = make_stone(22.0, 9.2, 1.0);
  const double r1 = context.produced(right.bevel_major_radius);
  const double r2 = context.produced(right.bevel_minor_radius);
  Checks checks;
  checks["digits"].see(std::fabs(wrong.minor_radius + 5.85), 0.01, [] { return "the published r₂ of −5.85 mm"; });
  checks["digits"].see(std::fabs(r2 - 0.68), 0.01, [] { return "the right r₂ of 0.68 mm"; });
  // What is right touches the sphere from inside, r − r₂ = √(d² + r₁²), at height b/2.
  checks["tangency"].see(std::fabs((r - r2) - std::hypot(d, r1)), epsilon * r, [] { return "the sphere"; });
  checks["tangency"].see(std::fabs(-d + r * d / (r - r2) - 0.5), epsilon * r, [] { return "the joint's height"; });
  return checks.measurement(
      {{"published r₁, r₂", fmt::format("{:.4f} mm, {:.4f} mm", wrong.major_radius, wrong.minor_radius)},
       {"right r₁, r₂", fmt::format("{:.4f} mm, {:.4f} mm", r1, r2)},
       {"the published r₂ is off by", fmt::format("{:.4f} mm", wrong.minor_radius - r2)}});
}

Measurement measure_black(Context& context) {
  // Black stones are 0.3 mm larger, not 0.3 cm.
  const CatalogueStone white = catalogue_stone(33, StoneColor::white);
  const CatalogueStone black = catalogue_stone(33, StoneColor::black);
  const double larger = context.produced(metres<double>(black.width) - metres<double>(white.width));
  Worst worst;
  worst.see(std::fabs(larger - 0.0003) / 1e-6, [] { return "how much wider black is"; });
  const auto mass = [](double w, double h) { return mass_properties(make_stone(w, h), Density{2750.0}).mass; };
  return worst.measurement({{"black, 22.3 × 9.8 mm", fmt::format("{:.2f} g", 1e3 * mass(metres<double>(black.width),
                                                                                        metres<double>(black.height)))},
                            {"as published, 25 × 12.2 mm", fmt::format("{:.2f} g", 1e3 * mass(0.025, 0.0122))}});
}

}  // namespace

std::vector<Claim> published_claims() {
  const std::string half_digit = "half a unit of the last printed digit";
  return {
      {.id = "PUBLISHED-1",
       .statement = "The printed closed form of size 33, 0.303588 cm², comes from a right formula and the wrong volume "
                    "V' = d² + πr/4 + πd/24.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::published,
       .oracle = "the talk's number, and its recipe",
       .checks = {within("", 0.5, "last printed digits", half_digit, 0.5)},
       .measure = measure_closed_form},
      {.id = "PUBLISHED-2",
       .statement = "V' fails dimensional analysis: it does not grow by 8 when lengths double.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::relation,
       .oracle = "the same stone, twice as large",
       .checks = {within("volume", 1e-14, "absolute", "doubling is exact; two volumes of 1 ulp each, times 8",
                         16.0 * epsilon),
                  none("V'", "volumes V' that grow by 4 or more")},
       .measure = measure_dimensions},
      {.id = "PUBLISHED-3",
       .statement = "The printed tensor diag(0.177721, 0.304776, 0.177721) cm² comes out of a grid sum of 2176 nodes "
                    "over V', digit for digit.",
       .function = "published_tensor",
       .family = OracleFamily::published,
       .oracle = "the talk's numbers, and their recipe",
       .checks = {within("digits", 0.5, "last printed digits", half_digit, 0.5),
                  none("nodes", "sums of other than 2176 nodes")},
       .measure = measure_grid},
      {.id = "PUBLISHED-4",
       .statement = "Both prints are 27 % low: right is diag(0.244624, 0.415607, 0.244624) cm². They agree because "
                    "they share the density.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::published,
       .oracle = "the talk's numbers",
       .checks = {within("digits", 0.5, "last printed digits", half_digit, 0.5),
                  within("deficit", 0.5, "percent off 27 %", "half a percent", 0.1),
                  within("density", 0.5, "percent",
                         "with the right volume the prints are right to half a percent, which the grid's is off", 0.1)},
       .measure = measure_low},
      {.id = "PUBLISHED-5",
       .statement = "The published CalculateBevel gives r₂ = −5.85 mm for 22 × 9.2 mm, b = 1 mm, where 0.68 mm touches "
                    "both caps.",
       .function = "make_stone(width, height, bevel), published_bevel",
       .family = OracleFamily::published,
       .oracle = "the talk's function, and the tangency of circles",
       .checks = {within("digits", 0.5, "last digits of −5.85 and 0.68 mm", half_digit, 0.1),
                  within("tangency", 4.0, "ε of the sphere's radius",
                         "four lengths rounded once each, a root and a quotient", 0.5)},
       .measure = measure_bevel},
      {.id = "PUBLISHED-6",
       .statement = "Black stones are 0.3 mm wider than white ones, not 0.3 cm.",
       .function = "catalogue_stone",
       .family = OracleFamily::published,
       .oracle = "the Nihon Ki-in's figure",
       .checks = {within(
           "", 1.1e-11, "µm",
           "the two widths are each rounded, and 0.3 mm as it is written here: 3 ulp of 22 mm are 1e-11 µm", 3.5e-12)},
       .measure = measure_black},
  };
}

}  // namespace goishi::verify
