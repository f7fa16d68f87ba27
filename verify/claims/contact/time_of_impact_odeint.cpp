/// TOI: the first touch against Odeint with events.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/contact/flying_bodies.hpp"
#include "verify/samples/attitude.hpp"
#include "verify/samples/flight_path.hpp"

namespace goishi::verify {

namespace {

/// A stone that is thrown, as Odeint sees it and as the time of impact does.
struct Throw {
  Specimen specimen;
  FlyingBody body;
  FlightPath<double> path;
};

/// It passes `target` after a time.
Throw draw_throw(Context& context, int i, const Vec3<double>& target, double after, const Vec3<double>& v_then) {
  Throw drawn{draw_stone(context, i), {}, {}};
  const Moments<double> moments = mass_properties(drawn.specimen.stone, Density<double>{1.0}).moments_per_mass;
  const Vec3<double> a(0.0, 0.0, -earth_gravity), v = v_then - after * a;
  const Vec3<double> p = target - after * v - after * after / 2.0 * a;
  const Quat<double> q = draw_attitude(context.random());
  const Vec3<double> w_B = 300.0 * draw_small(context, 3.0) * draw_unit(context);
  const Vec3<double> L_W =
      q * Vec3<double>(moments.transverse * w_B.x(), moments.transverse * w_B.y(), moments.axial * w_B.z());
  drawn.path = {.p_W = p,
                .v_W = v,
                .a_W = a,
                .u_W = q * Vec3<double>::UnitZ(),
                .k_W = L_W.normalized(),
                .rate = L_W.norm() / moments.transverse};
  drawn.body = {.p = triple(p),
                .v = triple(v),
                .a = triple(a),
                .attitude = {q.w(), q.x(), q.y(), q.z()},
                .spin = triple(w_B),
                .axial = static_cast<Long>(moments.axial),
                .transverse = static_cast<Long>(moments.transverse)};
  return drawn;
}

Pose<double> pose_of(const FlyingPlace& place) {
  const auto vector = [](const std::array<Long, 3>& v) {
    return Vec3<double>(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  return {.p_WB = vector(place.p), .q_WB = turn_between(Vec3<double>::UnitZ(), vector(place.u))};
}

struct SeenFlights {
  Worst& faults;
  Worst worst = {};
  int hits = 0, flights = 0;

  void see(const Context& context, const TimeOfImpact<double>& computed, const std::vector<FlyingBody>& bodies,
           const Gap& gap, double horizon, double fastest, double scale, const std::string& flight) {
    const auto see_error = [&](Long error, const char* name) {
      worst.see(static_cast<double>(error) / scale, [&] { return name + (": " + flight); });
    };
    ++flights;
    const Long time = static_cast<Long>(context.produced(computed.time));
    const FlyingEvent event = first_event(bodies, gap, static_cast<Long>(horizon), static_cast<Long>(0.05 / fastest));
    see_error(-event.least, "touching before");
    const bool hit = computed.status == ImpactStatus::hit;
    faults.see(hit || (computed.status == ImpactStatus::none && !event.found) ? 0.0 : 1.0, [&] { return flight; });
    if (!hit) {
      return;
    }
    ++hits;
    see_error(std::fabs(gap(places_at(bodies, time))), "the gap at the time");
    // Between instants Odeint's event finder may miss a short touch; it never sees one too early.
    if (event.found) {
      const Long speed =
          std::fabs(gap(places_at(bodies, event.time + 1e-7L)) - gap(places_at(bodies, event.time))) / 1e-7L;
      see_error((time - event.time) * speed, "the time, times the speed of approach");
    }
  }
};

Measurement measure_events(Context& context) {
  Worst faults;
  SeenFlights at_board{faults}, of_two{faults};
  for (int i = 0; at_board.flights < context.samples(60, 400); ++i) {
    const Board<double> board = draw_board(context, i / 6);
    const double after = context.uniform(0.02, 0.15), horizon = 1.5 * after;
    const Vec3<double> v(context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0));
    const Specimen aim = draw_stone(context, 0);
    const Pose<double> target = draw_board_pose(context, aim.stone, board, i % 2 + 1);
    const Throw stone = draw_throw(context, i, target.p_WB, after, v);
    const auto gap = [&](const FlyingPlaces& places) {
      return static_cast<Long>(separation(stone.specimen.stone, pose_of(places[0]), board).gap);
    };
    if (!(gap(places_at({stone.body}, 0)) > 1e-9L)) {
      continue;
    }
    const double width = outer_width(stone.specimen.stone);
    at_board.see(context, time_of_impact(stone.specimen.stone, stone.path, board, horizon), {stone.body}, gap, horizon,
                 std::max(50.0, stone.path.rate), width + stone.path.rate * horizon * width + stone.path.p_W.norm(),
                 fmt::format("{}, {}, board {:a} × {:a}, horizon {:a}", describe(stone.specimen), describe(stone.path),
                             board.half_width, board.half_length, horizon));
  }
  for (int i = 0; of_two.flights < context.samples(60, 400); ++i) {
    const double after = context.uniform(0.02, 0.15), horizon = 1.5 * after;
    const Vec3<double> v = 2.0 * context.uniform(0.0, 1.0) * draw_unit(context);
    const Throw other = draw_throw(context, i / 6, Vec3<double>(0.02 * draw_unit(context)), after, v);
    const Throw stone = draw_throw(context, i, Vec3<double>(0.03 * context.uniform(0.0, 1.0) * draw_unit(context)),
                                   after, Vec3<double>(v + context.uniform(0.1, 2.0) * draw_unit(context)));
    const auto gap = [&](const FlyingPlaces& places) {
      return static_cast<Long>(
          separation(stone.specimen.stone, pose_of(places[0]), other.specimen.stone, pose_of(places[1])).gap);
    };
    if (!(gap(places_at({stone.body, other.body}, 0)) > 1e-9L)) {
      continue;
    }
    const double width = outer_width(stone.specimen.stone) + outer_width(other.specimen.stone);
    const double rate = stone.path.rate + other.path.rate;
    of_two.see(context, time_of_impact(stone.specimen.stone, stone.path, other.specimen.stone, other.path, horizon),
               {stone.body, other.body}, gap, horizon, std::max(50.0, rate),
               width + rate * horizon * width + stone.path.p_W.norm() + other.path.p_W.norm(),
               fmt::format("{}, {} and {}, {}, horizon {:a}", describe(stone.specimen), describe(stone.path),
                           describe(other.specimen), describe(other.path), horizon));
  }
  return {.checks = {at_board.worst.measured("at the board"), of_two.worst.measured("of two stones"),
                     faults.measured("faults")},
          .figures = {{"hits at the board", fmt::format("{} of {} flights", at_board.hits, at_board.flights)},
                      {"hits of two stones", fmt::format("{} of {} flights", of_two.hits, of_two.flights)}}};
}

}  // namespace

std::vector<Claim> time_of_impact_odeint_claims() {
  return {
      {.id = "TOI-6",
       .statement =
           "The time of impact of a thrown stone with edges and corners of the board, and of two thrown stones, is "
           "that at which Odeint sees them touch.",
       .function = "time_of_impact (board, stones)",
       .family = OracleFamily::integration,
       .oracle = "Newton's and Euler's equations by Fehlberg 7(8) in long double, the first change of sign of the "
                 "separation bisected",
       .checks = {within("at the board", 64.0 * epsilon, "of width, distance and the angle turned times the width",
                         "the search ends when the separation is within 64 ε of the width", epsilon),
                  within("of two stones", 96.0 * epsilon, "of width, distance and the angle turned times the width",
                         "the search ends when the separation is within 256 ε of the two widths, half of the unit; "
                         "measured 2026-11-30 with 24 seeds: up to 1.1e-14",
                         epsilon),
                  none("faults", "faults")},
       .measure = measure_events},
  };
}

}  // namespace goishi::verify
