/// A drop as a value: cut, copied, stopped, pushed, changed, and looked back on.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/allocations.hpp"
#include "tests/thrown.hpp"

namespace goishi::drop_test {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN();

/// At the tolerance of a game.
Thrown rough() {
  Thrown thrown = tumbling();
  thrown.settings.tolerance = 1e-6;
  return thrown;
}

Drop<double> drop_of(const Thrown& thrown) {
  return {thrown.stone, thrown.body, thrown.start, thrown.settings};
}

bool same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

/// Every kind of motion: on the plane, over an edge, bounces that are summed, slides that do not turn, smooth friction.
std::vector<Drop<double>> all_kinds() {
  std::vector<Drop<double>> drops = {drop_of(rough()), drop_of(Thrown{})};
  const Board<double> board = make_board<double>();
  Thrown edge = rough();
  edge.start.p_WB.x() = board.half_width - 0.003;
  edge.settings.restitution = 0.2;
  drops.emplace_back(edge.stone, edge.body, edge.start, board, edge.settings);
  Thrown locked;
  locked.start.p_WB.z() = 0.0046;
  locked.start.v_WB = {0.3, 0.0, 0.0};
  locked.settings.friction = 0.05;
  locked.settings.rolling_resistance = locked.settings.pivot_radius = 0.001;
  drops.push_back(drop_of(locked));
  Thrown smooth = rough();
  smooth.settings.friction_model = FrictionModel::coulomb_contensou;
  smooth.settings.horizon = 0.5;
  drops.push_back(drop_of(smooth));
  return drops;
}

/// Goes on to the end, by steps that end at these times.
std::vector<Event<double>> cut(Drop<double>& drop, std::vector<double> times, bool copies) {
  std::vector<Event<double>> events;
  std::ranges::sort(times);
  for (const double time : times) {
    if (drop.time() <= time) {
      drop.advance_to(time, events);
    }
    if (copies) {
      const Drop<double> stored = drop;
      drop.advance(1.0);
      drop.apply_impulse({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
      drop = stored;
    }
  }
  return events;
}

TEST(DropValue, DoesNotDependOnHowTimeIsCut) {
  std::mt19937_64 random(1);
  for (const Drop<double>& fresh : all_kinds()) {
    const double end = fresh.settings().horizon.value_or(1.5);
    Drop<double> whole = fresh;
    const std::vector<Event<double>> told = cut(whole, {end}, false);
    ASSERT_LE(3U, told.size());
    for (const std::size_t pieces : {1U, 7U, 100U, 1000U}) {
      std::vector<double> times = {end};
      std::uniform_real_distribution<double> any(0.0, end);
      std::generate_n(std::back_inserter(times), pieces - 1, [&] { return any(random); });
      times.push_back(told[1].time);  // just at an event, too
      Drop<double> other = fresh;
      if (pieces % 2 == 0) {
        other.keep_motion();
      }
      const std::vector<Event<double>> events = cut(other, times, pieces == 7);
      EXPECT_TRUE(same(other.state(), whole.state())) << pieces;
      EXPECT_EQ(other.status(), whole.status());
      ASSERT_EQ(events.size(), told.size());
      for (std::size_t i = 0; i < told.size(); ++i) {
        EXPECT_EQ(events[i].kind, told[i].kind);
        EXPECT_EQ(events[i].time, told[i].time);
        EXPECT_TRUE(same(events[i].after, told[i].after));
        EXPECT_TRUE(same(events[i].before, told[i].before));
      }
      EXPECT_EQ(other.counters().contact_evaluations, whole.counters().contact_evaluations);
    }
    Drop<double> unseen = fresh;
    unseen.advance_to(end);
    EXPECT_TRUE(same(unseen.state(), whole.state()));
  }
}

TEST(DropValue, ABudgetStopsItWhereItGoesOn) {
  const Drop<double> fresh = drop_of(rough());
  Drop<double> whole = fresh, part = fresh;
  EXPECT_EQ(whole.advance_to_rest(), DropStatus::rest);
  int calls = 0;
  while (part.advance_to_rest({}, 3) == DropStatus::too_many_steps) {
    ASSERT_LT(++calls, 100000);
    ASSERT_LE(part.time(), whole.time());
  }
  EXPECT_GT(calls, 50);
  EXPECT_EQ(part.status(), DropStatus::rest);
  EXPECT_EQ(part.time(), whole.time());
  EXPECT_TRUE(same(part.state(), whole.state()));
}

TEST(DropValue, TellsOfNothingThatIsStillToCome) {
  Drop<double> drop = drop_of(Thrown{});
  double last = 0.0;
  int seen = 0;
  const auto sink = [&](const Event<double>& event) {
    EXPECT_LE(event.time, last);
    ++seen;
  };
  for (last = 0.0; last < 0.4; last += 0.001) {
    drop.advance_to(last, sink);
  }
  EXPECT_EQ(seen, drop.counters().events);
  EXPECT_EQ(drop.status(), DropStatus::rest);
  EXPECT_EQ(drop.time(), last - 0.001);  // a stone at rest has time, too
}

TEST(DropValue, StopsAfterSoManyImpactsAndGoesOn) {
  Thrown thrown = rough();
  Drop<double> whole = drop_of(thrown);
  whole.advance_to_rest();
  thrown.settings.maximum_impacts = 2;
  Drop<double> drop = drop_of(thrown);
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::moving);
  EXPECT_EQ(drop.counters().impacts, 2);
  while (drop.advance_to_rest() == DropStatus::moving) {
  }
  EXPECT_TRUE(same(drop.state(), whole.state()));
}

TEST(DropValue, AllocatesNothing) {
  Drop<double> drop = drop_of(rough());
  int events = 0;
  const long before = test::allocations();
  EXPECT_EQ(drop.advance_to_rest([&](const Event<double>&) { ++events; }), DropStatus::rest);
  EXPECT_EQ(test::allocations() - before, 0);
  EXPECT_EQ(events, drop.counters().events);
}

// --- looking back

TEST(DropValue, ShowsTheStateAtAnyTime) {
  for (Drop<double> drop : all_kinds()) {
    drop.keep_motion();
    const DropResult<double> result = followed(drop);
    EXPECT_EQ(drop.motion_begin(), 0.0);
    for (const Event<double>& event : result.events) {
      const State<double> before = drop.state_at(event.time, Side::before), after = drop.state_at(event.time);
      const double size = 1e-12 * (1.0 + event.after.p_WB.norm());
      EXPECT_LT((before.p_WB - event.before.p_WB).norm(), size) << to_string(event.kind);
      EXPECT_LT((after.p_WB - event.after.p_WB).norm(), size) << to_string(event.kind);
    }
    EXPECT_TRUE(same(drop.state_at(drop.time()), drop.state()));
    const double step = drop.time() / 997.0;
    std::vector<State<double>> forwards;
    for (int i = 0; i < 997; ++i) {
      forwards.push_back(drop.state_at(i * step));
    }
    for (int i = 996; 0 <= i; --i) {
      EXPECT_TRUE(same(drop.state_at(i * step), forwards[static_cast<std::size_t>(i)]));
    }
  }
}

TEST(DropValue, ShowsBothSidesOfAnImpact) {
  Drop<double> drop = drop_of(rough());
  drop.keep_motion();
  const DropResult<double> result = followed(drop);
  const auto impact = std::ranges::find(result.events, EventKind::impact, &Event<double>::kind);
  EXPECT_TRUE(same(drop.state_at(impact->time, Side::before), impact->before));
  EXPECT_TRUE(same(drop.state_at(impact->time, Side::after), impact->after));
  EXPECT_TRUE(same(drop.state_at(impact->time), impact->after));
}

TEST(DropValue, KeepsNoMoreMotionThanItIsTold) {
  Drop<double> all = drop_of(rough()), some = all;
  all.keep_motion();
  some.keep_motion(200);
  const DropResult<double> result = followed(all);
  some.advance_to_rest();
  EXPECT_GT(some.motion_begin(), 0.0);
  EXPECT_EQ(some.kept(), 200U);
  int told = 0;
  for (const Event<double>& event : result.events) {
    if (some.motion_begin() < event.time) {
      ++told;
      EXPECT_TRUE(same(some.state_at(event.time), all.state_at(event.time)));
      EXPECT_TRUE(same(some.state_at(event.time, Side::before), all.state_at(event.time, Side::before)));
    }
  }
  EXPECT_GT(told, 3);
  for (int i = 0; i <= 100; ++i) {
    const double time = some.motion_begin() + (some.time() - some.motion_begin()) * i / 100.0;
    EXPECT_TRUE(same(some.state_at(time), all.state_at(time))) << i;
    EXPECT_TRUE(same(some.state_at(time, Side::before), all.state_at(time, Side::before)) || i == 0) << i;
  }
  EXPECT_THROW(static_cast<void>(some.state_at(std::nextafter(some.motion_begin(), 0.0))), InvalidArgument);
  some.keep_motion(0);
  EXPECT_EQ(some.motion_begin(), some.time());
}

// --- what is done to it

TEST(DropValue, AnImpulseMovesAStoneAtRest) {
  Drop<double> drop = drop_of(rough());
  drop.keep_motion();
  drop.advance_to_rest();
  const double rested = drop.time();
  drop.advance(0.25);
  const State<double> before = drop.state();
  const Vec3<double> P(1e-3, 0.0, 5e-4);
  std::vector<Event<double>> told;
  drop.apply_impulse(before.p_WB, P, told);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].kind, EventKind::push);
  EXPECT_EQ(told[0].time, rested + 0.25);
  EXPECT_EQ(told[0].impulse_W, P);
  EXPECT_TRUE(same(told[0].before, before));
  EXPECT_LT((drop.state().v_WB - P / drop.body().mass).norm(), 1e-15);
  EXPECT_EQ(drop.state().L_W, before.L_W);
  EXPECT_EQ(drop.status(), DropStatus::moving);
  EXPECT_EQ(drop.ground(), Ground::board);
  const DropCounters until_then = drop.counters();
  EXPECT_GT(until_then.impacts, 3);
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::rest);
  EXPECT_GT(drop.counters().contact_evaluations, until_then.contact_evaluations);
  EXPECT_GT((drop.state().p_WB - before.p_WB).norm(), 0.005);
  EXPECT_TRUE(same(drop.state_at(rested + 0.1), before));
  EXPECT_TRUE(same(drop.state_at(rested + 0.25, Side::before), before));
  EXPECT_EQ(drop.state_at(rested + 0.25).v_WB, told[0].after.v_WB);
}

