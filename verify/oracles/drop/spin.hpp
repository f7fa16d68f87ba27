#pragma once
/// \file
/// A stone that spins on its cap, z = cos θ the height of its axis: the tippe-top's threshold and settling tilts under
/// friction in proportion to slip, what rolling keeps, and the swing of the tilt without friction, which energy and the
/// two momenta L_z and L · u reduce to a quadrature. Per unit of mass; shares no formula with src/.

#include <cmath>

namespace goishi::verify {

/// r, d and the moments per unit of mass   [m, m²]; g   [m/s²]. In long double, or enclosed.
template <class Real>
struct SpinningCap {
  Real r, d, axial, transverse, gravity;

  /// D = I_t r² (1 − z²) + I_a (d − r z)².
  [[nodiscard]] Real lever(const Real& z) const {
    return transverse * r * r * (1 - z * z) + axial * (d - r * z) * (d - r * z);
  }
  /// The least spin of a flat stone that makes it rise: ω² = g d (1 − α)²/(I_t − I_a (1 − α)), α = d/r   [rad/s].
  [[nodiscard]] Real threshold() const {
    using std::sqrt;
    const Real left = 1 - d / r;
    return sqrt(gravity * d * left * left / (transverse - axial * left));
  }
  /// g d D² − J² [I_t r² z + I_a r (d − r z)], J = L · (d u − r ẑ): 0 where it settles. Above the threshold gravity is too
  /// weak at z = 1, where this is negative, and strong enough where the axis lies.
  [[nodiscard]] Real righting(const Real& z, const Real& jellett) const {
    const Real D = lever(z);
    return gravity * d * D * D - jellett * jellett * (transverse * r * r * z + axial * r * (d - r * z));
  }
};

/// z where it settles.
[[nodiscard]] long double settling_height(const SpinningCap<long double>& stone, long double jellett);

/// The swing of the tilt of a frictionless stone between two heights of its axis.
class FrictionlessSwing {
 public:
  using Long = long double;
  /// From the height z₀ of the axis, spinning about the vertical with ω.
  FrictionlessSwing(const SpinningCap<Long>& stone, Long z0, Long spin);

  [[nodiscard]] Long other() const { return z1_; }  // the other turning point
  /// From the first turning point: time and height at the phase ψ, 0 there and π at the other.
  [[nodiscard]] Long time(Long phase) const;
  [[nodiscard]] Long height(Long phase) const;

 private:
  SpinningCap<Long> stone_;
  Long z0_, z1_, z2_;  // roots of the cubic
};

}  // namespace goishi::verify
