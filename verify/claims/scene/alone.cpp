/// SCENE: what must change nothing. A stone alone is a drop; how time is cut, copies, units of measurement.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/digest.hpp"
#include "verify/samples/scene.hpp"

namespace goishi::verify {

namespace {

// --- SCENE-1

/// A stone of a scene, and the same as a drop.
struct Twin {
  StoneId id;
  Drop<double> drop;
  Digest told = {}, told_alone = {};
  bool met = false;  // another stone
};

/// `advance` of all, and of each by itself, and what they tell.
class Twins {
 public:
  Twins(Context& context, int count) : scene_(make_board<double>(), settings_of(context)) {
    for (int i = 0; i < count; ++i) {
      const Piece piece = draw_piece(context, i);
      const Vec3<double> p(0.08 * (i % 4) - 0.12, 0.08 * (i / 4) - 0.12, context.uniform(0.03, 0.06));
      const State<double> start = thrown(context, piece, p, 0.1, 30.0);
      twins_.push_back({scene_.add(piece.stone(), piece.body, start),
                        Drop<double>(piece.stone(), piece.body, start, scene_.board(), scene_.settings().drop)});
    }
  }

  void advance_to(double time) {
    scene_.advance_to(time, [&](const SceneEvent<double>& event) { hear(event); });
    for (Twin& twin : twins_) {
      twin.drop.advance_to(time, twin.told_alone);
    }
  }
  void push(std::size_t i, const Vec3<double>& P) {
    Twin& twin = twins_[i];
    const Vec3<double> p = scene_.state(twin.id).p_WB + Vec3<double>(0.004, 0.0, 0.001);
    scene_.apply_impulse(twin.id, p, P, [&](const SceneEvent<double>& event) { hear(event); });
    twin.drop.apply_impulse(p, P, twin.told_alone);
  }
  void tilt(const Vec3<double>& gravity) {
    SceneSettings<double> settings = scene_.settings();
    settings.drop.gravity = gravity;
    scene_.change(settings, [&](const SceneEvent<double>& event) { hear(event); });
    for (Twin& twin : twins_) {
      twin.drop.change(settings.drop, twin.told_alone);
    }
  }
  [[nodiscard]] std::vector<Twin>& all() { return twins_; }
  [[nodiscard]] const Scene<double>& scene() const { return scene_; }

 private:
  [[nodiscard]] static SceneSettings<double> settings_of(Context& context) {
    SceneSettings<double> settings;
    settings.drop.tolerance = std::pow(10.0, context.uniform(-8.0, -4.0));
    settings.drop.restitution = context.uniform(0.0, 0.7);
    settings.drop.friction = context.uniform(0.1, 0.6);
    return settings;
  }
  void hear(const SceneEvent<double>& event) {
    Twin& twin = twins_[static_cast<std::size_t>(event.stone)];
    twin.told(event.event);
    twin.met = twin.met || event.other;
  }

