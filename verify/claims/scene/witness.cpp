/// SCENE: clusters of several stones against another time stepping, and how their error falls with the step.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/scene/moreau.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/scene.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify {

namespace {

/// Stones that touch, at rest, and are let go.
struct Leaning {
  SceneSettings<double> settings;
  std::vector<Piece> pieces;
  std::vector<State<double>> starts;

  [[nodiscard]] Scene<double> scene(double step) const {
    SceneSettings<double> set = settings;
    set.step = step;
    Scene<double> scene(make_board<double>(), set);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      static_cast<void>(scene.add(pieces[i].stone(), pieces[i].body, starts[i]));
    }
    return scene;
  }

  [[nodiscard]] Moreau witness() const {
    std::vector<HeavyBody> bodies;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Hull<long double> hull = narrow(hull_of(pieces[i].specimen));
      const auto field = [](long double x) { return static_cast<double>(x); };
      const Vec3<double> u = starts[i].q_WB * Vec3<double>::UnitZ(), &p = starts[i].p_WB, &I = pieces[i].body.moments;
      bodies.push_back(
          {.hull = {field(hull.height), field(hull.band), field(hull.sphere_radius), field(hull.sphere_offset),
                    field(hull.torus_radius), field(hull.tube_radius), field(hull.joint_radius)},
           .mass = pieces[i].body.mass,
           .axial = I.z(),
           .transverse = I.x(),
           .p = {p.x(), p.y(), p.z()},
           .u = {u.x(), u.y(), u.z()},
           .v = {0.0, 0.0, 0.0},
           .L = {0.0, 0.0, 0.0}});
    }
    const DropSettings<double>& drop = settings.drop;
    return Moreau(bodies, {.gravity = {drop.gravity.x(), drop.gravity.y(), drop.gravity.z()},
                           .board_friction = drop.friction,
                           .friction = settings.friction,
                           .rolling = *drop.rolling_resistance,
                           .pivot = *drop.pivot_radius,
                           .apart = clearance()});
  }

  [[nodiscard]] double clearance() const { return pieces.front().stone().width / 44000.0; }
};

/// One on two or three others, or two that lean on each other as cards do, on a slope: they slide, roll, are driven apart.
Leaning draw_leaning(Context& context, int i, bool resists) {
  Leaning drawn;
  SceneSettings<double>& set = drawn.settings;
  set.drop.tolerance = 1e-6;
  set.solver_tolerance = 1e-7;
  set.friction = context.uniform(0.05, 0.4);
  set.drop.friction = context.uniform(0.05, 0.4);
  set.drop.rolling_resistance = resists ? context.uniform(1e-4, 4e-4) : 0.0;
  set.drop.pivot_radius = resists ? context.uniform(1e-4, 4e-4) : 0.0;
  const double turn = context.uniform(0.0, 6.3), lean = context.uniform(0.0, 0.3);
  set.drop.gravity =
      g_earth * Vec3<double>(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), -std::cos(lean));
  const Piece piece(Specimen{{0.022, 0.0092, 0.002}, make_stone(0.022, 0.0092, 0.002)});
  const double half = piece.stone().height / 2.0, clearance = piece.stone().width / 44000.0;
  const auto put = [&](const Vec3<double>& p, const Quat<double>& q = {1.0, 0.0, 0.0, 0.0}) {
    drawn.pieces.push_back(piece);
    drawn.starts.push_back(set_down(p, q));
  };
  if (i % 3 == 2) {
    const double tilt = context.uniform(0.3, 0.9);
    for (const double side : {-1.0, 1.0}) {
      const Quat<double> q = turn_between(Vec3<double>::UnitZ(), {-side * std::cos(tilt), 0.0, -std::sin(tilt)});
      const Pose<double> pose{Vec3<double>::Zero(), q};
      const double low = separation(piece.stone(), pose, Plane<double>{}).gap;
      const double in = separation(piece.stone(), pose, Plane<double>{.n_W = {side, 0.0, 0.0}, .offset = 0.0}).gap;
      put({side * (clearance / 2.0 - in), 0.0, -low}, q);
    }
    return drawn;
  }
  const int count = 2 + i % 3;
  const double apart = context.uniform(1.001, 1.1) * outer_width(piece.stone());
  const double out = count == 2 ? apart / 2.0 : apart / std::sqrt(3.0);
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    put({out * std::cos(angle), out * std::sin(angle), half});
  }
  const double r = piece.stone().sphere_radius, d = piece.stone().sphere_offset;
  put({0.0, 0.0, half + std::sqrt(std::pow(2.0 * r + clearance, 2) - out * out) - 2.0 * d});
  return drawn;
}

// --- SCENE-13

