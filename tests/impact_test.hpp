#pragma once
/// \file
/// What the tests of impacts share: bodies whose numbers can be done by hand.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <goishi/impact/laws.hpp>
#include <limits>
#include <string>

#include "tests/expectations.hpp"

namespace goishi::impact_test {

using test::expect_invalid;
using test::expect_near;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Scalars = testing::Types<float, double, long double>;

inline constexpr std::array all_laws = {ImpactLaw::chatterjee_ruina, ImpactLaw::published, ImpactLaw::stronge};

template <class T = double>
[[nodiscard]] Vec3<T> vec(long double x, long double y, long double z) {
  return {T(x), T(y), T(z)};
}

template <class T>
[[nodiscard]] Vec3<T> up() {
  return vec<T>(0, 0, 1);
}

/// A solid ball of mass 2 and radius 1, its centre at (0, 0, 1), so that it touches the plane at the origin.
template <class T = double>
[[nodiscard]] ImpactBody<T> ball(const Vec3<T>& v_WB, const Vec3<T>& L_W = vec<T>(0, 0, 0)) {
  return {.mobility = make_mobility(T(2), Moments<T>{.axial = T(0.8L), .transverse = T(0.8L)}),
          .p_WB = vec<T>(0, 0, 1),
          .u_W = vec<T>(0.6L, 0, 0.8L),
          .v_WB = v_WB,
          .L_W = L_W};
}

/// Mass 1, both moments 2, its centre at (−1, 0, 1): at the origin W = (3/2, 0, 1/2; 0, 2, 0; 1/2, 0, 3/2).
template <class T = double>
[[nodiscard]] ImpactBody<T> off_centre(const Vec3<T>& v_WB) {
  return {.mobility = make_mobility(T(1), Moments<T>{.axial = T(2), .transverse = T(2)}),
          .p_WB = vec<T>(-1, 0, 1),
          .u_W = up<T>(),
          .v_WB = v_WB,
          .L_W = vec<T>(0, 0, 0)};
}

/// Meets the plane z = 0 at the origin.
template <class T>
[[nodiscard]] Impact<T> on_plane(ImpactLaw law, long double restitution, long double friction,
                                 const ImpactBody<T>& body) {
  return resolve(law, make_material(T(restitution), T(friction)), vec<T>(0, 0, 0), up<T>(), body);
}

}  // namespace goishi::impact_test
