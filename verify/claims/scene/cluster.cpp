/// SCENE: clusters. Their steps against the contact phase of a drop; what they keep.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/scene.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify {

namespace {

// --- SCENE-9

/// A stone that rolls or slides on the board.
struct Rolling {
  Piece piece;
  State<double> start;
  SceneSettings<double> settings;
};

Rolling draw_rolling(Context& context, bool slides, bool resists) {
  Rolling drawn{Piece(draw_stone(context, static_cast<int>(context.uniform(0.0, 2.0)))), {}, {}};
  drawn.settings.drop.tolerance = 1e-11;
  drawn.settings.drop.friction = slides ? 0.2 : 0.5;
  drawn.settings.solver_tolerance = 1e-8;
  drawn.settings.leaving_time = 1e6;  // it stays a cluster
  if (!resists) {
    drawn.settings.drop.rolling_resistance = drawn.settings.drop.pivot_radius = 0.0;
  } else {
    drawn.settings.drop.rolling_resistance = context.uniform(5e-5, 3e-4);
    drawn.settings.drop.pivot_radius = context.uniform(5e-5, 3e-4);
  }
  const Stone<double>& stone = drawn.piece.stone();
  const double tilt = context.uniform(0.05, 0.35), turn = context.uniform(0.0, 6.3);
  const Vec3<double> u(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
  const Vec3<double> arm = stone.sphere_offset * u - stone.sphere_radius * Vec3<double>::UnitZ();  // to the contact
  const Vec3<double> w = context.uniform(1.0, 15.0) * draw_unit(context);
  drawn.start = set_down({0.0, 0.0, -arm.z()}, turn_between(Vec3<double>::UnitZ(), u));
  drawn.start.v_WB = -w.cross(arm);
  if (slides) {
    drawn.start.v_WB += context.uniform(0.1, 0.3) * Vec3<double>(std::cos(3.0 * turn), std::sin(3.0 * turn), 0.0);
  }
  const Quat<double>& q = drawn.start.q_WB;
  drawn.start.L_W = formula::angular_momentum_W(q, drawn.piece.body, Vec3<double>(q.conjugate() * w));
  return drawn;
}

/// The same stone as a cluster: another one has touched it, and is gone.
struct Stepped {
  Scene<double> scene;
  StoneId id;

  Stepped(const Rolling& rolling, double step) : scene(make_board<double>(), with(rolling.settings, step)), id() {
    const Stone<double>& stone = rolling.piece.stone();
    const State<double>& start = rolling.start;
    id = scene.add(stone, rolling.piece.body, start);
    const double touch = 1.005 * *scene.settings().clearance;
    State<double> other = set_down(start.p_WB + Vec3<double>(0.0, 0.022, 0.0));
    other.p_WB.z() = 0.012;
    const auto between = [&] {
      return separation(stone, Pose<double>{other.p_WB, other.q_WB}, stone, Pose<double>{start.p_WB, start.q_WB});
    };
    for (int i = 0; i < 30; ++i) {
      const Separation<double> now = between();
      other.p_WB += (touch - now.gap) * now.n_W;
    }
    const Separation<double> now = between();
    const Vec3<double> v = velocity_at(start, rolling.piece.body, now.p_other).cast<double>();
    other.v_WB = v - 1e-6 * now.n_W;
    const StoneId passing = scene.add(stone, rolling.piece.body, other);
    scene.advance(1e-12);
    scene.remove(passing);
  }
  static SceneSettings<double> with(SceneSettings<double> settings, double step) {
    settings.step = step;
    return settings;
  }
};

Measurement measure_steps(Context& context) {
  Checks checks;
  std::vector<double> slopes;
  const double coarse = 1.0 / 1920.0, fine = coarse / 4.0, until = 0.08;
  for (int i = 0; i < context.samples(30, 200); ++i) {
    const bool slides = i % 2 == 1, resists = i % 4 < 2;
    const Rolling rolling = draw_rolling(context, slides, resists);
    Drop<double> drop(rolling.piece.stone(), rolling.piece.body, rolling.start, make_board<double>(),
                      rolling.settings.drop);
    drop.advance_to(until);
    const auto told = [&] { return fmt::format("stone {}", i); };
    const double w = rolling.piece.stone().width;
    const auto error = [&](double step) {
      Stepped stepped(rolling, step);
      see_choice(checks["clusters"], stepped.scene.mode(stepped.id) == StoneMode::cluster, told);
      stepped.scene.advance_to(until);
      const State<double> there = stepped.scene.state(stepped.id);
      const Vec3<double> z = Vec3<double>::UnitZ();
      return std::max((context.produced(there.p_WB) - drop.state().p_WB).norm() / (w / 2.0),
                      (there.q_WB * z - drop.state().q_WB * z).norm());
    };
    const double off = error(coarse), less = error(fine);
    checks[fmt::format("{}{}", slides ? "sliding" : "rolling", resists ? ", resisted" : "")].see(
        off / (coarse * std::sqrt(g_earth / w)), told);
    slopes.push_back(std::log(off / less) / std::log(4.0));
  }
  checks["slope"].see(std::fabs(quantile(slopes, 0.5) - 1.0), [] { return "the median"; });
  return checks.measurement(
      {{"slopes: a tenth below, median, a tenth above",
        fmt::format("{:.2f}, {:.2f}, {:.2f}", quantile(slopes, 0.1), quantile(slopes, 0.5), quantile(slopes, 0.9))}});
}

// --- SCENE-10

Measurement measure_time(Context& context) {
  Checks checks;
  std::vector<double> depths;
  for (int k = 0; k < context.samples(4, 25); ++k) {
    Scene<double> scene(make_board<double>(), game_settings());
    pile(context, scene, 12);
    const double h = *scene.settings().step, clearance = *scene.settings().clearance;
    const auto told = [&] { return fmt::format("heap {} at {} s", k, scene.time()); };
    double weight = 0.0;  // m g w of all
    for (const StoneId id : scene.stones()) {
      weight += scene.body(id).mass * g_earth * scene.stone(id).width;
    }
    Long last = carried_by(scene).energy, at_frame = last;
    for (int i = 1; i <= 1800; ++i) {
      scene.advance_to(i / 3600.0);
      const Long now = static_cast<Long>(context.produced(1.0)) * carried_by(scene).energy;
      checks["any time"].see(std::max(0.0, as_double(now - last)) / weight / (h * std::sqrt(g_earth / 0.022)), told);
      const double half = 0.0046;  // heights are produced, and gaps are differences
      depths.push_back(std::max(0.0, context.produced(half - least_gap(scene)) - half) / clearance);
      checks["deepest"].see(depths.back(), told);
      last = now;
      if (i % 60 == 0) {
        checks["frames"].see(std::max(0.0, as_double(now - at_frame)) / weight, told);
        at_frame = now;
      }
    }
  }
  checks["depth"].see(quantile(depths, 0.99), [] { return "ninety-nine in a hundred times"; });
  return checks.measurement();
}

/// Thrown at each other, with no gravity and nothing else to touch.
Measurement measure_weightless(Context& context) {
  Checks checks;
  long long steps = 0, impacts = 0;
  std::vector<double> turns;
  for (int k = 0; k < context.samples(6, 40); ++k) {
    SceneSettings<double> settings = weightless_settings();
    settings.restitution = 0.3;
    Scene<double> scene(make_board<double>(), settings);
    const Vec3<double> middle(0.0, 0.0, 1.0);
    Long speed = 0;
    for (int i = 0; i < 18; ++i) {
      const Piece piece(draw_stone(context, i % 2));
      const Vec3<double> off(0.026 * (i % 3 - 1), 0.026 * (i / 3 % 3 - 1), 0.026 * (i / 9));
      State<double> start = thrown(context, piece, middle + off, 0.1, 10.0);
      start.v_WB -= 5.0 * off;
      static_cast<void>(scene.add(piece.stone(), piece.body, start));
      speed += static_cast<Long>(piece.body.mass * start.v_WB.norm());
    }
    const Carried first = carried_by(scene);
    Carried last = first;
    for (int i = 0; i < 60; ++i) {
      scene.advance(1.0 / 120.0);
      const auto told = [&] { return fmt::format("swarm {} at {} s", k, scene.time()); };
      const std::vector<StoneId> ids = scene.stones();
      if (std::any_of(ids.begin(), ids.end(), [&](StoneId id) { return scene.mode(id) == StoneMode::cluster; })) {
        continue;  // places, velocities and contact points of a step are of three times
      }
      const Carried now = carried_by(scene);
      const Long all = static_cast<Long>(context.produced(1.0));
      checks["momentum"].see(as_double((all * now.p - first.p).norm() / speed), told);
      const Long3 moment = all * now.L - last.L - middle.cast<Long>().cross(all * now.p - last.p);
      turns.push_back(as_double(moment.norm() / (speed * 0.05L)));
      checks["pushed apart"].see(turns.back(), told);
      checks["energy"].see(as_double(std::max<Long>(0, all * now.energy - last.energy) / first.energy), told);
      last = now;
    }
    steps += scene.counters().stone_steps;
    impacts += scene.counters().pair_impacts;
  }
  checks["angular momentum"].see(quantile(turns, 0.9), [] { return "nine in ten"; });
  return checks.measurement({{"impacts, steps of stones in clusters", fmt::format("{}, {}", impacts, steps)}});
}

}  // namespace

std::vector<Claim> scene_cluster_claims() {
  return {
      {.id = "SCENE-9",
       .statement =
           "A stone that goes by a cluster's steps, rolling or sliding on the board, with resistance and without, "
           "comes to where its drop comes, in proportion to the step.",
       .function = "Scene::advance",
       .family = OracleFamily::integration,
       .oracle = "the contact phase of a drop at tolerance 1e-11, which DROP-17 judges by Lagrange's equations",
       .checks = {within("rolling", 0.3, "half widths or rad, of h √(g/w)",
                         "measured 2026-11-30 with 20 seeds: up to 0.144"),
                  within("rolling, resisted", 0.3, "half widths or rad, of h √(g/w)", "the same"),
                  within("sliding", 0.6, "half widths or rad, of h √(g/w)", "the same: up to 0.29"),
                  within("sliding, resisted", 0.6, "half widths or rad, of h √(g/w)", "the same"),
                  within("slope", 0.2, "off 1", "first order, in the median"), none("clusters", "that are none")},
       .measure = measure_steps},
      {.id = "SCENE-10",
       .statement =
           "The energy of a heap, looked at 60 times a second, only falls; at any time it is off by no more than "
           "a part of a step's fall, and nothing is deeper in anything than some clearances, inside steps too.",
       .function = "Scene::advance",
       .family = OracleFamily::invariant,
       .oracle = "energy and gaps of the states, at 3600 times a second",
       .checks = {within("frames", 1e-14, "of m g w of all", "round-off", 2e-16),
                  within("any time", 0.5, "of m g w of all and h √(g/w)",
                         "velocities are those of the middles of steps, and how fast they change; measured "
                         "2026-11-30 with 20 seeds: 0.01 to 0.16"),
                  within("depth", 12.0, "clearances",
                         "ninety-nine times in a hundred; a step that leads deeper than four is taken again, shorter",
                         0.5),
                  within("deepest", 200.0, "clearances",
                         "seldom a new contact is found deep inside: measured 2026-11-30 with 20 seeds 5 to 7, and "
                         "67 in the full tier",
                         4.0)},
       .measure = measure_time},
      {.id = "SCENE-11",
       .statement =
           "Stones that are thrown at each other where there is no gravity, in impacts and in clusters, keep their "
           "momentum and their angular momentum together, and their energy only falls.",
       .function = "Scene::advance",
       .family = OracleFamily::invariant,
       .oracle = "momenta and energy of the states, in long double",
       .checks = {within("momentum", 5e-15, "of all stones' together", "round-off", 1e-16),
                  within("angular momentum", 1e-14, "of all stones' together",
                         "nine times in ten round-off, from flight to flight", 2e-16),
                  within(
                      "pushed apart", 5e-6, "of all stones' angular momentum",
                      "an overlap is ended by moving two stones, with the momenta that they have, by some clearances; "
                      "measured 2026-11-30 with 20 seeds: up to 7e-7",
                      1e-7),
                  within("energy", 1e-14, "relative", "round-off", 2e-16)},
       .measure = measure_weightless},
  };
}

}  // namespace goishi::verify