/// Of all stones, places in half widths and axes.
std::vector<Vec3<double>> seen_in(const Moreau& witness) {
  std::vector<Vec3<double>> all;
  for (const HeavyBody& body : witness.bodies()) {
    const double w = body.hull.torus_radius + body.hull.tube_radius;
    all.push_back(Vec3<double>(body.p[0], body.p[1], body.p[2]) / w);
    all.emplace_back(body.u[0], body.u[1], body.u[2]);
  }
  return all;
}

std::vector<Vec3<double>> seen_in(const Scene<double>& scene, const Context& context) {
  std::vector<Vec3<double>> all;
  for (const StoneId id : scene.stones()) {
    const State<double> state = scene.state(id);
    all.push_back(context.produced(state.p_WB) / (outer_width(scene.stone(id)) / 2.0));
    all.push_back(state.q_WB * Vec3<double>::UnitZ());
  }
  return all;
}

double distance(const std::vector<Vec3<double>>& one, const std::vector<Vec3<double>>& other) {
  double most = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    most = std::max(most, (one[i] - other[i]).norm());
  }
  return most;
}

Measurement measure_witness(Context& context) {
  Checks checks;
  std::vector<double> slopes, own, free, resisted;
  const double until = 0.1, coarse = 1.0 / 1920.0, fine = coarse / 8.0;
  double moved = 0.0;
  int left_out = 0;
  for (int i = 0; i < context.samples(12, 48); ++i) {
    const bool resists = i / 3 % 2 == 1;
    const Leaning leaning = draw_leaning(context, i, resists);
    Moreau witness = leaning.witness(), better = witness;
    witness.advance(until, 1024);
    better.advance(until, 2048);
    // It is of first order, too: twice the better one less the other.
    std::vector<Vec3<double>> there = seen_in(better);
    const std::vector<Vec3<double>> coarser = seen_in(witness), first = seen_in(leaning.witness());
    for (std::size_t k = 0; k < there.size(); ++k) {
      there[k] += there[k] - coarser[k];
    }
    bool impacts = false, rested = false;
    const auto off = [&](double step) {
      Scene<double> scene = leaning.scene(step);
      scene.advance_to(until, [&](const SceneEvent<double>& event) {
        impacts = impacts || event.event.kind == EventKind::impact;
        rested = rested || event.event.kind == EventKind::rest;
      });
      return distance(seen_in(scene, context), there);
    };
    const double far = off(coarse), near = off(fine);
    if (impacts || rested) {  // by a law of its own; what is slow and held is stopped, v²/2a before it would
      ++left_out;
      continue;
    }
    own.push_back(distance(coarser, seen_in(better)));
    moved = std::max(moved, distance(first, there));
    (resists ? resisted : free).push_back(near / (fine * std::sqrt(g_earth / 0.022)));
    slopes.push_back(std::log(far / near) / std::log(8.0));
  }
  checks["without"].see(quantile(free, 0.5), [] { return "the median"; });
  checks["with resistance"].see(quantile(resisted, 0.5), [] { return "the median"; });
  checks["slope"].see(std::fabs(quantile(slopes, 0.5) - 1.0), [] { return "the median"; });
  return checks.measurement(
      {{"moved by up to", fmt::format("{:.2g} half widths or rad", moved)},
       {"the witness's two runs differ by", fmt::format("{:.2g} in the median", quantile(own, 0.5))},
       {"slopes: a tenth below, median, a tenth above",
        fmt::format("{:.2f}, {:.2f}, {:.2f}", quantile(slopes, 0.1), quantile(slopes, 0.5), quantile(slopes, 0.9))},
       {"left out, for an impact or rest", fmt::format("{}", left_out)}});
}

}  // namespace

std::vector<Claim> scene_witness_claims() {
  return {
      {.id = "SCENE-13",
       .statement =
           "Stones that lie on two or three others or lean on each other, are let go on a slope, slide, roll and drive "
           "each other apart, are after 0.1 s where another time stepping takes them, in proportion to the step; with "
           "dry friction between them and on the board, with resistance and without.",
       .function = "Scene::advance",
       .family = OracleFamily::integration,
       .oracle = "Moreau and Jean's scheme, θ = 1/2, contacts by projection on the cones, at 1/10240 and 1/20480 s, "
                 "extrapolated",
       .checks = {within("without", 0.25, "half widths or rad, of h √(g/w)",
                         "first order, in the median; measured 2026-11-30 with 20 seeds: up to 0.055", 0.02),
                  within("with resistance", 0.4, "half widths or rad, of h √(g/w)", "the same: up to 0.12", 0.02),
                  within("slope", 0.4, "off 1", "first order, in the median", 0.01)},
       .measure = measure_witness},
  };
}

}  // namespace goishi::verify
