#include "verify/bench/mass/mass.hpp"

#include <array>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <random>

namespace goishi::verify::bench::mass {

namespace {

constexpr std::size_t count = 1024;  // more than a branch predictor learns by heart

struct Dimensions {
  double width, height, bevel;
};

std::vector<Dimensions> draw_dimensions() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Dimensions> result(count);
  for (auto& [width, height, bevel] : result) {
    width = 0.021 + 0.002 * unit(random);
    height = width * (0.3 + 0.2 * unit(random));
    bevel = height * (0.05 + 0.2 * unit(random));
  }
  return result;
}

/// `ask(dimensions)`.
template <class Ask>
Curve curve_of(std::string name, std::string label, Ask ask) {
  return make_curve(
      count, std::move(name), std::move(label), [all = draw_dimensions(), ask](std::size_t i) { return ask(all[i]); },
      no_quantities);
}

/// `ask(stone)`; the stones are there.
template <class T, class Ask>
Curve curve_of_stones(std::string name, std::string label, bool bevelled, Ask ask) {
  std::vector<Stone<T>> stones;
  for (const auto& [width, height, bevel] : draw_dimensions()) {
    stones.push_back(make_stone(static_cast<T>(width), static_cast<T>(height), static_cast<T>(bevelled ? bevel : 0.0)));
  }
  return make_curve(
      count, std::move(name), std::move(label),
      [stones = std::move(stones), ask](std::size_t i) { return ask(stones[i]); }, no_quantities);
}

template <class T>
MassProperties<T> properties(const Stone<T>& stone) {
  return mass_properties(stone, Density<T>{T(2800)});
}

/// What a game would write: everything in double, no wider type. Faster, and less accurate.
std::array<double, 6> formulas_in_double(const Dimensions& one) {
  const Moments<double> moments = formula::lens_moments(one.width, one.height);
  const Moments<double> per_mass = formula::lens_moments_per_mass(one.width, one.height);
  return {formula::lens_volume(one.width, one.height),
          formula::lens_surface_area(one.width, one.height),
          moments.axial,
          moments.transverse,
          per_mass.axial,
          per_mass.transverse};
}

Race make_race(std::vector<Curve> curves) {
  return {.note = "Random stones, 21 to 23 mm wide.",
          .cost = "run time of a stone",
          .quantities = {},
          .cases = count,
          .block = count / 16,
          .curves = std::move(curves)};
}

Race prepare_stones(const Effort& /*any*/) {
  return make_race({curve_of("sharp", "sharp", [](const Dimensions& one) { return make_stone(one.width, one.height); }),
                    curve_of("bevelled", "bevelled",
                             [](const Dimensions& one) { return make_stone(one.width, one.height, one.bevel); }),
                    curve_of("measured", "from outer measures", [](const Dimensions& one) {
                      return make_measured_stone(one.width, one.height, one.bevel);
                    })});
}

Race prepare_properties(const Effort& /*any*/) {
  return make_race({curve_of_stones<double>("sharp", "sharp", false, properties<double>),
                    curve_of_stones<float>("sharp-float", "sharp, float", false, properties<float>),
                    curve_of("sharp-formulas", "sharp, the formulas in double alone", formulas_in_double),
                    curve_of_stones<double>("bevelled", "bevelled", true, properties<double>),
                    curve_of_stones<float>("bevelled-float", "bevelled, float", true, properties<float>)});
}

Race prepare_tensor(const Effort& /*any*/) {
  return make_race({curve_of("tensor", "Goishi",
                             [body = properties(make_stone(0.022, 0.0092, 0.001)),
                              q_WB = Quat<double>(0.5, 0.5, -0.5, 0.5)](const Dimensions& one) {
                               return inertia_tensor(body, q_WB, Vec3<double>(one.width, one.height, one.bevel));
                             })});
}

}  // namespace

Subject subject() {
  std::vector<Problem> problems = {{"make-stone", "A stone from its measures", prepare_stones},
                                   {"mass-properties", "Mass properties of a stone", prepare_properties},
                                   {"tensor", "Inertia tensor in any attitude about any point", prepare_tensor}};
  for (Problem& problem : mesh_problems()) {
    problems.push_back(std::move(problem));
  }
  return {.name = "mass",
          .title = "Stones and their mass properties",
          .note = "Mass: the price alone; the errors are in the claims MASS.",
          .problems = std::move(problems),
          .contestants = {}};
}

}  // namespace goishi::verify::bench::mass