  Scene<double> scene_;
  std::vector<Twin> twins_;
};

Measurement measure_alone(Context& context) {
  Checks checks;
  int met = 0, rests = 0;
  for (int k = 0; k < context.samples(8, 60); ++k) {
    Twins twins(context, 16);
    double time = 0.0;
    for (int i = 0; i < 40; ++i) {
      time += context.uniform(0.0, 0.06);
      twins.advance_to(time);
      if (i % 8 == 5) {
        const double size = twins.scene().body(twins.all()[0].id).mass;
        twins.push(static_cast<std::size_t>(i % 16), context.uniform(0.0, 0.2) * size * draw_unit(context));
      }
      if (i == 20 || i == 26) {
        twins.tilt({i == 20 ? 1.0 : 0.0, 0.0, -9.8});
      }
    }
    for (const Twin& twin : twins.all()) {
      if (twin.met) {
        ++met;
        continue;
      }
      State<double> there = twins.scene().state(twin.id);
      there.p_WB = context.produced(there.p_WB);
      const StoneMode mode = twins.scene().mode(twin.id);
      const bool rest = twin.drop.status() == DropStatus::rest;
      rests += rest ? 1 : 0;
      see_choice(checks["states"], is_same(there, twin.drop.state()) && (mode == StoneMode::rest) == rest,
                 [&] { return fmt::format("scene {}, stone {}", k, static_cast<int>(twin.id)); });
      see_choice(checks["events"], twin.told == twin.told_alone,
                 [&] { return fmt::format("scene {}, stone {}", k, static_cast<int>(twin.id)); });
    }
  }
  return checks.measurement({{"of those, at rest in the end", fmt::format("{}", rests)},
                             {"stones that met another, and are left out", fmt::format("{}", met)}});
}

// --- SCENE-2

Digest told_by(Scene<double>& scene, double until) {
  Digest digest;
  scene.advance_to(until, [&](const SceneEvent<double>& event) { digest(event.event); });
  return digest;
}

Measurement measure_cuts(Context& context) {
  Checks checks;
  long long steps = 0, impacts = 0;
  for (int k = 0; k < context.samples(20, 150); ++k) {
    Scene<double> whole(make_board<double>(), game_settings());
    pour(context, whole, 12);
    Scene<double> cut = whole;
    const double end = 0.5;
    const Digest told = told_by(whole, end);
    Digest heard;
    const auto hear = [&](const SceneEvent<double>& event) { heard(event.event); };
    const double longest = std::pow(10.0, context.uniform(-3.0, -0.5));
    for (double time = 0.0; time < end;) {
      time = std::fmin(end, time + context.uniform(0.0, longest));
      cut.advance_to(time, hear);
      static_cast<void>(cut.contacts());
      if (context.uniform(0.0, 1.0) < 0.05) {
        const Scene<double> stored = cut;  // and the original goes elsewhere
        cut.apply_impulse(StoneId(0), {0.0, 0.0, 0.0}, {1e-3, 1e-3, 1e-3});
        cut.advance(0.01);
        cut = stored;
      }
    }
    steps += whole.counters().stone_steps;
    impacts += whole.counters().pair_impacts;
    for (const StoneId id : whole.stones()) {
      State<double> there = cut.state(id);
      there.p_WB = context.produced(there.p_WB);
      see_choice(checks["states"], is_same(there, whole.state(id)),
                 [&] { return fmt::format("heap {}, stone {}", k, static_cast<int>(id)); });
    }
    see_choice(checks["events"], heard == told, [&] { return fmt::format("heap {}", k); });
  }
  return checks.measurement(
      {{"impacts of stones, steps of stones in clusters", fmt::format("{}, {}", impacts, steps)}});
}

// --- SCENE-3

/// The same stones in other units, which are powers of two of the old ones; lengths of one of eight, which has a cube root.
struct Units {
  double length, time, mass;
};

Scene<double> in_units(const Scene<double>& scene, SceneSettings<double> settings, const Units& unit) {
  const double a = unit.length, b = unit.time, c = unit.mass;
  Board<double> board = scene.board();
  for (double* length :
       {&board.spacing_x, &board.spacing_y, &board.half_width, &board.half_length, &board.thickness, &board.floor}) {
    *length *= a;
  }
  settings.drop.gravity *= a / (b * b);
  Scene<double> other(board, settings);
  for (const StoneId id : scene.stones()) {
    Stone<double> stone = scene.stone(id);
    for (double* length :
         {&stone.width, &stone.height, &stone.bevel, &stone.sphere_radius, &stone.sphere_offset,
          &stone.bevel_major_radius, &stone.bevel_minor_radius, &stone.core_sphere_radius, &stone.joint_radius}) {
      *length *= a;
    }
    RigidBody<double> body = scene.body(id);
    body.mass *= c;
    body.moments *= c * a * a;
    State<double> state = scene.state(id);
    state.p_WB *= a;
    state.v_WB *= a / b;
    state.L_W *= c * a * a / b;
    static_cast<void>(other.add(stone, body, state));
  }
  return other;
}

Measurement measure_units(Context& context) {
  Worst worst;
  long long steps = 0;
  for (int k = 0; k < context.samples(20, 150); ++k) {
    const SceneSettings<double> settings = game_settings();
    Scene<double> one(make_board<double>(), settings);
    pour(context, one, 10);
    const auto power = [&](int most) {
      return std::ldexp(1.0, std::uniform_int_distribution<int>(-most, most)(context.random()));
    };
    const double length = power(10);
    const Units unit{.length = length * length * length, .time = power(20), .mass = power(60)};
    Scene<double> other = in_units(one, settings, unit);
    one.advance(0.4);
    other.advance(0.4 * unit.time);
    steps += one.counters().stone_steps;
    for (const StoneId id : one.stones()) {
      State<double> there = other.state(id);
      there.p_WB = context.produced(there.p_WB) / unit.length;
      there.v_WB /= unit.length / unit.time;
      there.L_W /= unit.mass * unit.length * unit.length / unit.time;
      see_choice(worst, is_same(there, one.state(id)), [&] {
        return fmt::format("heap {}, stone {}, units {} m, {} s, {} kg", k, static_cast<int>(id), unit.length,
                           unit.time, unit.mass);
      });
    }
  }
  return worst.measurement({{"steps of stones in clusters", fmt::format("{}", steps)}});
}

}  // namespace

std::vector<Claim> scene_alone_claims() {
  return {
      {.id = "SCENE-1",
       .statement = "A stone of a scene that meets no other is a drop, to the last bit, state and events: thrown, "
                    "pushed, on a board that is tilted and laid flat again.",
       .function = "Scene",
       .family = OracleFamily::relation,
       .oracle = "drops of the same stones, which the claims DROP judge",
       .checks = {none("states", "stones that differ"), none("events", "stones that differ")},
       .measure = measure_alone},
      {.id = "SCENE-2",
       .statement = "How the time of a scene is cut does not matter, nor that it is asked, stored, or gone back to: "
                    "states and events are the same to the last bit.",
       .function = "Scene::advance_to",
       .family = OracleFamily::relation,
       .oracle = "the same scene in one piece",
       .checks = {none("states", "stones that differ"), none("events", "scenes that differ")},
       .measure = measure_cuts},
      {.id = "SCENE-3",
       .statement =
           "A scene knows no units: with lengths, times and masses in units that differ by powers of two "
           "(lengths by powers of eight) every stone is where it was, to the last bit. So no constant in it is "
           "absolute.",
       .function = "Scene",
       .family = OracleFamily::relation,
       .oracle = "the same scene in other units",
       .checks = {none("", "stones that differ")},
       .measure = measure_units},
  };
}

}  // namespace goishi::verify
