#pragma once
/// \file
/// Torque-free rotation of any rigid body by Taylor series of the raw Newton–Euler equations, in long double: what
/// judges steppers, in thousandths of a second.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace goishi::verify {

using Real3 = std::array<long double, 3>;
using Real4 = std::array<long double, 4>;

/// Attitude (w, x, y, z; body to world; unit) and angular velocity in B.
struct Turning {
  Real4 attitude;
  Real3 spin;
};

/// The same body after a time.
///
///     I ω̇ = (I ω) × ω,   q̇ = ½ q (0, ω)
///
/// Both are polynomial, so the k-th coefficient follows from the ones before it by Cauchy products. 24 terms, steps of
/// at most an eighth of the greatest rate: what is cut off is about 8⁻²⁵ < 1e-22 a step.
[[nodiscard]] inline Turning taylor_turning(const std::array<double, 3>& moments, Turning now, long double time) {
  constexpr std::size_t order = 24;
  const Real3 I = {moments[0], moments[1], moments[2]};
  const Real3 drive = {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
  // |ω| is at most |L| / I_min.
  const long double momentum = std::hypot(I[0] * now.spin[0], I[1] * now.spin[1], I[2] * now.spin[2]);
  const long double rate = momentum / std::min({I[0], I[1], I[2]});
  const long double steps = std::ceil(8.0L * rate * std::fabs(time)) + 1.0L;
  const long double dt = time / steps;
  for (long double step = 0.0L; step < steps; step += 1.0L) {
    std::array<Real4, order + 1> q{};
    std::array<Real3, order + 1> w{};
    q[0] = now.attitude;
    w[0] = now.spin;
    for (std::size_t k = 0; k < order; ++k) {
      const long double next = static_cast<long double>(k + 1);
      for (std::size_t j = 0; j <= k; ++j) {
        const Real4& a = q[j];
        const Real3& b = w[k - j];
        for (std::size_t i = 0; i < 3; ++i) {
          w[k + 1][i] += drive[i] * w[j][(i + 1) % 3] * b[(i + 2) % 3] / next;
        }
        q[k + 1][0] += (-a[1] * b[0] - a[2] * b[1] - a[3] * b[2]) / (2.0L * next);
        q[k + 1][1] += (a[0] * b[0] + a[2] * b[2] - a[3] * b[1]) / (2.0L * next);
        q[k + 1][2] += (a[0] * b[1] + a[3] * b[0] - a[1] * b[2]) / (2.0L * next);
        q[k + 1][3] += (a[0] * b[2] + a[1] * b[1] - a[2] * b[0]) / (2.0L * next);
      }
    }
    // Horner.
    now = {q[order], w[order]};
    for (std::size_t k = order; k-- > 0;) {
      for (std::size_t i = 0; i < 4; ++i) {
        now.attitude[i] = now.attitude[i] * dt + q[k][i];
      }
      for (std::size_t i = 0; i < 3; ++i) {
        now.spin[i] = now.spin[i] * dt + w[k][i];
      }
    }
  }
  return now;
}

}  // namespace goishi::verify
