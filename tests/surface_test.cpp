/// The surface of a stone: support, closest point, ray; by hand.

#include <gtest/gtest.h>

#include <goishi/shape/ray.hpp>
#include <goishi/shape/surface.hpp>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

template <class T>
class Surface : public testing::Test {
 protected:
  // 1e-15 of the width in double, which is documented, as a multiple of ε.
  static T close() { return T(9) / T(2) * std::numeric_limits<T>::epsilon() * T(8); }
  static T close_on_ray() { return T(10) * close(); }

  static void expect_support(const Stone<T>& stone, const Vec3<T>& n, long double value, const Vec3<T>& p,
                             Feature feature) {
    const Support<T> found = support(stone, n);
    expect_near(found.value, T(value), close());
    expect_near(found.p_B, p, close());
    EXPECT_EQ(found.feature, feature) << n.transpose();
  }

  static void expect_closest(const Stone<T>& stone, const Vec3<T>& from, long double distance, const Vec3<T>& p,
                             const Vec3<T>& normal, Feature feature, bool unique = true) {
    const SurfacePoint<T> found = closest_point(stone, from);
    const T size = close() * (T(1) + from.norm() / T(8));
    expect_near(found.distance, T(distance), size);
    expect_near(found.p_B, p, size);
    expect_near(found.normal_B, normal, size);
    EXPECT_EQ(found.feature, feature) << from.transpose();
    EXPECT_EQ(found.unique, unique) << from.transpose();
    EXPECT_EQ(signed_distance(stone, from), found.distance);
    EXPECT_EQ(is_inside(stone, from), found.distance <= T(0));
  }
};
TYPED_TEST_SUITE(Surface, Scalars);

TYPED_TEST(Surface, SupportOfTheSharpStone) {
  using T = TypeParam;
  const Stone<T> stone = sharp<T>();
  const T fifth = T(1) / T(5);
  this->expect_support(stone, vec<T>(0, 0, 1), 2, vec<T>(0, 0, 2), Feature::upper_cap);
  this->expect_support(stone, vec<T>(0, 0, -1), 2, vec<T>(0, 0, -2), Feature::lower_cap);
  this->expect_support(stone, vec<T>(1, 0, 0), 4, vec<T>(4, 0, 0), Feature::rim);
  this->expect_support(stone, vec<T>(0, -1, 0), 4, vec<T>(0, -4, 0), Feature::rim);
  // On the sphere about (0, 0, ∓3): r n ∓ d z.
  this->expect_support(stone, {T(3) * fifth, T(0), T(4) * fifth}, 2.6L, vec<T>(3, 0, 1), Feature::upper_cap);
  this->expect_support(stone, {T(0), T(-3) * fifth, T(-4) * fifth}, 2.6L, vec<T>(0, -3, -1), Feature::lower_cap);
  // More radial than the joint.
  this->expect_support(stone, {T(24) / T(25), T(0), T(7) / T(25)}, 3.84L, vec<T>(4, 0, 0), Feature::rim);
}

TYPED_TEST(Surface, SupportOfTheBevelledStone) {
  using T = TypeParam;
  const Stone<T> stone = bevelled<T>();
  this->expect_support(stone, vec<T>(0, 0, 1), 2, vec<T>(0, 0, 2), Feature::upper_cap);
  this->expect_support(stone, vec<T>(0, 1, 0), 3.5L, vec<T>(0, 3.5L, 0), Feature::rim);
  this->expect_support(stone, {T(7) / T(25), T(0), T(24) / T(25)}, 2.12L, vec<T>(1.4L, 0, 1.8L), Feature::upper_cap);
  // r₁ n_r + r₂, and the point on the torus.
  this->expect_support(stone, {T(24) / T(25), T(0), T(-7) / T(25)}, 3.41L, vec<T>(3.45L, 0, -0.35L), Feature::rim);
}

TYPED_TEST(Surface, SupportOfTheBallIsItsRadius) {
  using T = TypeParam;
  for (const Stone<T>& ball : {make_stone(T(4), T(4)), make_stone(T(4), T(4), T(1))}) {
    for (const Vec3<T>& n : {vec<T>(0, 0, 1), vec<T>(1, 0, 0), Vec3<T>(T(3) / T(5), T(0), T(-4) / T(5))}) {
      const Support<T> found = support(ball, n);
      expect_near(found.value, T(2), this->close());
      expect_near(found.p_B, Vec3<T>(T(2) * n), this->close());
    }
  }
}

