#pragma once
/// \file
/// A stone that spins on its cap, z = cos θ the height of its axis: the tippe-top's threshold and settling tilts under
/// friction in proportion to slip, what rolling keeps, and the swing of the tilt without friction, which energy and the
/// two momenta L_z and L · u reduce to a quadrature. Per unit of mass, in long double; shares no formula with src/.

namespace goishi::verify {

/// r, d and the moments per unit of mass   [m, m²]; g   [m/s²].
struct SpinningCap {
  using Long = long double;
  Long r, d, axial, transverse, gravity;

  /// I_t r² (1 − z²) + I_a (d − r z)².
  [[nodiscard]] Long lever(Long z) const;
  /// The least spin of a flat stone that makes it rise: ω² = g d (1 − α)²/(I_t − I_a (1 − α)), α = d/r   [rad/s].
  [[nodiscard]] Long threshold() const;
  /// z where it settles, L · (d u − r ẑ) being J: g d D² = J² [I_t r² z + I_a r (d − r z)].
  [[nodiscard]] Long settling_height(Long jellett) const;
};

/// The swing of the tilt of a frictionless stone between two heights of its axis.
class FrictionlessSwing {
 public:
  using Long = long double;
  /// From the height z₀ of the axis, spinning about the vertical with ω.
  FrictionlessSwing(const SpinningCap& stone, Long z0, Long spin);

  [[nodiscard]] Long other() const { return z1_; }  // the other turning point
  /// From the first turning point: time and height at the phase ψ, 0 there and π at the other.
  [[nodiscard]] Long time(Long phase) const;
  [[nodiscard]] Long height(Long phase) const;

 private:
  SpinningCap stone_;
  Long z0_, z1_, z2_;  // roots of the cubic
};

}  // namespace goishi::verify
