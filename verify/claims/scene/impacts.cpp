/// SCENE: two stones meet. When, and with what impulse.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/contact/flying_bodies.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/scene.hpp"

namespace goishi::verify {

namespace {

// --- SCENE-4

/// A stone that flies, and the same for Odeint.
struct Flyer {
  Piece piece;
  State<double> start;
  FlyingBody body;
};

/// It passes `target` after a time.
Flyer draw_flyer(Context& context, int i, const Vec3<double>& target, double after, const Vec3<double>& v_then) {
  Flyer drawn{draw_piece(context, i), {}, {}};
  const Vec3<double> a = gravity_W<double>(), v = v_then - after * a;
  drawn.start = thrown(context, drawn.piece, target - after * v - after * after / 2.0 * a, 0.0, 100.0);
  drawn.start.v_WB = v;
  const Quat<double>& q = drawn.start.q_WB;
  const Vec3<double>& I = drawn.piece.body.moments;
  const Vec3<double> L_B = q.conjugate() * drawn.start.L_W;
  drawn.body = {.p = triple(drawn.start.p_WB),
                .v = triple(v),
                .a = triple(a),
                .attitude = {q.w(), q.x(), q.y(), q.z()},
                .spin = triple(Vec3<double>(L_B.x() / I.x(), L_B.y() / I.y(), L_B.z() / I.z())),
                .axial = static_cast<Long>(I.z()),
                .transverse = static_cast<Long>(I.x())};
  return drawn;
}

Vec3<double> narrowed(const std::array<Long, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Pose<double> pose_of(const FlyingPlace& place) {
  return {.p_WB = narrowed(place.p), .q_WB = turn_between(Vec3<double>::UnitZ(), narrowed(place.u))};
}

Measurement measure_flights(Context& context) {
  Checks checks;
  int hits = 0;
  const int count = context.samples(40, 250);
  for (int i = 0; i < count; ++i) {
    // Over the board, 1 m.
    const double after = context.uniform(0.02, 0.2), end = 0.3;
    const Vec3<double> where(0.0, 0.0, 1.0), off = context.uniform(0.0, 0.012) * draw_unit(context);
    const Vec3<double> v = 0.5 * draw_unit(context);
    const Flyer one = draw_flyer(context, i, where, after, v);
    const Flyer two =
        draw_flyer(context, i / 5, where + off, after, v + context.uniform(0.1, 1.0) * draw_unit(context));
    Scene<double> scene(make_board<double>(), game_settings());
    std::optional<SceneEvent<double>> met;
    static_cast<void>(scene.add(one.piece.stone(), one.piece.body, one.start));
    try {
      static_cast<void>(scene.add(two.piece.stone(), two.piece.body, two.start));
    } catch (const InvalidArgument&) {
      continue;  // they overlap there
    }
    const double clearance = *scene.settings().clearance;
    scene.advance(end, [&](const SceneEvent<double>& event) {
      if (!met && event.other) {
        met = event;
      }
    });
    const auto gap_less = [&](double much) {
      return [&, much](const FlyingPlaces& at) -> Long {
        return static_cast<Long>(separation(one.piece.stone(), pose_of(at[0]), two.piece.stone(), pose_of(at[1])).gap -
                                 much);
      };
    };
    const auto told = [&] { return fmt::format("flight {}", i); };
    // Not to be missed where it comes nearer by more than Odeint's places are off.
    const std::vector<FlyingBody> bodies = {one.body, two.body};
    const FlyingEvent seen = first_event(bodies, gap_less(0.95 * clearance), static_cast<Long>(end), 5e-4L);
    see_choice(checks["missed"], !seen.found || met, told);
    if (!met) {
      continue;
    }
    ++hits;
    const Long time = static_cast<Long>(context.produced(met->event.time));
    checks["gap"].see(as_double(std::fabs(gap_less(clearance)(places_at(bodies, time)))) / clearance, told);
    const FlyingPlaces there = places_at(bodies, static_cast<Long>(met->event.time));
    const Vec3<double> p = narrowed(there[met->stone == StoneId(0) ? 0 : 1].p);
    checks["place"].see((context.produced(met->event.before.p_WB) - p).norm(), told);
    see_choice(checks["later"], !seen.found || met->event.time <= as_double(seen.time) * (1.0 + 1e-12), told);
  }
  return checks.measurement({{"flights, of which meet", fmt::format("{}, {}", count, hits)}});
}

// --- SCENE-5

/// The two stones of an impact, by its two events.
struct Met {
  const SceneEvent<double>&first, &second;
  const Scene<double>& scene;
};

void see_laws(const Context& context, const Met& met, Checks& checks) {
  const Event<double>&a = met.first.event, &b = met.second.event;
  const RigidBody<double>&one = met.scene.body(met.first.stone), &two = met.scene.body(met.second.stone);
  const Vec3<double>& g = met.scene.settings().drop.gravity;
  const Vec3<double>& p = a.contact_W;
  const Long3 n = a.normal_W.cast<Long>(), J = context.produced(a.impulse_W).cast<Long>();
  const Long3 before = velocity_at(a.before, one, p) - velocity_at(b.before, two, p);
  const Long3 after = velocity_at(a.after, one, p) - velocity_at(b.after, two, p);
  const auto told = [&] {
    return fmt::format("stones {} and {} at {:a} s", static_cast<int>(met.first.stone),
                       static_cast<int>(met.second.stone), a.time);
  };
  // Every speed that takes part: of the points, the centres, the turning.
  const Long size = before.norm() + a.before.v_WB.cast<Long>().norm() + b.before.v_WB.cast<Long>().norm() +
                    static_cast<Long>(0.011) * (turning_of(a.before, one).norm() + turning_of(b.before, two).norm());
  const Long m = std::min<Long>(one.mass, two.mass), arm = 0.011L;
  const auto gained = [](const Event<double>& event, const RigidBody<double>& body) {
    return Long3(static_cast<Long>(body.mass) * (event.after.v_WB - event.before.v_WB).cast<Long>());
  };
  checks["momentum"].see(as_double(std::max((gained(a, one) - J).norm(), (gained(b, two) + J).norm()) / (m * size)),
                         told);
  const auto turned = [&](const Event<double>& event, const Long3& impulse) {
    const Long3 r = (p - event.before.p_WB).cast<Long>();
    return ((event.after.L_W - event.before.L_W).cast<Long>() - r.cross(impulse)).norm();
  };
  checks["angular momentum"].see(as_double(std::max(turned(a, J), turned(b, -J)) / (m * arm * size)), told);
  const Long e = static_cast<Long>(met.scene.settings().restitution);
  checks["restitution"].see(
      as_double(std::fabs(static_cast<Long>(context.produced(1.0)) * after.dot(n) + e * before.dot(n)) / size), told);
  const Long normal = J.dot(n), across = (J - normal * n).norm() * static_cast<Long>(context.produced(1.0));
  checks["cone"].see(
      as_double(std::max<Long>(0, across - static_cast<Long>(met.scene.settings().friction) * normal) / (m * size)),
      told);
  see_choice(checks["pulls"], normal > 0, told);
  const auto energy = [&](const Event<double>& event, const RigidBody<double>& body) {
    return carried_by(event.after, body, g).energy - carried_by(event.before, body, g).energy;
  };
  const Long change = energy(a, one) + energy(b, two), scale = static_cast<Long>(one.mass + two.mass) * size * size;
  checks["energy"].see(as_double(std::fabs(change - J.dot(before + after) / 2) / scale), told);
  see_choice(checks["gains"], change <= 1e-14L * scale, told);
}

Measurement measure_impacts(Context& context) {
  Checks checks;
  int impacts = 0;
  for (int k = 0; k < context.samples(7, 60); ++k) {
    SceneSettings<double> settings = game_settings();
    settings.restitution = k % 5 == 0 ? 0.0 : k % 5 == 1 ? 1.0 : context.uniform(0.0, 1.0);
    settings.friction = k % 7 == 0 ? 0.0 : context.uniform(0.0, 1.0);
    Scene<double> scene(make_board<double>(), settings);
    pour(context, scene, 12);
    std::vector<SceneEvent<double>> events;
    scene.advance(0.4, events);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const SceneEvent<double>&a = events[i], &b = events[i + 1];
      if (a.event.kind != EventKind::impact || !a.other) {
        continue;
      }
      see_choice(checks["told of one alone"],
                 b.event.kind == EventKind::impact && b.other == a.stone && *a.other == b.stone &&
                     b.event.time == a.event.time && b.event.impulse_W == -a.event.impulse_W,
                 [&] { return fmt::format("heap {}, event {}", k, i); });
      see_laws(context, {a, b, scene}, checks);
      ++impacts;
      ++i;
    }
  }
  return checks.measurement({{"impacts", fmt::format("{}", impacts)}});
}

// --- SCENE-6

/// Stones in a row along x that touch rim to rim, with no gravity: by the definition of e, one impact after another.
class Row {
 public:
  struct Bead {
    Long x, v, m, half;
  };

