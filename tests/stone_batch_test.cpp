/// Many stones at once: each flies as it would alone.

#include <gtest/gtest.h>

#include <goishi/motion/batch.hpp>
#include <goishi/motion/free_flight.hpp>
#include <random>
#include <vector>

#include "tests/motion_test.hpp"

namespace goishi::motion_test {

namespace {

constexpr unsigned seed = 20261121;

template <class T>
struct Stone {
  State<T> state;
  Moments<T> moments;
};

/// Stones with spins of up to 100 rad/s; the flattest is a lamina, the longest a ball.
template <class T>
std::vector<Stone<T>> some_stones(std::size_t count) {
  std::mt19937 bits(seed);
  const auto some = [&bits] { return T(2) * static_cast<T>(bits() >> 8) / T(1 << 24) - T(1); };
  const auto some_vector = [&some](T size) { return Vec3<T>(size * some(), size * some(), size * some()); };
  std::vector<Stone<T>> stones;
  for (std::size_t i = 0; i < count; ++i) {
    const T transverse = T(1e-7) * (T(2) + some());
    const Moments<T> moments{.axial = transverse * (T(3) + some()) / T(2), .transverse = transverse};
    const Quat<T> q = Quat<T>(some(), some(), some(), T(2) + some()).normalized();
    stones.push_back({.state = {.p_WB = some_vector(T(1)),
                                .q_WB = q,
                                .v_WB = some_vector(T(3)),
                                .L_W = some_vector(T(100) * transverse)},
                      .moments = moments});
  }
  return stones;
}

template <class T>
class Batch : public testing::Test {};
using BatchScalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Batch, BatchScalars);

TYPED_TEST(Batch, FliesEachStoneAsIfAlone) {
  using T = TypeParam;
  const T epsilon = std::numeric_limits<T>::epsilon();
  const Vec3<T> g = gravity_W<T>();
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 15U, 16U, 17U, 33U}) {
    const std::vector<Stone<T>> stones = some_stones<T>(count);
    StoneBatch<T> batch(count);
    ASSERT_EQ(batch.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      batch.set(i, stones[i].state, stones[i].moments);
    }
    for (const T& t : {T(0), T(0.25), T(-2)}) {
      StoneBatch<T> flown = batch;
      flown.fly(g, t);
      for (std::size_t i = 0; i < count; ++i) {
        const Stone<T>& stone = stones[i];
        const State<T> one = free_flight(stone.state, stone.moments, g, t);
        const State<T> lane = flown.get(i);
        // Both are within the documented error of the truth.
        EXPECT_LE(angle_between(lane.q_WB, one.q_WB), 2 * flight_bound(stone.state, stone.moments, t)) << i;
        EXPECT_NO_THROW(require_state(lane)) << i;
        EXPECT_EQ(lane.L_W, stone.state.L_W) << i;
        // p + t (v + g t/2): two roundings of each product and sum, none above 1 + |t| (6 + 10 |t|) in size.
        const T size = T(1) + std::abs(t) * (T(6) + T(10) * std::abs(t));
        EXPECT_LE((lane.p_WB - one.p_WB).cwiseAbs().maxCoeff(), 4 * epsilon * size) << i;
        EXPECT_LE((lane.v_WB - one.v_WB).cwiseAbs().maxCoeff(), 2 * epsilon * (T(3) + T(10) * std::abs(t))) << i;
      }
    }
  }
}

TYPED_TEST(Batch, KeepsWhatWasSet) {
  using T = TypeParam;
  const std::vector<Stone<T>> stones = some_stones<T>(17);
  StoneBatch<T> batch(17);
  for (std::size_t i = 17; i-- > 0;) {
    batch.set(i, stones[i].state, stones[i].moments);
  }
  for (std::size_t i = 0; i < 17; ++i) {
    const State<T> kept = batch.get(i);
    EXPECT_EQ(kept.p_WB, stones[i].state.p_WB);
    EXPECT_EQ(kept.q_WB.coeffs(), stones[i].state.q_WB.coeffs());
    EXPECT_EQ(kept.v_WB, stones[i].state.v_WB);
    EXPECT_EQ(kept.L_W, stones[i].state.L_W);
  }
}

