/// CERTIFIED: the closed forms against rigorous integration of the profile. Both are enclosures: they meet, and are
/// narrow.

#include <fmt/format.h>

#include <algorithm>
#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <utility>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/oracles/stone/rigorous_integral.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

struct Pair {
  const char* name;
  Ball closed_form;
  Ball integral;
};

void add(std::vector<Pair>& pairs, const Ball& volume, const Ball& area, const Moments<Ball>& moments,
         const EnclosedIntegrals& integrals) {
  pairs.push_back({"volume", volume, integrals.volume});
  pairs.push_back({"area", area, integrals.surface_area});
  pairs.push_back({"I_a", moments.axial, integrals.axial});
  pairs.push_back({"I_t", moments.transverse, integrals.transverse});
}

std::vector<Pair> sharp_pairs(const Ball& w, const Ball& h) {
  const Stone<Ball> stone = formula::sharp_stone(w, h);
  const Meridian meridian = lens_meridian(w, h);
  const EnclosedIntegrals integrals = integrate_rigorously(meridian);
  const Moments<Ball> per_mass = formula::lens_moments_per_mass(w, h);
  std::vector<Pair> pairs = {{"outer width", outer_width(stone), greatest_width(meridian)},
                             {"I_a/m", per_mass.axial, integrals.axial / integrals.volume},
                             {"I_t/m", per_mass.transverse, integrals.transverse / integrals.volume}};
  add(pairs, formula::lens_volume(w, h), formula::lens_surface_area(w, h), formula::lens_moments(w, h), integrals);
  return pairs;
}

/// Of a measured stone the witness takes the generating width from the closed form; that its finished width is the one
/// asked for is then a pair of its own.
std::vector<Pair> bevelled_pairs(const Ball& given_width, const Ball& h, const Ball& b, bool measured) {
  const Ball offset =
      measured ? formula::measured_sphere_offset(given_width, h, b) : formula::sphere_offset(given_width, h);
  const Ball w = measured ? formula::generating_width(h, offset) : given_width;
  const Stone<Ball> stone = formula::bevelled_stone(w, h, b, offset);
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const Meridian meridian = bevelled_meridian(w, h, b);
  std::vector<Pair> pairs = {{"outer width", measured ? given_width : outer_width(stone), greatest_width(meridian)},
                             {"r₂", stone.bevel_minor_radius, meridian.tube_radius}};
  add(pairs, formula::bevelled_volume(stone, terms), formula::bevelled_surface_area(stone, terms),
      formula::bevelled_moments(stone, terms), integrate_rigorously(meridian));
  return pairs;
}

/// Calls see(pairs, name) for every catalogue stone, sharp and bevelled, and for random ones over the whole domain.
template <class See>
void for_each_stone(Context& context, int count, See&& see) {
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const Ball w = metres<Ball>(entry.width), h = metres<Ball>(entry.height);
    see(sharp_pairs(w, h), name);
    see(bevelled_pairs(w, h, metres<Ball>(catalogue::table_bevel), false), name + ", b = 1 mm");
  });
  for (int i = 0; i < count; ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const Ball w(shape.width), h(shape.height), b(shape.bevel);
    see(sharp_pairs(w, h), "sharp, " + describe(shape));
    see(bevelled_pairs(w, h, b, false), describe(shape));
    see(bevelled_pairs(w, h, b, true), "measured, " + describe(shape));
  }
}

/// Wide balls meet anything. To the bound of ENCLOSURE-2; 9.9e-76 is the worst measured (full tier, seeds 1 to 3).
bool is_narrow(const Ball& closed_form) {
  return closed_form.is_finite() && closed_form.relative_radius() <= 1e-74;
}

Measurement measure_meeting(Context& context) {
  Worst worst;
  const Ball factor(context.produced(1.0));
  for_each_stone(context, context.samples(20, 150), [&](const std::vector<Pair>& pairs, const std::string& stone) {
    for (const Pair& pair : pairs) {
      const bool met = is_narrow(pair.closed_form) && pair.integral.is_finite() &&
                       (factor * pair.closed_form).overlaps(pair.integral);
      worst.see(met ? 0.0 : 1.0, [&] { return fmt::format("{}, {}", pair.name, stone); });
    }
  });
  return worst.measurement();
}

Measurement measure_width(Context& context) {
  Worst worst;
  for_each_stone(context, context.samples(10, 90), [&](const std::vector<Pair>& pairs, const std::string& stone) {
    for (const Pair& pair : pairs) {
      if (pair.name != std::string_view("r₂")) {
        worst.see(pair.integral.relative_radius(), [&] { return fmt::format("{}, {}", pair.name, stone); });
      }
    }
  });
  return worst.measurement();
}

}  // namespace

std::vector<Claim> certified_claims() {
  const std::string arb =
      "Arb's acb_calc_integrate over the angle of the normal: a cap through pole and rim, a circle that touches it; "
      "discs and rings";
  return {
      {.id = "CERTIFIED-1",
       .statement =
           "Volume, area and both moments by the closed forms, sharp, bevelled and measured, meet what rigorous "
           "integration of the profile encloses, over the whole domain.",
       .function = "goishi::formula on Arb balls",
       .family = OracleFamily::quadrature,
       .oracle = arb,
       .checks = {within("", 0.0, "enclosures missed", "two enclosures of one number meet")},
       .measure = measure_meeting},
      {.id = "CERTIFIED-2",
       .statement = "What rigorous integration encloses is narrow, so that meeting it says something.",
       .function = "the oracle of CERTIFIED-1",
       .family = OracleFamily::proof,
       .oracle = "the balls' own radii",
       .checks = {{.unit = "relative radius",
                   .bound = 2e-31,
                   .reason = "Arb is asked for 104 bits, 5e-32, of each arc; two arcs have twice that, and a quotient "
                             "adds two such",
                   .resolution = 1e-32,
                   .counts = true}},
       .measure = measure_width},
  };
}

}  // namespace goishi::verify
