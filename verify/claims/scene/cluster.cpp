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

// --- SCENE-10

Measurement measure_time(Context& context) {
  Checks checks;
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
      checks["depth"].see(std::max(0.0, -context.produced(least_gap(scene)) / clearance), told);
      last = now;
      if (i % 60 == 0) {
        checks["frames"].see(std::max(0.0, as_double(now - at_frame)) / weight, told);
        at_frame = now;
      }
    }
  }
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

// --- SCENE-12

/// A heap that touches from the beginning on, on a slope, so that it slides and tumbles as one cluster.
Scene<double> draw_slide(Context& context, int k) {
  SceneSettings<double> settings = game_settings();
  settings.solver_tolerance = k % 2 == 0 ? 0.1 : 1e-3;
  settings.drop.rolling_resistance = settings.drop.pivot_radius = 0.0;  // which is told of nowhere
  settings.friction = context.uniform(0.1, 0.5);
  settings.drop.friction = context.uniform(0.1, 0.5);
  const double turn = context.uniform(0.0, 6.3), lean = context.uniform(0.1, 0.5);
  settings.drop.gravity =
      g_earth * Vec3<double>(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), -std::cos(lean));
  Scene<double> scene(make_board<double>(), settings);
  const Piece piece(draw_stone(context, 0));
  const double clearance = piece.stone().width / 44000.0, half = piece.stone().height / 2.0;
  const double apart = outer_width(piece.stone()) + clearance, out = apart / std::sqrt(3.0);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * M_PI * i / 3.0;
    static_cast<void>(
        scene.add(piece.stone(), piece.body, set_down({out * std::cos(angle), out * std::sin(angle), half})));
  }
  const double r = piece.stone().sphere_radius, d = piece.stone().sphere_offset;
  const double height = half + std::sqrt(std::pow(2.0 * r + clearance, 2) - out * out) - 2.0 * d;
  static_cast<void>(scene.add(piece.stone(), piece.body, set_down({0.0, 0.0, height})));
  static_cast<void>(scene.add(piece.stone(), piece.body, set_down({0.0, 0.0, height + 2.0 * half + clearance})));
  return scene;
}

/// A step of a scene whose stones are one cluster.
struct Step {
  bool plain = false;  // as long as it is set: not cut, taken again, or begun by an impact
  std::vector<SceneContact<double>> contacts;
  std::vector<State<double>> begin;  // as they are told when it has just begun
  std::vector<State<double>>
      solved;  // places of the begin, velocities of the middle, which the contacts are solved for
};

/// Up to the begin of the next.
Step go_to_next_step(Scene<double>& scene) {
  const double h = *scene.settings().step;
  const SceneCounters before = scene.counters();
  double low = 0.0, high = 1.01 * h;
  for (int i = 0; i < 34; ++i) {  // to 1e-10 of a step
    const double middle = (low + high) / 2.0;
    Scene<double> copy = scene;
    copy.advance(middle);
    (copy.counters().steps == before.steps ? low : high) = middle;
  }
  Step step;
  bool impacts = false, together = true;
  scene.advance(high,
                [&](const SceneEvent<double>& event) { impacts = impacts || event.event.kind != EventKind::contact; });
  const SceneCounters now = scene.counters();
  step.contacts = scene.contacts();
  Scene<double> later = scene;
  later.advance(h / 2.0);
  for (const StoneId id : scene.stones()) {
    together = together && scene.mode(id) == StoneMode::cluster;
    step.begin.push_back(scene.state(id));
    State<double> solved = scene.state(id);
    solved.v_WB = later.state(id).v_WB;
    solved.L_W = later.state(id).L_W;
    step.solved.push_back(solved);
  }
  step.plain = !impacts && together && now.cut_steps == before.cut_steps && now.retries == before.retries &&
               now.steps == before.steps + 1 && later.counters().steps == now.steps && std::fabs(high - h) < 1e-6 * h;
  return step;
}

