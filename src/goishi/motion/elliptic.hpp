#pragma once
/// \file
/// Elliptic integrals and functions, as far as a torque-free asymmetric body needs them, by Carlson's duplication and
/// Landen's transformation: no table, any precision.

#include <algorithm>
#include <array>
#include <goishi/scalar.hpp>
#include <limits>

namespace goishi::elliptic {

namespace detail {

/// Whether a relative deviation is so small that its sixth power, the first neglected term of Carlson's series, is
/// below round-off.
template <Ordered T>
[[nodiscard]] bool series_converged(const T& deviation) {
  return scalar::sq(T(deviation * deviation * deviation)) < std::numeric_limits<T>::epsilon() / T(4);
}

}  // namespace detail

/// Carlson's integral of the first kind, R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)).
/// Domain  x, y, z >= 0, at most one of them 0.   Error  claim ELLIPTIC-1.
template <Ordered T>
[[nodiscard]] T carlson_f(T x, T y, T z) {
  const T third = T(1) / T(3);
  while (true) {
    const T mean = (x + y + z) * third;
    const T X = (mean - x) / mean, Y = (mean - y) / mean;
    const T Z = -(X + Y);
    const T deviation = scalar::max(scalar::abs(X), scalar::max(scalar::abs(Y), scalar::abs(Z)));
    if (!(T(0) < deviation) || detail::series_converged(deviation)) {
      const T e2 = X * Y - Z * Z;
      const T e3 = X * Y * Z;
      return (T(1) - e2 / T(10) + e3 / T(14) + e2 * e2 / T(24) - T(3) * e2 * e3 / T(44)) / scalar::sqrt(mean);
    }
    const T root_x = scalar::sqrt(x), root_y = scalar::sqrt(y), root_z = scalar::sqrt(z);
    const T lambda = root_x * (root_y + root_z) + root_y * root_z;
    x = (x + lambda) / T(4);
    y = (y + lambda) / T(4);
    z = (z + lambda) / T(4);
  }
}

/// Carlson's integral of the third kind, R_J(x, y, z, p) = (3/2) ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))).
/// Domain  x, y, z >= 0, at most one of them 0; p >= each of them.   Error  claim ELLIPTIC-1.
template <Ordered T>
[[nodiscard]] T carlson_j(T x, T y, T z, T p) {
  const T fifth = T(1) / T(5);
  T sum(0), quarter_power(1);
  while (true) {
    const T mean = (x + y + z + p + p) * fifth;
    const T X = (mean - x) / mean, Y = (mean - y) / mean, Z = (mean - z) / mean;
    const T P = -(X + Y + Z) / T(2);
    const T deviation =
        scalar::max(scalar::max(scalar::abs(X), scalar::abs(Y)), scalar::max(scalar::abs(Z), scalar::abs(P)));
    if (!(T(0) < deviation) || detail::series_converged(deviation)) {
      const T xyz = X * Y * Z;
      const T e2 = X * Y + X * Z + Y * Z - T(3) * P * P;
      const T e3 = xyz + T(2) * e2 * P + T(4) * P * P * P;
      const T e4 = (T(2) * xyz + e2 * P + T(3) * P * P * P) * P;
      const T e5 = xyz * P * P;
      const T series = T(1) - T(3) * e2 / T(14) + e3 / T(6) + T(9) * e2 * e2 / T(88) - T(3) * e4 / T(22) -
                       T(9) * e2 * e3 / T(52) + T(3) * e5 / T(26);
      return quarter_power * series / (mean * scalar::sqrt(mean)) + T(6) * sum;
    }
    const T root_x = scalar::sqrt(x), root_y = scalar::sqrt(y), root_z = scalar::sqrt(z), root_p = scalar::sqrt(p);
    const T lambda = root_x * (root_y + root_z) + root_y * root_z;
    const T d = (root_p + root_x) * (root_p + root_y) * (root_p + root_z);
    // R_C(1, 1 + e²) = atan(e)/e, with e² = (p − x)(p − y)(p − z)/d² at this level.
    const T e = scalar::sqrt(T((p - x) * (p - y) * (p - z))) / d;
    const T rc = T(0) < e ? T(scalar::atan2(e, T(1)) / e) : T(1);
    sum = sum + quarter_power * rc / d;
    quarter_power = quarter_power / T(4);
    x = (x + lambda) / T(4);
    y = (y + lambda) / T(4);
    z = (z + lambda) / T(4);
    p = (p + lambda) / T(4);
  }
}

/// sn, cn and dn.
template <class T>
struct Jacobi {
  T sn, cn, dn;
};

/// Jacobi's elliptic functions of one modulus, and its quarter period K, from the complementary parameter m₁ = 1 − m,
/// by descending Landen transformations.
/// Domain  0 < m₁ <= 1, |u| <= K.   Error  absolute, claim ELLIPTIC-1; what cn and dn have of it where m₁ makes them small is
///         as small (ELLIPTIC-3).
template <Ordered T>
class JacobiFunctions {
 public:
  explicit JacobiFunctions(const T& m1) {
    T a(1), b = scalar::sqrt(m1);
    while (levels_ < most_levels) {
      const T sum = a + b;
      const T k = (a - b) / sum;
      if (!(std::numeric_limits<T>::epsilon() < k)) {
        break;
      }
      rest_[levels_] = T(2) * b / sum;
      k_[levels_++] = k;
      b = scalar::sqrt(T(a * b));
      a = sum / T(2);
    }
    mean_ = a;
  }

  [[nodiscard]] T quarter_period() const { return scalar::pi<T>() / (T(2) * mean_); }

  [[nodiscard]] Jacobi<T> operator()(const T& u) const {
    const T angle = mean_ * u;
    auto [s, c] = scalar::sincos(angle);
    T d(1);
    for (std::size_t i = levels_; i-- > 0;) {
      const T s2 = s * s, c2 = c * c;
      const T over = T(1) / (T(1) + k_[i] * s2);
      const T less = s2 < c2 ? T(T(1) - k_[i] * s2) : T(rest_[i] + k_[i] * c2);  // the same, by what is known better
      c = c * d * over;
      d = less * over;
      s = (T(1) + k_[i]) * s * over;
    }
    return {.sn = s, .cn = c, .dn = d};
  }

 private:
  static constexpr std::size_t most_levels = 24;
  std::array<T, most_levels> k_ = {};
  std::array<T, most_levels> rest_ = {};  // 1 − k
  std::size_t levels_ = 0;
  T mean_ = scalar::unset<T>();
};

}  // namespace goishi::elliptic
