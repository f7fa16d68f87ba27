#pragma once
/// \file
/// Power series in a step Δt, cut off after a fixed power, as a scalar: the shipped steps run on it, and the orders are
/// read off. The coefficients are exact: symbols, and numbers.

#include <cstddef>
#include <goishi/rotation.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "relations.hpp"

namespace derivation {

class Series {
 public:
  /// The last power that is kept, and the relations that bind the symbols. All series of a proof share them.
  static inline std::size_t last_power = 4;
  static inline Relations relations = {};

  Series() : Series(0) {}
  Series(int constant) : Series(ex(constant)) {}
  Series(const ex& constant) : coefficients_(last_power + 1, 0) { coefficients_[0] = constant; }

  /// Δt itself.
  static Series step() {
    Series dt;
    dt.coefficients_.at(1) = 1;
    return dt;
  }

  [[nodiscard]] const ex& operator[](std::size_t power) const { return coefficients_.at(power); }

  friend Series operator+(Series a, const Series& b) { return a += b; }
  friend Series operator-(Series a, const Series& b) { return a -= b; }
  friend Series operator-(const Series& a) { return Series(0) - a; }
  friend Series operator*(const Series& a, const Series& b) {
    Series product;
    product.fill([&](std::size_t n) { return convolution(a, b, 0, n); });
    return product;
  }
  friend Series operator/(const Series& a, const Series& b) {
    require(!b[0].is_zero(), "division by a series that begins with zero");
    Series quotient;
    const ex inverse = 1 / b[0];
    quotient.fill([&](std::size_t n) { return (a[n] - convolution(b, quotient, 1, n)) * inverse; });
    return quotient;
  }
  Series& operator+=(const Series& other) {
    for (std::size_t n = 0; n <= last_power; ++n) {
      coefficients_[n] += other[n];
    }
    return *this;
  }
  Series& operator-=(const Series& other) {
    for (std::size_t n = 0; n <= last_power; ++n) {
      coefficients_[n] -= other[n];
    }
    return *this;
  }
  Series& operator*=(const Series& other) { return *this = *this * other; }
  Series& operator/=(const Series& other) { return *this = *this / other; }

  /// The root that begins with 1: y² = a.
  friend Series sqrt(const Series& a) {
    require((a[0] - 1).is_zero(), "root of a series that does not begin with 1");
    Series y(1);
    for (std::size_t n = 1; n <= last_power; ++n) {
      y.coefficients_[n] = relations.of_polynomial((a[n] - convolution(y, y, 1, n - 1)) / 2);
    }
    return y;
  }

  friend Series cos(const Series& a) { return cosine_and_sine(a).first; }
  friend Series sin(const Series& a) { return cosine_and_sine(a).second; }
  friend Series atan2(const Series& /*y*/, const Series& /*x*/) { throw std::logic_error("Series: no atan2"); }

 private:
  static void require(bool condition, const char* what) {
    if (!condition) {
      throw std::logic_error(what);
    }
  }

  /// Σ a_k b_{n−k} over k from `from` to n.
  static ex convolution(const Series& a, const Series& b, std::size_t from, std::size_t n) {
    ex sum = 0;
    for (std::size_t k = from; k <= n; ++k) {
      sum += a[k] * b[n - k];
    }
    return sum;
  }

  template <class Coefficient>
  void fill(const Coefficient& coefficient) {
    for (std::size_t n = 0; n <= last_power; ++n) {
      coefficients_[n] = relations.of_polynomial(coefficient(n));
    }
  }

  /// c' = −a' s and s' = a' c, with c = 1 and s = 0 at first.
  static std::pair<Series, Series> cosine_and_sine(const Series& a) {
    require(a[0].is_zero(), "sine of a series that does not begin with zero");
    Series c(1);
    Series s(0);
    for (std::size_t n = 1; n <= last_power; ++n) {
      ex slope_of_c = 0;
      ex slope_of_s = 0;
      for (std::size_t k = 1; k <= n; ++k) {
        slope_of_c -= ex(static_cast<int>(k)) * a[k] * s[n - k];
        slope_of_s += ex(static_cast<int>(k)) * a[k] * c[n - k];
      }
      c.coefficients_[n] = relations.of_polynomial(slope_of_c / static_cast<int>(n));
      s.coefficients_[n] = relations.of_polynomial(slope_of_s / static_cast<int>(n));
    }
    return {c, s};
  }

  std::vector<ex> coefficients_;
};

}  // namespace derivation

namespace Eigen {
template <>
struct NumTraits<derivation::Series> : NumTraits<GiNaC::ex> {
  using Real = derivation::Series;
  using NonInteger = derivation::Series;
  using Nested = derivation::Series;
  using Literal = derivation::Series;
};
}  // namespace Eigen

namespace derivation {

static_assert(goishi::Elementary<Series> && !goishi::Ordered<Series>);

using SeriesVector = goishi::Vec3<Series>;
using SeriesQuaternion = goishi::Quat<Series>;

inline SeriesVector constant_series(const Vector& v) {
  return {Series(v.x()), Series(v.y()), Series(v.z())};
}

inline SeriesQuaternion constant_series(const Quaternion& q) {
  return {Series(q.w()), Series(q.x()), Series(q.y()), Series(q.z())};
}

inline Vector coefficient(const SeriesVector& v, std::size_t power) {
  return {v.x()[power], v.y()[power], v.z()[power]};
}

inline Quaternion coefficient(const SeriesQuaternion& q, std::size_t power) {
  return {q.w()[power], q.x()[power], q.y()[power], q.z()[power]};
}

}  // namespace derivation