TYPED_TEST(Surface, ClosestPointFromOutside) {
  using T = TypeParam;
  const Stone<T> stone = sharp<T>();
  this->expect_closest(stone, vec<T>(0, 0, 5), 3, vec<T>(0, 0, 2), vec<T>(0, 0, 1), Feature::upper_cap);
  this->expect_closest(stone, vec<T>(0, 0, -5), 3, vec<T>(0, 0, -2), vec<T>(0, 0, -1), Feature::lower_cap);
  this->expect_closest(stone, vec<T>(6, 0, 5), 5, vec<T>(3, 0, 1), vec<T>(0.6L, 0, 0.8L), Feature::upper_cap);
  this->expect_closest(stone, vec<T>(0, 7, 0), 3, vec<T>(0, 4, 0), vec<T>(0, 1, 0), Feature::rim);
  this->expect_closest(stone, vec<T>(16, 0, -5), 13, vec<T>(4, 0, 0), Vec3<T>(T(12) / T(13), T(0), T(-5) / T(13)),
                       Feature::rim);
  this->expect_closest(bevelled<T>(), vec<T>(5.25L, 0, 4), 3.75L, vec<T>(3, 0, 1), vec<T>(0.6L, 0, 0.8L),
                       Feature::upper_cap);
  this->expect_closest(bevelled<T>(), vec<T>(14.25L, 0, 5), 11.75L, Vec3<T>(T(9) / 4 + T(15) / 13, T(0), T(25) / 52),
                       Vec3<T>(T(12) / T(13), T(0), T(5) / T(13)), Feature::rim);
}

TYPED_TEST(Surface, ClosestPointFromInside) {
  using T = TypeParam;
  const Stone<T> stone = sharp<T>();
  this->expect_closest(stone, vec<T>(0, 0, 1), -1, vec<T>(0, 0, 2), vec<T>(0, 0, 1), Feature::upper_cap);
  // 4 from (0, 0, 3), the centre of the lower cap's sphere.
  this->expect_closest(stone, vec<T>(2.4L, 0, -0.2L), -1, vec<T>(3, 0, -1), vec<T>(0.6L, 0, -0.8L), Feature::lower_cap);
  this->expect_closest(bevelled<T>(), vec<T>(3, 0, 0), -0.5L, vec<T>(3.5L, 0, 0), vec<T>(1, 0, 0), Feature::rim);
}

TYPED_TEST(Surface, ClosestPointThatIsNotUnique) {
  using T = TypeParam;
  // The middle plane, its centre, the sharp edge, a ball's centre: one of the answers, and that there are others.
  this->expect_closest(sharp<T>(), vec<T>(2.25L, 0, 0), -1.25L, vec<T>(3, 0, 1), vec<T>(0.6L, 0, 0.8L),
                       Feature::upper_cap, false);
  this->expect_closest(sharp<T>(), vec<T>(0, 0, 0), -2, vec<T>(0, 0, 2), vec<T>(0, 0, 1), Feature::upper_cap, false);
  EXPECT_FALSE(closest_point(sharp<T>(), vec<T>(0, 4, 0)).unique);
  expect_near(signed_distance(sharp<T>(), vec<T>(0, 4, 0)), T(0), this->close());
  this->expect_closest(make_stone(T(4), T(4)), vec<T>(0, 0, 0), -2, vec<T>(0, 0, 2), vec<T>(0, 0, 1),
                       Feature::upper_cap, false);
  this->expect_closest(make_stone(T(4), T(4)), vec<T>(1, 0, 0), -1, vec<T>(2, 0, 0), vec<T>(1, 0, 0),
                       Feature::upper_cap);
}

TYPED_TEST(Surface, InsideReachesToTheSurface) {
  using T = TypeParam;
  const Stone<T> stone = sharp<T>();
  EXPECT_TRUE(is_inside(stone, vec<T>(0, 0, 2)));
  EXPECT_TRUE(is_inside(stone, vec<T>(4, 0, 0)));
  EXPECT_FALSE(is_inside(stone, vec<T>(0, 0, 2.001L)));
  EXPECT_FALSE(is_inside(stone, vec<T>(0, -4.001L, 0)));
  EXPECT_FALSE(is_inside(stone, vec<T>(3.9L, 0, 0.5L)));  // 5.24 from (0, 0, −3)
}

// --- rays

