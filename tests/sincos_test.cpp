/// Sine, cosine and arctangent of our own: what is exact of them.

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <goishi/scalar.hpp>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace {

using goishi::scalar::SineCosine;
namespace scalar = goishi::scalar;

template <class T>
class Sincos : public testing::Test {
 protected:
  /// Of every size, those that are seldom among them.
  static std::vector<T> angles() {
    std::vector<T> result{T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::max(), T(8192),
                          T(0x1p18)};
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> power(-20, 60), small(-100, 100);
    for (int i = 0; i < 2000; ++i) {
      const double size = i % 8 == 0 ? std::exp2(power(random)) : small(random);
      result.push_back(static_cast<T>(i % 2 == 0 ? size : -size));
    }
    return result;
  }
};
using Types = testing::Types<float, double>;
TYPED_TEST_SUITE(Sincos, Types, );

template <class T>
void expect_same(const SineCosine<T>& given, const SineCosine<T>& expected) {
  EXPECT_EQ(given.sin, expected.sin);
  EXPECT_EQ(given.cos, expected.cos);
}

TYPED_TEST(Sincos, OfNothingAndOfNoNumber) {
  using T = TypeParam;
  expect_same(scalar::sincos(T(0)), {.sin = T(0), .cos = T(1)});
  for (const T x :
       {std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(scalar::sin(x)));
    EXPECT_TRUE(std::isnan(scalar::cos(x)));
    EXPECT_TRUE(std::isnan(scalar::sincos(x, T(1))[0].sin));
    EXPECT_EQ(scalar::sincos(x, T(1))[1].sin, scalar::sin(T(1)));
  }
}

TYPED_TEST(Sincos, OddAndEven) {
  for (const TypeParam x : this->angles()) {
    const auto there = scalar::sincos(x), back = scalar::sincos(-x);
    EXPECT_EQ(there.sin, -back.sin) << x;
    EXPECT_EQ(there.cos, back.cos) << x;
  }
}

TYPED_TEST(Sincos, TwoAtOnceAndLanesAreThoseOfOne) {
  using T = TypeParam;
  using Lanes = std::experimental::native_simd<T>;
  const std::vector<T> angles = this->angles();
  for (std::size_t i = 0; i + Lanes::size() < angles.size(); ++i) {
    const auto both = scalar::sincos(angles[i], angles[i + 1]);
    const Lanes x([&](std::size_t k) { return angles[i + k]; });
    const auto all = scalar::sincos(x);
    const Lanes direction = scalar::atan2(x, Lanes(T(-3)));
    for (std::size_t k = 0; k < 2; ++k) {
      expect_same(both[k], scalar::sincos(angles[i + k]));
    }
    for (std::size_t k = 0; k < Lanes::size(); ++k) {
      expect_same({T(all.sin[k]), T(all.cos[k])}, scalar::sincos(angles[i + k]));
      EXPECT_EQ(T(direction[k]), scalar::atan2(angles[i + k], T(-3)));
    }
  }
}

TYPED_TEST(Sincos, InEveryRoundingMode) {
  using T = TypeParam;
  for (const T x : this->angles()) {
    const auto nearest = scalar::sincos(x);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const volatile T angle = x;
      const auto other = scalar::sincos(T(angle));
      std::fesetround(FE_TONEAREST);
      EXPECT_NEAR(other.sin, nearest.sin, 2 * std::numeric_limits<T>::epsilon() * std::abs(nearest.sin)) << x;
      EXPECT_NEAR(other.cos, nearest.cos, 2 * std::numeric_limits<T>::epsilon() * std::abs(nearest.cos)) << x;
    }
  }
}

TYPED_TEST(Sincos, ArctangentAsTheStandardHasIt) {
  using T = TypeParam;
  const T boundless = std::numeric_limits<T>::infinity();
  const std::vector<T> ends = {T(0),
                               T(-0.0),
                               T(1),
                               T(-1),
                               boundless,
                               -boundless,
                               T(1e-30),
                               T(-1e30),
                               std::numeric_limits<T>::denorm_min(),
                               std::numeric_limits<T>::max(),
                               std::numeric_limits<T>::lowest()};
  for (const T y : ends) {
    for (const T x : ends) {
      const T given = scalar::atan2(y, x), expected = std::atan2(y, x);
      EXPECT_NEAR(given, expected, 2 * std::numeric_limits<T>::epsilon() * std::abs(expected)) << y << ' ' << x;
      EXPECT_EQ(std::signbit(given), std::signbit(expected)) << y << ' ' << x;
    }
    EXPECT_TRUE(std::isnan(scalar::atan2(y, std::numeric_limits<T>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(scalar::atan2(std::numeric_limits<T>::quiet_NaN(), y)));
  }
}

}  // namespace