TEST(DropValue, AnImpulseInTheAirActsThere) {
  Thrown thrown;
  Drop<double> drop = drop_of(thrown);
  drop.advance(0.05);
  const Vec3<double> arm(0.0, 0.005, 0.0), P(0.0, 0.0, 1e-3);
  const State<double> before = drop.state();
  std::vector<Event<double>> told;
  drop.apply_impulse(before.p_WB + arm, P);
  EXPECT_LT((drop.state().L_W - before.L_W - arm.cross(P)).norm(), 1e-20);
  drop.advance(0.01, told);
  EXPECT_TRUE(told.empty());
  // Before anything else it begins.
  Drop<double> fresh = drop_of(thrown);
  fresh.apply_impulse(thrown.start.p_WB, P, told);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].kind, EventKind::start);
  EXPECT_EQ(told[1].kind, EventKind::push);
}

TEST(DropValue, WhatWasStaysSoUnderAnotherGravity) {
  Drop<double> drop = drop_of(rough());
  drop.keep_motion();
  drop.advance_to(0.5);
  std::vector<State<double>> before;
  for (int i = 0; i < 500; ++i) {
    before.push_back(drop.state_at(i * 1e-3));
  }
  DropSettings<double> settings = rough().settings;
  settings.gravity = {3.0, -2.0, -1.0};
  drop.change(settings);
  drop.advance(0.1);
  for (int i = 0; i < 500; ++i) {
    EXPECT_TRUE(same(drop.state_at(i * 1e-3), before[static_cast<std::size_t>(i)])) << i;
  }
}

