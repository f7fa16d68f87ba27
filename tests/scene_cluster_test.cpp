/// Stones that touch several things: one contact against its definition, piles against statics by hand, what makes them move.

#include "tests/scene_test.hpp"

namespace goishi::scene_test {

namespace {

/// The definition: W p + f, and which of the three cases holds.
TEST(SceneCone, AContactIsOpenSticksOrSlides) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  int open = 0, stuck = 0, slid = 0;
  for (int i = 0; i < 3000; ++i) {
    Mat3<double> A;
    for (int k = 0; k < 9; ++k) {
      A(k / 3, k % 3) = normal(random);
    }
    const Mat3<double> M = A * A.transpose() + 0.05 * Mat3<double>::Identity();
    const ContactMatrix<double> W{M(0, 0), M(1, 1), M(2, 2), M(0, 1), M(0, 2), M(1, 2)};
    const Vec3<double> f(normal(random), normal(random), normal(random));
    const double mu = 0.05 * std::exp(normal(random) + 2);
    const Vec3<double> p = detail::contact_impulse(W, formula::tangential(W), mu, f);
    const Vec3<double> v = M * p + f;
    const double p_t = std::hypot(p.x(), p.y()), v_t = std::hypot(v.x(), v.y());
    const double scale = 1e-9 * (f.norm() + M.norm() * p.norm());
    if (f.z() >= 0) {
      EXPECT_EQ(p, (Vec3<double>(0, 0, 0)));
      ++open;
      continue;
    }
    EXPECT_NEAR(v.z(), 0, scale);
    EXPECT_LE(p_t, mu * p.z() * (1 + 1e-9));
    if (scale < v_t) {
      // Against the slip, at the cone.
      EXPECT_NEAR(p_t, mu * p.z(), 1e-9 * p_t);
      EXPECT_NEAR((p.x() * v.x() + p.y() * v.y()) / (p_t * v_t), -1, 1e-9);
      ++slid;
    } else {
      ++stuck;
    }
  }
  EXPECT_GT(open, 500);
  EXPECT_GT(stuck, 100);
  EXPECT_GT(slid, 500);
}

struct Forces {
  double board = 0, stones = 0;
  int board_contacts = 0, stone_contacts = 0;
};

Forces forces_of(const Scene<double>& scene, double weight) {
  Forces sum;
  for (const SceneContact<double>& contact : scene.contacts()) {
    const double normal = contact.n_W.dot(contact.force_W);
    const double across = (contact.force_W - normal * contact.n_W).norm();
    EXPECT_GT(normal, 0);
    EXPECT_LE(across, 0.3 * normal * (1 + 1e-9));
    (contact.other ? sum.stones : sum.board) += std::abs(contact.force_W.z()) / weight;
    ++(contact.other ? sum.stone_contacts : sum.board_contacts);
  }
  return sum;
}

TEST(SceneCluster, OneOnTopOfTheOther) {
  const Kind kind;
  Scene<double> scene(make_board<double>(), rough());
  const StoneId below = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  const StoneId above = scene.add(kind.stone, kind.body, lying(0, 0, 0.0138));
  ASSERT_TRUE(scene.run_until_rest(1));
  EXPECT_NEAR(scene.state(above).p_WB.z(), 0.0138, 2e-6);
  EXPECT_NEAR(scene.state(below).p_WB.z(), 0.0046, 2e-6);
  const Forces sum = forces_of(scene, kind.weight());
  EXPECT_EQ(sum.board_contacts, 1);
  EXPECT_EQ(sum.stone_contacts, 1);
  EXPECT_NEAR(sum.board, 2, 1e-3);
  EXPECT_NEAR(sum.stones, 1, 1e-3);
}

/// Its weight goes to the three in equal parts, and theirs to the board beside it.
TEST(SceneCluster, OneOnThreeOthers) {
  const Kind kind;
  Scene<double> scene(make_board<double>(), rough());
  const double side = 0.0222, out = side / std::sqrt(3.0);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3;
    scene.add(kind.stone, kind.body, lying(out * std::cos(angle), out * std::sin(angle), 0.0046));
  }
  // Caps on caps: centres of spheres two radii apart.
  const double height =
      0.0046 + std::sqrt(std::pow(2 * kind.stone.sphere_radius, 2) - out * out) - 2 * kind.stone.sphere_offset;
  const StoneId top = scene.add(kind.stone, kind.body, lying(0, 0, height + 1e-6));
  ASSERT_TRUE(scene.run_until_rest(2));
  EXPECT_NEAR(scene.state(top).p_WB.z(), height, 5e-6);
  const Forces sum = forces_of(scene, kind.weight());
  EXPECT_EQ(sum.stone_contacts, 3);
  EXPECT_NEAR(sum.board, 4, 1e-3);
  EXPECT_NEAR(sum.stones, 1, 1e-3);
  for (const SceneContact<double>& contact : scene.contacts()) {
    if (contact.other) {
      // But for what the resistance to rolling bears: δ over the way out to where they touch.
      EXPECT_NEAR(std::abs(contact.force_W.z()) / kind.weight(), 1.0 / 3, 1e-4 / (out / 2));
    }
  }
}