/// What a stone's contacts do to it in a step.
struct Push {
  Long3 force = Long3::Zero(), moment = Long3::Zero();
};

/// Momenta from its begin to its middle.
void see_momenta(const Context& context, const Scene<double>& scene, const Step& step, const std::string& told,
                 Checks& checks) {
  const Long T = static_cast<Long>(*scene.settings().step) / 2;
  std::vector<Push> pushes(step.begin.size());
  for (const SceneContact<double>& contact : step.contacts) {
    const Long3 F = context.produced(contact.force_W).cast<Long>();
    const auto add = [&](StoneId id, Long sign) {
      const auto at = static_cast<std::size_t>(id);
      pushes[at].force += sign * F;
      pushes[at].moment += sign * (contact.p_WC - step.begin[at].p_WB).cast<Long>().cross(F);
    };
    add(contact.stone, 1);
    if (contact.other) {
      add(*contact.other, -1);
    }
  }
  for (const StoneId id : scene.stones()) {
    const auto at = static_cast<std::size_t>(id);
    const State<double>&begin = step.begin[at], &middle = step.solved[at];
    const Long m = scene.body(id).mass, unit = T * static_cast<Long>(g_earth) * m;
    const Long3 gain = m * (middle.v_WB - begin.v_WB).cast<Long>(), turn = (middle.L_W - begin.L_W).cast<Long>();
    const Long3 weight = m * scene.settings().drop.gravity.cast<Long>();
    checks["momentum"].see(as_double((gain - T * (weight + pushes[at].force)).norm() / unit), [&] { return told; });
    checks["angular momentum"].see(as_double((turn - T * pushes[at].moment).norm() / (unit * 0.011L)),
                                   [&] { return told; });
  }
}

/// Velocity of a contact's first body against the second, in this step, and what of it a turning body may change in half of
/// it: c ω² and v²/c.
struct Sliding {
  Long3 v;
  Long bend;
};

Sliding sliding_of(const Scene<double>& scene, const Step& step, const SceneContact<double>& contact) {
  const auto see = [&](StoneId id) {
    const State<double>& state = step.solved[static_cast<std::size_t>(id)];
    return Sliding{velocity_at(state, scene.body(id), contact.p_WC), turning_of(state, scene.body(id)).squaredNorm()};
  };
  Sliding seen = see(contact.stone);
  if (contact.other) {
    const Sliding second = see(*contact.other);
    seen.v -= second.v;
    seen.bend += second.bend;
  }
  seen.bend = 0.011L * seen.bend + seen.v.squaredNorm() / 0.011L;
  return seen;
}

/// Of a contact that pushes.
void see_friction(const Context& context, const Scene<double>& scene, const Step& step,
                  const SceneContact<double>& contact, const std::string& told, Checks& checks) {
  const Long T = *scene.settings().step, g = g_earth;
  const Long3 n = contact.n_W.cast<Long>(), F = context.produced(contact.force_W).cast<Long>();
  const Long N = F.dot(n),
             most = N * static_cast<Long>(contact.other ? scene.settings().friction : scene.settings().drop.friction);
  const Long3 across = F - N * n;
  checks["cone"].see(as_double(std::max<Long>(0, across.norm() / most - 1)), [&] { return told; });
  const Sliding sliding = sliding_of(scene, step, contact);
  const Long3 v = sliding.v - sliding.v.dot(n) * n;
  const Long lost = v.norm() + across.dot(v) / most;  // 0 where it sticks, or slides against the force
  const Long allowed = T * (static_cast<Long>(scene.settings().solver_tolerance) * g + sliding.bend);
  checks["friction"].see(as_double(std::fabs(lost) / allowed), [&] { return told; });
}