TYPED_TEST(Batch, WhatWasNotSetRestsAtTheOrigin) {
  using T = TypeParam;
  const std::vector<Stone<T>> stones = some_stones<T>(1);
  StoneBatch<T> batch(9);
  batch.set(4, stones[0].state, stones[0].moments);
  batch.fly(Vec3<T>(T(0), T(0), T(0)), T(5));
  for (std::size_t i = 0; i < 9; ++i) {
    if (i != 4) {
      const State<T> state = batch.get(i);
      EXPECT_TRUE(state.p_WB.isZero(T(0)) && state.v_WB.isZero(T(0)) && state.L_W.isZero(T(0))) << i;
      EXPECT_EQ(state.q_WB.coeffs(), Quat<T>::Identity().coeffs()) << i;
    }
  }
  EXPECT_FALSE(batch.get(4).p_WB.isZero(T(0)));
}

TYPED_TEST(Batch, GivesTheSameBitsWhereverAStoneStands) {
  using T = TypeParam;
  const Stone<T> stone = some_stones<T>(1)[0];
  StoneBatch<T> batch(2 * StoneBatch<T>::lanes + 1);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    batch.set(i, stone.state, stone.moments);
  }
  batch.fly(gravity_W<T>(), T(0.7));
  const State<T> first = batch.get(0);
  for (std::size_t i = 1; i < batch.size(); ++i) {
    const State<T> other = batch.get(i);
    EXPECT_EQ(other.p_WB, first.p_WB);
    EXPECT_EQ(other.q_WB.coeffs(), first.q_WB.coeffs());
  }
}

/// Farther than the batch's own sine counts: half angles of 3.4e9 rad. As alone, to the bit.
TYPED_TEST(Batch, TurnsFar) {
  using T = TypeParam;
  const auto stones = some_stones<T>(11);
  for (const double far : {1e8, 1e10, 1e12, 1e16, -1e16}) {
    const T time = static_cast<T>(far);
    StoneBatch<T> batch(stones.size());
    for (std::size_t i = 0; i < stones.size(); ++i) {
      batch.set(i, stones[i].state, stones[i].moments);
    }
    batch.fly(gravity_W<T>(), time);
    for (std::size_t i = 0; i < stones.size(); ++i) {
      const State<T> together = batch.get(i);
      EXPECT_NEAR(static_cast<double>(together.q_WB.squaredNorm()), 1.0, 8.0 * std::numeric_limits<T>::epsilon());
      if (std::fabs(far) > 2e9) {
        const State<T> alone = free_flight(stones[i].state, stones[i].moments, gravity_W<T>(), time);
        EXPECT_EQ(together.q_WB.coeffs(), alone.q_WB.coeffs()) << "stone " << i << ", t = " << far;
        EXPECT_EQ(together.p_WB, alone.p_WB) << "stone " << i << ", t = " << far;
      }
    }
  }
}

TYPED_TEST(Batch, RefusesWhatOverflowsAndStaysWhereItIs) {
  using T = TypeParam;
  const auto stones = some_stones<T>(5);
  StoneBatch<T> batch(stones.size());
  for (std::size_t i = 0; i < stones.size(); ++i) {
    batch.set(i, stones[i].state, stones[i].moments);
  }
  const T huge = std::numeric_limits<T>::max() / T(4);
  EXPECT_THROW(batch.fly(gravity_W<T>(), huge), InvalidArgument);
  EXPECT_THROW(batch.fly(Vec3<T>(huge, T(0), T(0)), T(100)), InvalidArgument);
  for (std::size_t i = 0; i < stones.size(); ++i) {
    EXPECT_EQ(batch.get(i).p_WB, stones[i].state.p_WB);
    EXPECT_EQ(batch.get(i).q_WB.coeffs(), stones[i].state.q_WB.coeffs());
  }
}

}  // namespace
}  // namespace goishi::motion_test
