/// A scene as a whole: alone a drop, flights and impacts by hand, any cut of time, copies, rest, hands.

#include "tests/scene_test.hpp"

#include <map>
#include <tuple>

#include "tests/allocations.hpp"

namespace goishi::scene_test {

namespace {

TEST(Scene, OneStoneIsADropToTheLastBit) {
  const Kind kind;
  std::mt19937_64 random(1);
  const SceneSettings<double> settings = rough();
  const Board<double> board = make_board<double>();
  for (int i = 0; i < 6; ++i) {
    const State<double> start = thrown(random, kind, {0.1 * i - 0.25, 0, 0.05}, 0.3, 10);
    const DropResult<double> alone = drop(kind.stone, kind.body, start, board, settings.drop);
    Scene<double> scene(board, settings);
    std::vector<SceneEvent<double>> events;
    const StoneId id = scene.add(kind.stone, kind.body, start);
    for (int k = 0; k < 5 * i; ++k) {
      scene.advance(0.003 * (1 + k % 7), events);
    }
    ASSERT_TRUE(scene.run_until_rest(60, events));
    EXPECT_TRUE(same(scene.state(id), alone.state));
    EXPECT_EQ(scene.time(), alone.time);
    ASSERT_EQ(events.size(), alone.events.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_TRUE(same(events[k].event, alone.events[k])) << k;
      EXPECT_EQ(events[k].stone, id);
      EXPECT_FALSE(events[k].other);
    }
  }
}

TEST(Scene, APushedAndTiltedStoneIsThatOfADrop) {
  const Kind kind;
  SceneSettings<double> settings = rough();
  const Board<double> board = make_board<double>();
  const State<double> start = lying(0, 0, 0.01);
  Drop<double> drop(kind.stone, kind.body, start, board, settings.drop);
  Scene<double> scene(board, settings);
  const StoneId id = scene.add(kind.stone, kind.body, start);
  std::vector<Event<double>> events;
  std::vector<SceneEvent<double>> told;
  drop.advance_to_rest(events);
  ASSERT_TRUE(scene.run_until_rest(10, told));
  drop.apply_impulse({0.01, 0, 0.005}, {1e-3, 2e-4, 0}, events);
  scene.apply_impulse(id, {0.01, 0, 0.005}, {1e-3, 2e-4, 0}, told);
  drop.advance(0.02, events);
  scene.advance(0.02, told);
  settings.drop.gravity = {1, 0, -9.7};
  drop.change(settings.drop, events);
  scene.change(settings, told);
  drop.advance(0.5, events);
  scene.advance(0.5, told);
  EXPECT_TRUE(same(scene.state(id), drop.state()));
  ASSERT_EQ(told.size(), events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_TRUE(same(told[k].event, events[k])) << k;
  }
}

/// Beside a list in which each looks for the least.
TEST(Scene, TheAgendaTellsWhatIsDueInOrder) {
  std::mt19937_64 random(3);
  detail::Agenda<double> agenda;
  std::map<std::pair<int, std::size_t>, double> list;
  const auto least = [&] {
    return std::min_element(list.begin(), list.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second, a.first) < std::tie(b.second, b.first);
    });
  };
  int told = 0;
  for (int i = 0; i < 20000; ++i) {
    const int kind = static_cast<int>(random() % 4);
    const std::size_t id = random() % 50;
    const double time = static_cast<double>(random() % 64);
    switch (random() % 4) {
      case 0:
      case 1:
        agenda.set(static_cast<detail::DueKind>(kind), id, time);
        list[{kind, id}] = time;
        break;
      case 2:
        agenda.remove(static_cast<detail::DueKind>(kind), id);
        list.erase({kind, id});
        break;
      default: {
        const std::optional<detail::Due<double>> next = agenda.next(time);
        const auto expected = list.empty() ? list.end() : least();
        ASSERT_EQ(next.has_value(), expected != list.end() && expected->second <= time);
        if (next) {
          ++told;
          EXPECT_EQ(next->time, expected->second);
          EXPECT_EQ(std::pair(static_cast<int>(next->kind), next->id), expected->first);
          list.erase(expected);
        }
      }
    }
  }
  EXPECT_LT(1000, told);
}