TEST(DropValue, AnotherBoardLetsItFall) {
  Thrown thrown;
  const Board<double> board = make_board<double>();
  thrown.start.p_WB.x() = board.half_width + 0.1;
  Drop<double> drop(thrown.stone, thrown.body, thrown.start, thrown.settings);
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::rest);
  EXPECT_FALSE(drop.board());
  const double height = drop.state().p_WB.z();
  drop.change(std::optional<Board<double>>(board));
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::rest);
  EXPECT_EQ(drop.ground(), Ground::floor);
  EXPECT_FALSE(drop.lower_order());
  EXPECT_NEAR(drop.state().p_WB.z(), height + board.floor, 1e-12);
  // It is inside what comes back.
  drop.change(std::optional<Board<double>>());
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::start_inside);
  EXPECT_NEAR(drop.depth(), 0.0046 - drop.state().p_WB.z(), 1e-12);
}

TEST(DropValue, WhatFliesOnGoesOnFlying) {
  Thrown thrown;
  thrown.settings.gravity = Vec3<double>::Zero();
  thrown.settings.horizon = unbounded;
  thrown.start.v_WB = {0.0, 0.0, 1.0};
  Drop<double> drop = drop_of(thrown);
  EXPECT_EQ(drop.advance_to_rest(), DropStatus::flies_on);
  drop.advance(3.0);
  EXPECT_EQ(drop.status(), DropStatus::flies_on);
  EXPECT_DOUBLE_EQ(drop.state().p_WB.z(), 3.05);
}

