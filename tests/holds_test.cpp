/// `holds`: a stone that is laid down, by hand-made cases; the claim compares with the drop.

#include <gtest/gtest.h>

#include <cmath>
#include <goishi/drop/holds.hpp>
#include <numbers>

#include "tests/expectations.hpp"

namespace goishi::holds_test {

namespace {

using test::infinity;

constexpr double g_earth = 9.80665, mu = 0.3, delta = 1e-4, kappa = 5e-5;

struct Laid {
  Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  Pose<double> pose = {{0.0, 0.0, 0.0}, Quat<double>::Identity()};
  DropSettings<double> settings = {};

  explicit Laid(double tilt = 0.0, double lean_x = 0.0, double lean_y = 0.0) {
    pose.q_WB = Quat<double>(std::cos(tilt / 2.0), 0.0, std::sin(tilt / 2.0), 0.0);
    pose.p_WB.z() = -separation(stone, pose, Plane<double>{}).gap;
    settings.friction = mu;
    settings.rolling_resistance = delta;
    settings.pivot_radius = kappa;
    settings.gravity = g_earth * Vec3<double>(lean_x, lean_y, -1.0).normalized();
  }
  [[nodiscard]] Hold<double> hold() const { return holds(stone, pose, Plane<double>{}, settings); }
};

TEST(Holds, AFlatStoneLevel) {
  const Hold<double> flat = Laid().hold();
  EXPECT_TRUE(flat.holds);
  EXPECT_EQ(flat.contacts, 1);
  EXPECT_NEAR(flat.gap, 0.0, 1e-17);
  EXPECT_EQ(flat.friction, 0.0);
  EXPECT_EQ(flat.resistance, 0.0);
  // It rolls long before it slides: the lever is half its height.
  EXPECT_NEAR(flat.tilt, std::atan(delta / 0.0046), 1e-9);
}

TEST(Holds, ASlopeAsksForItsTangent) {
  for (const double lean : {0.01, 0.29, 0.31, 2.0}) {
    Laid laid(0.0, 0.6 * lean, -0.8 * lean);
    laid.settings.rolling_resistance = laid.settings.pivot_radius = 0.0109;
    const Hold<double> slope = laid.hold();
    EXPECT_EQ(slope.holds, lean < mu) << lean;
    EXPECT_NEAR(slope.friction, lean / mu, 1e-14 * lean / mu);
    EXPECT_NEAR(slope.resistance, lean * 0.0046 / 0.0109, 1e-9);
    EXPECT_NEAR(slope.tilt, lean < mu ? std::atan(mu) - std::atan(lean) : 0.0, 1e-6);
    laid.settings.friction = 0.0;
    EXPECT_FALSE(laid.hold().holds);
    EXPECT_EQ(laid.hold().friction, infinity);
    laid.settings.friction = infinity;
    EXPECT_TRUE(laid.hold().holds);
    EXPECT_EQ(laid.hold().friction, 0.0);
  }
}

TEST(Holds, ALeaningStoneAsksForItsLever) {
  // On the cap the contact is d sin θ beside the centre, d the distance of the sphere's centre from the stone's.
  for (const double tilt : {0.001, 0.005, 0.05}) {
    const Laid laid(tilt);
    const double lever = laid.stone.sphere_offset * std::sin(tilt);
    const Hold<double> hold = laid.hold();
    EXPECT_EQ(hold.holds, lever < delta) << tilt;
    EXPECT_NEAR(hold.resistance, lever / delta, 1e-9 * lever / delta + 1e-12);
    EXPECT_EQ(hold.friction, 0.0);
  }
  // On a slope that leads the weight over the contact it stands.
  const double lever = Laid(0.05).stone.sphere_offset * std::sin(0.05), height = Laid(0.05).pose.p_WB.z();
  for (const double side : {-1.0, 1.0}) {
    const Hold<double> hold = Laid(0.05, side * lever / height).hold();
    EXPECT_NEAR(hold.resistance, side < 0.0 ? 2.0 * lever / delta : 0.0, 1e-6) << side;
  }
}

TEST(Holds, APatchBearsATorqueAboutTheNormal) {
  // The weight leans across the lever: N lever tan α about the normal, and N h tan α against rolling.
  const double tilt = 0.004, lean = 0.01;
  const Laid laid(tilt, 0.0, lean);
  const double lever = laid.stone.sphere_offset * std::sin(tilt), height = laid.pose.p_WB.z();
  const double roll = std::hypot(lever, height * lean) / delta, turn = lever * lean / kappa;
  EXPECT_NEAR(laid.hold().resistance, std::hypot(roll, turn), 1e-9);
}

TEST(Holds, WithoutResistanceOnlyWhatIsBalanced) {
  Laid flat, leaning(0.01);
  flat.settings.rolling_resistance = flat.settings.pivot_radius = 0.0;
  leaning.settings = flat.settings;
  EXPECT_TRUE(flat.hold().holds);
  EXPECT_LT(flat.hold().tilt, 1e-9);
  EXPECT_EQ(flat.hold().resistance, 0.0);
  EXPECT_FALSE(leaning.hold().holds);
  EXPECT_EQ(leaning.hold().resistance, infinity);
}

TEST(Holds, NothingInTheAirAndEverythingWithoutGravity) {
  Laid laid;
  laid.pose.p_WB.z() += 1e-6;
  EXPECT_FALSE(laid.hold().holds);
  EXPECT_EQ(laid.hold().contacts, 0);
  EXPECT_NEAR(laid.hold().gap, 1e-6, 1e-15);
  EXPECT_EQ(laid.hold().friction, infinity);
  laid.settings.gravity.setZero();
  EXPECT_TRUE(laid.hold().holds);
  EXPECT_EQ(laid.hold().tilt, std::acos(0.0));
  EXPECT_TRUE(laid.hold());
}

TEST(Holds, GravityThatPullsAwayHoldsNothing) {
  Laid laid;
  laid.settings.gravity = -laid.settings.gravity;
  EXPECT_FALSE(laid.hold().holds);
  EXPECT_EQ(laid.hold().friction, infinity);
  EXPECT_EQ(laid.hold().resistance, infinity);
  EXPECT_EQ(laid.hold().tilt, 0.0);
}

/// A ball on the floor against the board's side.
TEST(Holds, BetweenFloorAndBoard) {
  const Board<double> board = make_board<double>();
  Laid laid;
  laid.stone = make_stone(0.022, 0.022);
  laid.settings.rolling_resistance = laid.settings.pivot_radius = 0.0;
  laid.pose.p_WB = {board.half_width + 0.011, 0.0, board.floor + 0.011};
  // Gravity that leans towards the board is borne by the side without friction, away from it by nothing.
  laid.settings.gravity = {-1.0, 0.0, -g_earth};
  const Hold<double> towards = holds(laid.stone, laid.pose, board, laid.settings);
  EXPECT_TRUE(towards.holds);
  EXPECT_EQ(towards.contacts, 2);
  EXPECT_EQ(towards.friction, 0.0);
  EXPECT_EQ(towards.resistance, 0.0);
  EXPECT_LT(towards.tilt, 1e-6);  // along the side it rolls at once
  for (const double friction : {2.0, infinity}) {
    laid.settings.friction = friction;
    EXPECT_LT(holds(laid.stone, laid.pose, board, laid.settings).tilt, 1e-6);
    EXPECT_EQ(holds(laid.stone, laid.pose, board, laid.settings).friction, 0.0);
  }
  laid.settings.friction = mu;
  laid.settings.gravity = {0.1, 0.0, -g_earth};
  EXPECT_FALSE(holds(laid.stone, laid.pose, board, laid.settings).holds);
  laid.settings.gravity = {-1.0, 0.1, -g_earth};
  EXPECT_FALSE(holds(laid.stone, laid.pose, board, laid.settings).holds);
}

TEST(Holds, RefusesWhatIsInside) {
  Laid laid;
  laid.pose.p_WB.z() -= 1e-6;
  test::expect_invalid("position", [&] { static_cast<void>(laid.hold()); });
  laid = Laid();
  laid.settings.friction = -1.0;
  test::expect_invalid("friction", [&] { static_cast<void>(laid.hold()); });
  laid = Laid();
  laid.pose.q_WB.w() = 2.0;
  EXPECT_THROW(static_cast<void>(laid.hold()), InvalidArgument);
}

TEST(Holds, InFloat) {
  const Stone<float> stone = make_stone(0.022F, 0.0092F, 0.001F);
  Pose<float> pose{{0.0F, 0.0F, 0.0F}, Quat<float>::Identity()};
  pose.p_WB.z() = -separation(stone, pose, Plane<float>{}).gap;
  const Hold<float> hold = holds(stone, pose, Plane<float>{}, DropSettings<float>{});
  EXPECT_TRUE(hold.holds);
  EXPECT_NEAR(hold.tilt / std::atan(1e-4F / 0.0046F), 1.0F, 0.02F);
}

}  // namespace

}  // namespace goishi::holds_test
