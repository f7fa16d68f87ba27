#pragma once
/// \file
/// What the tests of surface, board and contact share: stones whose numbers can be done by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <goishi/board/board.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/error.hpp>
#include <goishi/shape/stone.hpp>
#include <limits>
#include <string>

#include "tests/expectations.hpp"

namespace goishi::contact_test {

using test::expect_invalid;
using test::expect_near;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Scalars = testing::Types<float, double, long double>;

/// w = 8, h = 4: r = 5, d = 3, rim radius 4; the joint's normal is (4, 3)/5.
template <class T = double>
[[nodiscard]] Stone<T> sharp() {
  return make_stone(T(8), T(4));
}

/// The same with b = 2: r₁ = 9/4, r₂ = 5/4, so 7 wide; cap and bevel join at (3, 1), with the normal (3, 4)/5.
template <class T = double>
[[nodiscard]] Stone<T> bevelled() {
  return make_stone(T(8), T(4), T(2));
}

/// 100 × 120 × 30, its corner at (50, 60, 0).
template <class T = double>
[[nodiscard]] Board<T> board() {
  return {.lines = 2,
          .spacing_x = T(80),
          .spacing_y = T(100),
          .half_width = T(50),
          .half_length = T(60),
          .thickness = T(30),
          .floor = T(-30)};
}

template <class T>
[[nodiscard]] Vec3<T> vec(long double x, long double y, long double z) {
  return {T(x), T(y), T(z)};
}

/// u = Bz in W.
template <class T>
[[nodiscard]] Pose<T> lying(long double x, long double y, long double z) {
  return {.p_WB = vec<T>(x, y, z), .q_WB = Quat<T>(T(1), T(0), T(0), T(0))};
}

/// The axis is −Wy, up to round-off.
template <class T>
[[nodiscard]] Pose<T> standing(long double x, long double y, long double z) {
  using std::sqrt;
  const T half = sqrt(T(1) / T(2));
  return {.p_WB = vec<T>(x, y, z), .q_WB = Quat<T>(half, half, T(0), T(0))};
}

/// The axis leans by an angle with this cosine from z towards x.
template <class T>
[[nodiscard]] Pose<T> leaning(const T& cosine, long double x, long double y, long double z) {
  using std::sqrt;
  return {.p_WB = vec<T>(x, y, z),
          .q_WB = Quat<T>(sqrt((T(1) + cosine) / T(2)), T(0), sqrt((T(1) - cosine) / T(2)), T(0))};
}

/// Calls with each component of a good vector replaced by NaN, ∞ and −∞, and with ∞ − ∞.
template <class Call>
void with_each_bad(const Vec3<double>& good, Call&& call) {
  for (int i = 0; i < 3; ++i) {
    for (const double value : {nan, infinity, -infinity}) {
      Vec3<double> bad = good;
      bad[i] = value;
      call(bad);
    }
  }
  call(Vec3<double>(infinity, -infinity, 0.0));
}

/// Calls with directions that are none.
template <class Call>
void with_each_bad_direction(Call&& call) {
  with_each_bad({0.0, 0.0, 1.0}, call);
  call(Vec3<double>(0.0, 0.0, 0.0));
  call(Vec3<double>(1.0, 1.0, 0.0));
  call(Vec3<double>(0.6, 0.0, 0.8000001));
}

/// Expects every bad pose to be refused.
inline void expect_bad_poses_refused(const std::function<void(const Pose<double>&)>& call) {
  with_each_bad({1.0, 2.0, 3.0}, [&](const Vec3<double>& bad) {
    expect_invalid("position", [&] { call({.p_WB = bad, .q_WB = Quat<double>(1.0, 0.0, 0.0, 0.0)}); });
  });
  for (int i = 0; i < 4; ++i) {
    for (const double value : {nan, infinity, 2.0}) {
      Pose<double> bad{.p_WB = {1.0, 2.0, 3.0}, .q_WB = Quat<double>(0.5, 0.5, 0.5, 0.5)};
      bad.q_WB.coeffs()[i] = value;
      expect_invalid("attitude", [&] { call(bad); });
    }
  }
  expect_invalid("attitude", [&] { call({.p_WB = {1.0, 2.0, 3.0}, .q_WB = Quat<double>(0.0, 0.0, 0.0, 0.0)}); });
  expect_invalid("position", [&] { call({}); });
}

}  // namespace goishi::contact_test
