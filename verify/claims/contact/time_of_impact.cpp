/// TOI: when a flying stone first touches.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/motion/free_flight.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/golden.hpp"
#include "verify/samples/flight_path.hpp"

namespace goishi::verify {

namespace {

// --- a plane

/// The gap over z = 0 as a function of time, in long double.
struct Height {
  Hull<Long> hull;
  FlightPath<double> path;
  Long operator()(Long t) const { return nearest_along(standing(hull, path, t), {0, 0, 1}); }

  /// The least gap over [0, end]: at 10 000 instants, and in every dip of them that comes near the surface.
  [[nodiscard]] Long least(Long end, Long near) const {
    constexpr int count = 10000;
    std::array<Long, 3> last{};
    Long result = std::numeric_limits<Long>::infinity();
    for (int i = 0; i <= count; ++i) {
      last = {last[1], last[2], (*this)(end * i / count)};
      result = std::min(result, last[2]);
      if (i >= 2 && last[1] <= last[0] && last[1] <= last[2] && last[1] < near) {
        const Long dip = golden<Long>(*this, end * (i - 2) / count, end * i / count, 1e-12L * end);
        result = std::min(result, (*this)(dip));
      }
    }
    return result;
  }
};

Measurement measure_drops(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_stone(context, i);
    const double width = outer_width(specimen.stone);
    FlightPath<double> path = draw_path(context, Vec3<double>(0.0, 0.0, width * context.uniform(1.0, 10.0)),
                                        Vec3<double>(0.1, 0.0, i % 4 < 2 ? 0.0 : context.uniform(-1.0, 1.0)), i);
    if (i % 2 == 0) {
      path.u_W = path.k_W = {0.0, 0.0, 1.0};  // flat, spinning or not
    } else if (i % 4 == 1) {
      path.k_W = path.u_W;  // tilted, spinning about its own axis
    } else {
      path.rate = 0.0;
    }
    const TimeOfImpact<double> computed = time_of_impact(specimen.stone, path, Plane<double>{}, 10.0);
    const Long g = static_cast<Long>(earth_gravity), v = static_cast<Long>(path.v_W.z());
    const Long gap = Height{narrow(hull_of(specimen)), path}(0);
    const Long expected = (v + std::sqrt(v * v + 2 * g * gap)) / g;
    // A gap that is off by ε of the height changes the time by that over the speed.
    const double condition = path.p_W.z() / static_cast<double>((g * expected - v) * expected);
    const auto describe_case = [&] { return describe(specimen) + ", " + describe(path); };
    checks["status"].see(computed.status == ImpactStatus::hit ? 0.0 : 1.0, describe_case);
    checks["time"].see(
        std::fabs(static_cast<double>(static_cast<Long>(context.produced(computed.time)) / expected - 1)),
        std::max(1.0, condition), describe_case);
  }
  return checks.measurement();
}

Measurement measure_plane_time(Context& context) {
  Checks checks;
  int hits = 0, grazing = 0, steps = 0;
  for (int i = 0; i < context.samples(60, 400); ++i) {
    const Specimen specimen = draw_stone(context, i);
    const double width = outer_width(specimen.stone);
    FlightPath<double> path = draw_path(context, Vec3<double>(0.0, 0.0, width * context.uniform(0.51, 3.0)),
                                        Vec3<double>(0.0, 0.0, context.uniform(-0.5, 0.7)), i);
    const double end = 0.15;
    Height height{narrow(hull_of(specimen)), path};
    if (i % 2 == 0) {
      // Let a dip of the gap before the fall nearly touch: so little over or under the surface.
      Long dip = 0;
      Long least = std::numeric_limits<Long>::infinity();
      const Long turn = std::numbers::pi_v<Long> / std::max<Long>(std::fabs(static_cast<Long>(path.rate)), 60);
      for (int k = 1; k < 100; ++k) {
        const Long t = 2 * turn * k / 100;
        if (height(t) < least) {
          least = height(t), dip = t;
        }
      }
      dip = golden<Long>(height, dip - turn / 50, dip + turn / 50, 1e-15L);
      path.p_W.z() -= static_cast<double>(height(dip)) + (i % 4 == 0 ? 1.0 : -1.0) * width * draw_small(context, 12.0);
      height.path = path;
      ++grazing;
    }
    const auto see = [&](double error, const char* check, const char* what = "") {
      checks[check].see(error, [&] {
        return fmt::format("{}{}{}, {}", what, i % 2 == 0 ? "grazing: " : "", describe(specimen), describe(path));
      });
    };
    const TimeOfImpact<double> computed = time_of_impact(specimen.stone, path, Plane<double>{}, end);
    steps = std::max(steps, computed.steps);
    if (height(0) < 0) {
      see(computed.status == ImpactStatus::overlapping || height(0) > -1e-14L * width ? 0.0 : 1.0, "faults",
          "overlapping: ");
      continue;
    }
    const Long time = static_cast<Long>(context.produced(computed.time));
    see(computed.status == (time < end ? ImpactStatus::hit : ImpactStatus::none) ? 0.0 : 1.0, "faults", "status: ");
    // Nothing of the stone under the surface before the time, to round-off; on the surface then.
    const double scale = width + path.p_W.norm() + path.rate * end * width;
    see(-static_cast<double>(height.least(time, 1e-3L * width)) / scale, "penetration");
    if (computed.status == ImpactStatus::hit) {
      ++hits;
      see(std::fabs(static_cast<double>(height(time))) / scale, "gap at the time");
      see(std::fabs(computed.contact.gap) <= 1e-14 * scale ? 0.0 : 1.0, "faults", "contact's gap: ");
      const double cut = computed.time * (1.0 - 1e-9);
      const TimeOfImpact<double> early = time_of_impact(specimen.stone, path, Plane<double>{}, cut);
      // Next to a graze the stone touches, but for round-off, before that.
      const bool in_time = early.status == ImpactStatus::none ? early.time == cut : early.time <= cut;
      see(cut <= 0.0 || early.status == ImpactStatus::none ? 0.0
                                                           : std::fabs(static_cast<double>(height(early.time))) / scale,
          "gap at the time", "at a horizon before: ");
      see(cut <= 0.0 || in_time ? 0.0 : 1.0, "faults", "horizon before: ");
    } else {
      see(computed.time == end ? 0.0 : 1.0, "faults", "time of none: ");
    }
  }
  return checks.measurement(
      {{"hits", fmt::format("{}, {} flights made to graze", hits, grazing)}, {"most steps", fmt::format("{}", steps)}});
}

// --- where it starts

Measurement measure_starts(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(500, 2000); ++i) {
    const Specimen specimen = draw_stone(context, i);
    const Stone<double>& stone = specimen.stone;
    const Board<double> board = make_board<double>();
    const Plane<double> plane;
    const double half = stone.height / 2.0, v = context.uniform(0.01, 1.0);
    // Flat on the surface, at rest unless said.
    FlightPath<double> flat = draw_path(context, Vec3<double>(0.0, 0.0, half), Vec3<double>(0.0, 0.0, 0.0), i);
    flat.u_W = flat.k_W = {0.0, 0.0, 1.0};
    const auto see = [&](double error, const char* check, const char* what) {
      checks[check].see(error, [&] { return fmt::format("{}: {}, {}", what, describe(specimen), describe(flat)); });
    };
    const auto see_all = [&](const FlightPath<double>& path, ImpactStatus status, double time, const char* name) {
      const TimeOfImpact<double> on_plane = time_of_impact(stone, path, plane, 10.0);
      const TimeOfImpact<double> on_board = time_of_impact(stone, path, board, 10.0);
      for (const TimeOfImpact<double>& at : {on_plane, on_board}) {
        see(at.status == status ? 0.0 : 1.0, "status", name);
        // A gap that is off by ε of the height changes the time by that over the speed.
        see(std::fabs(context.produced(at.time) - time) / std::max(time, half / v), "time", name);
      }
    };
    see_all(flat, ImpactStatus::hit, 0.0, "at rest on the surface");
    FlightPath<double> path = flat;
    path.v_W.z() = -v;
    see_all(path, ImpactStatus::hit, 0.0, "on the surface, into it");
    path.v_W.z() = v;
    see_all(path, ImpactStatus::hit, 2.0 * v / earth_gravity, "on the surface, leaving");
    path.a_W.z() = 0.0;
    see_all(path, ImpactStatus::none, 10.0, "on the surface, leaving for good");
    path = flat;
    path.p_W.z() = half * context.uniform(-1.0, 1.0 - 1e-6);
    see_all(path, ImpactStatus::overlapping, 0.0, "in the surface");
    path.v_W.z() = v;
    see_all(path, ImpactStatus::overlapping, 0.0, "in the surface, leaving");

    // Two stones, one on the other, falling together.
    FlightPath<double> above = flat, below = flat;
    below.p_W.z() = 0.0, above.p_W.z() = 2.0 * half;
    const auto see_pair = [&](double speed, ImpactStatus status, double time, const char* name) {
      above.v_W.z() = speed;
      const TimeOfImpact<double> at = time_of_impact(stone, above, stone, below, 10.0);
      see(at.status == status ? 0.0 : 1.0, "status", name);
      see(std::fabs(context.produced(at.time) - time) / 10.0, "time", name);
    };
    see_pair(-v, ImpactStatus::hit, 0.0, "two stones, approaching");
    see_pair(v, ImpactStatus::none, 10.0, "two stones, leaving");
    above.p_W.z() *= context.uniform(0.0, 1.0 - 1e-6);
    see_pair(v, ImpactStatus::overlapping, 0.0, "two stones in one another");
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> time_of_impact_claims() {
  return {
      {.id = "TOI-1",
       .statement = "A stone that falls flat, or tilted without wobbling, touches the plane when the parabola says.",
       .function = "time_of_impact (plane)",
       .family = OracleFamily::exact,
       .oracle = "the root of the parabola, √(2(h₀ − h/2)/g) from rest, in long double",
       .checks = {within("time", 4e-15, "relative, over the height per distance fallen",
                         "a gap and its parabola of some six roundings of the height, Newton's last step; measured "
                         "2026-11-30 with 23 seeds: up to 1.7e-15",
                         epsilon),
                  none("status", "faults")},
       .measure = measure_drops},
      {.id = "TOI-2",
       .statement =
           "A wobbling stone, up to 1000 rad/s, is nowhere under the plane before the time that is given, flights "
           "that graze included, and on it then; within a shorter horizon there is no hit.",
       .function = "time_of_impact (plane)",
       .family = OracleFamily::brute_force,
       .oracle = "the gap of caps and torus in long double at 10 000 instants, their dips searched by golden section",
       .checks = {within("penetration", 1e-14, "of width, height and the angle turned times the width",
                         "round-off of the gap: the angle is rounded, the axis has some ten roundings; measured "
                         "2026-11-30 with 23 seeds: up to 1.8e-15",
                         epsilon),
                  within("gap at the time", 1e-14, "of width, height and the angle turned times the width",
                         "the same; measured 2026-11-30 with 23 seeds: up to 1.8e-15", epsilon),
                  none("faults", "faults")},
       .measure = measure_plane_time},
      {.id = "TOI-3",
       .statement =
           "Where a flight starts decides: in contact it hits at 0 unless it leaves, and then when it comes back; "
           "overlapping is said to overlap.",
       .function = "time_of_impact (plane, board, stones)",
       .family = OracleFamily::exact,
       .oracle = "0, 2v/g, never",
       .checks = {within("time", 1e-15, "relative, or of the time in which the speed goes half the height",
                         "the roundings of 2v/g; measured 2026-11-30 with 23 seeds: up to 2.2e-16", epsilon),
                  none("status", "faults")},
       .measure = measure_starts},
  };
}

}  // namespace goishi::verify
