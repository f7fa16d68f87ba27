/// TOI: when a flying stone first touches the board's sides, edges and corners, and another flying stone.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/time_of_impact.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/flight_path.hpp"

namespace goishi::verify {

namespace {

/// At how many instants flight i is looked at: some flights at ten thousand.
int instants_of(Context& context, int i) {
  return i % context.samples(30, 5) == 0 ? 10000 : 200;
}

/// `gap`: at a time, between the flying stone and the other body.
template <class Gap>
void see_flight(const Context& context, Checks& checks, const TimeOfImpact<double>& computed, Gap&& gap, double horizon,
                int instants, double scale, const std::string& flight) {
  const auto see = [&](double error, const char* check, const char* what = "") {
    checks[check].see(error, [&] { return what + flight; });
  };
  see(computed.status == ImpactStatus::hit || computed.status == ImpactStatus::none ? 0.0 : 1.0, "faults", "status: ");
  for (int k = 0; k < instants; ++k) {
    const Separation<double> at = gap(context.produced(computed.time) * k / instants);
    see(-at.gap / scale, "penetration");
  }
  if (computed.status == ImpactStatus::none) {
    see(computed.time == horizon ? 0.0 : 1.0, "faults", "time of none: ");
    return;
  }
  see(computed.time <= horizon ? 0.0 : 1.0, "faults", "a hit after the horizon: ");
  see(std::fabs(gap(context.produced(computed.time)).gap) / scale, "gap at the time");
  const double off = computed.contact.gap - gap(computed.time).gap;
  see(std::fabs(off) <= 16.0 * epsilon * scale ? 0.0 : 1.0, "faults", "contact's gap: ");
}

Measurement measure_board_time(Context& context) {
  Checks checks;
  int hits = 0, flights = 0, normals = 0;
  std::array<int, 6> features{};
  for (int i = 0; flights < context.samples(300, 1500); ++i) {
    const Specimen specimen = draw_stone(context, i);
    const Board<double> board = draw_board(context, i / 6);
    const double reach = outer_width(specimen.stone) / 2.0;
    // Thrown so that its centre passes near an edge or a corner after some 0.1 s.
    const Pose<double> target = draw_board_pose(context, specimen.stone, board, i % 2 + 1);
    const double after = context.uniform(0.02, 0.2);
    const Vec3<double> v(context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0), context.uniform(-1.0, 1.0));
    const Vec3<double> fall(0.0, 0.0, -earth_gravity);
    FlightPath<double> path = draw_path(context, Vec3<double>::Zero(), Vec3<double>(v - after * fall), i);
    path.p_W = target.p_WB - after * path.v_W - after * after / 2.0 * fall;
    if (!(separation(specimen.stone, pose_at(path, 0.0), board).gap > 1e-9)) {
      continue;
    }
    ++flights;
    const double horizon = i % 5 == 0 ? after : 2.0 * after;
    const TimeOfImpact<double> computed = time_of_impact(specimen.stone, path, board, horizon);
    const double scale = 2.0 * reach + path.p_W.norm() + path.rate * horizon * reach + specimen.stone.sphere_radius;
    see_flight(
        context, checks, computed, [&](double t) { return separation(specimen.stone, pose_at(path, t), board); },
        horizon, instants_of(context, flights), scale,
        fmt::format("{}, {}, board {:a} × {:a}, horizon {:a}", describe(specimen), describe(path), board.half_width,
                    board.half_length, horizon));
    normals = std::max(normals, computed.separations);
    if (computed.status == ImpactStatus::hit) {
      ++hits;
      ++features[static_cast<std::size_t>(computed.contact.other_feature)];
    }
  }
  Measurement result = checks.measurement();
  result.figures = {{"hits", fmt::format("{} of {} flights", hits, flights)},
                    {"most normals", fmt::format("{}", normals)}};
  for (const OtherFeature feature : {OtherFeature::surface, OtherFeature::side, OtherFeature::top_edge,
                                     OtherFeature::vertical_edge, OtherFeature::corner}) {
    result.figures.push_back(
        {std::string(to_string(feature)), fmt::format("{} hits", features[static_cast<std::size_t>(feature)])});
  }
  return result;
}

Measurement measure_pair(Context& context) {
  Checks checks;
  int hits = 0, flights = 0, normals = 0;
  for (int i = 0; flights < context.samples(300, 1500); ++i) {
    const Specimen one = draw_stone(context, i), two = draw_stone(context, i / 6);
    const double reach = (outer_width(one.stone) + outer_width(two.stone)) / 2.0;
    const FlightPath<double> other = draw_path(
        context, 0.1 * draw_unit(context), Vec3<double>(2.0 * context.uniform(0.0, 1.0) * draw_unit(context)), i / 9);
    // Their centres pass at up to half as far again as they can touch.
    const double after = context.uniform(0.01, 0.1);
    const Vec3<double> v = other.v_W + 2.0 * context.uniform(0.1, 1.0) * draw_unit(context);
    const Vec3<double> pass = other.p_W + after * other.v_W + reach * context.uniform(0.0, 1.5) * draw_unit(context);
    const FlightPath<double> path = draw_path(context, Vec3<double>(pass - after * v), v, i);
    if (!(separation(one.stone, pose_at(path, 0.0), two.stone, pose_at(other, 0.0)).gap > 1e-9)) {
      continue;
    }
    ++flights;
    const double horizon = i % 5 == 0 ? after : 2.0 * after;
    const TimeOfImpact<double> computed = time_of_impact(one.stone, path, two.stone, other, horizon);
    const double scale = reach + path.p_W.norm() + (path.rate + other.rate) * horizon * reach +
                         one.stone.sphere_radius + two.stone.sphere_radius;
    see_flight(
        context, checks, computed,
        [&](double t) { return separation(one.stone, pose_at(path, t), two.stone, pose_at(other, t)); }, horizon,
        instants_of(context, flights), scale,
        fmt::format("{}, {} and {}, {}, horizon {:a}", describe(one), describe(path), describe(two), describe(other),
                    horizon));
    normals = std::max(normals, computed.separations);
    hits += computed.status == ImpactStatus::hit;
  }
  Measurement result = checks.measurement();
  result.figures = {{"hits", fmt::format("{} of {} flights", hits, flights)},
                    {"most normals", fmt::format("{}", normals)}};
  return result;
}

}  // namespace

