#pragma once
/// \file
/// The drops that are timed: size 33, bevel 1 mm, let go 5 cm over the plane, in random attitude, with a random spin of
/// up to 30 rad/s. Restitution, friction and resistance are the defaults.

#include <goishi/mass/inertia.hpp>
#include <vector>

#include "compiled/drop.hpp"

namespace goishi::verify::bench::drops {

struct Scene {
  Stone<double> stone;
  MassProperties<double> mass;
  RigidBody<double> body;
  std::vector<State<double>> starts;
};

[[nodiscard]] Scene make_scene(std::size_t count);

}  // namespace goishi::verify::bench::drops
