/// Meshes in place of closed forms: what they cost, and how far they are off.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>

#include "verify/bench/mass/mass.hpp"

namespace goishi::verify::bench::mass {

namespace {

const Stone<double>& stone() {
  static const Stone<double> bevelled = make_stone(0.022, 0.0092, 0.001);
  return bevelled;
}

/// Volume and moments, at density 1.
using Answer = std::array<double, 3>;

Answer closed_forms() {
  const MassProperties<double> mass = mass_properties(stone(), Density{1.0});
  return {mass.volume, mass.moments.axial, mass.moments.transverse};
}

Answer by_mesh(Tessellation method, int rings) {
  const int rows = std::max(1, 3 * rings / 8);  // as many for each ring at any fineness
  const MeshMass<double> mass = mesh_mass(tessellate(stone(), method, {rings, rows, rings}));
  return {mass.volume, mass.tensor(2, 2), mass.tensor(0, 0)};
}

/// Three meshes, of n, n/2 and n/4 rings, and the terms of second and fourth order taken away.
Answer extrapolated(int rings) {
  const Answer coarse = by_mesh(Tessellation::subdivision, rings / 4),
               middle = by_mesh(Tessellation::subdivision, rings / 2), fine = by_mesh(Tessellation::subdivision, rings);
  Answer result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double first = (4.0 * middle[i] - coarse[i]) / 3.0, second = (4.0 * fine[i] - middle[i]) / 3.0;
    result[i] = (16.0 * second - first) / 15.0;
  }
  return result;
}

std::vector<double> judge_mass(const std::vector<Answer>& answers) {
  const MassProperties<long double> exact =
      mass_properties(make_stone(0.022L, 0.0092L, 0.001L), Density<long double>{1.0L});
  const std::array<long double, 3> right = {exact.volume, exact.moments.axial, exact.moments.transverse};
  double worst = 0.0;
  for (const Answer& answer : answers) {
    for (std::size_t i = 0; i < right.size(); ++i) {
      worst = std::max(worst, std::fabs(static_cast<double>(static_cast<long double>(answer[i]) / right[i] - 1.0L)));
    }
  }
  return {worst};
}

/// `ask(rings)`.
template <class Ask, class Judge>
Curve curve_of(std::string name, std::string label, std::vector<double> rings, Ask ask, Judge judge) {
  return {.who = {std::move(name), std::move(label), "ours", Kind::rings, std::move(rings)},
          .enter = [=](double setting) {
            return make_entry(
                1, [=](std::size_t) { return ask(static_cast<int>(setting)); }, judge);
          }};
}

Race prepare_mass(const Effort& /*any*/) {
  const std::vector<double> rings = {8, 16, 32, 64, 128};
  const auto by = [](Tessellation method) { return [method](int n) { return by_mesh(method, n); }; };
  return {.note = "A white 33 with a bevel of 1 mm. The mesh is made anew each time. Errors against long double.",
          .cost = "run time",
          .quantities = {{"greatest error of volume and moments", "relative"}},
          .cases = 1,
          .curves = {make_curve(
                         1, "closed-forms", "closed forms", [](std::size_t) { return closed_forms(); }, judge_mass),
                     curve_of("subdivision", "mesh by subdivision", rings, by(Tessellation::subdivision), judge_mass),
                     curve_of("rings", "mesh by rings", rings, by(Tessellation::rings), judge_mass),
                     curve_of("extrapolated", "three meshes, extrapolated", rings, extrapolated, judge_mass)}};
}

Race prepare_tessellation(const Effort& /*any*/) {
  const std::vector<double> rings = {1, 2, 4, 8, 16, 32, 64};
  const auto judge = [](const std::vector<Mesh<double>>& meshes) {
    return std::vector<double>{deviation(meshes.front(), stone()), static_cast<double>(meshes.front().triangles.size()),
                               static_cast<double>(meshes.front().points.size())};
  };
  const auto level = [](int n) { return std::countr_zero(static_cast<unsigned int>(n)); };
  const auto made = [level](Tessellation method) {
    return [=](int n) { return tessellate(stone(), method, level(n)); };
  };
  const auto welded = [level](int n) {
    return weld(unwelded(tessellate(stone(), Tessellation::subdivision, level(n))));
  };
  return {.note = "A white 33 with a bevel of 1 mm, levels 0 to 6.",
          .cost = "run time of a mesh",
          .quantities = {{"distance from the stone", "m"}, {"triangles", "", false}, {"vertices", "", false}},
          .cases = 1,
          .curves = {curve_of("subdivision", "by subdivision", rings, made(Tessellation::subdivision), judge),
                     curve_of("welded", "by subdivision, taken apart and welded", rings, welded, judge),
                     curve_of("rings", "by rings", rings, made(Tessellation::rings), judge)}};
}

}  // namespace

std::vector<Problem> mesh_problems() {
  return {{"mesh-mass", "Mass properties from a mesh", prepare_mass},
          {"tessellation", "A stone as triangles", prepare_tessellation}};
}

}  // namespace goishi::verify::bench::mass
