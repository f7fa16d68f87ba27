/// What drops seldom do: hops at an edge or at two places, bounces that are closed, slides that do not turn.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <goishi/drop/holds.hpp>
#include <optional>
#include <utility>

#include "tests/thrown.hpp"

namespace goishi::drop_test {

namespace {

using detail::ContactScales;
using detail::ContactState;
using detail::EdgeHops;
using detail::Interpolant;
using detail::Run;

/// A stone that hits the board's surface with its rim, at its place for good: what changes is the motion.
struct Hopping {
  Thrown thrown_;
  Board<double> board = make_board<double>();
  Run<double> run;
  EdgeHops<double> hops;
  std::vector<Event<double>> events;
  Separation<double> contact;

  static Thrown tilted(const DropSettings<double>& settings, double degrees) {
    Thrown stone;
    stone.settings = settings;
    stone.tilt(degrees);
    stone.start.p_WB = {0.02, 0.01, 0.02};
    return stone;
  }
  explicit Hopping(const DropSettings<double>& settings, double degrees = 50.0)
      : thrown_(tilted(settings, degrees)),
        run(detail::make_run<double>(thrown_.stone, thrown_.body, board, thrown_.start, settings, 0.0)),
        contact(separation(thrown_.stone, Pose<double>{run.state.p_WB, run.state.q_WB}, board)) {}

  [[nodiscard]] double approach() const {
    const ImpactBody<double> body = detail::impact_body(run);
    return -contact.n_W.dot(formula::point_velocity(body, Vec3<double>(contact.p_stone - body.p_WB)));
  }
  [[nodiscard]] double edge_speed() const { return *run.settings.edge_speed; }
  bool hop() {
    run.sink = EventSink<double>(events);
    return hops.hop(run, contact, approach());
  }
};

DropSettings<double> smooth() {
  DropSettings<double> settings;
  settings.friction = settings.damping = 0.0;
  settings.rolling_resistance = settings.pivot_radius = 0.0;
  return settings;
}

TEST(EdgeHops, AreElastic) {
  Hopping scene(smooth());
  scene.run.state.v_WB = {0.1, 0.0, -2.0 * scene.edge_speed()};
  const double energy = scene.run.energy(), approach = scene.approach();
  scene.hop();
  EXPECT_NEAR(scene.run.energy() / energy, 1.0, 1e-14);
  EXPECT_NEAR(scene.approach() / approach, -1.0, 1e-12);
}

TEST(EdgeHops, LeaveAtAThirdOfTheirSpeedAtLeast) {
  Hopping scene(smooth());
  scene.run.state.v_WB = {0.1, 0.0, -0.1 * scene.edge_speed()};
  scene.hop();
  EXPECT_NEAR(-scene.approach() / scene.edge_speed(), 1.0 / 3.0, 1e-9);
}

TEST(EdgeHops, GainNoMoreThanOneHop) {
  Hopping scene(smooth());
  const double v = scene.edge_speed(), hop = scene.run.body.mass * v * v / 2.0;
  scene.run.state.v_WB = {0.1, 0.0, -v};
  const double least = scene.run.energy();
  scene.hop();
  for (const double faster : {0.11, 0.15, 1.0}) {  // as if it came from lifts
    scene.run.state.v_WB = {faster, 0.0, -v};
    scene.hop();
    EXPECT_NEAR((scene.run.energy() - least) / hop, 1.0, 1e-6) << faster;
  }
  EXPECT_GT(scene.run.state.v_WB.x(), 0.09);
}

TEST(EdgeHops, ResistanceSlowsTurningAndDoesNotReverseIt) {
  for (const bool pivots : {true, false}) {
    for (const double impact : {1.0, 1e5}) {  // of the edge speed
      DropSettings<double> settings = smooth();
      (pivots ? settings.pivot_radius : settings.rolling_resistance) = 1e-4;
      Hopping scene(settings, 0.0);  // flat: the impulse goes through the centre
      const Vec3<double> w = pivots ? Vec3<double>(0.0, 0.0, 3.0) : Vec3<double>(0.0, 3.0, 0.0);
      scene.run.state.L_W = scene.run.body.moments.cwiseProduct(w);
      scene.run.state.v_WB = -impact * scene.edge_speed() * scene.contact.n_W;
      const Vec3<double> before = scene.run.state.L_W;
      scene.hop();
      const Vec3<double> lost = before - scene.run.state.L_W;
      EXPECT_LT(lost.cross(before).norm(), 1e-12 * before.squaredNorm()) << pivots << impact;
      const double taken = 2.0 * impact * scene.edge_speed() * scene.run.body.mass * 1e-4;
      const double expected = std::min(taken, before.norm());
      EXPECT_NEAR(lost.dot(before.normalized()) / expected, 1.0, 1e-3) << pivots << impact;
    }
  }
}

TEST(EdgeHops, ASeriesIsOneEvent) {
  Hopping scene(smooth());
  const auto hop_after = [&](double periods) {
    scene.run.time += periods / scene.run.scales.frequency;
    scene.run.state.v_WB = {0.0, 0.0, -scene.edge_speed()};
    scene.hop();
    return scene.events.size();
  };
  const std::size_t first = hop_after(0.0);
  ASSERT_EQ(first, 1U);
  EXPECT_EQ(scene.events[0].kind, EventKind::contact);
  EXPECT_EQ(scene.events[0].before.v_WB.z(), -scene.edge_speed());
  EXPECT_EQ(hop_after(1.0), first);
  EXPECT_EQ(hop_after(1.0), first);
  EXPECT_EQ(hop_after(2.0), first + 1);
  EXPECT_EQ(scene.run.counters.edge_impacts, 4);
  EXPECT_TRUE(scene.run.lower_order);
}

TEST(EdgeHops, TheFloorIsASecondContactForAMoment) {
  Hopping scene(smooth());
  Separation<double> floor = scene.contact;
  floor.p_other.z() = scene.board.floor;
  floor.other_feature = OtherFeature::surface;
  EXPECT_FALSE(scene.hops.is_beside(scene.run, floor));
  scene.hops.touch_side(scene.run);
  EXPECT_TRUE(scene.hops.is_beside(scene.run, floor));
  scene.run.time += 0.1 / scene.run.scales.frequency;
  EXPECT_TRUE(scene.hops.is_beside(scene.run, floor));
  scene.run.time += 0.1 / scene.run.scales.frequency;
  EXPECT_FALSE(scene.hops.is_beside(scene.run, floor));
}

// --- support that is lost within a step

/// A flat stone whose centre goes along a parabola in s = 2θ − 1.26: from `middle`, by `along` s, and `back` s².
struct Passing {
  Thrown thrown;
  Board<double> board = make_board<double>();
  Run<double> run;
  ContactState<double> contact;
  Interpolant<double, 4> way = {};