TYPED_TEST(Surface, RayDownAChord) {
  using T = TypeParam;
  const RayHit<T> ray = cast_ray(sharp<T>(), vec<T>(3, 0, 5), vec<T>(0, 0, -1));
  EXPECT_TRUE(ray.hit && ray.forward);
  expect_near(ray.entry, T(4), this->close_on_ray());
  expect_near(ray.exit, T(6), this->close_on_ray());
  EXPECT_EQ(ray.first, ray.entry);
  expect_near(ray.surface.p_B, vec<T>(3, 0, 1), this->close_on_ray());
  expect_near(ray.surface.normal_B, vec<T>(0.6L, 0, 0.8L), this->close_on_ray());
  EXPECT_EQ(ray.surface.feature, Feature::upper_cap);
}

TYPED_TEST(Surface, RayThroughTheBevel) {
  using T = TypeParam;
  // At the height 7/20 the torus is 9/4 + √((5/4)² − (7/20)²) = 69/20 wide.
  const RayHit<T> ray = cast_ray(bevelled<T>(), vec<T>(-10, 0, 0.35L), vec<T>(1, 0, 0));
  EXPECT_TRUE(ray.hit && ray.forward);
  expect_near(ray.entry, T(6.55L), this->close_on_ray());
  expect_near(ray.exit, T(13.45L), this->close_on_ray());
  expect_near(ray.surface.normal_B, vec<T>(-0.96L, 0, 0.28L), this->close_on_ray());
  EXPECT_EQ(ray.surface.feature, Feature::rim);
}

TYPED_TEST(Surface, RayFromInsideHitsWhereItLeaves) {
  using T = TypeParam;
  const RayHit<T> ray = cast_ray(sharp<T>(), vec<T>(0, 0, 1), vec<T>(0, 0, -1));
  EXPECT_TRUE(ray.hit && ray.forward);
  expect_near(ray.entry, T(-1), this->close_on_ray());
  EXPECT_EQ(ray.first, ray.exit);
  expect_near(ray.exit, T(3), this->close_on_ray());
  expect_near(ray.surface.normal_B, vec<T>(0, 0, -1), this->close_on_ray());
}

TYPED_TEST(Surface, RayThatLeavesTheStoneBehind) {
  using T = TypeParam;
  const RayHit<T> ray = cast_ray(sharp<T>(), vec<T>(0, 0, 5), vec<T>(0, 0, 1));
  EXPECT_TRUE(ray.hit);
  EXPECT_FALSE(ray.forward);
  expect_near(ray.entry, T(-7), this->close_on_ray());
  expect_near(ray.exit, T(-3), this->close_on_ray());
  EXPECT_TRUE(std::isnan(ray.first));
}

TYPED_TEST(Surface, RayThatMisses) {
  using T = TypeParam;
  for (const Stone<T>& stone : {sharp<T>(), bevelled<T>()}) {
    EXPECT_FALSE(cast_ray(stone, vec<T>(-10, 0, 2.001L), vec<T>(1, 0, 0)).hit);
    EXPECT_FALSE(cast_ray(stone, vec<T>(4.001L, 0, 9), vec<T>(0, 0, -1)).hit);
    EXPECT_FALSE(cast_ray(stone, vec<T>(4.2L, 0, 0), vec<T>(0.6L, 0, -0.8L)).hit);  // 5.16 from (0, 0, −3)
  }
  EXPECT_TRUE(cast_ray(sharp<T>(), vec<T>(3.999L, 0, 9), vec<T>(0, 0, -1)).hit);
}

// --- errors of the caller

TEST(SurfaceBadInput, PointsAndDirections) {
  const Stone<double> stone = bevelled();
  const Vec3<double> up(0.0, 0.0, 1.0);
  with_each_bad({1.0, 2.0, 3.0}, [&](const Vec3<double>& bad) {
    expect_invalid("point", [&] { (void)closest_point(stone, bad); });
    expect_invalid("point", [&] { (void)signed_distance(stone, bad); });
    expect_invalid("point", [&] { (void)is_inside(stone, bad); });
    expect_invalid("start", [&] { (void)cast_ray(stone, bad, up); });
  });
  with_each_bad_direction([&](const Vec3<double>& bad) {
    expect_invalid("normal", [&] { (void)support(stone, bad); });
    expect_invalid("direction", [&] { (void)cast_ray(stone, up, bad); });
  });
}

TEST(SurfaceText, NamesTheFeatures) {
  EXPECT_EQ(to_string(Feature::upper_cap), "upper cap");
  EXPECT_EQ(to_string(Feature::lower_cap), "lower cap");
  EXPECT_EQ(to_string(Feature::rim), "rim");
}

}  // namespace
}  // namespace goishi::contact_test
