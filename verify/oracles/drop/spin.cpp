#include "verify/oracles/drop/spin.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace goishi::verify {

using Long = long double;

Long settling_height(const SpinningCap<Long>& stone, Long jellett) {
  Long low = 0, high = 1;
  for (int i = 0; i < 70; ++i) {
    const Long middle = (low + high) / 2;
    (stone.righting(middle, jellett) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

// With a = L · u, p = L_z and E' = E − a²/(2 I_a): I_t (I_t + d² (1 − z²)) ż² = f(z),
// f = 2 I_t (E' − g (r − d z)) (1 − z²) − (p − a z)², of which z₀ is a root. What is left after division by z − z₀ is
// k₂ z² + k₁ z + k₀.
FrictionlessSwing::FrictionlessSwing(const SpinningCap<Long>& stone, Long z0, Long spin) : stone_(stone), z0_(z0) {
  const Long It = stone.transverse, a = stone.axial * spin * z0;
  const Long p = It * spin * (1 - z0 * z0) + a * z0;
  const Long rise = (p - a * z0) * (p - a * z0) / (2 * It * (1 - z0 * z0)) - stone.gravity * stone.d * z0;  // E' − g r
  const Long k2 = -2 * It * stone.gravity * stone.d;
  const Long k1 = -2 * It * rise - a * a + k2 * z0;
  const Long k0 = -k2 + 2 * a * p + k1 * z0;
  const Long root = std::sqrt(k1 * k1 - 4 * k2 * k0);
  const Long one = (-k1 + root) / (2 * k2), other = (-k1 - root) / (2 * k2);
  z1_ = std::fabs(one) < std::fabs(other) ? one : other;
  z2_ = std::fabs(one) < std::fabs(other) ? other : one;
}

Long FrictionlessSwing::height(Long phase) const {
  return (z0_ + z1_) / 2 + (z0_ - z1_) / 2 * std::cos(phase);
}

Long FrictionlessSwing::time(Long phase) const {
  const auto slowness = [&](Long psi) {
    const Long z = height(psi), d = stone_.d;
    return std::sqrt((stone_.transverse + d * d * (1 - z * z)) / (2 * stone_.gravity * d * std::fabs(z2_ - z)));
  };
  return boost::math::quadrature::gauss_kronrod<Long, 61>::integrate(slowness, Long(0), phase, 10, 1e-14L);
}

}  // namespace goishi::verify
