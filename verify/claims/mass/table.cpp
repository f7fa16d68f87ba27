/// TABLE: every entry of the generated inertia table is the double nearest to the exact value, certified by an
/// enclosure; and the catalogue has the sizes that are published.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/inertia_table.hpp>
#include <tuple>

#include "verify/certify/printed.hpp"
#include "verify/certify/witness.hpp"
#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

using certify::StoneWitness;

/// The row's quantities in the order of a `StoneWitness`.
std::array<double, std::tuple_size_v<StoneWitness>> shipped(const InertiaRow& row) {
  return {row.bevel,   row.width, row.height, row.outer_width, row.volume,         row.surface_area,
          row.density, row.mass,  row.axial,  row.transverse,  row.axial_per_mass, row.transverse_per_mass};
}

/// By the closed forms in exact arithmetic: whole micrometres over a million, whole kilograms per cubic metre.
StoneWitness closed_forms(const CatalogueStone& entry, int bevel) {
  const Ball w = metres<Ball>(entry.width), h = metres<Ball>(entry.height), b = metres<Ball>(bevel);
  const Ball density(entry.density);
  const Stone<Ball> stone =
      bevel > 0 ? formula::bevelled_stone(w, h, b, formula::sphere_offset(w, h)) : formula::sharp_stone(w, h);
  // One closed form serves both: at b = 0 the band vanishes.
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const Ball volume = formula::bevelled_volume(stone, terms);
  const Moments<Ball> moments = formula::bevelled_moments(stone, terms);
  return {{{"bevel", b},
           {"width", w},
           {"height", h},
           {"outer_width", outer_width(stone)},
           {"volume", volume},
           {"surface_area", formula::bevelled_surface_area(stone, terms)},
           {"density", density},
           {"mass", density * volume},
           {"axial", density * moments.axial},
           {"transverse", density * moments.transverse},
           {"axial_per_mass", moments.axial / volume},
           {"transverse_per_mass", moments.transverse / volume}}};
}

template <class See>
void for_each_row(See&& see) {
  std::size_t index = 0;
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      for (const int bevel : {0, catalogue::table_bevel}) {
        see(index++, catalogue_stone(size.number, color), bevel);
      }
    }
  }
}

auto nearest_to(StoneWitness (*enclosures)(const CatalogueStone&, int)) {
  return [enclosures](Context& context) {
    Worst worst;
    for_each_row([&](std::size_t index, const CatalogueStone& entry, int bevel) {
      const auto values = shipped(inertia_table.at(index));
      const StoneWitness exact = enclosures(entry, bevel);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        worst.see(certify::is_the_nearest(context.produced(values[i]), exact[i].exact) ? 0.0 : 1.0, [&] {
          return fmt::format("{} of size {} {}, b = {} µm: {:a}", exact[i].key, entry.number, to_string(entry.color),
                             bevel, values[i]);
        });
      }
    });
    return worst.measurement();
  };
}

Measurement measure_rows(Context& context) {
  Worst worst;
  std::size_t rows = 0;
  for_each_row([&](std::size_t index, const CatalogueStone& entry, int bevel) {
    ++rows;
    const bool same = index < inertia_table.size() && inertia_table[index].number == entry.number &&
                      inertia_table[index].color == entry.color && inertia_table[index].bevel == metres<double>(bevel);
    worst.see(same ? 0.0 : 1.0,
              [&] { return fmt::format("row {}: size {} {}", index, entry.number, to_string(entry.color)); });
  });
  worst.see(std::fabs(context.produced(static_cast<double>(inertia_table.size())) - static_cast<double>(rows)),
            [] { return "number of rows"; });
  return worst.measurement();
}

/// What the production code computes at run time, against the certified row.
Measurement measure_production(Context& context) {
  Worst worst;
  for_each_row([&](std::size_t index, const CatalogueStone& entry, int bevel) {
    const InertiaRow& row = inertia_table.at(index);
    const Stone<double> stone = make_stone(entry, metres<double>(bevel));
    const MassProperties<double> body = mass_properties(stone, Density{static_cast<double>(entry.density)});
    const std::array<std::pair<double, double>, 7> pairs = {
        {{outer_width(stone), row.outer_width},
         {body.volume, row.volume},
         {body.surface_area, row.surface_area},
         {body.moments.axial, row.axial},
         {body.moments.transverse, row.transverse},
         {body.moments_per_mass.axial, row.axial_per_mass},
         {body.moments_per_mass.transverse, row.transverse_per_mass}}};
    for (const auto& [computed, certified] : pairs) {
      worst.see(std::fabs(context.produced(computed) / certified - 1.0),
                [&] { return fmt::format("size {} {}, b = {} µm", entry.number, to_string(entry.color), bevel); });
    }
  });
  return worst.measurement();
}

