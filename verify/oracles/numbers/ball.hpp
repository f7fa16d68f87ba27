#pragma once
/// \file
/// Arb's real balls as a scalar: midpoint ± radius, guaranteed to contain the exact result. Elementary, not Ordered.

#include <arb.h>

#include <string>

namespace goishi::verify {

class Ball {
 public:
  /// 256 bits, 77 decimal digits.
  static constexpr slong precision = 256;

  Ball() { arb_init(value_); }
  Ball(int n) : Ball() { arb_set_si(value_, n); }  // NOLINT(google-explicit-constructor): exact
  explicit Ball(double x) : Ball() { arb_set_d(value_, x); }
  explicit Ball(float x) : Ball(static_cast<double>(x)) {}
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  /// The enclosure of a decimal string: "0.1" contains one tenth.
  [[nodiscard]] static Ball from_decimal(const std::string& text) {
    Ball result;
    arb_set_str(result.value_, text.c_str(), precision);
    return result;
  }

  friend Ball operator+(const Ball& x, const Ball& y) { return apply(arb_add, x, y); }
  friend Ball operator-(const Ball& x, const Ball& y) { return apply(arb_sub, x, y); }
  friend Ball operator*(const Ball& x, const Ball& y) { return apply(arb_mul, x, y); }
  friend Ball operator/(const Ball& x, const Ball& y) { return apply(arb_div, x, y); }
  friend Ball operator-(const Ball& x) {
    Ball result;
    arb_neg(result.value_, x.value_);
    return result;
  }
  friend Ball sqrt(const Ball& x) { return apply(arb_sqrt, x); }
  friend Ball sin(const Ball& x) { return apply(arb_sin, x); }
  friend Ball cos(const Ball& x) { return apply(arb_cos, x); }
  friend Ball atan2(const Ball& y, const Ball& x) { return apply(arb_atan2, y, x); }
  bool operator<(const Ball&) const = delete;

  [[nodiscard]] arb_srcptr get() const { return value_; }
  [[nodiscard]] arb_ptr get() { return value_; }

  /// The midpoint, rounded to nearest.
  explicit operator double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  explicit operator float() const { return static_cast<float>(static_cast<double>(*this)); }

  /// Proved: false where the ball leaves it open.
  [[nodiscard]] bool is_positive() const { return arb_is_positive(value_) != 0; }
  [[nodiscard]] bool is_negative() const { return arb_is_negative(value_) != 0; }
  [[nodiscard]] bool is_finite() const { return arb_is_finite(value_) != 0; }
  [[nodiscard]] bool overlaps(const Ball& other) const { return arb_overlaps(value_, other.value_) != 0; }
  /// Radius over midpoint.
  [[nodiscard]] double relative_radius() const {
    Ball radius, ratio;
    arb_get_rad_arb(radius.value_, value_);
    arb_t middle;
    arb_init(middle);
    arb_get_mid_arb(middle, value_);
    arb_abs(middle, middle);
    arb_div(ratio.value_, radius.value_, middle, precision);
    arb_clear(middle);
    return static_cast<double>(ratio);
  }

 private:
  static Ball apply(void (*function)(arb_t, const arb_t, const arb_t, slong), const Ball& x, const Ball& y) {
    Ball result;
    function(result.value_, x.value_, y.value_, precision);
    return result;
  }
  static Ball apply(void (*function)(arb_t, const arb_t, slong), const Ball& x) {
    Ball result;
    function(result.value_, x.value_, precision);
    return result;
  }

  arb_t value_;
};

}  // namespace goishi::verify
