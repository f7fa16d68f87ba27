#pragma once
/// \file
/// Volume, area and moments of a stone by Arb's rigorous integration of its meridian. The meridian is built as a
/// draughtsman would: an arc through pole and rim, and a circle about a point of the middle plane that touches it. Its
/// arcs are followed by the angle of the normal, where all integrands are entire functions: no root, no branch cut.

#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify {

/// A stone's meridian in the half-plane (ρ, z); z < 0 by reflection. Lengths in m; angles, of the normal from the
/// axis, in rad.
struct Meridian {
  Ball height;
  Ball sphere_radius;  // of the cap, an arc about (0, −sphere_offset) from angle 0 to the joint
  Ball sphere_offset;
  Ball joint_angle;
  Ball tube_distance;  // the bevel is an arc about (tube_distance, 0) from the joint to π/2
  Ball tube_radius;
  bool bevelled = false;  // else the cap reaches the rim, and the tube is a point there
};

/// The lens of width w and height h, both in m.   Domain  0 < h <= w.
[[nodiscard]] Meridian lens_meridian(const Ball& width, const Ball& height);

/// The same, its rim bevelled with height b   [m].   Domain  0 < b < h <= w.
[[nodiscard]] Meridian bevelled_meridian(const Ball& width, const Ball& height, const Ball& bevel);

/// Diameter of the finished stone   [m].   Domain  a meridian of either function above.
[[nodiscard]] Ball greatest_width(const Meridian& meridian);

/// Moments per density, about the centre of mass.
struct EnclosedIntegrals {
  Ball volume;        // [m³]
  Ball surface_area;  // [m²]
  Ball axial;         // [m⁵]
  Ball transverse;    // [m⁵]
};

/// Enclosures, some 30 digits narrow. Never wrong: where Arb cannot narrow one, it is wide.
[[nodiscard]] EnclosedIntegrals integrate_rigorously(const Meridian& meridian);

}  // namespace goishi::verify