  Row(std::vector<Bead> beads, Long e, Long clearance) : beads_(std::move(beads)), e_(e), clearance_(clearance) {}

  /// Up to a time, or to an approach slower than `slow`, which is none of these: then false.
  [[nodiscard]] bool advance(Long until, Long slow) {
    while (true) {
      std::size_t first = 0;
      Long soonest = until - time_;
      bool hit = false;
      for (std::size_t i = 0; i + 1 < beads_.size(); ++i) {
        const Bead &a = beads_[i], &b = beads_[i + 1];
        const Long gap = b.x - a.x - a.half - b.half - clearance_;
        if (b.v < a.v && gap / (a.v - b.v) < soonest) {
          soonest = gap / (a.v - b.v);
          first = i;
          hit = true;
        }
      }
      for (Bead& bead : beads_) {
        bead.x += bead.v * soonest;
      }
      time_ += soonest;
      if (!hit) {
        return true;
      }
      Bead &a = beads_[first], &b = beads_[first + 1];
      if (a.v - b.v < slow) {
        return false;
      }
      const Long J = (1 + e_) * (a.v - b.v) / (1 / a.m + 1 / b.m);
      a.v -= J / a.m;
      b.v += J / b.m;
      ++impacts;
    }
  }
  [[nodiscard]] const std::vector<Bead>& beads() const { return beads_; }
  [[nodiscard]] Long time() const { return time_; }

