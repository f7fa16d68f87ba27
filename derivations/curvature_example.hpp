#pragma once
/// \file
/// The part of the curvature's derivation that is in numbers: three profiles of size 33, sharp, bevelled and continuous, and
/// the curvature along them.

#include <goishi/shape/bevel.hpp>
#include <goishi/shape/lens.hpp>
#include <goishi/shape/stone.hpp>
#include <string>

#include "algebra.hpp"
#include "enclosure.hpp"
#include "profile.hpp"
#include "proof.hpp"

namespace derivation {

namespace formula = goishi::formula;

inline ex degrees(const ex& n) {
  return n * Pi / 180;
}

inline void example(Document& document) {
  document.section("Size 33");
  const ex w = 22, h = ex(92) / 10, b = 1;
  const ex d = formula::measured_sphere_offset<ex>(w, h, b);
  const goishi::Stone<ex> two_arcs = formula::bevelled_stone<ex>(formula::generating_width<ex>(h, d), h, b, d);
  document.text(
      R"($w = 22$ mm, $h = 9.2$ mm, $\varphi_m = 41.66°$, $\delta = 5°$: the transition is about the joint of the
stone that is measured so with a bevel of 1 mm. Lengths in mm. Every number is enclosed by fractions: sine and cosine
by their series, $\pi$ by Machin's formula.)");
  const auto made = [&](const ex& middle, const ex& delta) {
    return continuous(w, h, sin(degrees(delta)) / degrees(delta), cos(degrees(middle)), sin(degrees(middle)));
  };
  const ex joint = ex(4166) / 100;
  const Continuous stone = made(joint, 5);
  const auto sine_at = [&](const ex& angle) { return sin(degrees(angle)); };
  const ex half_digit = ex(1) / 200;
  document.check("that joint is at $41.66°$, rounded",
                 positive(two_arcs.joint_cosine - sine_at(joint - half_digit)) &&
                     positive(sine_at(joint + half_digit) - two_arcs.joint_cosine));
  const auto holds = [&](const std::string& name, const ex& value, int places, const std::string& expected) {
    document.check("$" + name + " = " + expected + "$", decimals(value, places) == expected);
  };
  holds("r", stone.sphere_radius, 3, "16.247");
  holds(R"(\rho_e)", stone.edge_radius, 3, "0.638");
  document.text(
      "The curvature along the three profiles, in 1/mm (the sharp one's rim is an edge, without a curvature):");
  const auto curved = [](const ex& radius) { return decimals(1 / radius, 5); };
  const std::string lens = curved(formula::sphere_radius<ex>(w, h));
  const std::string cap = curved(two_arcs.sphere_radius), bevel = curved(two_arcs.bevel_minor_radius);
  const std::string flat = curved(stone.sphere_radius), edge = curved(stone.edge_radius);
  // The radius of curvature is linear in the angle from φ_a to φ_b.
  const auto between = [&](const ex& part) {
    return curved(stone.sphere_radius + part * (stone.edge_radius - stone.sphere_radius));
  };
  document.text(R"(| normal at | sharp | bevelled | continuous |
|---|---|---|---|
| $0$ (pole) to $\varphi_a = 36.66°$ | )" +
                lens + " | " + cap + " | " + flat + R"( |
| $39.16°$ | )" +
                lens + " | " + cap + " | " + between(ex(1) / 4) + R"( |
| $\varphi_m = 41.66°$ | )" +
                lens + " | jumps: " + cap + ", " + bevel + " | " + between(ex(1) / 2) + R"( |
| $44.16°$ | )" +
                lens + " | " + bevel + " | " + between(ex(3) / 4) + R"( |
| $\varphi_b = 46.66°$ to $90°$ (rim) | edge | )" +
                bevel + " | " + edge + " |");
  document.check("the curvature of two arcs jumps by $(2d + b)/b = 24.22$ at the joint",
                 decimals(two_arcs.sphere_radius / two_arcs.bevel_minor_radius, 2) == "24.22" &&
                     decimals((2 * d + b) / b, 2) == "24.22");

  document.text("Neither later nor wider transitions need exist:");
  const auto refused = [&](const std::string& angles, const ex& at, const ex& delta) {
    document.check("$" + angles + R"($: $\rho_e < 0$)", positive(-made(at, delta).edge_radius));
  };
  refused(R"(\varphi_m = 45.4°, \delta = 5°)", ex(454) / 10, 5);
  refused(R"(\varphi_m = 41.66°, \delta = 25°)", joint, 25);
}

}  // namespace derivation
