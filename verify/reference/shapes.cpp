/// shapes.json: the lengths of a stone.

#include <goishi/shape/stone.hpp>

#include "verify/oracles/stone/rigorous_integral.hpp"
#include "verify/reference/sections.hpp"
#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

namespace {

template <class T>
Answers<T> shape_answers(const Shape& shape) {
  const Stone<T> stone = stone_of<T>(shape);
  // What may be 0 is counted in ulps of the width there: a ball's d, a sharp stone's r₂.
  const double width = scale_of(shape.width);
  const auto or_zero = [&](const std::string& name, const T& value, bool zero) {
    return answer(name, value, zero ? width : 0.0);
  };
  const bool ball = !(shape.height < shape.width), sharp = !(0.0 < shape.bevel);
  return {answer("generating_width", stone.width),
          answer("outer_width", outer_width(stone)),
          answer("sphere_radius", stone.sphere_radius),
          or_zero("sphere_offset", stone.sphere_offset, ball),
          or_zero("bevel_major_radius", stone.bevel_major_radius, ball && !sharp),
          or_zero("bevel_minor_radius", stone.bevel_minor_radius, sharp),
          answer("joint_radius", stone.joint_radius),
          answer("joint_cosine", stone.joint_cosine),
          {.quantity = "joint_sine", .values = {stone.joint_sine}, .scale = ball && sharp ? 1.0 : 0.0}};
}

/// The formulas, which meet what a draughtsman constructs: an arc through pole and rim, a circle that touches it.
Answers<OrderedBall> constructed_answers(const Shape& shape) {
  const Stone<OrderedBall> stone = stone_of<OrderedBall>(shape);
  const Ball w = stone.width.ball(), h(shape.height), b(shape.bevel);
  const Meridian drawn = 0.0 < shape.bevel ? bevelled_meridian(w, h, b) : lens_meridian(w, h);
  const auto meet = [](const OrderedBall& x, const Ball& y, const char* what) { require_met(x, OrderedBall(y), what); };
  meet(shape.measured ? OrderedBall(shape.width) : outer_width(stone), greatest_width(drawn), "the outer width");
  meet(stone.sphere_radius, drawn.sphere_radius, "r");
  meet(stone.sphere_offset, drawn.sphere_offset, "d");
  meet(stone.bevel_major_radius, drawn.tube_distance, "r1");
  meet(stone.bevel_minor_radius, drawn.tube_radius, "r2");
  meet(stone.joint_radius, drawn.sphere_radius * sin(drawn.joint_angle), "the joint's radius");
  meet(stone.joint_cosine, sin(drawn.joint_angle), "the joint's cosine");
  meet(stone.joint_sine, cos(drawn.joint_angle), "the joint's sine");
  return shape_answers<OrderedBall>(shape);
}

}  // namespace

Section shapes_section() {
  Section section{
      .name = "shapes",
      .about =
          "The lengths of a stone: two spheres of radius r whose centres stand 2d apart, and a torus that touches both",
      .inputs = shape_inputs(),
      .quantities = {{.name = "generating_width", .unit = "m", .about = "width of the lens that generates the stone"},
                     {.name = "outer_width", .unit = "m", .about = "width of the finished stone, 2 (r1 + r2)"},
                     {.name = "sphere_radius", .unit = "m", .about = "r"},
                     {.name = "sphere_offset", .unit = "m", .about = "d = r - h/2"},
                     {.name = "bevel_major_radius", .unit = "m", .about = "r1 of the torus; w/2 of a sharp stone"},
                     {.name = "bevel_minor_radius", .unit = "m", .about = "r2 of the torus; 0 of a sharp stone"},
                     {.name = "joint_radius", .unit = "m", .about = "of the circle where cap and torus touch"},
                     {.name = "joint_cosine", .unit = "", .about = "radial part of the normal there"},
                     {.name = "joint_sine", .unit = "", .about = "axial part of the normal there"}},
      .problems = {}};
  for (const Shape& shape : all_shapes()) {
    section.problems.push_back({.id = numbered("shape", section.problems.size() + 1),
                                .about = shape.about,
                                .inputs = inputs_of(shape),
                                .enclose = [shape] { return constructed_answers(shape); },
                                .compute = [shape] { return shape_answers<double>(shape); }});
  }
  return section;
}

}  // namespace goishi::verify::reference
