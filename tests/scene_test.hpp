#pragma once
/// What the tests of the scene share.

#include <gtest/gtest.h>

#include <goishi/mass/inertia.hpp>
#include <random>
#include <vector>
#include "compiled/scene.hpp"

namespace goishi::scene_test {

inline bool same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

inline bool same(const Event<double>& a, const Event<double>& b) {
  return a.kind == b.kind && a.time == b.time && same(a.before, b.before) && same(a.after, b.after) &&
         a.energy == b.energy && a.impulse_W == b.impulse_W;
}

/// A stone of size 33, sharp unless told otherwise. (Where sharp rims just touch, any normal is as good.)
struct Kind {
  Stone<double> stone = make_stone(0.022, 0.0092);
  RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));

  Kind() = default;
  explicit Kind(double bevel)
      : stone(make_measured_stone(0.022, 0.0092, bevel)),
        body(make_rigid_body(mass_properties(stone, Density{2800.0}))) {}

  [[nodiscard]] double weight() const { return body.mass * gravity_W<double>().norm(); }
};

inline State<double> lying(double x, double y, double z) {
  return {.p_WB = {x, y, z}, .q_WB = {1, 0, 0, 0}, .v_WB = {0, 0, 0}, .L_W = {0, 0, 0}};
}

inline State<double> moving(State<double> state, const Vec3<double>& v) {
  state.v_WB = v;
  return state;
}

/// At the tolerance of a game.
inline SceneSettings<double> rough() {
  SceneSettings<double> settings;
  settings.drop.tolerance = 1e-4;
  settings.drop.restitution = settings.restitution = 0.3;
  return settings;
}

inline SceneSettings<double> weightless() {
  SceneSettings<double> settings = rough();
  settings.drop.gravity = {0, 0, 0};
  settings.step = 1.0 / 480;  // without gravity there is no time to take it from
  settings.impact_speed = 0.005;
  return settings;
}

/// Anything, in any attitude, over the middle of the board.
inline State<double> thrown(std::mt19937_64& random, const Kind& kind, const Vec3<double>& p, double speed,
                            double spin) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3<double>(normal(random), normal(random), normal(random)); };
  Quat<double> q(normal(random), normal(random), normal(random), normal(random));
  q.normalize();
  State<double> state{.p_WB = p, .q_WB = q, .v_WB = speed * vector(), .L_W = {0, 0, 0}};
  state.L_W = formula::angular_momentum_W<double>(q, kind.body, spin * vector());
  return state;
}

/// A heap that is about to fall down: `n`³ stones, thrown in any way.
inline Scene<double> heap(int n, unsigned seed, const SceneSettings<double>& settings = rough()) {
  const Kind kind;
  std::mt19937_64 random(seed);
  Scene<double> scene(make_board<double>(), settings);
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3<double> p(0.024 * (i % n), 0.024 * (i / n % n), 0.03 + 0.024 * (i / n / n));
    scene.add(kind.stone, kind.body, thrown(random, kind, p, 0.1, 5));
  }
  return scene;
}

/// The least gap of two stones, and of one and the board   [m].
inline double least_gap(const Scene<double>& scene) {
  double least = 1;
  const std::vector<StoneId> stones = scene.stones();
  for (std::size_t i = 0; i < stones.size(); ++i) {
    const State<double> one = scene.state(stones[i]);
    least = std::min(least, separation(scene.stone(stones[i]), Pose<double>{one.p_WB, one.q_WB}, scene.board()).gap);
    for (std::size_t j = 0; j < i; ++j) {
      const State<double> two = scene.state(stones[j]);
      if ((one.p_WB - two.p_WB).norm() < 0.0221) {
        least = std::min(least, separation(scene.stone(stones[i]), Pose<double>{one.p_WB, one.q_WB},
                                           scene.stone(stones[j]), Pose<double>{two.p_WB, two.q_WB})
                                    .gap);
      }
    }
  }
  return least;
}

}  // namespace goishi::scene_test
