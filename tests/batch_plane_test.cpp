/// Many stones and a plane at once: each gap is what it would be alone.

#include <gtest/gtest.h>

#include <goishi/contact/batch_plane.hpp>
#include <random>
#include <vector>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

template <class T>
class BatchOfPlaneGaps : public testing::Test {};
using BatchScalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchOfPlaneGaps, BatchScalars);

TYPED_TEST(BatchOfPlaneGaps, AreTheGapsOfEach) {
  using T = TypeParam;
  std::mt19937 bits(20261121);
  const auto some = [&bits] { return static_cast<T>(bits() >> 8) / T(1 << 23) - T(1); };
  const Stone<T> kinds[] = {sharp<T>(), bevelled<T>(), make_stone(T(3), T(3)), make_stone(T(9), T(0.01))};
  const Plane<T> planes[] = {{}, {.n_W = {T(0.6), T(0), T(-0.8)}, .offset = T(3)}};
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 1000U}) {
    std::vector<Pose<T>> poses;
    PlaneBatch<T> batch(count);
    ASSERT_EQ(batch.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      poses.push_back({.p_WB = {some(), some(), some()}, .q_WB = Quat<T>(some(), some(), some(), some()).normalized()});
      batch.set(i, kinds[i % 4], poses[i]);
    }
    int on_rim = 0;
    for (const Plane<T>& plane : planes) {
      std::vector<T> gaps(count, T(nan));
      batch.gaps(plane, gaps);
      for (std::size_t i = 0; i < count; ++i) {
        const Separation<T> alone = separation(kinds[i % 4], poses[i], plane);
        // Both are within 1e-15 of the width, 4.5 ε, of the truth: the poses are nearer than the stones are wide.
        expect_near(gaps[i], alone.gap, T(9) * std::numeric_limits<T>::epsilon() * outer_width(kinds[i % 4]));
        on_rim += alone.feature == Feature::rim ? 1 : 0;
      }
    }
    if (count == 1000) {  // both sides of the mask
      EXPECT_GT(on_rim, 100);
      EXPECT_LT(on_rim, 1900);
    }
  }
}

TYPED_TEST(BatchOfPlaneGaps, OfStonesThatFly) {
  using T = TypeParam;
  const Moments<T> moments{.axial = T(0.5), .transverse = T(0.3)};
  for (const std::size_t count : {0U, 1U, 7U, 9U, 100U}) {
    StoneBatch<T> flying(count);
    PlaneBatch<T> shapes(count), standing(count);
    const Stone<T> kinds[] = {sharp<T>(), bevelled<T>()};
    for (std::size_t i = 0; i < count; ++i) {
      const T x = static_cast<T>(i) / T(100);
      flying.set(i,
                 {.p_WB = {x, T(1) - x, T(2)},
                  .q_WB = Quat<T>(T(1), x, T(0.5), -x).normalized(),
                  .v_WB = {T(1), T(0), x},
                  .L_W = {T(1), x, T(-2)}},
                 moments);
      shapes.set(i, kinds[i % 2]);
    }
    flying.fly(Vec3<T>(T(0), T(0), T(-1)), T(0.25));
    const Plane<T> plane{.n_W = {T(0.6), T(0), T(0.8)}, .offset = T(0.5)};
    std::vector<T> gaps(count), alone(count);
    shapes.gaps(flying, plane, gaps);
    for (std::size_t i = 0; i < count; ++i) {
      const State<T> now = flying.get(i);
      standing.set(i, kinds[i % 2], {.p_WB = now.p_WB, .q_WB = now.q_WB});
    }
    standing.gaps(plane, alone);
    EXPECT_EQ(gaps, alone);
  }
}

TEST(BatchOfPlaneGapsBadInput, IsRefused) {
  expect_invalid("stones", [] {
    std::vector<double> none(3);
    PlaneBatch<double>(3).gaps(StoneBatch<double>(2), Plane<double>{}, none);
  });
  expect_invalid("stone", [] { PlaneBatch<double>(3).set(0, Stone<double>()); });
  expect_invalid("index", [] { PlaneBatch<double>(3).set(3, sharp()); });
  PlaneBatch<double> batch(3);
  std::vector<double> gaps(3);
  expect_invalid("index", [&] { batch.set(3, sharp(), lying<double>(0, 0, 0)); });
  expect_bad_poses_refused([&](const Pose<double>& bad) { batch.set(1, sharp(), bad); });
  with_each_bad_direction([&](const Vec3<double>& bad) {
    expect_invalid("normal", [&] { batch.gaps({bad, 0}, gaps); });
  });
  for (const double bad : {nan, infinity}) {
    expect_invalid("offset", [&] { batch.gaps({.offset = bad}, gaps); });
  }
  std::vector<double> few(2);
  expect_invalid("gaps", [&] { batch.gaps({}, few); });
  batch.set(2, sharp(), lying<double>(0, 0, 5));
  batch.gaps({}, gaps);
  EXPECT_TRUE(std::isnan(gaps[0]) && std::isnan(gaps[1]));  // not set
  EXPECT_EQ(gaps[2], 3.0);
}

}  // namespace
}  // namespace goishi::contact_test
