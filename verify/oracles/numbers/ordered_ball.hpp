#pragma once
/// \file
/// Balls that answer <, so that whole algorithms run on them, choices and all. Where the balls prove the answer it is
/// given. Where they do not, at a switch, both answers are: `every_outcome` runs the algorithm once for each.

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify {

/// How comparisons that the balls do not decide are answered, in this thread: outside `every_outcome`, not at all.
struct Undecided {
  static constexpr unsigned most_open = 8;
  bool exploring = false;
  unsigned answers = 0;  // bit i: to the i-th one
  unsigned asked = 0;

  static Undecided& now() {
    thread_local Undecided state;
    return state;
  }
  bool answer() {
    if (!exploring || most_open <= asked) {
      throw std::runtime_error("a comparison that balls do not decide");
    }
    return ((answers >> asked++) & 1U) != 0;
  }
};

class OrderedBall {
 public:
  OrderedBall() = default;
  OrderedBall(int n) : ball_(n) {}  // NOLINT(google-explicit-constructor): exact
  explicit OrderedBall(double x) : ball_(x) {}
  explicit OrderedBall(const Ball& ball) : ball_(ball) {}

  using Self = OrderedBall;
  friend Self operator+(const Self& x, const Self& y) { return Self(x.ball_ + y.ball_); }
  friend Self operator-(const Self& x, const Self& y) { return Self(x.ball_ - y.ball_); }
  friend Self operator*(const Self& x, const Self& y) { return Self(x.ball_ * y.ball_); }
  friend Self operator/(const Self& x, const Self& y) { return Self(x.ball_ / y.ball_); }
  friend Self operator-(const Self& x) { return Self(-x.ball_); }
  Self& operator+=(const Self& y) { return *this = *this + y; }
  Self& operator-=(const Self& y) { return *this = *this - y; }
  Self& operator*=(const Self& y) { return *this = *this * y; }
  Self& operator/=(const Self& y) { return *this = *this / y; }
  /// What of the ball is negative is no number that a root is taken of: a sum of squares next to 0. NaN if all of it is.
  friend Self sqrt(const Self& x) {
    Ball result;
    arb_sqrtpos(result.get(), x.ball_.get(), Ball::precision);
    return Self(result);
  }
  friend Self sin(const Self& x) { return Self(sin(x.ball_)); }
  friend Self cos(const Self& x) { return Self(cos(x.ball_)); }
  friend Self atan2(const Self& y, const Self& x) { return Self(atan2(y.ball_, x.ball_)); }
  friend Self abs(const Self& x) {
    Ball result;
    arb_abs(result.get(), x.ball_.get());
    return Self(result);
  }
  friend Self floor(const Self& x) {
    Ball result;
    arb_floor(result.get(), x.ball_.get(), Ball::precision);
    return Self(result);
  }

  friend bool operator<(const Self& x, const Self& y) {
    return decided(arb_lt(x.ball_.get(), y.ball_.get()), arb_ge(x.ball_.get(), y.ball_.get()));
  }
  friend bool operator<=(const Self& x, const Self& y) {
    return decided(arb_le(x.ball_.get(), y.ball_.get()), arb_gt(x.ball_.get(), y.ball_.get()));
  }
  friend bool operator>(const Self& x, const Self& y) { return y < x; }
  friend bool operator>=(const Self& x, const Self& y) { return y <= x; }
  friend std::ostream& operator<<(std::ostream& out, const Self& x) { return out << static_cast<double>(x.ball_); }

  [[nodiscard]] const Ball& ball() const { return ball_; }
  /// The midpoint, rounded to nearest.
  explicit operator double() const { return static_cast<double>(ball_); }

 private:
  static bool decided(int yes, int no) { return yes != 0 || (no == 0 && Undecided::now().answer()); }
  Ball ball_;
};

/// While it lives, undecided comparisons are answered; then as before.
class Exploration {
 public:
  Exploration() = default;
  Exploration(const Exploration&) = delete;
  Exploration& operator=(const Exploration&) = delete;
  ~Exploration() { Undecided::now() = before_; }

  static void start(unsigned answers) { Undecided::now() = {.exploring = true, .answers = answers, .asked = 0}; }

 private:
  Undecided before_ = Undecided::now();
};

/// What f returns for each way to answer the comparisons that the balls leave open; one result where they leave none.
/// Throws where one run leaves more than `Undecided::most_open` open.
template <class F>
[[nodiscard]] auto every_outcome(F&& f) {
  const Exploration exploration;
  std::vector<std::invoke_result_t<F>> results;
  unsigned open = 0;
  for (unsigned answers = 0; (answers >> open) == 0; ++answers) {
    Exploration::start(answers);
    results.push_back(f());
    open = std::max(open, Undecided::now().asked);
  }
  return results;
}

}  // namespace goishi::verify

/// 256 bits: |q|² = 1 holds to a few units of 2⁻²⁵⁶, `unit_tolerance` is 64 epsilons.
template <>
struct std::numeric_limits<goishi::verify::OrderedBall> {
  static constexpr bool is_specialized = true;
  static constexpr bool has_quiet_NaN = false;
  static constexpr int digits10 = 75;
  static goishi::verify::OrderedBall epsilon() { return power_of_two(-250); }
  static goishi::verify::OrderedBall min() { return power_of_two(-100000); }
  static goishi::verify::OrderedBall max() { return power_of_two(100000); }

 private:
  static goishi::verify::OrderedBall power_of_two(int exponent) {
    goishi::verify::Ball result(1);
    arb_mul_2exp_si(result.get(), result.get(), exponent);
    return goishi::verify::OrderedBall(result);
  }
};

template <>
struct Eigen::NumTraits<goishi::verify::OrderedBall> {
  using Real = goishi::verify::OrderedBall;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = HugeCost,
    AddCost = HugeCost,
    MulCost = HugeCost
  };
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real dummy_precision() { return Real(0); }
  static int digits10() { return std::numeric_limits<Real>::digits10; }
};
