/// SCENE: what stands still, and why: towers, wedges, a stone on others, heaps that have come to rest.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/scene.hpp"

namespace goishi::verify {

namespace {

Piece size_33(double bevel) {
  return Piece({{0.022, 0.0092, bevel}, make_stone(0.022, 0.0092, bevel)});
}

/// The force on `one` by `other`, or by the board, as the scene tells it: the sum.
Vec3<double> force_on(const Scene<double>& scene, StoneId one, std::optional<StoneId> other) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const SceneContact<double>& contact : scene.contacts()) {
    if (contact.stone == one && contact.other == other) {
      sum += contact.force_W;
    } else if (other && contact.stone == *other && contact.other == one) {
      sum -= contact.force_W;
    }
  }
  return sum;
}

// --- SCENE-7

/// Some on top of each other, of several sizes: each bears all above it.
void see_tower(Context& context, int k, Checks& checks) {
  Scene<double> scene(make_board<double>(), game_settings());
  const int count = 2 + k % 4;
  std::vector<StoneId> ids;
  std::vector<double> weights;
  double z = 0.0;
  for (int i = 0; i < count; ++i) {
    const Piece piece(draw_stone(context, i % 2 == 0 ? 0 : 5));
    const double half = piece.stone().height / 2.0;
    ids.push_back(scene.add(piece.stone(), piece.body, set_down({0.0, 0.0, z + half})));
    weights.push_back(piece.body.mass * g_earth);
    z += 2.0 * half + *scene.settings().clearance;
  }
  const bool rests = scene.run_until_rest(2.0);
  see_choice(checks["rest"], rests, [&] { return fmt::format("tower {}", k); });
  double above = 0.0;
  for (int i = count; i-- > 0;) {
    const auto at = static_cast<std::size_t>(i);
    above += weights[at];
    const Vec3<double> up = force_on(scene, ids[at], i == 0 ? std::nullopt : std::optional(ids[at - 1]));
    checks["tower"].see((context.produced(up) - Vec3<double>(0.0, 0.0, above)).norm() / above,
                        [&] { return fmt::format("tower {}, stone {}", k, i); });
  }
}

/// On two or three others around it: caps on caps, by symmetry alike; and where it lies.
void see_on_others(Context& context, int k, Checks& checks) {
  const Piece piece = size_33(k % 2 == 0 ? 0.0 : 0.001);
  const int count = k % 3 == 0 ? 2 : 3;
  const double apart = context.uniform(0.0222, 0.024), mu = 0.4;
  SceneSettings<double> settings = game_settings();
  settings.friction = settings.drop.friction = mu;
  Scene<double> scene(make_board<double>(), settings);
  const double clearance = piece.stone().width / 44000.0, turn = context.uniform(0.0, 3.0);
  const double out = count == 2 ? apart / 2.0 : apart / std::sqrt(3.0), half = piece.stone().height / 2.0;
  std::vector<StoneId> ids;
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / count;
    ids.push_back(scene.add(piece.stone(), piece.body, set_down({out * std::cos(angle), out * std::sin(angle), half})));
  }
  // Centres of spheres two radii and the clearance apart.
  const double r = piece.stone().sphere_radius, d = piece.stone().sphere_offset;
  const double height = half + std::sqrt(std::pow(2.0 * r + clearance, 2) - out * out) - 2.0 * d;
  const StoneId top = scene.add(piece.stone(), piece.body, set_down({0.0, 0.0, height}));
  const bool rests = scene.run_until_rest(3.0);
  const auto told = [&] { return fmt::format("on {}, {} m apart", count, apart); };
  see_choice(checks["rest"], rests, told);
  const double weight = piece.body.mass * g_earth;
  checks["lies"].see((context.produced(scene.state(top).p_WB) - Vec3<double>(0.0, 0.0, height)).norm() / clearance,
                     told);
  for (const StoneId id : ids) {
    // Resistance bears δ over the way out to where they touch.
    const double share = force_on(scene, top, id).z() / weight;
    checks["shares"].see(
        std::fabs(context.produced(share) - 1.0 / count) / (1e-4 + piece.stone().width / 220.0 / (out / 2.0)), told);
  }
}

