#pragma once
/// \file
/// Volume, area and moments by one-dimensional quadrature of the profile ρ(z).

#include "verify/oracles/stone/geometry.hpp"

namespace goishi::verify {

/// At density 1, about the centre of mass.
struct Integrals {
  double volume;
  double surface_area;
  double axial;
  double transverse;
};

[[nodiscard]] Integrals integrate_profile(const Geometry& geometry);

}  // namespace goishi::verify
