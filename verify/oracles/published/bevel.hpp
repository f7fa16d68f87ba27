#pragma once
/// \file
/// The talk's CalculateBevel, but for its argument list: P_x = √(r² + y²), y = d + b/2, where √(r² − y²) is right.

#include <cmath>

namespace goishi::verify {

/// In the unit of r, d and b.
template <class Real>
struct PublishedBevel {
  Real major_radius, minor_radius;

  PublishedBevel(const Real& r, const Real& d, const Real& b) {
    using std::sqrt;
    const Real y = b / 2 + d;
    const Real px = sqrt(y * y + r * r);
    major_radius = px * d / y;
    minor_radius = r - sqrt(d * d + major_radius * major_radius);
  }
};

}  // namespace goishi::verify
