/// Drops at the limits: no gravity, no horizon, stiff resistance, any size, laws without sticking, float.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/expectations.hpp"
#include "tests/thrown.hpp"

namespace goishi::drop_test {

namespace {

using test::infinity;

// --- no gravity, no horizon

TEST(DropLimits, WithoutGravityWhatDoesNotMoveRests) {
  for (const double height : {0.0046, 0.05}) {  // touching, and in the air
    for (const double horizon : {1.0, infinity}) {
      Thrown stone;
      stone.start.p_WB.z() = height;
      stone.settings.gravity = Vec3<double>::Zero();
      stone.settings.horizon = horizon;
      EXPECT_EQ(stone.drop().status, DropStatus::rest) << height;
      EXPECT_EQ(stone.drop_on_board().status, DropStatus::rest) << height;
      EXPECT_EQ(stone.drop().time, 0.0);
    }
  }
}

TEST(DropLimits, WithoutGravityAPlasticImpactEndsAtRest) {
  Thrown stone;
  stone.settings.gravity = Vec3<double>::Zero();
  stone.settings.horizon = infinity;
  stone.settings.restitution = 0.0;
  stone.start.v_WB.z() = -1.0;
  EXPECT_EQ(stone.drop().status, DropStatus::rest);
  EXPECT_NEAR(stone.drop().time, 0.0454, 1e-15);
}

/// The side of the board, and gravity along the surface: nothing that rests or floats gets a speed from nowhere.
TEST(DropLimits, NoEnergyFromNothing) {
  Thrown beside;
  const Board<double> board = make_board<double>();
  beside.settings.gravity = Vec3<double>::Zero();
  beside.start.p_WB = {board.half_width, 0.0, 0.0046};  // over the edge
  EXPECT_EQ(beside.drop_on_board().state.v_WB.norm(), 0.0);
  Thrown along;
  along.settings.gravity = {1.0, 0.0, 0.0};
  along.settings.horizon = 0.1;
  along.start.p_WB.z() = 0.0046;
  const DropResult<double> drop = along.drop();
  EXPECT_EQ(drop.status, DropStatus::moving);
  EXPECT_NEAR(drop.state.v_WB.x(), 0.1, 1e-15);
  EXPECT_NEAR(drop.state.v_WB.z(), 0.0, 1e-15);
}

TEST(DropLimits, AnInfiniteHorizonHasFiniteTimes) {
  Thrown stone;
  stone.settings.friction = 0.01;
  stone.settings.horizon = infinity;
  stone.start.p_WB.z() = 0.0046;
  stone.start.v_WB.x() = 0.1;
  const DropResult<double> drop = stone.drop();
  EXPECT_EQ(drop.status, DropStatus::rest);
  EXPECT_NEAR(drop.time, 0.1 / (0.01 * g_earth), 1e-12);
  for (const Event<double>& event : drop.events) {
    EXPECT_TRUE(std::isfinite(event.time));
  }
}

TEST(DropLimits, ThinStonesComeToRest) {
  for (const double thin : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    for (const double bevel : {0.0, 0.3}) {
      for (const double degrees : {20.0, 88.0}) {
        Thrown stone = thrown(make_stone(0.022, 0.022 * thin, 0.022 * thin * bevel));
        stone.tilt(degrees);
        stone.settings.tolerance = 1e-6;
        const DropResult<double> drop = stone.drop_on_board();
        EXPECT_EQ(drop.status, DropStatus::rest) << thin << ", " << bevel << ", " << degrees;
        EXPECT_LT(drop.counters.work(), 200000) << thin << ", " << bevel << ", " << degrees;
      }
    }
  }
}

TEST(DropLimits, NothingThatNeverEndsIsFollowedWithoutEnd) {
  Thrown stone;  // neither friction nor resistance
  stone.settings.friction = 0.0;
  stone.settings.rolling_resistance = stone.settings.pivot_radius = 0.0;
  stone.settings.horizon = infinity;
  stone.settings.maximum_steps = 20000;
  stone.settings.restitution = 0.3;
  stone.tilt(20.0);
  const DropResult<double> drop = stone.drop();
  EXPECT_EQ(drop.status, DropStatus::too_many_steps);
  EXPECT_GE(drop.counters.work(), 20000);
  EXPECT_LE(drop.counters.work(), 21000);
}

/// Whatever is done to a stone at rest, and under whatever friction: what a call computes beyond its budget is one stretch's.
TEST(DropLimits, APushOfAnySizeKeepsToTheBudget) {
  constexpr int budget = 500;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int pushed = 0;
  long long most = 0;
  for (int i = 0; i < 2000; ++i) {
    Thrown stone;
    const double frictions[] = {0.0, 1e-100, 0.3, 3.0, 1e100, infinity}, lengths[] = {0.0, 1e-100, 1e-10, 1e-4, 1e-2};
    stone.settings.friction_model = static_cast<FrictionModel>(random() % 3);
    stone.settings.friction = frictions[random() % 6];
    stone.settings.rolling_resistance = lengths[random() % 5];
    stone.settings.pivot_radius = lengths[random() % 5];
    stone.start.p_WB.z() = 0.0046;
    Drop<double> drop(stone.stone, stone.body, stone.start, stone.settings);
    static_cast<void>(drop.advance_to_rest({}, budget));
    const Vec3<double> at(0.01 * unit(random), 0.01 * unit(random), 0.0092 * (0.5 + unit(random) / 2.0));
    const Vec3<double> push =
        std::pow(10.0, 70.0 * unit(random)) * Vec3<double>(unit(random), unit(random), unit(random));
    drop.apply_impulse(at, push);
    const long long before = drop.counters().work();
    static_cast<void>(drop.advance_to_rest({}, budget));
    const long long done = drop.counters().work() - before;
    pushed += 0 < done ? 1 : 0;
    most = std::max(most, done);
  }
  EXPECT_LT(800, pushed);
  EXPECT_LT(most, budget + 100);
}

// --- resistance

TEST(DropLimits, PivotFrictionFarAboveRollingResistanceEnds) {
  Thrown stone;
  stone.start.p_WB.z() = 0.03;
  stone.tilt(10.0);
  stone.spin({10.0, 5.0, 10.0});
  stone.settings.pivot_radius = 1e-3;
  stone.settings.rolling_resistance = 1e-5;
  const DropResult<double> drop = stone.drop();
  EXPECT_EQ(drop.status, DropStatus::rest);
  EXPECT_LT(drop.counters.contact_evaluations, 500000);
}

TEST(DropLimits, StickAndSlipDoNotAlternateAtOneTime) {
  for (const double delta : {1e-3, 2e-3, 3e-3, 5.5e-3}) {
    Thrown stone;
    stone.tilt(20.0);
    stone.settings.rolling_resistance = delta;
    const DropResult<double> drop = stone.drop();
    EXPECT_EQ(drop.status, DropStatus::rest) << delta;
    for (std::size_t i = 1; i < drop.events.size(); ++i) {
      const Event<double>&a = drop.events[i - 1], &b = drop.events[i];
      const bool opposite = (a.kind == EventKind::stick && b.kind == EventKind::slip) ||
                            (a.kind == EventKind::slip && b.kind == EventKind::stick);
      EXPECT_FALSE(opposite && b.time - a.time < 1e-9) << delta << " at " << b.time;
    }
  }
}

TEST(DropLimits, LengthsOfResistanceAreThoseOfTheStone) {
  for (const double bad : {0.0111, 0.3}) {
    for (std::optional<double> DropSettings<double>::*length :
         {&DropSettings<double>::rolling_resistance, &DropSettings<double>::pivot_radius,
          &DropSettings<double>::patch_radius}) {
      Thrown stone;
      stone.settings.*length = bad;
      test::expect_invalid(length == &DropSettings<double>::rolling_resistance ? "rolling_resistance"
                           : length == &DropSettings<double>::pivot_radius     ? "pivot_radius"
                                                                               : "patch_radius",
                           [&] { (void)stone.drop(); });
      stone.settings.*length = 0.011;
      EXPECT_NO_THROW((void)stone.drop());
    }
  }
}

TEST(DropLimits, TheSteepestDiscOnASlopeIsBounded) {
  Thrown disc = thrown(make_stone(0.022, 2.2e-6));
  disc.settings.friction = 1e6;
  disc.settings.gravity = g_earth * std::sqrt(0.5) * Vec3<double>(1.0, 0.0, -1.0);
  disc.settings.horizon = 5.0;
  disc.start.p_WB.z() = 0.02;
  disc.tilt(30.0);
  disc.spin({20.0, 10.0, 30.0});
  const DropResult<double> drop = disc.drop();
  EXPECT_NE(drop.status, DropStatus::not_converged);
  EXPECT_LE(drop.counters.work(), 2000000 + 1000000);
}

// --- rest

/// A slope of half a degree under laws that do not stick: the stone creeps on, at tan α / c under the one.
TEST(DropLimits, LawsThatDoNotStickDoNotRestOnASlope) {
  Thrown stone;
  stone.settings.gravity = {0.085578, 0.0, -9.80628};
  stone.settings.horizon = 1.0;
  stone.start.p_WB.z() = 0.0046;
  stone.settings.friction_model = FrictionModel::slip_proportional;
  stone.settings.slip_coefficient = 1.0;
  const DropResult<double> proportional = stone.drop();
  EXPECT_EQ(proportional.status, DropStatus::moving);
  const double fast = 0.085578 / 9.80628;
  EXPECT_NEAR(proportional.state.v_WB.x(), fast * -std::expm1(-9.80628), 1e-10);
  stone.settings.friction_model = FrictionModel::coulomb_contensou;
  const DropResult<double> patch = stone.drop();
  EXPECT_EQ(patch.status, DropStatus::moving);
  EXPECT_GT(patch.state.v_WB.x(), 1e-7);
  stone.settings.friction_model = FrictionModel::dry;
  EXPECT_EQ(stone.drop().status, DropStatus::rest);
}

/// On the edge, its centre 10 µm beyond it: c cosh λt, λ² = 5g/7R.
TEST(DropLimits, ABallBeyondTheEdgeFalls) {
  Thrown ball = thrown(make_stone(0.02, 0.02));
  const double edge = make_board<double>().half_width, c = 1e-5, R = 0.01;
  ball.settings.rolling_resistance = ball.settings.pivot_radius = 0.0;
  ball.start.p_WB = {edge + c, 0.0, std::sqrt(R * R - c * c)};
  ball.settings.friction = infinity;
  const double rate = std::sqrt(5.0 * g_earth / (7.0 * R)), time = std::acosh(100.0) / rate;
  ball.settings.horizon = time;
  const DropResult<double> early = ball.drop_on_board();
  EXPECT_EQ(early.status, DropStatus::moving);
  EXPECT_NEAR((early.state.p_WB.x() - edge) / c, 100.0, 5.0);
  ball.settings.horizon = 0.4;
  EXPECT_LT(ball.drop_on_board().state.p_WB.z(), -0.05);
  // Exactly over it, it balances.
  ball.start.p_WB = {edge, 0.0, R};
  EXPECT_EQ(ball.drop_on_board().status, DropStatus::rest_leaning);
}

TEST(DropLimits, AStoneOfAnySizeFallsOffTheEdge) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    Thrown stone = thrown(make_stone(0.022 * size, 0.0092 * size, 0.001 * size));
    BoardDimensions<double> dimensions;
    for (double BoardDimensions<double>::*length :
         {&BoardDimensions<double>::border_x, &BoardDimensions<double>::border_y, &BoardDimensions<double>::thickness,
          &BoardDimensions<double>::legs, &BoardDimensions<double>::spacing_x, &BoardDimensions<double>::spacing_y}) {
      dimensions.*length *= size;
    }
    const Board<double> board = make_board(dimensions);
    stone.settings.rolling_resistance = stone.settings.pivot_radius = 0.0;
    stone.start.p_WB = {board.half_width + 1e-3 * size, 0.0, 0.00465 * size};
    stone.settings.horizon = 2.0 * std::sqrt(size);
    const DropResult<double> drop = goishi::drop(stone.stone, stone.body, stone.start, board, stone.settings);
    EXPECT_LT(drop.state.p_WB.z(), -0.1 * size) << size;
  }
}

