#pragma once
/// \file
/// The angle of a direction, in float, double and batches, by + − × ÷ alone: the same to the last bit everywhere. What
/// callers use is in `scalar.hpp`.
///
///     atan(b/a) = atan c + atan((b − c a)/(a + c b)),   0 <= b <= a,   c = 0, ½ or 1, whichever is near
///
/// The numerator is exact, and the one quotient is at most 9/32.
///
/// Error   <= 2 ulp in double, 0.51 in float.

#include <array>
#include <cmath>
#include <cstddef>
#include <goishi/scalar/sincos.hpp>
#include <limits>

namespace goishi::scalar::detail {

/// A number and its round-off.
struct Exactly {
  double value, rest;
};

/// atan t for |t| <= 9/32: t + t z P(z), z = t², minimax of 2^-60.
[[nodiscard]] inline double atan_of_small(double t) {
  constexpr std::array P = {-0x1.5555555555543p-2, 0x1.999999999503fp-3,  -0x1.249249216a72bp-3,
                            0x1.c71c6fa5919cdp-4,  -0x1.745caee1aad56p-4, 0x1.3b0795fded92bp-4,
                            -0x1.10322ef4459a3p-4, 0x1.ce4d12f56f16ap-5,  -0x1.31415165ace21p-5};
  const double z = t * t, z2 = z * z, z4 = z2 * z2;
  const double p =
      ((P[0] + z * P[1]) + z2 * (P[2] + z * P[3])) + z4 * (((P[4] + z * P[5]) + z2 * (P[6] + z * P[7])) + z4 * P[8]);
  return t + (t * z) * p;
}

/// For sizes from 2^-900 to 2^900, the smaller one from 0.
[[nodiscard]] inline double atan2_near(double y, double x) {
  // By quadrant, from the axis that is nearer, and c: the angle without what the quotient adds.
  static constexpr std::array<std::array<Exactly, 3>, 4> base = {{
      {{{0, 0}, {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56}, {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}},
      {{{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
        {0x1.1b6e192ebbe44p+0, 0x1.b1b466a88828ep-54},
        {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}},
      {{{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},
        {0x1.56c6e7397f5aep+1, 0x1.660b64ece6f4bp-53},
        {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54}}},
      {{{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
        {0x1.0468a8ace4df6p+1, 0x1.0620bf7406affp-55},
        {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54}}},
  }};
  const bool steep = std::fabs(x) < std::fabs(y), behind = std::signbit(x);
  const double a = std::fabs(steep ? y : x), b = std::fabs(steep ? x : y);
  const std::size_t n = b < 0x1.2p-2 * a ? 0 : b < 0x1.7p-1 * a ? 1 : 2;
  const double c = static_cast<double>(n) * 0.5;
  const double part = atan_of_small((b - c * a) / (a + c * b));
  const Exactly& from = base[(steep ? 1U : 0U) + (behind ? 2U : 0U)][n];
  return std::copysign(from.value + (from.rest + (steep != behind ? -part : part)), y);
}

/// Infinite, of no direction, or so large or small that sums and halves are not exact.
[[nodiscard, gnu::noinline, gnu::cold]] inline double atan2_seldom(double y, double x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double most = std::fabs(x) < std::fabs(y) ? std::fabs(y) : std::fabs(x);
  if (!(std::fabs(y) <= infinity && std::fabs(x) <= infinity)) {
    return x + y;  // no number
  }
  if (most <= std::numeric_limits<double>::max() && 0 < most) {
    const double scale = most < 1 ? 0x1p600 : 0x1p-600;
    return atan2_near(y * scale, x * scale);
  }
  const auto one_if_most = [&](double z) { return std::copysign(std::fabs(z) < most ? 0.0 : 1.0, z); };
  return 0 < most ? atan2_near(one_if_most(y), one_if_most(x)) : atan2_near(y, std::copysign(1.0, x));
}

[[nodiscard]] inline double own_atan2(double y, double x) {
  const double most = std::fabs(x) < std::fabs(y) ? std::fabs(y) : std::fabs(x);
  const double least = std::fabs(x) < std::fabs(y) ? std::fabs(x) : std::fabs(y);
  return 0x1p-900 < most && most < 0x1p900 && least <= most ? atan2_near(y, x) : atan2_seldom(y, x);
}
[[nodiscard]] inline float own_atan2(float y, float x) {
  return static_cast<float>(own_atan2(static_cast<double>(y), static_cast<double>(x)));
}
template <SimdBatch V>
[[nodiscard]] V own_atan2(const V& y, const V& x) {
  V result = y;
  for (std::size_t i = 0; i < V::size(); ++i) {
    const typename V::value_type y_i = y[i], x_i = x[i];
    result[i] = own_atan2(y_i, x_i);
  }
  return result;
}

}  // namespace goishi::scalar::detail
