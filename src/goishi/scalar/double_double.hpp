#pragma once
/// \file
/// Numbers of twice the digits of double, as unevaluated sums of two (Dekker 1971), by + − × ÷ of doubles alone: the wider type
/// of double, the same bits everywhere, where `long double` has 53, 64 or 113 of them.

#include <cmath>
#include <concepts>
#include <goishi/scalar/arctangent.hpp>
#include <goishi/scalar/sincos.hpp>
#include <limits>
#include <ostream>

namespace goishi {

/// hi + lo, |lo| <= half an ulp of hi.
///
/// Error   products, quotients, roots and sums of numbers of one sign 2^-103 of the value, other sums 2^-103 of their terms;
///         sine, cosine and arctangent 2^-70 of 1. In other rounding modes some bits more.
/// Range   that of double; digits are lost where the square of 2^-52 of a result is no normal number, and where a factor is
///         above 2^996.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi_(x) {}  // NOLINT(google-explicit-constructor): exact
  constexpr explicit DoubleDouble(std::integral auto n) : hi_(static_cast<double>(n)) {}
  constexpr explicit DoubleDouble(float x) : hi_(x) {}
  constexpr DoubleDouble(double hi, double lo) : hi_(hi), lo_(lo) {}

  [[nodiscard]] constexpr double hi() const { return hi_; }
  [[nodiscard]] constexpr double lo() const { return lo_; }
  constexpr explicit operator double() const { return hi_; }

  /// a b, exactly.
  [[nodiscard, gnu::always_inline]] static constexpr DoubleDouble product(double a, double b) {
    const double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
    const double hi = a * b;
    return {hi, a2 * b2 - (((hi - a1 * b1) - a2 * b1) - a1 * b2)};
  }
  /// a + b, exactly.
  [[nodiscard, gnu::always_inline]] static constexpr DoubleDouble sum(double a, double b) {
    const double hi = a + b, b_there = hi - a;
    return {hi, (a - (hi - b_there)) + (b - b_there)};
  }
  /// Likewise, |a| >= |b| or a = 0.
  [[nodiscard, gnu::always_inline]] static constexpr DoubleDouble ordered_sum(double a, double b) {
    const double hi = a + b;
    return {hi, b - (hi - a)};
  }

  [[gnu::always_inline]] friend constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi_, -x.lo_}; }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble high = sum(x.hi_, y.hi_);
    return ordered_sum(high.hi_, high.lo_ + (x.lo_ + y.lo_));
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator+(const DoubleDouble& x, double y) {
    const DoubleDouble high = sum(x.hi_, y);
    return ordered_sum(high.hi_, high.lo_ + x.lo_);
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator+(double x, const DoubleDouble& y) { return y + x; }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) {
    return x + -y;
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator-(const DoubleDouble& x, double y) { return x + -y; }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator-(double x, const DoubleDouble& y) { return -y + x; }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble high = product(x.hi_, y.hi_);
    return ordered_sum(high.hi_, high.lo_ + (x.hi_ * y.lo_ + x.lo_ * y.hi_));
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator*(const DoubleDouble& x, double y) {
    const DoubleDouble high = product(x.hi_, y);
    return ordered_sum(high.hi_, high.lo_ + x.lo_ * y);
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator*(double x, const DoubleDouble& y) { return y * x; }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.hi_ / y.hi_;
    const DoubleDouble back = product(quotient, y.hi_);
    const double rest = ((x.hi_ - back.hi_) - back.lo_) + (x.lo_ - quotient * y.lo_);
    return ordered_sum(quotient, rest / y.hi_);
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator/(const DoubleDouble& x, double y) {
    return x / DoubleDouble(y);
  }
  [[gnu::always_inline]] friend constexpr DoubleDouble operator/(double x, const DoubleDouble& y) {
    return DoubleDouble(x) / y;
  }
  constexpr DoubleDouble& operator+=(const DoubleDouble& x) { return *this = *this + x; }
  constexpr DoubleDouble& operator-=(const DoubleDouble& x) { return *this = *this - x; }
  constexpr DoubleDouble& operator*=(const DoubleDouble& x) { return *this = *this * x; }
  constexpr DoubleDouble& operator/=(const DoubleDouble& x) { return *this = *this / x; }

  friend constexpr bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.hi_ < y.hi_ || (x.hi_ == y.hi_ && x.lo_ < y.lo_);
  }
  friend constexpr bool operator==(const DoubleDouble& x, const DoubleDouble& y) = default;
  friend constexpr bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }
  friend constexpr bool operator<=(const DoubleDouble& x, const DoubleDouble& y) { return x < y || x == y; }
  friend constexpr bool operator>=(const DoubleDouble& x, const DoubleDouble& y) { return y <= x; }

  friend DoubleDouble abs(const DoubleDouble& x) { return x < DoubleDouble(0) ? -x : x; }
  friend DoubleDouble floor(const DoubleDouble& x) {
    const double hi = std::floor(x.hi_);
    return hi < x.hi_ ? DoubleDouble(hi) : ordered_sum(hi, std::floor(x.lo_));
  }
  friend DoubleDouble sqrt(const DoubleDouble& x) {
    const double root = std::sqrt(x.hi_);
    if (!(0 < root && root <= std::numeric_limits<double>::max())) {
      return root;
    }
    const DoubleDouble square = product(root, root);
    return ordered_sum(root, (((x.hi_ - square.hi_) - square.lo_) + x.lo_) / (2 * root));
  }
  friend DoubleDouble sin(const DoubleDouble& x) { return sine_and_cosine(x).sin; }
  friend DoubleDouble cos(const DoubleDouble& x) { return sine_and_cosine(x).cos; }

  /// α of `y` and `x` in double, and what the turn by −α leaves: tan of it is less than 2^-50.
  friend DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x) {
    const double angle = scalar::detail::own_atan2(y.hi_, x.hi_);
    const auto [s, c] = sine_and_cosine(angle);
    const DoubleDouble across = y * c - x * s, along = x * c + y * s;
    return 0 < along.hi_ ? DoubleDouble(angle) + across / along : DoubleDouble(angle);
  }
  friend std::ostream& operator<<(std::ostream& out, const DoubleDouble& x) { return out << x.hi_; }

  [[nodiscard]] static constexpr DoubleDouble pi() { return {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}; }
  [[nodiscard]] static scalar::SineCosine<DoubleDouble> sine_and_cosine(const DoubleDouble& x);

 private:
  /// The upper 26 bits.
  [[nodiscard, gnu::always_inline]] static constexpr double upper_half(double x) {
    const double shifted = 0x1.0000002p27 * x;
    return shifted - (shifted - x);
  }

  double hi_, lo_ = 0;
};

}  // namespace goishi

