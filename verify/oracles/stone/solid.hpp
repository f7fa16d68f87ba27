#pragma once
/// \file
/// The stone as a set of points: inside both balls, and inside the torus where the torus rules. Integrated in three
/// nested dimensions, or by throwing points; the profile is not used.

#include <array>
#include <random>

#include "verify/oracles/stone/geometry.hpp"

namespace goishi::verify {

using Point = std::array<double, 3>;

/// < 0 inside, > 0 outside, 0 on the surface; continuous along rays from the centre.
[[nodiscard]] double outside(const Geometry& geometry, const Point& x_B);

/// Integrals of 1, x_i and x_i x_j of the points seen from another frame: x_W = R_WB x_B + p_WB.
struct SolidMoments {
  double volume;
  Point first;                                  // ∫ x_i
  std::array<std::array<double, 3>, 3> tensor;  // ∫ (|x|² δ_ij − x_i x_j)
};

using Rotation = std::array<std::array<double, 3>, 3>;

/// Spherical coordinates about the stone's centre, nested: azimuth, polar angle, radius (to the surface along the ray,
/// found by Brent's method on `outside`).
[[nodiscard]] SolidMoments integrate_solid(const Geometry& geometry, const Rotation& R_WB, const Point& p_WB);

/// Estimates by points thrown into the bounding box, with their standard errors.
struct Estimate {
  double value;
  double standard_error;
};
struct MonteCarlo {
  Estimate volume, axial, transverse;
};
[[nodiscard]] MonteCarlo throw_points(const Geometry& geometry, int count, std::mt19937_64& random);

}  // namespace goishi::verify