/// Two that lean on each other, rim on rim, each on its rim on the board: about where it stands each has its weight's moment
/// and that of the other's push, which is horizontal.
void see_cards(Context& context, int k, Checks& checks) {
  const Piece piece = size_33(k % 2 == 0 ? 0.002 : 0.001);
  SceneSettings<double> settings = game_settings();
  settings.friction = settings.drop.friction = 1.0;
  Scene<double> scene(make_board<double>(), settings);
  const double clearance = piece.stone().width / 44000.0;
  const double lean = context.uniform(0.06, 0.5);  // of the stones from the vertical
  std::vector<StoneId> ids;
  for (const double side : {-1.0, 1.0}) {
    // Its axis along ∓x and up or down.
    const Quat<double> q = turn_between(Vec3<double>::UnitZ(), {-side * std::cos(lean), 0.0, -std::sin(lean)});
    State<double> start = set_down({0.0, 0.0, 0.0}, q);
    const Pose<double> pose{start.p_WB, start.q_WB};
    start.p_WB.z() = -separation(piece.stone(), pose, Plane<double>{}).gap;
    const Plane<double> between{.n_W = {side, 0.0, 0.0}, .offset = 0.0};
    start.p_WB.x() = side * (clearance / 2.0 - separation(piece.stone(), pose, between).gap);
    ids.push_back(scene.add(piece.stone(), piece.body, start));
  }
  const bool rests = scene.run_until_rest(2.0);
  const auto told = [&] { return fmt::format("cards {}, leaning by {} rad", k, lean); };
  see_choice(checks["rest"], rests, told);
  const double weight = piece.body.mass * g_earth;
  for (const StoneId id : ids) {
    const StoneId other = ids[id == ids[0] ? 1 : 0];
    const Vec3<double> p = scene.state(id).p_WB;
    const double side = p.x() < 0.0 ? -1.0 : 1.0;  // pushed outwards
    Vec3<double> foot = p, head = p;
    for (const SceneContact<double>& contact : scene.contacts()) {
      if (contact.stone == id && !contact.other) {
        foot = contact.p_WC;
      } else if (contact.other) {
        head = contact.p_WC;
      }
    }
    const double push = weight * std::fabs((p.x() - foot.x()) / (head.z() - foot.z()));
    const double borne = piece.stone().width / 220.0 * (weight + push);
    const Vec3<double> levers(head.z() - foot.z(), 0.0, head.x() - foot.x());
    const Vec3<double> by_other = force_on(scene, id, other) - Vec3<double>(side * push, 0.0, 0.0);
    const Vec3<double> by_board = force_on(scene, id, std::nullopt) - Vec3<double>(-side * push, 0.0, weight);
    for (const Vec3<double>& off : {by_other, by_board}) {
      const double size = std::max(std::fabs(off.x() * levers.x()), std::fabs(off.z() * levers.z()));
      checks["cards"].see(std::fabs(context.produced(size + weight * levers.x()) - weight * levers.x()) / borne, told);
    }
  }
}

Measurement measure_by_hand(Context& context) {
  Checks checks;
  for (int k = 0; k < context.samples(12, 60); ++k) {
    see_tower(context, k, checks);
    see_on_others(context, k, checks);
    see_cards(context, k, checks);
  }
  return checks.measurement();
}

// --- SCENE-8

struct Load {
  Long3 force = Long3::Zero(), moment = Long3::Zero();
  Long resistance = 0;  // that its contacts can bear at most
};

/// Each stone of a heap at rest: the forces on it and gravity, their moments.
void see_balance(const Context& context, const Scene<double>& scene, int k, Checks& checks) {
  const SceneSettings<double>& settings = scene.settings();
  const Long g = settings.drop.gravity.norm();
  std::map<StoneId, Load> loads;
  double on_board = 0.0, weight = 0.0;
  for (const SceneContact<double>& contact : scene.contacts()) {
    const Long3 F = context.produced(contact.force_W).cast<Long>(), n = contact.n_W.cast<Long>();
    const auto told = [&] {
      return fmt::format("heap {}, stone {} on {}", k, static_cast<int>(contact.stone),
                         contact.other ? std::to_string(static_cast<int>(*contact.other)) : std::string("the board"));
    };
    const Long normal = F.dot(n), mu = contact.other ? settings.friction : settings.drop.friction;
    see_choice(checks["pulls"], normal > 0, told);
    const Long across = (F - normal * n).norm() * static_cast<Long>(context.produced(1.0));
    checks["cone"].see(as_double(std::max<Long>(0, across / (mu * normal) - 1)), told);
    const auto add = [&](StoneId id, Long sign) {
      Load& load = loads[id];
      load.force += sign * F;
      load.moment += sign * (contact.p_WC - scene.state(id).p_WB).cast<Long>().cross(F);
      load.resistance += normal * static_cast<Long>(scene.stone(id).width) / 220;  // δ, which is more than κ
    };
    add(contact.stone, 1);
    if (contact.other) {
      add(*contact.other, -1);
    } else {
      on_board += as_double(-F.dot(settings.drop.gravity.cast<Long>()) / g);
    }
  }
  for (const StoneId id : scene.stones()) {
    const Long m = scene.body(id).mass;
    const auto told = [&] { return fmt::format("heap {}, stone {}", k, static_cast<int>(id)); };
    Load& load = loads[id];
    const Long3 off = load.force + m * settings.drop.gravity.cast<Long>();
    checks["forces"].see(as_double(off.norm() / (m * g)), told);
    checks["moments"].see(as_double(load.moment.norm() / load.resistance) * context.produced(1.0), told);
    weight += as_double(m * g);
    see_choice(checks["still"], scene.state(id).v_WB.isZero(0.0) && scene.state(id).L_W.isZero(0.0), told);
  }
  checks["weight"].see(std::fabs(on_board / weight - 1.0), [&] { return fmt::format("heap {}", k); });
}