/// Rim to rim in line: the impulse goes through both centres.
TEST(Scene, TwoStonesMeetInLine) {
  const Kind kind;
  Scene<double> scene(make_board<double>(), weightless());
  const StoneId a = scene.add(kind.stone, kind.body, moving(lying(-0.05, 0, 0.1), {1, 0, 0}));
  const StoneId b = scene.add(kind.stone, kind.body, lying(0, 0, 0.1));
  std::vector<SceneEvent<double>> events;
  scene.advance(0.1, events);
  // e = 0.3: (1 − e)/2 and (1 + e)/2.
  EXPECT_NEAR(scene.state(a).v_WB.x(), 0.35, 1e-9);
  EXPECT_NEAR(scene.state(b).v_WB.x(), 0.65, 1e-9);
  const double when = 0.05 - 0.022 - 0.022 / 44000;
  std::vector<double> times;
  for (const SceneEvent<double>& told : events) {
    if (told.event.kind == EventKind::impact) {
      times.push_back(told.event.time);
      EXPECT_EQ(*told.other, told.stone == a ? b : a);
      EXPECT_NEAR(told.event.impulse_W.x(), (told.stone == a ? -0.65 : 0.65) * kind.body.mass, 1e-9 * kind.body.mass);
    }
  }
  ASSERT_EQ(times.size(), 2U);
  EXPECT_NEAR(times[0], when, 1e-8);
  EXPECT_NEAR(scene.state(b).p_WB.x(), 0.65 * (0.1 - when), 1e-8);
}

TEST(Scene, NewtonsCradlePassesItOn) {
  const Kind kind;
  SceneSettings<double> settings = weightless();
  settings.restitution = 1;
  settings.friction = 0;
  Scene<double> scene(make_board<double>(), settings);
  for (int i = 0; i < 5; ++i) {
    scene.add(kind.stone, kind.body, lying(i == 0 ? -0.03 : 0.0221 * i, 0, 0.1));
  }
  scene.apply_impulse(StoneId(0), {-0.03, 0, 0.1}, {kind.body.mass, 0, 0});
  scene.advance(0.2);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(scene.state(StoneId(i)).v_WB.x(), i == 4 ? 1.0 : 0.0, 1e-9) << i;
  }
}

/// With no gravity, and nothing to touch but each other.
TEST(Scene, ImpactsKeepMomenta) {
  const Kind kind;
  std::mt19937_64 random(7);
  SceneSettings<double> settings = weightless();
  settings.restitution = 0.8;
  Scene<double> scene(make_board<double>(), settings);
  for (int i = 0; i < 27; ++i) {
    const Vec3<double> p(0.03 * (i % 3), 0.03 * (i / 3 % 3), 1 + 0.03 * (i / 9));
    State<double> start = thrown(random, kind, p, 0.1, 10);
    start.v_WB += 8.0 * (Vec3<double>(0.03, 0.03, 1.03) - p);  // inwards
    scene.add(kind.stone, kind.body, start);
  }
  const auto momenta = [&] {
    std::pair<Vec3<double>, Vec3<double>> sum = {{0, 0, 0}, {0, 0, 0}};
    for (const StoneId id : scene.stones()) {
      const State<double> state = scene.state(id);
      sum.first += formula::linear_momentum(state, scene.body(id));
      sum.second += formula::angular_momentum_about<double>({0, 0, 1}, state, scene.body(id));
    }
    return sum;
  };
  const auto before = momenta();
  double energy = scene.energy();
  const double scale = 27 * kind.body.mass * 0.3;
  for (int frame = 0; frame < 30; ++frame) {
    scene.advance(1.0 / 60);
    const double now = scene.energy();
    EXPECT_LE(now, energy * (1 + 1e-12)) << frame;
    energy = now;
    EXPECT_GT(least_gap(scene), -5e-6) << frame;
  }
  EXPECT_GT(scene.counters().pair_impacts, 20);
  const auto after = momenta();
  EXPECT_LT((after.first - before.first).norm(), 1e-13 * scale);
  // Two points a clearance apart get opposite impulses.
  EXPECT_LT((after.second - before.second).norm(), 1e-4 * scale * 0.05);
}

TEST(Scene, DoesNotDependOnHowTimeIsCut) {
  Scene<double> whole = heap(2, 3);
  Scene<double> cut = whole;
  std::vector<SceneEvent<double>> events, told;
  whole.advance_to(0.7, events);
  for (double t = 0.0007; t < 0.7; t += 0.0113) {
    cut.advance_to(t, told);
    static_cast<void>(cut.contacts());
    const Scene<double> copy = cut;
    cut = copy;
  }
  cut.advance_to(0.7, told);
  EXPECT_GT(whole.counters().stone_steps, 10);
  ASSERT_EQ(events.size(), told.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_TRUE(same(events[k].event, told[k].event)) << k;
    EXPECT_EQ(events[k].stone, told[k].stone);
  }
  for (const StoneId id : whole.stones()) {
    EXPECT_TRUE(same(whole.state(id), cut.state(id)));
  }
}

TEST(Scene, AHeapComesToRest) {
  for (const unsigned seed : {1U, 2U}) {
    Scene<double> scene = heap(2, seed);
    double energy = scene.energy();
    for (int frame = 0; frame < 60; ++frame) {
      scene.advance(1.0 / 60);
      EXPECT_GT(least_gap(scene), -1e-5) << frame;
      const double now = scene.energy();
      EXPECT_LE(now, energy * (1 + 1e-9)) << frame;
      energy = now;
    }
    ASSERT_TRUE(scene.run_until_rest(30));
    EXPECT_GT(scene.counters().pair_impacts, 3);
    // What turning bodies do to their contacts is foreseen: few steps lead too deep.
    EXPECT_LT(4 * scene.counters().retries, scene.counters().steps);
    Vec3<double> force(0, 0, 0);
    for (const SceneContact<double>& contact : scene.contacts()) {
      force += contact.other ? Vec3<double>(0, 0, 0) : contact.force_W;
    }
    EXPECT_NEAR(force.z(), 8 * Kind().weight(), 1e-3 * Kind().weight());
  }
}