TEST(SceneCluster, TakenAwayFromBelowItFalls) {
  const Kind kind;
  Scene<double> scene(make_board<double>(), rough());
  const StoneId below = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  const StoneId above = scene.add(kind.stone, kind.body, lying(0, 0, 0.0138));
  ASSERT_TRUE(scene.run_until_rest(1));
  scene.remove(below);
  scene.advance(0.02);
  EXPECT_LT(scene.state(above).p_WB.z(), 0.0138 - 0.001);
  ASSERT_TRUE(scene.run_until_rest(10));
  EXPECT_NEAR(scene.state(above).p_WB.z(), 0.0046, 1e-5);
}

TEST(SceneCluster, ATiltMovesItOnlyBeyondFriction) {
  const Kind kind;
  SceneSettings<double> settings = rough();
  settings.drop.rolling_resistance = settings.drop.pivot_radius = 0.005;  // it does not roll
  Scene<double> scene(make_board<double>(), settings);
  const StoneId below = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  const StoneId above = scene.add(kind.stone, kind.body, lying(0, 0, 0.0138));
  ASSERT_TRUE(scene.run_until_rest(1));
  const State<double> before = scene.state(above);
  settings.drop.gravity = {0.2 * 9.8, 0, -9.8};
  scene.change(settings);
  ASSERT_TRUE(scene.run_until_rest(1));
  EXPECT_LT((scene.state(above).p_WB - before.p_WB).norm(), 1e-6);
  settings.drop.gravity = {0.4 * 9.8, 0, -9.8};  // μ = 0.3
  scene.change(settings);
  scene.advance(0.1);
  // Both slide with the board's friction, (0.4 − 0.3) 9.8 t²/2, or the upper one faster.
  EXPECT_GT(scene.state(above).p_WB.x(), 0.9 * 0.98 * 0.005);
  EXPECT_GT(scene.state(below).p_WB.x(), 0.5 * 0.98 * 0.005);
}

/// About where the lower one touches the board the two have the moment 2 m g_x h, and it bears δ 2 m g_z.
TEST(SceneCluster, APileTipsWhereResistanceEnds) {
  const Kind kind;
  SceneSettings<double> settings = rough();
  settings.drop.rolling_resistance = 1e-4;
  const double most = 1e-4 / 0.0092;
  for (const double share : {0.9, 1.1}) {
    Scene<double> scene(make_board<double>(), settings);
    scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
    const StoneId above = scene.add(kind.stone, kind.body, lying(0, 0, 0.0138));
    ASSERT_TRUE(scene.run_until_rest(1));
    const State<double> before = scene.state(above);
    SceneSettings<double> leaning = settings;
    leaning.drop.gravity = {share * most * 9.8, 0, -9.8};
    scene.change(leaning);
    scene.advance(0.3);
    const double moved = scene.state(above).p_WB.x() - before.p_WB.x();
    if (share < 1) {
      EXPECT_EQ(scene.mode(above), StoneMode::rest);
      EXPECT_LT(std::abs(moved), 1e-7);
    } else {
      EXPECT_GT(moved, 1e-5);
    }
  }
}

TEST(SceneCluster, APushWakesWhatItReaches) {
  const Kind kind(0.001);
  Scene<double> scene(make_board<double>(), rough());
  std::vector<StoneId> row;
  for (int i = 0; i < 5; ++i) {
    row.push_back(scene.add(kind.stone, kind.body, lying(0.022 * i, 0, 0.0046)));
  }
  const StoneId far = scene.add(kind.stone, kind.body, lying(0, 0.1, 0.0046));
  ASSERT_TRUE(scene.run_until_rest(1));
  const State<double> before = scene.state(far);
  std::vector<SceneEvent<double>> events;
  scene.apply_impulse(row[0], scene.state(row[0]).p_WB, {0.5 * kind.body.mass, 0, 0}, events);
  scene.advance(0.05, events);
  EXPECT_GT(scene.state(row[4]).p_WB.x(), 0.088 + 1e-4);
  EXPECT_TRUE(same(scene.state(far), before));
  for (const SceneEvent<double>& told : events) {
    EXPECT_NE(told.stone, far);
  }
  EXPECT_TRUE(scene.run_until_rest(5));
}

