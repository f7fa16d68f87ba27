/// mass.json: volume, area, mass, moments, and the tensor about a point.

#include <fmt/format.h>

#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <stdexcept>

#include "verify/oracles/stone/rigorous_integral.hpp"
#include "verify/reference/draw.hpp"
#include "verify/reference/sections.hpp"
#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

namespace {

struct Weighed {
  Shape shape;
  double density;
  std::array<double, 3> position;
  std::array<double, 4> attitude;
};

template <class T>
Answers<T> mass_answers(const Weighed& of) {
  const Stone<T> stone = stone_of<T>(of.shape);
  const MassProperties<T> body = mass_properties(stone, Density<T>{T(of.density)});
  const Mat3<T> tensor = inertia_tensor(body, attitude_of<T>(of.attitude), vector_of<T>(of.position));
  const T trace = tensor(0, 0) + tensor(1, 1) + tensor(2, 2);
  return {answer("volume", body.volume),
          answer("surface_area", body.surface_area),
          answer("mass", body.mass),
          answer("axial", body.moments.axial),
          answer("transverse", body.moments.transverse),
          answer("axial_per_mass", body.moments_per_mass.axial),
          answer("transverse_per_mass", body.moments_per_mass.transverse),
          {.quantity = "tensor",
           .values = {tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(0, 2), tensor(1, 2)},
           .scale = scale_of(static_cast<double>(trace))}};
}

/// The closed forms, which meet what Arb integrates of the meridian, by other formulas.
Answers<OrderedBall> integrated_answers(const Weighed& of) {
  Answers<OrderedBall> answers = mass_answers<OrderedBall>(of);
  const Ball w = stone_of<OrderedBall>(of.shape).width.ball(), h(of.shape.height), b(of.shape.bevel);
  const EnclosedIntegrals integrals =
      integrate_rigorously(0.0 < of.shape.bevel ? bevelled_meridian(w, h, b) : lens_meridian(w, h));
  const Ball density(of.density);
  const std::array<Ball, 7> seen = {integrals.volume,
                                    integrals.surface_area,
                                    density * integrals.volume,
                                    density * integrals.axial,
                                    density * integrals.transverse,
                                    integrals.axial / integrals.volume,
                                    integrals.transverse / integrals.volume};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].is_finite() || !(seen[i].relative_radius() < 1e-30) ||
        !answers[i].values.front().ball().overlaps(seen[i])) {
      throw std::runtime_error(fmt::format("{} is not what integration encloses", answers[i].quantity));
    }
  }
  return answers;
}

}  // namespace

Section mass_section() {
  const auto integral = [](const char* name, const char* unit, const char* about) {
    return QuantityKind{.name = name, .unit = unit, .proof = Proof::integral, .about = about};
  };
  Section section{
      .name = "mass",
      .about = "Volume, area, mass and moments of a stone of uniform density, and its tensor about the origin",
      .inputs = shape_inputs(),
      .quantities = {integral("volume", "m^3", "V"),
                     integral("surface_area", "m^2", ""),
                     integral("mass", "kg", "density times V"),
                     integral("axial", "kg m^2", "about the symmetry axis, through the centre of mass"),
                     integral("transverse", "kg m^2", "across it"),
                     integral("axial_per_mass", "m^2", ""),
                     integral("transverse_per_mass", "m^2", ""),
                     {.name = "tensor",
                      .unit = "kg m^2",
                      .components = 6,
                      .about = "xx, yy, zz, xy, xz, yz of the tensor about the origin, in the world; off the "
                               "diagonal minus the products of inertia"}},
      .problems = {}};
  section.inputs.push_back({"density", "kg/m^3", ""});
  section.inputs.push_back({"position", "m", "of the centre of mass, in the world"});
  section.inputs.push_back({"attitude", "", "w, x, y, z of a quaternion of any length: normalise it; body to world"});
  Draw draw(2);
  for (const Shape& shape : all_shapes()) {
    const std::size_t number = section.problems.size();
    Weighed of{.shape = shape, .density = 2800.0, .position = {0.0, 0.0, 0.0}, .attitude = {1.0, 0.0, 0.0, 0.0}};
    if (number % 4 == 1) {
      of.attitude = {1.0, 1.0, 1.0, 1.0};
    } else if (number % 4 > 1) {
      of.density = draw.part(100, 800, 1) * 10.0;
      of.attitude = draw.wholes<4>(9);
      for (double& x : of.position) {
        x = shape.width * draw.part(-200, 200, 100);
      }
    }
    std::vector<Input> inputs = inputs_of(shape);
    inputs.push_back(input("density", of.density));
    inputs.push_back(input("position", of.position));
    inputs.push_back(input("attitude", of.attitude));
    section.problems.push_back({.id = numbered("mass", number + 1),
                                .about = shape.about,
                                .inputs = std::move(inputs),
                                .enclose = [of] { return integrated_answers(of); },
                                .compute = [of] { return mass_answers<double>(of); }});
  }
  return section;
}

}  // namespace goishi::verify::reference
