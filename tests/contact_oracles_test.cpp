/// The oracles of contact: right where the answer is known without them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verify/oracles/contact/brute_contact.hpp"
#include "verify/oracles/contact/flying_bodies.hpp"
#include "verify/oracles/stone/triangles.hpp"

namespace {

using namespace goishi::verify;

using Real = long double;
using Real3 = Triple<Real>;

constexpr Real g = 9.80665L;
constexpr Real3 up = {0, 0, 1};
constexpr Real3 east = {1, 0, 0};

/// w × h with bevel b, at p, its axis along u.
Standing stone(double width, double height, double bevel, const Real3& p, const Real3& u) {
  return {narrow(construct_hull(width, height, bevel)), p, u};
}

double on_board(const Standing& standing) {
  return static_cast<double>(search_board(standing, 0.2L, 0.2L, 20).value);
}

double of_pair(const Standing& one, const Standing& other) {
  return static_cast<double>(search_pair(one, other, 20).value);
}

TEST(Hull, PolesAndRimAreOnIt) {
  for (const double bevel : {0.0, 0.001, 0.005}) {
    const Hull<Real> hull = narrow(construct_hull(0.022, 0.0092, bevel));
    EXPECT_NEAR(static_cast<double>(outside<Real>(hull, 0, 0.0046L)), 0, 1e-18);
    EXPECT_NEAR(static_cast<double>(outside<Real>(hull, hull.torus_radius + hull.tube_radius, 0)), 0, 1e-18);
    EXPECT_LT(outside<Real>(hull, 0, 0), 0);
    EXPECT_GT(outside<Real>(hull, 0.0111L, 0.0L), 0);
  }
}

TEST(Hull, ABallIsRound) {
  const Hull<Real> hull = narrow(construct_hull(0.022, 0.022, 0.003));
  for (const Real angle : {0.0L, 0.3L, 1.0L, 1.5L}) {
    EXPECT_NEAR(static_cast<double>(searched_support(hull, std::sin(angle), std::cos(angle))), 0.011, 1e-16);
    EXPECT_NEAR(static_cast<double>(searched_distance(hull, 0.03L * std::sin(angle), 0.03L * std::cos(angle))), 0.019,
                1e-16);
  }
}

TEST(SearchBoard, ABallsGapIsItsCentresDistance) {
  const auto ball = [](const Real3& p) { return stone(0.022, 0.022, 0.0, p, east); };
  EXPECT_NEAR(on_board(ball({0.05L, 0.1L, 0.03L})), 0.03 - 0.011, 1e-12);    // surface
  EXPECT_NEAR(on_board(ball({0.05L, -0.23L, -0.1L})), 0.03 - 0.011, 1e-12);  // side
  EXPECT_NEAR(on_board(ball({0.23L, 0.1L, 0.04L})), 0.05 - 0.011, 1e-12);    // edge
  EXPECT_NEAR(on_board(ball({-0.23L, 0.24L, -0.1L})), 0.05 - 0.011, 1e-12);  // upright edge
  EXPECT_NEAR(on_board(ball({0.23L, -0.24L, 0.12L})), 0.13 - 0.011, 1e-12);  // corner
  EXPECT_NEAR(on_board(ball({0.05L, 0.1L, -0.02L})), -0.02 - 0.011, 1e-12);  // inside
}

TEST(SearchBoard, AStoneOnEdgeReachesDownByHalfItsWidth) {
  EXPECT_NEAR(on_board(stone(0.022, 0.0092, 0.0, {0.05L, 0, 0.02L}, east)), 0.02 - 0.011, 1e-12);
  EXPECT_NEAR(on_board(stone(0.022, 0.0092, 0.0, {0.05L, 0, 0.02L}, up)), 0.02 - 0.0046, 1e-12);
  EXPECT_NEAR(on_board(stone(0.022, 0.0092, 0.0, {0.205L, 0, -0.1L}, east)), 0.005 - 0.0046, 1e-12);
}

TEST(SearchPair, StonesOnEachOtherSideBySideAndInOneAnother) {
  const Standing flat = stone(0.022, 0.0092, 0.001, {0.1L, 0, 0}, up);
  const Real reach = 2 * (flat.hull.torus_radius + flat.hull.tube_radius);
  EXPECT_NEAR(of_pair(flat, stone(0.022, 0.0092, 0.001, {0.1L, 0, 0.01L}, up)), 0.01 - 0.0092, 1e-12);
  EXPECT_NEAR(of_pair(flat, stone(0.022, 0.0092, 0.001, {0.13L, 0, 0}, up)), static_cast<double>(0.03L - reach), 1e-12);
  EXPECT_NEAR(of_pair(flat, flat), -0.0092, 1e-12);
  EXPECT_NEAR(of_pair(stone(0.02, 0.02, 0.0, {0, 0, 0}, up), stone(0.03, 0.03, 0.0, {0.03L, 0.04L, 0}, east)),
              0.05 - 0.025, 1e-12);
}

/// Size 33 in all but its name; at p, its axis up, turning with ω in B.
FlyingBody body(const Real3& p, const Real3& spin) {
  return {.p = p,
          .v = {0.1L, 0, 0},
          .a = {0, 0, -g},
          .attitude = {1, 0, 0, 0},
          .spin = spin,
          .axial = 0.4156L,
          .transverse = 0.2446L};
}

TEST(FlyingBodies, AFlatDropTakesAsLongAsItsParabola) {
  const Gap gap = [](const FlyingPlaces& places) { return places[0].p[2] - 0.01L; };
  for (const Real spin : {0.0L, 100.0L}) {
    const FlyingEvent event = first_event({body({0, 0, 0.05L}, {0, 0, spin})}, gap, 1, 0.001L);
    EXPECT_TRUE(event.found);
    EXPECT_NEAR(static_cast<double>(event.time), static_cast<double>(std::sqrt(2 * 0.04L / g)), 1e-16);
    EXPECT_GE(event.least, 0);
  }
  const FlyingEvent none = first_event({body({0, 0, 0.05L}, {0, 0, 0})}, gap, 0.05L, 0.001L);
  EXPECT_FALSE(none.found);
  EXPECT_NEAR(static_cast<double>(none.least), static_cast<double>(0.04L - g * 0.0025L / 2), 1e-16);
}

TEST(FlyingBodies, TheAxisIsBackAfterATurnOfPrecession) {
  const Real3 spin = {3, 0, 5};
  const FlyingBody top = body({0, 0, 0}, spin);
  const Real momentum = std::hypot(top.transverse * spin[0], top.axial * spin[2]);
  const Real turn = 2 * std::numbers::pi_v<Real> * top.transverse / momentum;
  const FlyingPlaces back = places_at({top, top}, turn), half = places_at({top}, turn / 2);
  for (const FlyingPlace& place : back) {
    EXPECT_NEAR(static_cast<double>(place.u[0]), 0, 1e-14);
    EXPECT_NEAR(static_cast<double>(place.u[1]), 0, 1e-14);
    EXPECT_NEAR(static_cast<double>(place.u[2]), 1, 1e-14);
  }
  // Half a turn: the mirror image in L.
  const Real cosine = top.axial * spin[2] / momentum;
  EXPECT_NEAR(static_cast<double>(half[0].u[2]), static_cast<double>(2 * cosine * cosine - 1), 1e-14);
}

TEST(Triangles, DistanceFromOneAndFromAHeap) {
  const Point3 a{0.0, 0.0, 0.0}, b{1.0, 0.0, 0.0}, c{0.0, 1.0, 0.0};
  EXPECT_DOUBLE_EQ(triangle_distance({0.2, 0.2, 0.5}, a, b, c), 0.5);
  EXPECT_DOUBLE_EQ(triangle_distance({0.2, 0.2, 0.0}, a, b, c), 0.0);
  EXPECT_DOUBLE_EQ(triangle_distance({0.5, -2.0, 0.0}, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(triangle_distance({1.0, 1.0, 0.0}, a, b, c), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(triangle_distance({-3.0, -4.0, 0.0}, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(triangle_distance({4.0, 0.0, 4.0}, a, b, c), 5.0);
  Triangles heap;
  heap.add(a, b, c);
  heap.add({0.0, 0.0, 2.0}, {1.0, 0.0, 2.0}, {0.0, 1.0, 2.0});
  EXPECT_DOUBLE_EQ(heap.distance({0.1, 0.1, 1.5}), 0.5);
  EXPECT_DOUBLE_EQ(heap.distance({0.1, 0.1, -1.0}), 1.0);
}

}  // namespace
