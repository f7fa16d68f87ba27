/// Drops: ends, statuses, records and what is skipped.

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "tests/allocations.hpp"
#include "tests/thrown.hpp"

namespace goishi::drop_test {

namespace {

int count(const DropResult<double>& drop, EventKind kind) {
  int found = 0;
  for (const Event<double>& event : drop.events) {
    found += event.kind == kind ? 1 : 0;
  }
  return found;
}

TEST(Drop, FlatStoneEndsAtTheSumOfItsBounces) {
  const Thrown thrown;
  const DropResult<double> drop = goishi::drop(thrown.stone, thrown.body, thrown.start);
  const double t0 = std::sqrt(2.0 * (0.05 - 0.0046) / 9.80665);
  EXPECT_EQ(drop.status, DropStatus::rest);
  EXPECT_NEAR(drop.time, 3.0 * t0, 1e-13);
  EXPECT_NEAR(drop.events[1].time, t0, 1e-15);
  EXPECT_EQ(drop.events.front().kind, EventKind::start);
  EXPECT_EQ(drop.events.back().kind, EventKind::rest);
  EXPECT_EQ(count(drop, EventKind::bounces_close), 1);
  // The impulses of all bounces, and gravity while they last, take the velocity away.
  const auto close = std::ranges::find(drop.events, EventKind::bounces_close, &Event<double>::kind);
  ASSERT_NE(close, drop.events.end());
  const double lasts = close->time - std::prev(close)->time, gain = close->impulse_W.z() / thrown.body.mass;
  const double v = close->before.v_WB.z();
  EXPECT_NEAR(lasts, 4.0 * v / 9.80665, 1e-15);  // 2 v/(g (1 − e)), with e = 1/2
  EXPECT_NEAR(v + gain - 9.80665 * lasts, 0.0, 1e-14);
  EXPECT_EQ(close->impulse_W.head<2>().norm() + close->after.v_WB.norm(), 0.0);
  EXPECT_EQ(close->normal_W, Vec3<double>(0.0, 0.0, 1.0));
  EXPECT_NEAR(close->contact_W.z(), 0.0, 1e-15);
  EXPECT_EQ(drop.counters.steps_accepted, 0);  // no contact phase where nothing turns
  EXPECT_NEAR(drop.state.p_WB.z(), 0.0046, 1e-15);
  EXPECT_EQ(drop.ground, Ground::board);
}

TEST(Drop, RecordsWhatHappens) {
  const Thrown thrown = tumbling();
  const DropResult<double> drop = goishi::drop(thrown.stone, thrown.body, thrown.start);
  ASSERT_EQ(drop.status, DropStatus::rest);
  double time = 0.0, energy = std::numeric_limits<double>::infinity();
  for (const Event<double>& event : drop.events) {
    EXPECT_LE(time, event.time);
    EXPECT_LE(event.energy, energy + 1e-12);
    time = event.time;
    energy = event.energy;
    if (event.kind == EventKind::impact) {
      EXPECT_NEAR((event.after.v_WB - event.before.v_WB - event.impulse_W / thrown.body.mass).norm(), 0.0, 1e-15);
      EXPECT_NEAR(event.contact_W.z(), 0.0, 1e-15);
      EXPECT_EQ(event.normal_W, Vec3<double>(0.0, 0.0, 1.0));
    }
  }
  EXPECT_EQ(count(drop, EventKind::impact), drop.counters.impacts);
  EXPECT_GT(drop.counters.contact_evaluations, 0);
  EXPECT_EQ(drop.state.v_WB.norm() + drop.state.L_W.norm(), 0.0);
  EXPECT_FALSE(drop.lower_order);
}

TEST(Drop, IsTheSameOnTheMiddleOfTheBoard) {
  const Thrown thrown = tumbling();
  const DropResult<double> plane = goishi::drop(thrown.stone, thrown.body, thrown.start);
  const DropResult<double> board = goishi::drop(thrown.stone, thrown.body, thrown.start, make_board<double>());
  EXPECT_EQ(plane.time, board.time);
  EXPECT_EQ(plane.state.p_WB, board.state.p_WB);
  EXPECT_EQ(plane.counters.separations, board.counters.separations);  // one axis, as on the plane
}

TEST(Drop, StopsWhenItIsTold) {
  const Thrown thrown = tumbling();
  DropSettings<double> settings;
  settings.maximum_impacts = 3;
  const DropResult<double> three = goishi::drop(thrown.stone, thrown.body, thrown.start, settings);
  EXPECT_EQ(three.status, DropStatus::moving);
  EXPECT_EQ(three.counters.impacts, 3);
  settings = {};
  settings.horizon = 0.25;
  const DropResult<double> early = goishi::drop(thrown.stone, thrown.body, thrown.start, settings);
  EXPECT_EQ(early.status, DropStatus::moving);
  EXPECT_EQ(early.time, 0.25);
  settings = {};
  settings.maximum_events = 4;
  EXPECT_EQ(goishi::drop(thrown.stone, thrown.body, thrown.start, settings).status, DropStatus::too_many_events);
  settings = {};
  settings.maximum_steps = 5;
  EXPECT_EQ(goishi::drop(thrown.stone, thrown.body, thrown.start, settings).status, DropStatus::too_many_steps);
}

TEST(Drop, GoesOnFromWhereItStopped) {
  const Thrown thrown = tumbling();
  const DropResult<double> whole = goishi::drop(thrown.stone, thrown.body, thrown.start);
  Drop<double> drop(thrown.stone, thrown.body, thrown.start);
  drop.advance_to(0.2);
  std::vector<Event<double>> told;
  drop.change(DropSettings<double>{}, told);  // to the same ones: it begins anew there
  EXPECT_EQ(told.front().kind, EventKind::woken);
  const DropResult<double> rest = followed(drop);
  EXPECT_NEAR(rest.time, whole.time, 1e-7);
  EXPECT_NEAR((rest.state.p_WB - whole.state.p_WB).norm(), 0.0, 1e-7);
}

TEST(Drop, RestGoesOnUntilGravityMovesIt) {
  const Thrown thrown;
  Drop<double> rested(thrown.stone, thrown.body, thrown.start);
  const int steps = followed(rested).counters.steps_accepted;
  const auto on_slope = [&](double angle) {
    DropSettings<double> settings;
    settings.gravity = 9.80665 * Vec3<double>(std::sin(angle), 0.0, -std::cos(angle));
    settings.horizon = 0.5;
    Drop<double> again = rested;
    again.change(settings);
    return followed(again);
  };
  EXPECT_EQ(on_slope(0.0).status, DropStatus::rest);
  EXPECT_EQ(on_slope(0.0).counters.steps_accepted, steps);
  EXPECT_EQ(on_slope(0.005).status, DropStatus::rest);  // within δ/(r − d)
  const DropResult<double> slid = on_slope(0.5);        // beyond atan μ
  EXPECT_EQ(slid.status, DropStatus::moving);
  EXPECT_GT(slid.state.p_WB.x(), 0.1);
}

TEST(Drop, FallsOffTheBoardOntoTheFloor) {
  Thrown thrown = tumbling();
  const Board<double> board = make_board<double>();
  thrown.start.p_WB.x() = board.half_width - 0.02;
  thrown.start.v_WB = {0.5, 0.0, 0.0};
  const DropResult<double> drop = goishi::drop(thrown.stone, thrown.body, thrown.start, board);
  EXPECT_EQ(drop.status, DropStatus::rest);
  EXPECT_EQ(drop.ground, Ground::floor);
  const Plane<double> floor{Vec3<double>(0.0, 0.0, 1.0), board.floor};
  EXPECT_NEAR(separation(thrown.stone, Pose<double>{drop.state.p_WB, drop.state.q_WB}, floor).gap, 0.0, 1e-15);
}

TEST(Drop, DoesNotSumBouncesBeyondTheEdge) {
  const Stone<double> ball = make_stone(0.022, 0.022);
  const RigidBody<double> body = make_rigid_body(mass_properties(ball, Density{2800.0}));
  const Board<double> board = make_board<double>();
  const auto rolling = [&](double from_edge) {
    const double speed = 0.05;
    State<double> start{.p_WB = {board.half_width - from_edge, 0.0, 0.011 + 1e-5},
                        .q_WB = Quat<double>::Identity(),
                        .v_WB = {speed, 0.0, 0.0},
                        .L_W = {0.0, body.moments.y() * speed / 0.011, 0.0}};
    DropSettings<double> settings;
    settings.rolling_resistance = settings.pivot_radius = 0.0;
    settings.horizon = 0.02;
    return goishi::drop(ball, body, start, board, settings);
  };
  EXPECT_EQ(count(rolling(1e-2), EventKind::bounces_close), 1);
  EXPECT_EQ(count(rolling(1e-4), EventKind::bounces_close), 0);
}

TEST(Drop, FliesOnWithoutGravity) {
  Thrown thrown = tumbling();
  DropSettings<double> settings;
  settings.gravity = Vec3<double>::Zero();
  settings.horizon = std::numeric_limits<double>::infinity();
  thrown.start.v_WB = {0.0, 0.0, 1.0};
  EXPECT_EQ(goishi::drop(thrown.stone, thrown.body, thrown.start, settings).status, DropStatus::flies_on);
}

TEST(Drop, SaysHowDeepAStartIsInside) {
  Thrown thrown;
  thrown.start.p_WB.z() = 0.004;
  const DropResult<double> drop = goishi::drop(thrown.stone, thrown.body, thrown.start);
  EXPECT_EQ(drop.status, DropStatus::start_inside);
  EXPECT_NEAR(drop.depth, 0.0006, 1e-15);
  EXPECT_EQ(goishi::drop(thrown.stone, thrown.body, thrown.start, make_board<double>()).status,
            DropStatus::start_inside);
}

TEST(Drop, AllocatesForItsEventsAlone) {
  const Thrown thrown = tumbling();
  DropSettings<double> settings;
  settings.maximum_impacts = 10;
  const long before = test::allocations();
  const DropResult<double> drop = goishi::drop(thrown.stone, thrown.body, thrown.start, settings);
  EXPECT_EQ(test::allocations() - before, 1);
  EXPECT_EQ(drop.counters.impacts, 10);
}

TEST(Drop, WorksInLongDouble) {
  const Stone<long double> stone = make_stone(0.022L, 0.0092L, 0.001L);
  const RigidBody<long double> body = make_rigid_body(mass_properties(stone, Density<long double>{2800.0L}));
  const State<long double> start{.p_WB = {0.0L, 0.0L, 0.05L},
                                 .q_WB = Quat<long double>(0.5L, 0.5L, -0.1L, 0.7L).normalized(),
                                 .v_WB = {0.0L, 0.0L, 0.0L},
                                 .L_W = {3e-6L, -2e-6L, 4e-6L}};
  const DropResult<long double> drop = goishi::drop(stone, body, start);
  const Thrown thrown = tumbling();
  const DropResult<double> in_double = goishi::drop(thrown.stone, thrown.body, thrown.start);
  EXPECT_EQ(drop.status, DropStatus::rest);
  EXPECT_NEAR(static_cast<double>(drop.time), in_double.time, 1e-7);
}

}  // namespace

}  // namespace goishi::drop_test
