#pragma once
/// \file
/// A stone by its definition alone: the sphere through pole and rim, the torus that touches it. Solved for numerically
/// in 50 digits; no formula of src/ is used. Frame B, meridian half-plane (ρ, z).

namespace goishi::verify {

struct Geometry {
  double height;         // h
  double bevel;          // b
  double sphere_radius;  // of the two balls
  double sphere_offset;  // their centres at z = ∓ this
  double torus_radius;   // ρ of the centre of the bevel's circle
  double tube_radius;    // of the bevel's circle; 0: sharp
  double joint_radius;   // ρ where they touch
  double outer_radius;   // greatest ρ
};

/// The lens of width w and height h, its rim bevelled with height b (0: left sharp). 0 < h < w.
[[nodiscard]] Geometry solve_published(double width, double height, double bevel);

/// The stone whose finished width is w. 0 < b < h < w.
[[nodiscard]] Geometry solve_measured(double outer_width, double height, double bevel);

}  // namespace goishi::verify