TEST(DropLimits, ASmallStoneRests) {
  Thrown stone = thrown(make_stone(22e-6, 9.2e-6));
  stone.start.p_WB.z() = 50e-6;
  stone.tilt(20.0);
  EXPECT_EQ(stone.drop().status, DropStatus::rest);
}

// --- numbers

TEST(DropLimits, AnAttitudeThatIsUnitToRoundOffIsTaken) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (const double off : {-60.0, -32.0, 32.0, 50.0, 60.0}) {
    Thrown stone;
    const double k = std::sqrt(0.5 * (1.0 + off * epsilon));
    stone.start.q_WB = {k, 0.0, k, 0.0};
    EXPECT_EQ(stone.drop().status, DropStatus::rest) << off;
    EXPECT_EQ(stone.drop_on_board().status, DropStatus::rest) << off;
  }
}

TEST(DropLimits, WorksInFloat) {
  const Stone<float> stone = make_stone(0.022F, 0.0092F, 0.001F);
  const RigidBody<float> body = make_rigid_body(mass_properties(stone, Density<float>{2800.0F}));
  const Board<float> board = make_board<float>();
  for (const float height : {0.006F, 0.05F}) {
    const State<float> start{.p_WB = {0.0F, 0.0F, height},
                             .q_WB = Quat<float>(std::cos(0.1F), 0.0F, std::sin(0.1F), 0.0F),
                             .v_WB = {0.0F, 0.0F, 0.0F},
                             .L_W = {0.0F, 0.0F, 0.0F}};
    EXPECT_EQ(drop(stone, body, start).status, DropStatus::rest);
    const DropResult<float> on_board = drop(stone, body, start, board);
    EXPECT_EQ(on_board.status, DropStatus::rest);
    const Separation<float> touch =
        separation(stone, Pose<float>{on_board.state.p_WB, on_board.state.q_WB},
                   Plane<float>{Vec3<float>::UnitZ(), on_board.ground == Ground::floor ? board.floor : 0.0F});
    EXPECT_NEAR(touch.gap, 0.0F, 1e-7F);
  }
}

}  // namespace

}  // namespace goishi::drop_test