  int impacts = 0;

 private:
  std::vector<Bead> beads_;
  Long e_, clearance_, time_ = 0;
};

Measurement measure_rows(Context& context) {
  Checks checks;
  int impacts = 0;
  for (int k = 0; k < context.samples(60, 500); ++k) {
    SceneSettings<double> settings = weightless_settings();
    // Newton's cradle is one of them.
    settings.restitution = k % 3 == 0 ? 1.0 : context.uniform(0.5, 1.0);
    settings.impact_speed = 1e-4;
    settings.step = 1e-6;  // a second impact of two within one is none of these
    Scene<double> scene(make_board<double>(), settings);
    std::vector<Row::Bead> beads;
    double x = -0.1;
    for (int i = 0; i < 6; ++i) {
      const Piece piece(k % 3 == 0 ? Specimen{{0.022, 0.0092, 0.001}, make_stone(0.022, 0.0092, 0.001)}
                                   : draw_piece(context, i).specimen);
      const double half = outer_width(piece.stone()) / 2.0;
      x += half + context.uniform(1e-4, 2e-3);
      State<double> start = set_down({x, 0.0, 0.1});
      start.v_WB.x() = i == 0 ? 1.0 : 0.0;
      static_cast<void>(scene.add(piece.stone(), piece.body, start));
      beads.push_back({x, start.v_WB.x(), piece.body.mass, half});
      x += half;
    }
    Row row(beads, static_cast<Long>(settings.restitution), static_cast<Long>(*scene.settings().clearance));
    const bool whole = row.advance(0.08L, 0.01L);
    const double until = as_double(row.time()) - (whole ? 0.0 : 1e-5);
    scene.advance_to(until);
    for (std::size_t i = 0; i < beads.size(); ++i) {
      const State<double> there = scene.state(StoneId(i));
      const auto told = [&] { return fmt::format("row {}, stone {}", k, i); };
      if (whole) {
        checks["velocity"].see(
            (context.produced(there.v_WB) - Vec3<double>(as_double(row.beads()[i].v), 0.0, 0.0)).norm(), told);
        // Each impact may be a hundredth of the clearance early, at up to 1 m/s and more.
        checks["place"].see(std::fabs(context.produced(there.p_WB.x()) - as_double(row.beads()[i].x)) /
                                *scene.settings().clearance / (1.0 + row.impacts),
                            told);
      }
    }
    impacts += row.impacts;
  }
  return checks.measurement({{"impacts", fmt::format("{}", impacts)}});
}

}  // namespace

std::vector<Claim> scene_impact_claims() {
  return {
      {.id = "SCENE-4",
       .statement =
           "Two stones in flight, each turning at up to 100 rad/s, meet where and when Odeint sees them come as "
           "near as the clearance; no meeting is missed, none comes too late.",
       .function = "Scene::advance",
       .family = OracleFamily::integration,
       .oracle = "Odeint, Fehlberg 7(8) in long double, and the separation of the places that it gives",
       .checks = {within("gap", 0.02, "of the clearance",
                         "derived: first_touch ends between half a hundredth and a hundredth above it", 1e-3),
                  within("place", 2e-15, "m", "a few roundings, 1 m over the board", 2e-16), none("missed", "meetings"),
                  none("later", "meetings")},
       .measure = measure_flights},
      {.id = "SCENE-5",
       .statement =
           "An impact of two stones, in flight, at rest or in clusters, is told of both; it keeps momentum and "
           "angular momentum about the contact, has the restitution that was asked for, is in the cone of "
           "friction, does not pull and gains no energy.",
       .function = "Scene::advance",
       .family = OracleFamily::invariant,
       .oracle = "momenta, velocities and energy of the states before and after, in long double",
       .checks = {within("momentum", 1e-14, "of the speeds", "some roundings", 2e-16),
                  within("angular momentum", 1e-14, "of the speeds", "some roundings", 2e-16),
                  within("restitution", 1e-14, "of the speeds", "some roundings", 2e-16),
                  within("cone", 2e-15, "of the speeds", "some roundings", 1e-16),
                  within("energy", 2e-15, "of the speeds squared",
                         "derived: it changes by J · (v⁻ + v⁺)/2; some roundings", 1e-16),
                  none("gains", "impacts"), none("pulls", "impulses"), none("told of one alone", "impacts")},
       .measure = measure_impacts},
      {.id = "SCENE-6",
       .statement = "Stones in a row, the first thrown at the others, pass the blow on as masses and restitution say, "
                    "Newton's cradle among them.",
       .function = "Scene::advance",
       .family = OracleFamily::exact,
       .oracle = "impacts on a line, one after the other",
       .checks = {within("velocity", 5e-15, "m/s", "some roundings of 1 m/s", 1e-15),
                  within("place", 0.02, "of the clearance, for each impact",
                         "a touch is up to a hundredth of it early")},
       .measure = measure_rows},
  };
}

}  // namespace goishi::verify
