#pragma once
/// \file
/// A stone as the convex hull of two spherical caps and a torus, constructed from its width, height and bevel alone; no
/// formula of src/ is used. Support and distance by searching its outline, and in 50 digits.

#include <array>

#include "verify/oracles/numbers/multiprecision.hpp"

namespace goishi::verify {

/// A stone by ruler and compass, in frame B: meridian half-plane (ρ, z).
template <class Real>
struct Hull {
  Real height;         // h
  Real band;           // b/2, height of the joint of cap and bevel over the middle
  Real sphere_radius;  // of both caps, their centres at z = ∓ `sphere_offset`
  Real sphere_offset;
  Real torus_radius;  // ρ of the centre of the bevel's circle
  Real tube_radius;   // of that circle; 0: a sharp edge
  Real joint_radius;  // ρ of the joint
};

/// The lens of width w and height h with a bevel of height b (0: sharp), 0 < h <= w, 0 <= b < h.
[[nodiscard]] Hull<Digits50> construct_hull(double width, double height, double bevel);
[[nodiscard]] Hull<long double> narrow(const Hull<Digits50>& hull);

template <class Real>
using Triple = std::array<Real, 3>;

/// < 0 inside, > 0 outside: inside both balls, and inside the torus where it rules. At (ρ, z).
template <class Real>
[[nodiscard]] Real outside(const Hull<Real>& hull, const Real& rho, const Real& z);

/// The point of the outline at s in [0, 1], from the upper pole over the rim to the lower: (ρ, z).
[[nodiscard]] std::array<long double, 2> outline(const Hull<long double>& hull, long double s);

/// max n · x over the solid, n = n_r radial + n_z axial: sampled outline, golden section.
[[nodiscard]] long double searched_support(const Hull<long double>& hull, long double n_r, long double n_z);

/// Distance of (ρ, z) from the outline, unsigned: sampled, golden section.
[[nodiscard]] long double searched_distance(const Hull<long double>& hull, long double rho, long double z);

/// The farthest point in a unit direction (n_r >= 0, n_z), among those of a cap, of the joint and of the torus: (ρ, z).
template <class Real>
[[nodiscard]] std::array<Real, 2> farthest(const Hull<Real>& hull, const Real& n_r, const Real& n_z);

/// The closest point of the outline to (ρ, z) by its candidates: feet on both caps, on the bevel and the edge of a
/// sharp stone, where they are on the outline.
struct Foot {
  Digits50 rho, z;
  Digits50 n_r, n_z;   // from the outline's centre of curvature there to the point, unit
  Digits50 distance;   // unsigned
  double from_centre;  // the point's distance from that centre
  double radius;       // the outline's radius of curvature there
};
[[nodiscard]] Foot closest_foot(const Hull<Digits50>& hull, const Digits50& rho, const Digits50& z);

}  // namespace goishi::verify
