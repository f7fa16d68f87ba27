#pragma once
/// \file
/// Witnesses for a solid of revolution about the z axis: integrals over the solid itself, at density 1.

#include "algebra.hpp"

namespace derivation {

/// Coordinates of a point of the solid, and the radius ρ of the solid's slice at height z.
inline const realsymbol x("x");
inline const realsymbol y("y");
inline const realsymbol z("z");
inline const possymbol rho("rho", "\\rho");

/// What is integrated for the volume and for the moments about the axes z and x.
inline const ex volume_element = 1;
inline const ex axial_element = pow(x, 2) + pow(y, 2);
inline const ex transverse_element = pow(y, 2) + pow(z, 2);

/// ∫∫ f dx dy over the disc of radius ρ at height z, in polar coordinates x = s cos θ, y = s sin θ; f a polynomial.
inline ex over_disc(const ex& f) {
  const symbol s("s");
  const symbol cosine("cos");
  const symbol sine("sin");
  const ex polar = f.subs(exmap{{x, s * cosine}, {y, s * sine}});
  return integral(s * arc_integral(polar, cosine, sine, full_turn), s, 0, rho).expand();
}

/// ∫ f over the part of the solid between two heights, where the squared radius of the slice is a polynomial in z.
inline ex over_solid(const ex& f, const ex& squared_radius, const ex& lower, const ex& upper) {
  return integral(over_disc(f).subs(rho == sqrt(squared_radius)), z, lower, upper);
}

}  // namespace derivation
