/// The oracles of contact that lasts: they must be right where the answer is known, and agree with each other.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "verify/oracles/contact/wobble.hpp"
#include "verify/oracles/drop/spin.hpp"
#include "verify/oracles/drop/touching_body.hpp"
#include "verify/oracles/published/loop.hpp"
#include "verify/oracles/stone/hull.hpp"

namespace {

using namespace goishi::verify;
using Long = long double;

constexpr Long gravity = 9.80665L;
constexpr Long pi = std::numbers::pi_v<Long>;

void expect_relative(Long found, Long expected, double bound) {
  EXPECT_LE(static_cast<double>(std::fabs(found / expected - 1)), bound)
      << static_cast<double>(found) << " instead of " << static_cast<double>(expected);
}

/// The sharp stone of size 33 by its own numbers: r = (w² + h²)/(4h), I/m as in the talk's corrected table.
Rocker size_33() {
  const Long r = (0.022L * 0.022L + 0.0092L * 0.0092L) / (4 * 0.0092L);
  return {.sphere_radius = r,
          .sphere_offset = r - 0.0046L,
          .torus_radius = 0.011L,
          .tube_radius = 0,
          .transverse = 0.244624139941691e-4L,
          .gravity = gravity};
}

SpinningCap<Long> spinning_size_33() {
  const Rocker rocker = size_33();
  return {.r = rocker.sphere_radius,
          .d = rocker.sphere_offset,
          .axial = 0.415606897126197e-4L,
          .transverse = rocker.transverse,
          .gravity = gravity};
}

TEST(Wobble, SmallSwingsHaveThePendulumsPeriod) {
  const Rocker rocker = size_33();
  const Long lever = rocker.sphere_radius - rocker.sphere_offset, stiffness = gravity * rocker.sphere_offset;
  expect_relative(rocking_period(rocker, Footing::rolling, 1e-5L),
                  2 * pi * std::sqrt((rocker.transverse + lever * lever) / stiffness), 1e-9);
  expect_relative(rocking_period(rocker, Footing::frictionless, 1e-5L),
                  2 * pi * std::sqrt(rocker.transverse / stiffness), 1e-9);
}

TEST(Wobble, MotionInTimeAgreesWithTheQuadrature) {
  const Rocker rocker = size_33();
  for (const Footing footing : {Footing::rolling, Footing::frictionless}) {
    const PlanarMotion end = rocked(rocker, footing, {}, {.tilt = 0.3L}, rocking_period(rocker, footing, 0.3L));
    EXPECT_NEAR(static_cast<double>(end.tilt), 0.3, 1e-10);
  }
}

TEST(Wobble, ResistanceTakesTwiceItsAngleEachHalfSwing) {
  const Rocker rocker = size_33();
  const Long delta = 1e-7L;
  const auto turns = turning_points(rocker, Footing::rolling, {.rolling_resistance = delta}, 1e-3L);
  ASSERT_GE(turns.size(), 3U);
  EXPECT_NEAR(static_cast<double>(std::fabs(turns[0].tilt)),
              static_cast<double>(1e-3L - 2 * delta / rocker.sphere_offset), 1e-9);
  EXPECT_LT(turns[0].tilt, 0);
  EXPECT_GT(turns[1].tilt, 0);
}

TEST(Wobble, ABallThatSlidesComesToRoll) {
  const Long radius = 0.011L, mu = 0.25L, speed = 0.4L;
  const Rocker ball = {.sphere_radius = radius,
                       .sphere_offset = 0,
                       .torus_radius = 0,
                       .tube_radius = radius,
                       .transverse = radius * radius * 2 / 5,
                       .gravity = gravity};
  const PlanarMotion end = end_of_slide(ball, {.friction = mu}, {.v = speed});
  expect_relative(end.time, 2 * speed / (7 * mu * gravity), 1e-12);
  expect_relative(end.v, speed * 5 / 7, 1e-12);
}

TEST(Spin, ThresholdAndSettlingTiltsAreThePublishedOnes) {
  const SpinningCap<Long> stone = spinning_size_33();
  EXPECT_NEAR(static_cast<double>(stone.threshold()), 27.930, 5e-4);
  const Long spins[] = {30, 40, 60};
  const double tilts[] = {9.116, 22.035, 35.970};
  for (int i = 0; i < 3; ++i) {
    const Long z = settling_height(stone, stone.axial * spins[i] * (stone.r - stone.d));
    EXPECT_NEAR(static_cast<double>(std::acos(z) * 180 / pi), tilts[i], 5e-4);
  }
}

TEST(Spin, WithoutSpinTheSwingIsAQuarterOfRocking) {
  const Long tilt = 0.4L;
  const FrictionlessSwing swing(spinning_size_33(), std::cos(tilt), 1e-5L);
  expect_relative(swing.time(pi), rocking_period(size_33(), Footing::frictionless, tilt) / 4, 1e-6);
  expect_relative(swing.height(0), std::cos(tilt), 1e-15);
  expect_relative(swing.height(pi), 1, 1e-12);
}

// --- touching_body: x, y, θ, φ, ψ, ẋ, ẏ, θ̇, p_φ, p_ψ

TouchingBody touching_size_33(TouchingBody::Law law, Long mu) {
  const SpinningCap<Long> stone = spinning_size_33();
  return {.hull = narrow(construct_hull(0.022, 0.0092, 0)),
          .axial = stone.axial,
          .transverse = stone.transverse,
          .gravity = gravity,
          .law = law,
          .mu = mu,
          .coefficient = 1.5L};
}

Long energy_of(const TouchingBody& body, const TouchingState& y) {
  const Long s = std::sin(y[2]), c = std::cos(y[2]), across = (y[8] - y[9] * c) / s;
  // With the height's own rate, by a difference quotient of the height.
  const Long h = 1e-6L, rise = (height_of(body, y[2] + h) - height_of(body, y[2] - h)) / (2 * h) * y[7];
  return (y[5] * y[5] + y[6] * y[6] + rise * rise) / 2 +
         (body.transverse * y[7] * y[7] + across * across / body.transverse + y[9] * y[9] / body.axial) / 2 +
         gravity * height_of(body, y[2]);
}

TEST(TouchingBody, ABallThatSlidesComesToRoll) {
  const Long radius = 0.011L, mu = 0.25L, speed = 0.1L;
  const TouchingBody ball = {.hull = narrow(construct_hull(0.022, 0.022, 0)),
                             .axial = radius * radius * 2 / 5,
                             .transverse = radius * radius * 2 / 5,
                             .gravity = gravity,
                             .mu = mu};
  const TouchingPath path = follow(ball, TouchingState{0, 0, 0.5L, 0, 0, speed, 0, 0, 0, 0}, 0.03L);
  ASSERT_FALSE(path.gave_up);
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_EQ(path.events[0].kind, "stick");
  expect_relative(path.events[0].time, 2 * speed / (7 * mu * gravity), 1e-11);
  expect_relative(path.end[5], speed * 5 / 7, 1e-11);
}

TEST(TouchingBody, RollingKeepsEnergy) {
  const TouchingBody body = touching_size_33(TouchingBody::Law::dry, std::numeric_limits<Long>::infinity());
  TouchingState start = {0, 0, 0.4L, 0.1L, 0.2L, 0, 0, 1.5L, 2e-4L, 3e-4L};
  const auto slip = slip_of(body, start);
  start[5] = -slip[0];
  start[6] = -slip[1];
  const TouchingPath path = follow(body, start, 0.05L);
  ASSERT_FALSE(path.gave_up || path.lifted);
  EXPECT_GT(std::fabs(path.end[2] - start[2]), 1e-3L);
  expect_relative(energy_of(body, path.end), energy_of(body, start), 1e-10);
}

TEST(TouchingBody, NearTheVerticalRollingKeepsEnergyAndItsIntegrals) {
  const TouchingBody body = touching_size_33(TouchingBody::Law::dry, 100);
  const SpinningCap<Long> stone = spinning_size_33();
  const Long spin = stone.axial * 5;
  TouchingState start = {0, 0, 0.03L, 0.1L, 0.2L, 0, 0, 4, spin + 1e-9L, spin};  // out to a fifth of a radian, and back
  const auto slip = slip_of(body, start);
  start[5] = -slip[0];
  start[6] = -slip[1];
  const auto jellett = [&](const TouchingState& y) { return stone.d * y[9] - stone.r * y[8]; };
  const auto routh = [&](const TouchingState& y) {
    return y[9] * y[9] * (stone.transverse * stone.axial + stone.lever(std::cos(y[2])));
  };
  for (const Long time : {0.02L, 0.06L, 0.1L}) {
    const TouchingPath path = follow(body, start, time);
    ASSERT_FALSE(path.gave_up || path.lifted);
    expect_relative(energy_of(body, path.end), energy_of(body, start), 1e-11);
    expect_relative(jellett(path.end), jellett(start), 1e-12);
    expect_relative(routh(path.end), routh(start), 1e-11);
    const auto left = slip_of(body, path.end);
    EXPECT_LT(std::hypot(left[0], left[1]), 1e-13L);
  }
}

TEST(TouchingBody, FrictionOnTheCapKeepsJellettsIntegral) {
  const TouchingBody body = touching_size_33(TouchingBody::Law::slip_proportional, 0);
  const SpinningCap<Long> stone = spinning_size_33();
  const auto jellett = [&](const TouchingState& y) { return stone.d * y[9] - stone.r * y[8]; };
  const TouchingState start = {0, 0, 0.3L, 0, 0, 0.02L, -0.01L, 0, stone.axial * 30, stone.axial * 29};
  const TouchingPath path = follow(body, start, 0.05L);
  ASSERT_FALSE(path.gave_up || path.lifted);
  ASSERT_TRUE(path.events.empty());
  expect_relative(jellett(path.end), jellett(start), 1e-13);
  EXPECT_LT(energy_of(body, path.end), energy_of(body, start));
}

// --- the talk's loop

TEST(PublishedLoop, FallsByItsOwnScheme) {
  const PublishedStone stone = {.sphere_radius = 0.0155,
                                .sphere_offset = 0.0109,
                                .ring_radius = 0.011,
                                .tube_radius = 0,
                                .axial = 4.2e-5,
                                .transverse = 2.4e-5};
  const PublishedState start = {.p = {0, 0, 1}, .v = {0.5, 0, 0}, .q = {1, 0, 0, 0}, .w = {0, 0, 3}};
  const double dt = 1e-3;
  const int n = 100;
  const PublishedPath path = run_published_loop(stone, {}, start, dt, n);
  EXPECT_EQ(path.contacts, 0);
  EXPECT_NEAR(path.end.v[2], -9.80665 * n * dt, 1e-12);
  EXPECT_NEAR(path.end.p[2], 1 - 9.80665 * dt * dt * n * (n + 1) / 2, 1e-12);  // semi-implicit: Σ k
  EXPECT_NEAR(path.end.p[0], 0.05, 1e-12);
  EXPECT_NEAR(2 * std::atan2(path.end.q[3], path.end.q[0]), 2 * n * std::atan(3 * dt / 2), 1e-12);
  EXPECT_NEAR(published_energy(stone, {}, start), 0.5 * 0.25 + 0.5 * 4.2e-5 * 9 + 9.80665, 1e-12);
}

}  // namespace