TEST(Scene, RestCostsNothing) {
  Scene<double> scene = heap(2, 5);
  ASSERT_TRUE(scene.run_until_rest(30));
  const SceneCounters before = scene.counters();
  const long allocated = test::allocations();
  scene.advance(1000);
  EXPECT_EQ(test::allocations(), allocated);
  EXPECT_EQ(scene.counters().separations, before.separations);
  EXPECT_EQ(scene.counters().steps, before.steps);
  EXPECT_EQ(scene.counters().stretches, before.stretches);
  for (const StoneId id : scene.stones()) {
    EXPECT_EQ(scene.mode(id), StoneMode::rest);
    EXPECT_EQ(scene.state(id).v_WB, (Vec3<double>(0, 0, 0)));
  }
}

/// Upwards nothing ends the flight: a bound of the speed over all of it would be one of hundreds of m/s.
TEST(Scene, ALongFlightIsNotLookedAtAllTheTime) {
  const Kind kind;
  SceneSettings<double> settings = rough();
  settings.drop.gravity = {0, 0, 5};
  Scene<double> scene(make_board<double>(), settings);
  scene.add(kind.stone, kind.body, lying(0, 0, 0.1));
  scene.add(kind.stone, kind.body, lying(0.0235, 0, 0.1));
  scene.advance(0.005);
  EXPECT_LT(scene.counters().looks, 10);
  scene.advance(5);
  EXPECT_LT(scene.counters().looks, 200);
}

// --- hands

/// It leans on the hand and slides; the hand works against the board's friction, and carries a part of the weight.
TEST(Scene, AHandPushesAStoneAlong) {
  const Kind kind(0.002);
  Scene<double> scene(make_board<double>(), rough());
  const double z = 0.0046;
  const StoneId hand = scene.add(kind.stone, kind.body, lying(-0.03, 0, z));
  const StoneId pushed = scene.add(kind.stone, kind.body, lying(0, 0, z));
  ASSERT_TRUE(scene.run_until_rest(1));
  scene.hold(hand, {0.05, 0, 0}, {0, 0, 0}, 1.0);
  EXPECT_EQ(scene.mode(hand), StoneMode::held);
  double work = 0;
  for (int frame = 0; frame < 45; ++frame) {
    work = frame == 40 ? scene.work(hand) : work;
    scene.advance(0.02);
    EXPECT_GT(least_gap(scene), -5e-6);
  }
  EXPECT_NEAR(scene.state(hand).p_WB.x(), -0.03 + 0.045, 1e-12);
  EXPECT_NEAR(scene.state(pushed).v_WB.x(), 0.05, 1e-4);
  Vec3<double> on_board(0, 0, 0), on_hand(0, 0, 0);
  for (const SceneContact<double>& contact : scene.contacts()) {
    EXPECT_EQ(contact.stone, pushed);
    (contact.other ? on_hand : on_board) += contact.force_W;
  }
  EXPECT_NEAR(on_board.x(), -0.3 * on_board.z(), 1e-3 * kind.weight());
  EXPECT_NEAR(on_board.x() + on_hand.x(), 0, 1e-3 * kind.weight());
  EXPECT_NEAR(on_board.z() + on_hand.z(), kind.weight(), 1e-3 * kind.weight());
  EXPECT_NEAR(scene.work(hand) - work, on_hand.x() * 0.05 * 0.1, 0.03 * on_hand.x() * 0.005);  // to a step
  scene.advance(0.2);
  EXPECT_NEAR(scene.state(hand).p_WB.x(), 0.02, 1e-12);
  scene.release(hand);
  EXPECT_TRUE(scene.run_until_rest(5));
}

TEST(Scene, AStoneThatIsLetGoFalls) {
  const Kind kind;
  Scene<double> scene(make_board<double>(), rough());
  const StoneId id = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  scene.hold(id, {0, 0, 0.1}, {0, 0, 3}, 0.5);
  scene.advance(0.5);
  EXPECT_NEAR(scene.state(id).p_WB.z(), 0.0546, 1e-12);
  EXPECT_NEAR(scene.state(id).q_WB.z(), std::sin(0.75), 1e-12);
  scene.release(id);
  scene.advance(0.05);
  EXPECT_NEAR(scene.state(id).p_WB.z(), 0.0546 - 9.80665 * 0.05 * 0.05 / 2, 1e-12);
}

}  // namespace

}  // namespace goishi::scene_test