/// The scheme is of first order: half the step, half the error.
TEST(SceneCluster, ConvergesWithTheStep) {
  const Kind kind;
  const auto height_after = [&](double step) {
    SceneSettings<double> settings = rough();
    settings.step = step;
    settings.solver_tolerance = 1e-6;
    settings.friction = settings.drop.friction = 0;
    settings.drop.rolling_resistance = settings.drop.pivot_radius = 0;
    Scene<double> scene(make_board<double>(), settings);
    scene.add(kind.stone, kind.body, lying(-0.0111, 0, 0.0046));
    scene.add(kind.stone, kind.body, lying(0.0111, 0, 0.0046));
    const double height =
        0.0046 + std::sqrt(std::pow(2 * kind.stone.sphere_radius, 2) - 0.0111 * 0.0111) - 2 * kind.stone.sphere_offset;
    const StoneId wedge = scene.add(kind.stone, kind.body, lying(0, 0, height + 1e-6));
    scene.advance(0.04);  // it drives the others apart
    return Vec3<double>(scene.state(wedge).p_WB.z(), scene.state(StoneId(1)).p_WB.x(), 0);
  };
  const Vec3<double> exact = height_after(1.0 / 15360);
  const double coarse = (height_after(1.0 / 480) - exact).norm(), fine = (height_after(1.0 / 1920) - exact).norm();
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, coarse / 2);
  EXPECT_LT(coarse, 2e-5);
}

/// Velocities are of the middles of steps, places of their ends: what is told is of one time.
TEST(SceneCluster, EnergyNeverRises) {
  const Kind kind;
  SceneSettings<double> settings = rough();
  Scene<double> scene(make_board<double>(), settings);
  for (int i = 0; i < 8; ++i) {  // side by side, so that they fall together
    State<double> start = lying(0.0220004 * i, 0, 0.03);
    start.L_W = formula::angular_momentum_W<double>(start.q_WB, kind.body, Vec3<double>(0.3 * i, 1 - 0.2 * i, 2));
    scene.add(kind.stone, kind.body, start);
  }
  const double weighs = kind.weight() * kind.stone.width;
  double last = scene.energy();
  long long steps = 0;
  while (scene.time() < 0.6) {
    scene.advance(1.0 / 3840);
    const double now = scene.energy();
    EXPECT_LT(now - last, 1e-3 * weighs) << scene.time();
    last = now;
    steps = scene.counters().stone_steps;
  }
  EXPECT_LT(500, steps);
}

/// As of a stone alone: a stone that rolls and turns on the spot, in a cluster since another one has touched it, comes to
/// where its drop comes.
TEST(SceneCluster, ResistanceIsThatOfADrop) {
  const Kind kind(0.002);
  SceneSettings<double> settings = rough();
  settings.drop.tolerance = 1e-10;
  settings.drop.rolling_resistance = 1e-4;
  settings.drop.pivot_radius = 5e-5;
  settings.solver_tolerance = 1e-6;
  settings.step = 1.0 / 3840;
  settings.clearance = 1e-8;
  settings.leaving_time = 1e6;
  const Quat<double> q(std::cos(0.15), 0, std::sin(0.15), 0);
  const Vec3<double> arm =
      kind.stone.sphere_offset * (q * Vec3<double>(0, 0, 1)) - Vec3<double>(0, 0, kind.stone.sphere_radius);
  const Vec3<double> w(1, 2, 5);
  State<double> start{.p_WB = {0, 0, -arm.z()}, .q_WB = q, .v_WB = -w.cross(arm), .L_W = {0, 0, 0}};
  start.L_W = formula::angular_momentum_W<double>(q, kind.body, formula::in_body(q, w));
  State<double> other = lying(0, 0.022, 0.012);
  const auto between = [&] {
    return separation(kind.stone, Pose<double>{other.p_WB, other.q_WB}, kind.stone, Pose<double>{start.p_WB, q});
  };
  for (int i = 0; i < 20; ++i) {
    const Separation<double> now = between();
    other.p_WB += (1.005 * *settings.clearance - now.gap) * now.n_W;
  }
  const Separation<double> now = between();
  other.v_WB = start.v_WB + w.cross(now.p_other - start.p_WB) - 1e-6 * now.n_W;
  Scene<double> scene(make_board<double>(), settings);
  const StoneId id = scene.add(kind.stone, kind.body, start);
  const StoneId passing = scene.add(kind.stone, kind.body, other);
  scene.advance(1e-12);
  scene.remove(passing);
  ASSERT_EQ(scene.mode(id), StoneMode::cluster);
  Drop<double> drop(kind.stone, kind.body, start, scene.board(), settings.drop);
  scene.advance_to(0.1);
  drop.advance_to(0.1);
  const Vec3<double> axis(0, 0, 1);
  EXPECT_LT((scene.state(id).q_WB * axis - drop.state().q_WB * axis).norm(), 1e-3);
  EXPECT_LT((scene.state(id).p_WB - drop.state().p_WB).norm(), 5e-6);
}