double gap_of(const Scene<double>& scene, const SceneContact<double>& contact) {
  const State<double> one = scene.state(contact.stone);
  const Pose<double> pose{one.p_WB, one.q_WB};
  if (!contact.other) {
    return separation(scene.stone(contact.stone), pose, scene.board()).gap;
  }
  const State<double> two = scene.state(*contact.other);
  return separation(scene.stone(contact.stone), pose, scene.stone(*contact.other), Pose<double>{two.p_WB, two.q_WB})
             .gap -
         *scene.settings().clearance;
}

Measurement measure_contacts(Context& context) {
  Checks checks;
  int steps = 0;
  std::vector<double> gaps;
  for (int k = 0; k < context.samples(12, 80); ++k) {
    Scene<double> scene = draw_slide(context, k);
    scene.advance(1e-12);
    std::vector<SceneContact<double>> pushed;
    for (int i = 0; i < 40; ++i) {
      const Step step = go_to_next_step(scene);
      const std::string told = fmt::format("slide {}, step {}", k, i);
      if (step.plain) {
        ++steps;
        see_momenta(context, scene, step, told, checks);
        for (const SceneContact<double>& contact : step.contacts) {
          see_friction(context, scene, step, contact, told, checks);
        }
        for (const SceneContact<double>& contact : pushed) {
          const double off = std::fabs(gap_of(scene, contact));
          gaps.push_back(off);
          checks["closed"].see(context.produced(off), [&] { return told; });
        }
      }
      pushed = step.contacts;
    }
  }
  return checks.measurement({{"steps", fmt::format("{}", steps)},
                             {"gaps of contacts that have pushed: median, 99 %",
                              fmt::format("{:.2g}, {:.2g} m", quantile(gaps, 0.5), quantile(gaps, 0.99))}});
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
      {.id = "SCENE-10",
       .statement =
           "The energy of a heap, looked at 60 times a second, only falls; at any time it is off by no more than "
           "a part of a step's fall, and nothing is deeper in anything than some clearances, inside steps too.",
       .function = "Scene::advance",
       .family = OracleFamily::invariant,
       .oracle = "energy and gaps of the states, at 3600 times a second",
       .checks = {within("frames", 1e-14, "of m g w of all", "round-off", 2e-16),
                  within("any time", 3.0, "of m g w of all and h √(g/w)",
                         "velocities are of the middles of steps; measured 2026-11-30 with 20 seeds: 0.09 to 0.16"),
                  within("depth", 12.0, "clearances",
                         "a step that leads deeper than four is taken again, shorter; measured 2026-11-30 with 20 "
                         "seeds: 4.7 to 7.4")},
       .mutants = {},
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
       .mutants = {},
       .measure = measure_weightless},
      {.id = "SCENE-12",
       .statement =
           "In a step of a cluster the forces that it tells of, and gravity, are what changes momentum and angular "
           "momentum; they are in their cones, friction is against the slip or holds it, and a contact that has "
           "pushed is closed in the end.",
       .function = "Scene::contacts",
       .family = OracleFamily::invariant,
       .oracle = "Newton's and Euler's laws, Signorini's and Coulomb's, of the states a step apart, in long double",
       .checks =
           {within("momentum", 1e-13, "of h m g", "round-off", 2e-15),
            within("angular momentum", 1e-3, "of h m g w/2",
                   "the contact point is told as that on the first stone, half a clearance beside"),
            within("cone", 1e-9, "of μ N", "derived: the cone is met to 1e-10", 1e-10),
            within("friction", 2.0, "of h times the solver's tolerance of g, c ω² and v²/c",
                   "derived: slip is taken to b, which bodies that turn change it by in half a step, and by what the "
                   "solver leaves; measured 2026-11-30 with 20 seeds: 0.5 to 0.9"),
            within("closed", 1e-5, "m",
                   "what turning changes in a step in third order is kept to twice the clearance, and what the "
                   "solver leaves to 0.1 g h²; measured 2026-11-30 with 20 seeds: 2e-6 to 4.2e-6")},
       .mutants = {},
       .measure = measure_contacts},
  };
}

}  // namespace goishi::verify
