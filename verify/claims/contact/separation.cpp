/// CONTACT: gap, normal and contact points against search and against 50 digits.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

Measurement measure_plane_gap(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const PlaneCase drawn = draw_plane_case(context, i);
    const auto see = [&](double gap, const char* name) {
      worst.see(std::fabs(static_cast<double>(Digits50(Digits50(context.produced(gap)) - drawn.gap))) / drawn.scale,
                [&] { return fmt::format("{}: {}", name, describe(drawn)); });
    };
    const Stone<double>& stone = drawn.specimen.stone;
    see(separation(stone, drawn.pose, drawn.plane).gap, "separation");
    see(surface_gap(stone, drawn.pose, drawn.plane), "surface_gap of a plane");
    if (i % 2 == 0) {
      see(surface_separation(stone, drawn.pose, drawn.plane.offset).gap, "surface_separation");
    }
    if (i % 4 == 0) {
      see(surface_gap(stone, drawn.pose), "surface_gap");
    }
  }
  return worst.measurement();
}

// --- the board

long double along(const Standing& stone, const Board<double>& board, const Vec3<double>& n_W) {
  const Triple<long double> n = triple(Long3(n_W.cast<long double>().normalized()));
  return nearest_along(stone, n) - static_cast<long double>(board.half_width) * std::fabs(n[0]) -
         static_cast<long double>(board.half_length) * std::fabs(n[1]);
}

Measurement measure_board_gap(Context& context) {
  Checks checks;
  std::array<int, 6> features{};
  int short_of = 0;
  Specimen specimen;
  Hull<long double> hull;
  const int count = context.samples(3000, 60000);
  for (int i = 0; i < count; ++i) {
    if (i % 8 == 0) {
      specimen = draw_stone(context, i / 8);
      hull = narrow(hull_of(specimen));
    }
    const Board<double> board = draw_board(context, i / 48);
    const Pose<double> pose = draw_board_pose(context, specimen.stone, board, i);
    const Separation<double> computed = separation(specimen.stone, pose, board);
    const Standing stone = standing(hull, pose);
    const double width = outer_width(specimen.stone);
    const double gap = context.produced(computed.gap);
    const auto see = [&](double error, const char* name) {
      checks[name].see(error, width, [&] {
        return fmt::format("{}: {}, board {:a} × {:a}, gap {:.6g}", board_strata[static_cast<std::size_t>(i % 8)],
                           describe(specimen, pose), board.half_width, board.half_length, gap);
      });
    };
    see(std::fabs(static_cast<double>(along(stone, board, computed.n_W) - static_cast<long double>(gap))), "gap");
    const Best best = search_board(stone, static_cast<long double>(board.half_width),
                                   static_cast<long double>(board.half_length), 20);
    const double better = static_cast<double>(best.value - static_cast<long double>(gap));
    see(better, "better normal");
    short_of += !(-better <= 1e-9 * width);
    ++features[static_cast<std::size_t>(computed.other_feature)];
  }
  see_search(checks["search"], short_of, count);
  Measurement result = checks.measurement();
  for (const OtherFeature feature : {OtherFeature::surface, OtherFeature::side, OtherFeature::top_edge,
                                     OtherFeature::vertical_edge, OtherFeature::corner}) {
    result.figures.push_back(
        {std::string(to_string(feature)), fmt::format("{} poses", features[static_cast<std::size_t>(feature)])});
  }
  result.figures.push_back({"the search was not within 1e-9 of the width", fmt::format("{} of {}", short_of, count)});
  return result;
}

/// Points all over a stone, in B.
std::vector<Long3> points_of(const Hull<long double>& hull) {
  std::vector<Long3> points;
  for (int i = 0; i <= 24; ++i) {
    const auto [rho, z] = outline(hull, i / 24.0L);
    for (int k = 0; k < 12; ++k) {
      const long double azimuth = std::numbers::pi_v<long double> / 6 * k;
      points.emplace_back(rho * std::cos(azimuth), rho * std::sin(azimuth), z);
    }
  }
  return points;
}