/// Where its rim all but lies flat a thin stone's contact runs around it faster than the stone turns.
TEST(SceneCluster, AThinStoneThatTurnsFastGainsNoEnergy) {
  const Stone<double> plate = make_stone(0.022, 0.0011, 0.0005);
  const RigidBody<double> body = make_rigid_body(mass_properties(plate, Density{2800.0}));
  const SceneSettings<double> settings = rough();
  for (unsigned k = 0; k < 40; ++k) {
    std::mt19937_64 random(k);
    std::uniform_real_distribution<double> unit(0, 1);
    Scene<double> scene(make_board<double>(), settings);
    State<double> start = lying(0, 0, 0);
    const double tilt = 0.02 + 0.1 * unit(random), speed = 100 + 200 * unit(random), turn = 6.3 * unit(random);
    start.q_WB = Quat<double>(std::cos(tilt / 2), std::sin(tilt / 2), 0, 0);
    const Vec3<double> w(speed * std::cos(turn), 0.84 * speed, 20 * unit(random));
    start.L_W = formula::angular_momentum_W<double>(start.q_WB, body, formula::in_body(start.q_WB, w));
    start.p_WB.z() = -separation(plate, Pose<double>{start.p_WB, start.q_WB}, scene.board()).gap;
    const Pose<double> pose{start.p_WB, start.q_WB};
    start.v_WB = -w.cross(separation(plate, pose, scene.board()).p_stone - start.p_WB);
    scene.add(plate, body, start);
    State<double> other = lying(0.004, 0.002, 0.02);
    const auto between = [&] { return separation(plate, Pose<double>{other.p_WB, other.q_WB}, plate, pose); };
    for (int i = 0; i < 30; ++i) {
      const Separation<double> now = between();
      other.p_WB += (1.005 * plate.width / 44000 - now.gap) * now.n_W;
    }
    const Separation<double> now = between();
    other.v_WB = start.v_WB + w.cross(now.p_other - start.p_WB) - 1e-3 * now.n_W;
    scene.add(plate, body, other);
    const double energy = scene.energy();
    for (int i = 0; i < 40; ++i) {
      scene.advance(1.0 / 4000);
      ASSERT_LT(scene.energy(), 1.05 * energy) << k;
    }
  }
}

/// It bounces on the other one, which rests as soon as it is left alone, and comes back.
TEST(SceneCluster, WhatRestsAtOnceIsNotForgotten) {
  const Stone<double> low = make_stone(0.019295, 0.019277, 0.0114), high = make_stone(0.03154, 0.010624);
  const auto body_of = [](const Stone<double>& stone) {
    return make_rigid_body(mass_properties(stone, Density{2800.0}));
  };
  SceneSettings<double> settings;
  settings.drop.tolerance = 8.1e-6;
  settings.friction = 0;
  settings.drop.friction = 0.111;
  settings.restitution = settings.drop.restitution = 0.563;
  for (int k = 0; k < 6; ++k) {
    Scene<double> scene(make_board<double>(), settings);
    const StoneId below = scene.add(low, body_of(low), lying(0, 0, 0.019277 / 2));
    const StoneId above = scene.add(high, body_of(high), lying(0, 0, 0.0743 + 0.001 * k));
    for (int i = 0; i < 80; ++i) {
      scene.advance(1.0 / 240);
      const State<double> one = scene.state(below), two = scene.state(above);
      const Pose<double> first{one.p_WB, one.q_WB}, second{two.p_WB, two.q_WB};
      ASSERT_GT(separation(low, first, high, second).gap, -1e-5) << k << " at " << scene.time();
    }
  }
}

}  // namespace

}  // namespace goishi::scene_test