/// The published thickness of a white stone   [0.1 mm].
int published_height(int number) {
  constexpr std::array<std::pair<int, int>, 6> thin = {{{22, 63}, {25, 70}, {28, 75}, {30, 80}, {31, 84}, {32, 88}}};
  for (const auto& [known, height] : thin) {
    if (known == number) {
      return height;
    }
  }
  return 92 + 3 * (number - 33);  // from 33 to 50
}

Measurement measure_catalogue(Context& context) {
  Worst worst;
  int stones = 0, greatest = 0;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const bool black = entry.color == StoneColor::black;
    const int width = (entry.standard == Standard::talk ? 220 : 219) + (black ? 3 : 0);
    const int height = published_height(entry.number) + (black ? 6 : 0);
    const auto see = [&](int micrometres, int tenths) {
      worst.see(std::fabs(context.produced(static_cast<double>(micrometres)) - 100.0 * tenths), [&] { return name; });
    };
    see(entry.width, width);
    see(entry.height, height);
    ++stones;
    greatest = std::max(greatest, entry.number);
  });
  worst.see(std::fabs(stones - 2.0 * 2.0 * (6 + 50 - 32)) + std::fabs(greatest - 50.0), [] { return "the numbers"; });
  return worst.measurement();
}

}  // namespace

std::vector<Claim> table_claims() {
  const std::string arb = "Arb, 256 bits, from the catalogue's decimal dimensions as exact fractions";
  return {
      {.id = "TABLE-1",
       .statement = "Every entry of the inertia table is the double nearest to the exact value; the enclosure leaves "
                    "no other possible.",
       .function = "inertia_table",
       .family = OracleFamily::rounding,
       .oracle = arb,
       .checks = {within("", 0.0, "entries not proved", "an entry is the nearest double or it is not")},
       .measure = nearest_to(closed_forms)},
      {.id = "TABLE-2",
       .statement = "The table has a row for each of the 24 sizes, white before black, sharp and with b = 1 mm.",
       .function = "inertia_table",
       .family = OracleFamily::exact,
       .oracle = "the catalogue",
       .checks = {within("", 0.0, "rows", "counted")},
       .measure = measure_rows},
      {.id = "TABLE-3",
       .statement = "What mass_properties computes from the dimensions in double agrees with the certified table.",
       .function = "mass_properties",
       .family = OracleFamily::rounding,
       .oracle = "the certified table",
       .checks =
           {{.unit = "relative",
             .bound = 12.0 * std::numeric_limits<double>::epsilon(),
             .reason =
                 "8 ulp of production; width, height and bevel in metres are rounded (½ ulp each, to the fifth power), "
                 "and ρ I once more",
             .resolution = std::numeric_limits<double>::epsilon()}},
       .measure = measure_production},
      {.id = "TABLE-4",
       .statement =
           "Every entry of the inertia table is the double nearest to the exact value, by enclosures that no closed "
           "form made.",
       .function = "inertia_table",
       .family = OracleFamily::quadrature,
       .oracle = "Arb's rigorous integration of the profile",
       .checks = {within("", 0.0, "entries not proved", "an entry is the nearest double or it is not")},
       .measure = nearest_to(certify::witness_of)},
      {.id = "TABLE-5",
       .statement =
           "The catalogue's stones are those that are published: 22 (talk) or 21.9 mm (Nihon Ki-in) wide, from "
           "33, 9.2 mm thick, to 50 by 0.3 mm a number, black 0.3 mm wider and 0.6 mm thicker.",
       .function = "catalogue_stone",
       .family = OracleFamily::published,
       .oracle = "the figures in tenths of a millimetre, and the rule from 33 on",
       .checks = {within("", 0.0, "µm", "whole micrometres")},
       .measure = measure_catalogue},
  };
}

}  // namespace goishi::verify