std::vector<Claim> time_of_impact_body_claims() {
  return {
      {.id = "TOI-4",
       .statement = "A stone thrown at edges and corners of the board is not in it before the time that is given, and "
                    "touches it then; none within the horizon is none.",
       .function = "time_of_impact (board)",
       .family = OracleFamily::invariant,
       .oracle = "the separation, judged by CONTACT-2, at up to 10 000 instants of the flight in long double",
       .checks = {within("penetration", 16.0 * epsilon,
                         "of width, distance, the sphere's radius and the angle turned times the width",
                         "the search comes from outside: the roundings of a separation", epsilon),
                  within("gap at the time", 64.0 * epsilon,
                         "of width, distance, the sphere's radius and the angle turned times the width",
                         "the search ends when the separation is within 64 ε of the width; measured 2026-11-30 "
                         "with 23 seeds: up to 5.3e-15",
                         epsilon),
                  none("faults", "faults")},
       .measure = measure_board_time},
      {.id = "TOI-5",
       .statement =
           "Two flying stones are apart before the time that is given and touch then, each turning at up to 1000 "
           "rad/s.",
       .function = "time_of_impact (stones)",
       .family = OracleFamily::invariant,
       .oracle = "the separation, judged by CONTACT-4, at up to 10 000 instants of the flight in long double",
       .checks = {within("penetration", 16.0 * epsilon,
                         "of widths, distance, the spheres' radii and the angles turned times the widths",
                         "the search comes from outside: the roundings of a separation", epsilon),
                  within("gap at the time", 256.0 * epsilon,
                         "of widths, distance, the spheres' radii and the angles turned times the widths",
                         "the search ends when the separation is within 256 ε of the two widths; measured "
                         "2026-11-30 with 23 seeds: up to 2.3e-14",
                         epsilon),
                  none("faults", "faults")},
       .measure = measure_pair},
  };
}

}  // namespace goishi::verify
