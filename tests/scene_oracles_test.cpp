/// The witness of the scene's clusters, before it judges: gaps against a search, slides, rolls and stands by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "verify/oracles/contact/brute_contact.hpp"
#include "verify/oracles/scene/moreau.hpp"

namespace goishi::verify {

namespace {

Hull<double> hull_of(double width, double height, double bevel) {
  const Hull<long double> hull = narrow(construct_hull(width, height, bevel));
  const auto field = [](long double x) { return static_cast<double>(x); };
  return {field(hull.height),       field(hull.band),        field(hull.sphere_radius), field(hull.sphere_offset),
          field(hull.torus_radius), field(hull.tube_radius), field(hull.joint_radius)};
}

/// A stone of size 33, 5 g, near enough in its moments; or a ball.
HeavyBody body_of(double height, double z) {
  const double I = 0.005 * 0.4 * 0.011 * 0.011;
  return {.hull = hull_of(0.022, height, height < 0.022 ? 0.001 : 0.0),
          .mass = 0.005,
          .axial = height < 0.022 ? 2e-7 : I,
          .transverse = height < 0.022 ? 1.2e-7 : I,
          .p = {0, 0, z},
          .u = {0, 0, 1},
          .v = {0, 0, 0},
          .L = {0, 0, 0}};
}

TEST(SceneOracles, GapsAreThoseOfASearch) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const Hull<long double> wide = narrow(construct_hull(0.022, 0.0092, 0.001));
  int apart = 0;
  for (int i = 0; i < 40; ++i) {
    HeavyBody one = body_of(0.0092, 0), two = one;
    for (HeavyBody* body : {&one, &two}) {
      Vector u = {normal(random), normal(random), normal(random)};
      const double size = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
      body->u = {u[0] / size, u[1] / size, u[2] / size};
    }
    one.p = {0.014 + 0.004 * normal(random), 0.005 * normal(random), 0.005 * normal(random)};
    const auto standing = [&](const HeavyBody& body) {
      return Standing{wide, {body.p[0], body.p[1], body.p[2]}, {body.u[0], body.u[1], body.u[2]}};
    };
    const double searched = static_cast<double>(search_pair(standing(one), standing(two), 60).value);
    if (searched < 1e-6) {
      continue;  // many normals are as good
    }
    ++apart;
    EXPECT_NEAR(gap_between(one, two, one.p).gap, searched, 1e-12) << i;
  }
  EXPECT_GT(apart, 10);
}

TEST(SceneOracles, ABallThatSlidesRollsInTheEnd) {
  HeavyBody ball = body_of(0.022, 0.011);
  ball.v = {0.5, 0, 0};
  Moreau stepping({ball}, {.board_friction = 0.3});
  const double g = 9.80665, rolls = 2 * 0.5 / (7 * 0.3 * g);
  stepping.advance(rolls / 2, 1000);
  EXPECT_NEAR(stepping.bodies()[0].v[0], 0.5 - 0.3 * g * rolls / 2, 1e-6);
  stepping.advance(rolls, 1000);
  EXPECT_NEAR(stepping.bodies()[0].v[0], 0.5 * 5 / 7, 1e-6);
  EXPECT_NEAR(stepping.bodies()[0].p[2], 0.011, 1e-9);
}

/// δ N against ω: a ball that rolls slows down by (δ/R) g 5/7; one that turns on the spot loses κ N t.
TEST(SceneOracles, ResistanceSlowsRollingAndTurning) {
  const double g = 9.80665, R = 0.011, delta = 2e-4, kappa = 3e-4;
  HeavyBody ball = body_of(0.022, R);
  ball.v = {0.1, 0, 0};
  ball.L = {0, ball.transverse * 0.1 / R, 0};
  Moreau rolling({ball}, {.board_friction = 0.5, .rolling = delta, .pivot = kappa});
  rolling.advance(0.2, 2000);
  EXPECT_NEAR(rolling.bodies()[0].v[0], 0.1 - delta / R * g * 5 / 7 * 0.2, 1e-5);
  HeavyBody top = body_of(0.0092, 0.0046);
  top.L = {0, 0, 1e-5};
  Moreau turning({top}, {.rolling = delta, .pivot = kappa});
  turning.advance(0.2, 2000);
  EXPECT_NEAR(turning.bodies()[0].L[2], 1e-5 - kappa * top.mass * g * 0.2, 1e-9);
}

TEST(SceneOracles, WhatIsHeldStays) {
  const double h = 0.0092;
  Moreau tower({body_of(h, h / 2), body_of(h, 3 * h / 2)},
               {.gravity = {0.2 * 9.8, 0, -9.8}, .rolling = 5e-3, .pivot = 5e-3});
  tower.advance(0.1, 1000);
  EXPECT_LT(tower.unsolved(), 1.1e-7);
  for (const HeavyBody& body : tower.bodies()) {
    EXPECT_NEAR(body.p[0], 0, 1e-7);
    EXPECT_NEAR(std::fabs(body.u[2]), 1, 1e-9);
  }
  Moreau slides({body_of(h, h / 2)}, {.gravity = {0.4 * 9.8, 0, -9.8}, .rolling = 5e-3, .pivot = 5e-3});
  slides.advance(0.1, 1000);
  EXPECT_NEAR(slides.bodies()[0].v[0], 0.1 * 9.8 * 0.1, 1e-4);
}

}  // namespace

}  // namespace goishi::verify
