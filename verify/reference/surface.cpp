/// surface.json: support, signed distance, closest point.

#include <concepts>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>

#include "verify/reference/draw.hpp"
#include "verify/reference/sections.hpp"
#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

namespace {

using Place = std::array<double, 3>;

template <class T>
Answers<T> support_answers(const Shape& shape, const Place& direction) {
  const double width = scale_of(shape.width);
  const Stone<T> stone = stone_of<T>(shape);
  const Vec3<T> n = direction_of<T>(direction);
  const Support<T> farthest = support(stone, n);
  if constexpr (std::same_as<T, OrderedBall>) {  // from outside the point is the closest one
    const Vec3<T> away = formula::plus(farthest.p_B, T(shape.width), n);
    require_met(farthest.value, formula::dot(n, farthest.p_B), "the support");
    require_met(T(shape.width), signed_distance(stone, away), "a distance from a support point");
  }
  return {answer("support", farthest.value, width), answer("support_point", farthest.p_B, width)};
}

/// The nearest point where there is one. Its normal leads to the point from the centre of the sphere, or from the core's rim:
/// the nearer the point is to that, the less it says of the normal, and the greater the scale.
template <class T>
Answers<T> distance_answers(const Shape& shape, const Place& point) {
  const Stone<T> stone = stone_of<T>(shape);
  const SurfacePoint<T> nearest = closest_point(stone, vector_of<T>(point));
  const double reach = scale_of(shape.width + length_of(point));
  Answers<T> answers = {answer("distance", nearest.distance, reach)};
  if (nearest.unique) {
    if constexpr (std::same_as<T, OrderedBall>) {  // no point is beyond the plane that touches there
      require_met(detail::support_of_unit(stone, nearest.normal_B).value, formula::dot(nearest.normal_B, nearest.p_B),
                  "the support where a point is closest");
    }
    const double from_core = static_cast<double>(T(nearest.distance + stone.bevel_minor_radius));
    const double lever =
        nearest.feature == Feature::rim ? from_core : static_cast<double>(stone.core_sphere_radius) + from_core;
    const double away = std::fabs(static_cast<double>(nearest.distance));
    answers.push_back(answer("closest_point", nearest.p_B, scale_of(reach + away * reach / lever)));
    answers.push_back(answer("normal", nearest.normal_B, scale_of(1.0 + reach / lever)));
  }
  return answers;
}

std::vector<Place> directions_for(const Shape& shape, Draw& draw) {
  std::vector<Place> all = {{0.0, 0.0, 1.0},  {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0},
                            {3.0, -4.0, 0.0}, {3.0, 0.0, 4.0},  {1.0, 2.0, -2.0}};
  const double aspect = shape.height / shape.width;
  for (int i = 0; i < 4; ++i) {
    all.push_back(draw.wholes<3>(99));
    if (i % 2 == 1) {  // nearly along the axis, as caps of thin stones are met
      all.back()[0] *= aspect;
      all.back()[1] *= aspect;
    }
  }
  return all;
}

std::vector<Place> points_for(const Shape& shape, Draw& draw) {
  const double w = shape.width, h = shape.height;
  std::vector<Place> all = {{0.0, 0.0, 0.0},     {0.0, 0.0, h / 2.0}, {0.0, 0.0, -h},
                            {w / 2.0, 0.0, 0.0}, {0.0, -w, 0.0},      {w / 4.0, 0.0, 0.0},
                            {w, 0.0, h / 4.0},   {0.0, 0.0, h / 4.0}, {w / 4.0, w / 8.0, h / 8.0}};
  for (int i = 0; i < 5; ++i) {
    const Place way = draw.wholes<3>(99);
    const double size = i == 4 ? 1000.0 * w : w;
    all.push_back({size * way[0] / 128.0, size * way[1] / 128.0, size * way[2] / (i % 2 == 0 ? 128.0 : 1024.0)});
  }
  return all;
}

}  // namespace

Section surface_section() {
  Section section{
      .name = "surface",
      .about = "The surface of a stone in its own frame: origin at the centre, z the symmetry axis",
      .inputs = shape_inputs(),
      .quantities =
          {{.name = "support", .unit = "m", .about = "how far the stone reaches in the direction"},
           {.name = "support_point", .unit = "m", .components = 3, .about = "where it does"},
           {.name = "distance", .unit = "m", .about = "of the point from the surface, negative inside"},
           {.name = "closest_point", .unit = "m", .components = 3, .about = "of the surface; only where it is one"},
           {.name = "normal",
            .unit = "",
            .components = 3,
            .about = "unit, out of the stone, there; only where it is one"}},
      .problems = {}};
  section.inputs.push_back({"direction", "", "of any length: normalise it; asks for the support"});
  section.inputs.push_back({"point", "m", "asks for the distance"});
  Draw draw(3);
  const auto add = [&](const Shape& shape, const char* name, const Place& place, auto ask) {
    std::vector<Input> inputs = inputs_of(shape);
    inputs.push_back(input(name, place));
    section.problems.push_back(
        make_problem(numbered("surface", section.problems.size() + 1), shape.about, std::move(inputs), std::move(ask)));
  };
  for (const Shape& shape : some_shapes()) {
    for (const Place& way : directions_for(shape, draw)) {
      add(shape, "direction", way, [=]<class T>(std::type_identity<T>) { return support_answers<T>(shape, way); });
    }
    for (const Place& point : points_for(shape, draw)) {
      add(shape, "point", point, [=]<class T>(std::type_identity<T>) { return distance_answers<T>(shape, point); });
    }
  }
  return section;
}

}  // namespace goishi::verify::reference