Measurement measure_heaps(Context& context) {
  Checks checks;
  int leaning = 0, stones = 0;
  for (int k = 0; k < context.samples(4, 30); ++k) {
    Scene<double> scene(make_board<double>(), game_settings());
    pile(context, scene, 16);
    const bool rests = scene.run_until_rest(8.0);
    see_choice(checks["rest"], rests, [&] { return fmt::format("heap {}", k); });
    if (!rests) {
      continue;
    }
    see_balance(context, scene, k, checks);
    for (const SceneContact<double>& contact : scene.contacts()) {
      leaning += contact.other ? 1 : 0;
    }
    stones += static_cast<int>(scene.stones().size());
    // Rest costs nothing, and what is woken rests again, there.
    const SceneCounters before = scene.counters();
    scene.advance(100.0);
    const SceneCounters after = scene.counters();
    see_choice(checks["costs"],
               before.steps == after.steps && before.separations == after.separations &&
                   before.stretches == after.stretches && before.looks == after.looks,
               [&] { return fmt::format("heap {}", k); });
    Scene<double> woken = scene;
    woken.change(woken.settings());
    see_choice(checks["rest"], woken.run_until_rest(1.0), [&] { return fmt::format("heap {}, woken", k); });
    // On a slope that holds nothing all of it goes.
    Scene<double> tilted = scene;
    SceneSettings<double> steep = tilted.settings();
    steep.drop.gravity = {g_earth * std::sin(1.0), 0.0, -g_earth * std::cos(1.0)};
    tilted.change(steep);
    tilted.advance(0.05);
    for (const StoneId id : scene.stones()) {
      see_choice(checks["stays on a slope"],
                 1e-3 < (context.produced(tilted.state(id).p_WB) - scene.state(id).p_WB).norm(),
                 [&] { return fmt::format("heap {}, stone {}", k, static_cast<int>(id)); });
    }
    // On a gentle one they rock, and hold each other again.
    Scene<double> leaning_board = scene;
    SceneSettings<double> gentle = leaning_board.settings();
    const double slope = context.uniform(0.01, 0.1);
    gentle.drop.gravity = {g_earth * std::sin(slope), 0.0, -g_earth * std::cos(slope)};
    leaning_board.change(gentle);
    const bool holds = leaning_board.run_until_rest(8.0);
    see_choice(checks["rest"], holds, [&] { return fmt::format("heap {}, leaning by {} rad", k, slope); });
    if (holds) {
      see_balance(context, leaning_board, k, checks);
    }
    for (const StoneId id : scene.stones()) {
      checks["moves, woken"].see((context.produced(woken.state(id).p_WB) - scene.state(id).p_WB).norm(),
                                 [&] { return fmt::format("heap {}, stone {}", k, static_cast<int>(id)); });
    }
  }
  return checks.measurement({{"stones, contacts of two", fmt::format("{}, {}", stones, leaning)}});
}

}  // namespace

std::vector<Claim> scene_statics_claims() {
  return {
      {.id = "SCENE-7",
       .statement =
           "Stones that stand on each other, lie on two or three others or lean on each other as cards do come "
           "to rest there, with the forces that statics gives by hand.",
       .function = "Scene::contacts",
       .family = OracleFamily::exact,
       .oracle = "weights above, symmetry, moments about a foot",
       .checks = {within("tower", 1e-5, "of the weight", "the solver stops there at a change of 1e-6 g a step", 2e-7),
                  within("shares", 1.0, "of δ over the lever and 1e-4", "what resistance may bear"),
                  within("lies", 10.0, "of the clearance", "it sinks by what the steps leave"),
                  within("cards", 1.001, "of δ N of both contacts over the lever", "derived: what resistance may bear"),
                  none("rest", "that do not rest")},
       .measure = measure_by_hand},
      {.id = "SCENE-8",
       .statement =
           "A heap of 16 stones, thrown on each other, comes to rest. Then each stone is held: the forces on it add "
           "up to its weight, their moments to what resistance bears, each in its cone. The board bears all. "
           "What rests costs nothing; woken, it rests again, where it was; on a gentle slope it rests anew; on a steep "
           "one all of it goes.",
       .function = "Scene::run_until_rest",
       .family = OracleFamily::invariant,
       .oracle = "balance of forces and moments of each stone, in long double",
       .checks = {within("forces", 1e-4, "of the weight", "rest is where no acceleration above 1e-4 g is left", 2e-6),
                  within("moments", 1.001, "of what resistance bears",
                         "derived: |τ| <= δ N of each contact, and what is left of forces"),
                  within("cone", 1e-9, "of μ N", "the cone is met to 1e-10", 1e-10),
                  within("weight", 1e-5, "of the weight", "as the forces", 1e-6),
                  within("moves, woken", 2e-6, "m", "it rests again at once; measured 2026-11-30 with 20 seeds: 0",
                         2e-7),
                  none("pulls", "contacts"), none("rest", "heaps that do not"), none("still", "stones that move"),
                  none("costs", "heaps"), none("stays on a slope", "stones")},
       .measure = measure_heaps},
  };
}

}  // namespace goishi::verify