  Passing(double level, const Vec3<double>& middle, const Vec3<double>& along, const Vec3<double>& back)
      : run(detail::make_run<double>(thrown.stone, thrown.body, board, thrown.start, smooth(), 0.0)) {
    run.level = level;
    run.state.q_WB = {1.0, 0.0, 0.0, 0.0};
    contact.enter(run, Feature::lower_cap);
    for (int i = 0; i < 2; ++i) {
      const auto at = static_cast<std::size_t>(i);
      way.c[0][at] = middle[i] - 1.26 * along[i] + 1.26 * 1.26 * back[i];
      way.c[1][at] = 2.0 * along[i] - 4.0 * 1.26 * back[i];
      way.c[2][at] = 4.0 * back[i];
    }
  }
  [[nodiscard]] double gap_at(double share) const {
    const auto y = way(share);
    return contact.support_left(run, detail::place_of(run.contact_body, contact.feature, contact.y), y[0], y[1]).gap;
  }
  /// Where it is found to be lost; the places that were looked at.
  [[nodiscard]] std::pair<std::optional<double>, int> lost() const {
    const auto place = detail::place_of(run.contact_body, contact.feature, contact.y);
    detail::SupportLoss search(run, contact, way, 0, std::nullopt, [&](const auto&) { return place; });
    const std::optional<double> found = search();
    return {found, search.views()};
  }
};

/// Over the surface's edge and back, around the board's side, over a corner of it: by more than nothing, and not quite.
TEST(SupportLoss, IsFoundWithinAStep) {
  const Board<double> board = make_board<double>();
  const double half = board.half_width, wide = outer_width(Thrown().stone) / 2.0, corner = wide / std::sqrt(2.0);
  for (const double beyond : {1e-2, 1e-4, 1e-7, 1e-10, -1e-10, -1e-7, -1e-4, -1e-2}) {
    const Passing over(0.0, {half + beyond, 0.0, 0.0}, {0.0, 0.1, 0.0}, {-0.1, 0.0, 0.0});
    const Passing back(0.0, {0.0, -(board.half_length + beyond), 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0});
    const Passing beside(board.floor, {half + wide - beyond, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.1, 0.0, 0.0});
    const Passing round(board.floor, {half + corner - beyond, board.half_length + corner - beyond, 0.0},
                        {-0.1, 0.1, 0.0}, {0.02, 0.02, 0.0});
    for (const Passing* way : {&over, &back, &beside, &round}) {
      ASSERT_LT(0.0, way->gap_at(0.0));
      ASSERT_LT(0.0, way->gap_at(1.0));
      const auto [share, views] = way->lost();
      EXPECT_EQ(share.has_value(), 0.0 < beyond) << beyond;
      EXPECT_EQ(share.has_value() && way->gap_at(*share) <= 0.0, 0.0 < beyond) << beyond;
      EXPECT_LT(views, 25) << beyond;
    }
  }
}

/// Along an edge or a side that it never touches, however near, two looks are enough.
TEST(SupportLoss, OnceIsEnoughAlongAnEdge) {
  const Board<double> board = make_board<double>();
  const double wide = outer_width(Thrown().stone) / 2.0;
  const Passing inside(0.0, {board.half_width - 1e-9, 0.0, 0.0}, {0.0, 0.15, 0.0}, {0.0, 0.0, 0.0});
  const Passing outside(board.floor, {board.half_width + wide + 1e-9, 0.0, 0.0}, {0.0, 0.15, 0.0}, {0.0, 0.0, 0.0});
  for (const Passing* way : {&inside, &outside}) {
    const auto [share, views] = way->lost();
    EXPECT_FALSE(share);
    EXPECT_EQ(views, 2);
  }
}

TEST(Interpolant, ChangesAreThoseOfItsParts) {
  Interpolant<double, 1> along = {};
  for (std::size_t k = 0; k < along.c.size(); ++k) {
    along.c[k][0] = 1.0 + 0.5 * static_cast<double>(k * k);
  }
  for (const double a : {0.0, 0.3, 1.0}) {
    for (const double b : {0.0, 0.7, 1.0}) {
      const std::array<double, 5> changes = along.changes(0, a, b);
      for (const double s : {0.25, 0.5, 1.0}) {
        double sum = 0.0, power = 1.0;
        for (const double change : changes) {
          power *= s;
          sum += power * change;
        }
        EXPECT_NEAR(sum, along(a + s * (b - a))[0] - along(a)[0], 1e-13) << a << ", " << b << ", " << s;
      }
    }
  }
}

/// On the floor, its rim against the board's side: neither holds it alone.
TEST(EdgeHops, AStoneLeansOnTwo) {
  Thrown stone;
  const Board<double> board = make_board<double>();
  stone.tilt(75.0);
  stone.settings.friction = 1.0;
  stone.settings.restitution = 0.0;
  const Pose<double> upright{Vec3<double>::Zero(), stone.start.q_WB};
  const double low = separation(stone.stone, upright, Plane<double>{}).gap;
  stone.start.p_WB = {board.half_width, 0.0, board.floor - low};
  stone.start.p_WB.x() -= separation(stone.stone, {stone.start.p_WB, stone.start.q_WB}, board).gap;
  for (int i = 0; i < 60; ++i) {
    stone.start.p_WB.x() += 1e-6 - separation(stone.stone, {stone.start.p_WB, stone.start.q_WB}, board).gap;
  }
  const DropResult<double> drop = stone.drop_on_board();
  EXPECT_EQ(drop.status, DropStatus::rest_leaning);
  EXPECT_LT(drop.time, 0.2);
  // The statics that ended it, by themselves; and without the board it would not stay.
  const Pose<double> there{drop.state.p_WB, drop.state.q_WB};
  const Hold<double> hold = holds(stone.stone, there, board, stone.settings);
  EXPECT_TRUE(hold.holds);
  EXPECT_EQ(hold.contacts, 2);
  stone.settings.touching = 1e-4;
  EXPECT_FALSE(holds(stone.stone, there, Plane<double>{.offset = board.floor}, stone.settings).holds);
  // What friction it needs is the limit: more holds it, less does not.
  EXPECT_GT(hold.friction, 0.1);
  EXPECT_LT(hold.friction, 1.0);
  for (const double factor : {0.999, 1.001}) {
    DropSettings<double> settings = stone.settings;
    settings.touching = 1e-9;
    settings.friction = factor * hold.friction * stone.settings.friction;
    EXPECT_EQ(holds(stone.stone, there, board, settings).holds, 1.0 < factor) << factor;
  }
}

// --- bounces

/// How far a stone that slides while it bounces comes: friction of the bounces counts, wherever they are closed.
TEST(Bounces, AreClosedOnlyWhereNoneDiffers) {
  const auto run = [](double closing_speed, auto&& change) {
    Thrown stone;
    stone.start.p_WB.z() = 0.0056;
    change(stone);
    stone.settings.closing_speed = closing_speed;
    return stone.drop_on_board();
  };
  const auto same = [&](auto&& change, const char* what) {
    const DropResult<double> early = run(10.0, change), late = run(1e-7, change);
    EXPECT_EQ(early.status, late.status) << what;
    EXPECT_LT((early.state.p_WB - late.state.p_WB).norm(), 1e-8) << what;
    EXPECT_LT(early.state.q_WB.angularDistance(late.state.q_WB), 1e-6) << what;
  };
  const auto nothing = [](Thrown&) {};  // flat, and straight down: one impact stands for all
  EXPECT_LT(run(10.0, nothing).counters.impacts, 3);
  EXPECT_GT(run(1e-7, nothing).counters.impacts, 10);
  same(nothing, "falls flat");
  same(
      [](Thrown& stone) {
        stone = thrown(make_stone(0.022, 0.022));
        stone.start.p_WB.z() = 0.012;
        stone.start.v_WB.x() = 0.05;
      },
      "slides");
  same([](Thrown& stone) { stone.tilt(1e-3); }, "is tilted");
  same([](Thrown& stone) { stone.start.L_W.y() = 1e-8; }, "turns");
  same(
      [](Thrown& stone) {
        stone.settings.friction = 0.0;
        stone.settings.horizon = 0.5;
        stone.start.p_WB.x() = make_board<double>().half_width - 0.002;
        stone.start.v_WB.x() = 0.05;
      },
      "comes to the edge");
  same(
      [](Thrown& stone) {
        const Board<double> board = make_board<double>();
        stone.settings.friction = 0.0;
        stone.settings.horizon = 0.1;
        stone.start.p_WB = {board.half_width + 0.0115, 0.0, board.floor + 0.0056};
        stone.start.v_WB.x() = -0.05;
      },
      "comes to the side");
}

// --- sliding without turning

/// Friction that is too weak to turn the stone against its resistance: steps, way and time are those of any direction.
TEST(LockedSlide, IsTheSameInEveryDirection) {
  for (const double damping : {0.0, 0.5}) {
    const auto slide = [&](const Vec3<double>& direction) {
      Thrown stone;
      stone.start.p_WB.z() = 0.0046;
      stone.start.v_WB = 0.3 * direction;
      stone.settings.friction = 0.05;
      stone.settings.rolling_resistance = stone.settings.pivot_radius = 0.001;
      stone.settings.damping = damping;
      return stone.drop();
    };
    const DropResult<double> along = slide(Vec3<double>::UnitX());
    const double way = along.state.p_WB.head<2>().norm();
    ASSERT_EQ(along.status, DropStatus::rest);
    if (!(0.0 < damping)) {
      EXPECT_NEAR(way / (0.3 * 0.3 / (2.0 * 0.05 * g_earth)), 1.0, 1e-9);
    }
    for (const Vec3<double>& other : {Vec3<double>(0.0, 1.0, 0.0), Vec3<double>(0.6, -0.8, 0.0)}) {
      const DropResult<double> across = slide(other);
      EXPECT_NEAR(across.state.p_WB.head<2>().norm() / way, 1.0, 1e-12);
      EXPECT_NEAR(across.time / along.time, 1.0, 1e-12);
      EXPECT_EQ(across.counters.steps_accepted, along.counters.steps_accepted);
      EXPECT_EQ(across.counters.steps_rejected, along.counters.steps_rejected);
    }
  }
}

}  // namespace

}  // namespace goishi::drop_test