Measurement measure_certificate(Context& context) {
  Checks checks;
  Specimen specimen;
  Hull<long double> hull;
  std::vector<Long3> points;
  for (int i = 0; i < context.samples(4000, 50000); ++i) {
    if (i % 8 == 0) {
      specimen = draw_stone(context, i / 8);
      hull = narrow(hull_of(specimen));
      points = points_of(hull);
    }
    const Board<double> board = draw_board(context, i / 48);
    Pose<double> pose = draw_board_pose(context, specimen.stone, board, i);
    const Separation<double> at = separation(specimen.stone, pose, board);
    const double width = outer_width(specimen.stone), gap = context.produced(at.gap);
    const auto see = [&](double error, const char* name) {
      checks[name].see(error, width, [&] {
        return fmt::format("{}: {}, board {:a} × {:a}, gap {:.6g}", board_strata[static_cast<std::size_t>(i % 8)],
                           describe(specimen, pose), board.half_width, board.half_length, gap);
      });
    };
    see(std::fabs(context.produced(at.n_W).norm() - 1.0) * width, "unit normal");
    see(at.status == (at.gap < 0.0 ? SeparationStatus::overlapping : SeparationStatus::separated) && at.certified
            ? 0.0
            : width,
        "faults");
    see((at.p_stone - at.p_other - gap * at.n_W).norm(), "between the points");
    // A thin stone's support point is found from its sphere's centre.
    see(std::fabs(outside_stone(hull, pose, context.produced(at.p_stone))) /
            (1.0 + specimen.stone.sphere_radius / width),
        "point on the stone");
    const double reach = std::fabs(at.n_W.x()) * board.half_width + std::fabs(at.n_W.y()) * board.half_length;
    const Quat<long double> q = pose.q_WB.cast<long double>().normalized();
    const Long3 n = at.n_W.cast<long double>(), n_B = q.conjugate() * n;
    const long double least = n.dot(Long3(pose.p_WB.cast<long double>())) - static_cast<long double>(reach + gap);
    for (const Long3& x_B : points) {
      see(-static_cast<double>(least + n_B.dot(x_B)), "beyond the plane");
    }
    pose.p_WB -= gap * at.n_W;
    if (at.gap < 0.0 || i % 8 == 5) {
      see(std::fabs(separation(specimen.stone, pose, board).gap), "push-out");
    }
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> contact_claims() {
  return {
      {.id = "CONTACT-1",
       .statement =
           "The gap between a stone and a plane is right: any shape, any attitude, at the switch of cap and rim.",
       .function = "separation (plane), surface_separation, surface_gap",
       .family = OracleFamily::other_formula,
       .oracle = "the farthest point of caps and torus in 50 digits",
       .checks = {{.unit = "of the greater of width and distance",
                   .bound = 1.25e-15,
                   .reason =
                       "the product n · p has three roundings of the distance, the difference two, the axis 2 ulp",
                   .resolution = epsilon / 4.0}},
       .measure = measure_plane_gap},
      {.id = "CONTACT-2",
       .statement =
           "The gap or depth of a stone at the board is the greatest separation over all normals: surface, sides, "
           "edges, corners, small boards, stones deep inside.",
       .function = "separation (board)",
       .family = OracleFamily::brute_force,
       .oracle = "a search over sampled normals, refined by golden section and simplex, its best valued in long double",
       .checks = {within("gap", 2.5e-14, "of the width",
                         "the board's sides add roundings of ten widths, thin stones those of their spheres; "
                         "measured 2026-11-30 with 23 seeds: up to 6.7e-15",
                         epsilon),
                  within("better normal", 2.5e-14, "of the width",
                         "the same, one-sided; measured 2026-11-30 with 23 seeds: up to 5.0e-15", epsilon),
                  none("search", "faults")},
       .measure = measure_board_gap},
      {.id = "CONTACT-3",
       .statement =
           "No point of the stone lies beyond the plane that is given; pushed out along the normal by the depth, "
           "it touches.",
       .function = "separation (board)",
       .family = OracleFamily::invariant,
       .oracle = "300 points of each stone, and the gap after the push-out",
       .checks =
           {within("unit normal", 1e-15, "relative",
                   "a root and a quotient; measured 2026-11-30 with 23 seeds: up to 4.4e-16", epsilon),
            {.name = "between the points",
             .unit = "of the width",
             .bound = 1.2e-14,
             .reason =
                 "points at ten widths from the middle are rounded; measured 2026-11-30 with 23 seeds: up to 2.5e-15",
             .resolution = epsilon},
            within("point on the stone", 4e-15, "of the width and the sphere's radius",
                   "the same; measured 2026-11-30 with 23 seeds: up to 9.6e-16", epsilon),
            within("beyond the plane", 1.5e-14, "of the width",
                   "the gap, as CONTACT-2; measured 2026-11-30 with 23 seeds: up to 3.2e-15", epsilon),
            within("push-out", 8e-14, "of the width",
                   "the position after it is rounded at ten widths from the middle; measured 2026-11-30 with 23 "
                   "seeds: up to 1.9e-14",
                   epsilon),
            none("faults", "faults")},
       .measure = measure_certificate},
  };
}

}  // namespace goishi::verify
