/// SCENE: clusters. Their steps against the contact phase of a drop; what they keep; the laws of their contacts.

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

constexpr double g_earth = 9.80665;

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
                         "measured 2026-11-30 with 20 seeds: up to 0.12"),
                  within("rolling, resisted", 0.3, "half widths or rad, of h √(g/w)", "the same"),
                  within("sliding", 0.6, "half widths or rad, of h √(g/w)", "the same: up to 0.25"),
                  within("sliding, resisted", 0.6, "half widths or rad, of h √(g/w)", "the same"),
                  within("slope", 0.2, "off 1", "first order, in the median"), none("clusters", "that are none")},
       .mutants = {},
       .measure = measure_steps},
  };
}

}  // namespace goishi::verify
