/// The witness of the certified digits: its meridian, and its integrals against known ones.

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "verify/oracles/numbers/ordered_ball.hpp"
#include "verify/oracles/stone/rigorous_integral.hpp"

namespace goishi::verify {
namespace {

Ball pi() {
  return atan2(Ball(0), Ball(-1));
}

Ball decimal(const char* text) {
  return Ball::from_decimal(text);
}

/// Both hold one number, and neither holds much else.
void expect_same(const Ball& x, const Ball& y) {
  EXPECT_TRUE(x.overlaps(y)) << static_cast<double>(x) << " and " << static_cast<double>(y);
  EXPECT_LT(x.relative_radius(), 1e-30);
  EXPECT_LT(y.relative_radius(), 1e-30);
}

TEST(RigorousIntegral, OfTheUnitBall) {
  const EnclosedIntegrals ball = integrate_rigorously(lens_meridian(Ball(2), Ball(2)));
  expect_same(ball.volume, Ball(4) * pi() / Ball(3));
  expect_same(ball.surface_area, Ball(4) * pi());
  expect_same(ball.axial, Ball(8) * pi() / Ball(15));
  expect_same(ball.transverse, Ball(8) * pi() / Ball(15));
}

TEST(RigorousIntegral, OfABevelledBall) {  // a ball, whatever the bevel
  const EnclosedIntegrals ball = integrate_rigorously(bevelled_meridian(Ball(2), Ball(2), decimal("0.3")));
  expect_same(ball.volume, Ball(4) * pi() / Ball(3));
  expect_same(ball.surface_area, Ball(4) * pi());
  expect_same(ball.axial, Ball(8) * pi() / Ball(15));
  expect_same(ball.transverse, Ball(8) * pi() / Ball(15));
}

TEST(RigorousIntegral, OfTwoCaps) {  // height 1, base radius 2: Archimedes
  const EnclosedIntegrals lens = integrate_rigorously(lens_meridian(Ball(4), Ball(2)));
  expect_same(lens.volume, Ball(13) * pi() / Ball(3));
  expect_same(lens.surface_area, Ball(10) * pi());
}

/// The half of a torus that looks outwards, with a cylinder inside: caps of no height, by Pappus.
TEST(RigorousIntegral, OfAPuck) {
  Meridian puck = lens_meridian(Ball(2), Ball(2));
  puck.height = Ball(2);
  puck.sphere_radius = Ball(0);
  puck.joint_angle = Ball(0);
  puck.tube_distance = Ball(3);
  puck.tube_radius = Ball(1);
  puck.bevelled = true;
  const EnclosedIntegrals integrals = integrate_rigorously(puck);
  const Ball half_disc = pi() / Ball(2);
  const Ball cylinder = Ball(18) * pi();
  const Ball centroid = Ball(3) + Ball(4) / (Ball(3) * pi());
  expect_same(integrals.volume, cylinder + Ball(2) * pi() * centroid * half_disc);
  // Only the outer half of the tube: the flat faces are no arc.
  expect_same(integrals.surface_area, Ball(2) * pi() * pi() * (Ball(3) + Ball(2) / pi()));
}

TEST(RigorousIntegral, TheMeridianTouches) {
  const Ball w = decimal("22"), h = decimal("9.2"), b = decimal("1");
  const Meridian stone = bevelled_meridian(w, h, b);
  const Ball& r = stone.sphere_radius;
  const Ball& d = stone.sphere_offset;
  expect_same(h / Ball(2) + d, r);                // through the pole
  expect_same(sqrt(w * w / Ball(4) + d * d), r);  // through the rim
  const Ball between = sqrt(stone.tube_distance * stone.tube_distance + d * d);
  expect_same(between, r - stone.tube_radius);                 // circles touch from inside
  expect_same(Ball(2) * (r * cos(stone.joint_angle) - d), b);  // where the band begins
  EXPECT_EQ(arb_lt(greatest_width(stone).get(), w.get()), 1);
}

TEST(OrderedBall, AnswersWhatItCanProve) {
  const OrderedBall one(1), two(2);
  EXPECT_TRUE(one < two);
  EXPECT_FALSE(two < one);
  EXPECT_FALSE(one < one);  // exact
  EXPECT_TRUE(one <= one);
  EXPECT_EQ(every_outcome([&] { return one < two; }), std::vector<bool>({true}));
}

TEST(OrderedBall, GoesBothWaysWhereItCannot) {
  const OrderedBall third(decimal("0.333333333333")), root(sqrt(Ball(2)) * sqrt(Ball(2)));
  EXPECT_EQ(every_outcome([&] { return root < OrderedBall(2); }), std::vector<bool>({false, true}));
  EXPECT_EQ(every_outcome([&] { return third < OrderedBall(2) && root <= OrderedBall(2); }),
            std::vector<bool>({false, true}));
  const auto paths = every_outcome([&] { return 2 * int(root < OrderedBall(2)) + int(OrderedBall(2) < root); });
  EXPECT_EQ(paths, std::vector<int>({0, 2, 1, 3}));
}

TEST(OrderedBall, AnswersNothingElse) {
  const OrderedBall root(sqrt(Ball(2)) * sqrt(Ball(2)));
  const auto ask = [&] { return root < OrderedBall(2); };
  EXPECT_THROW((void)ask(), std::runtime_error);
  EXPECT_EQ(every_outcome(ask).size(), 2U);
  EXPECT_THROW((void)ask(), std::runtime_error);  // the exploration is over
  const auto ask_often = [&](int times) {
    for (int i = 0; i < times; ++i) {
      (void)ask();
    }
    return 0;
  };
  EXPECT_EQ(every_outcome([&] { return ask_often(8); }).size(), 256U);
  EXPECT_THROW((void)every_outcome([&] { return ask_often(9); }), std::runtime_error);
  EXPECT_THROW((void)ask(), std::runtime_error);
}

}  // namespace
}  // namespace goishi::verify