template <>
class std::numeric_limits<goishi::DoubleDouble> {
 public:
  using T = goishi::DoubleDouble;
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false;
  static constexpr bool has_infinity = true, has_quiet_NaN = true;
  static constexpr int digits = 104, digits10 = 30, max_digits10 = 33, radix = 2;
  static constexpr T min() { return numeric_limits<double>::min(); }
  static constexpr T max() { return numeric_limits<double>::max(); }
  static constexpr T lowest() { return numeric_limits<double>::lowest(); }
  static constexpr T epsilon() { return 0x1p-103; }
  static constexpr T infinity() { return numeric_limits<double>::infinity(); }
  // NOLINTNEXTLINE(readability-identifier-naming): the standard's name
  static constexpr T quiet_NaN() { return numeric_limits<double>::quiet_NaN(); }
};

namespace goishi {

/// x = k π/2 + r, and Taylor's series of r, its first terms in twice the digits.
inline scalar::SineCosine<DoubleDouble> DoubleDouble::sine_and_cosine(const DoubleDouble& x) {
  if (!(std::fabs(x.hi_) <= std::numeric_limits<double>::max())) {
    return {x.hi_ - x.hi_, x.hi_ - x.hi_};
  }
  double k = 0;
  DoubleDouble r;
  if (std::fabs(x.hi_) < 0x1p18) {
    k = std::floor(x.hi_ * 0x1.45f306dc9c883p-1 + 0.5);
    // 31, 32, 53 and 53 bits of π/2: of the first two, k times is exact.
    r = sum(x.hi_ - k * 0x1.921fb544p+0, -(k * 0x1.0b4611a6p-34)) - product(k, 0x1.3198a2e037073p-69);
    r = r - k * 0x1.129024e088a68p-123 + x.lo_;
  } else if (x.lo_ != 0) {  // which may be many turns
    const auto [s, c] = sine_and_cosine(x.hi_);
    const auto [s_lo, c_lo] = sine_and_cosine(x.lo_);
    return {.sin = s * c_lo + c * s_lo, .cos = c * c_lo - s * s_lo};
  } else {
    const auto far = scalar::detail::reduced_far(x.hi_);
    k = far.k;
    r = ordered_sum(far.r, far.l);
  }
  const DoubleDouble z = r * r;
  const double w = z.hi_;
  // 1/3!, 1/5!, 1/7! and 1/2! … 1/8! in twice the digits, by division; what follows in double.
  constexpr DoubleDouble one = 1;
  constexpr DoubleDouble s3 = one / 6, s5 = one / 120, s7 = one / 5040, c2 = 0.5, c4 = one / 24, c6 = one / 720,
                         c8 = one / 40320;
  const double s9 = 1.0 / 362880 * (1 - w / 110 * (1 - w / 156 * (1 - w / 210 * (1 - w / 272 * (1 - w / 342)))));
  const double c10 = 1.0 / 3628800 * (1 - w / 132 * (1 - w / 182 * (1 - w / 240 * (1 - w / 306 * (1 - w / 380)))));
  const DoubleDouble s = r - r * z * (s3 - z * (s5 - z * (s7 - z * s9)));
  const DoubleDouble c = one - z * (c2 - z * (c4 - z * (c6 - z * (c8 - z * c10))));
  switch (static_cast<int>(k - 4 * std::floor(k / 4))) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

namespace scalar::detail {

[[nodiscard]] inline SineCosine<DoubleDouble> sincos(const DoubleDouble& x) {
  return DoubleDouble::sine_and_cosine(x);
}
[[nodiscard]] inline DoubleDouble own_atan2(const DoubleDouble& y, const DoubleDouble& x) {
  return atan2(y, x);
}

}  // namespace scalar::detail

}  // namespace goishi