// --- bad input

template <class F>
std::string refused(F&& call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(DropValue, RefusesWhatIsNot) {
  Drop<double> drop = drop_of(rough());
  drop.advance(0.1);
  for (const double dt : {-1e-300, no_number, unbounded}) {
    EXPECT_NE(refused([&] { drop.advance(dt); }).find("dt"), std::string::npos) << dt;
  }
  Drop<double> late = drop_of(Thrown{});
  late.advance_to(1.7e308);
  EXPECT_NE(refused([&] { late.advance(1e308); }).find("dt"), std::string::npos);
  EXPECT_EQ(late.status(), DropStatus::rest);
  for (const double time : {0.0999, no_number, unbounded}) {
    EXPECT_NE(refused([&] { drop.advance_to(time); }).find("time"), std::string::npos) << time;
  }
  EXPECT_NE(refused([&] { drop.advance(0.1, {}, 0); }).find("budget = 0"), std::string::npos);
  EXPECT_NE(refused([&] { drop.advance_to_rest({}, -1); }).find("budget = -1"), std::string::npos);
  EXPECT_NE(refused([&] {
              drop.apply_impulse({no_number, 0.0, 0.0}, {0.0, 0.0, 0.0});
            }).find("p_W"),
            std::string::npos);
  EXPECT_NE(refused([&] {
              drop.apply_impulse({0.0, 0.0, 0.0}, {0.0, unbounded, 0.0});
            }).find("P_W"),
            std::string::npos);
  EXPECT_EQ(drop.time(), 0.1);
  const auto asked = [&](double time) { return refused([&] { static_cast<void>(drop.state_at(time)); }); };
  EXPECT_EQ(asked(0.05), "time = 0.05: has no motion kept, which there is from 0.1");
  EXPECT_EQ(asked(0.2), "time = 0.2: is after what has been computed, up to 0.1");
  EXPECT_NE(asked(no_number), "");
  drop.keep_motion(1);
  drop.advance(0.5);
  EXPECT_NE(asked(0.01).find("is before the motion that is kept, from "), std::string::npos);
  DropSettings<double> wrong;
  wrong.restitution = 2.0;
  EXPECT_NE(refused([&] { drop.change(wrong); }), "");
  EXPECT_EQ(drop.settings().restitution, rough().settings.restitution);  // as before
}

}  // namespace

}  // namespace goishi::drop_test
