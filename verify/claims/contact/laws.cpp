/// CONTACT: moved and mirrored worlds, a million poses.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

/// A rigid motion of the world.
struct Motion {
  Quat<double> turn;
  Vec3<double> shift;
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& p) const { return turn * p + shift; }
  [[nodiscard]] Pose<double> operator()(const Pose<double>& pose) const {
    return {.p_WB = (*this)(pose.p_WB), .q_WB = (turn * pose.q_WB).normalized()};
  }
};

Motion draw_motion(Context& context, double reach) {
  return {.turn = draw_attitude(context.random()), .shift = reach * context.uniform(-1.0, 1.0) * draw_unit(context)};
}

/// The world seen in a mirror across x (0) or y (1): an attitude keeps its axis' mirror image.
Pose<double> mirrored(const Pose<double>& pose, int k) {
  Pose<double> result = pose;
  result.p_WB[k] = -result.p_WB[k];
  (k == 0 ? result.q_WB.y() : result.q_WB.x()) *= -1.0;
  result.q_WB.z() *= -1.0;
  return result;
}

/// Turned over, and spun about its own axis.
Pose<double> turned_over(Context& context, const Pose<double>& pose) {
  const double angle = context.uniform(-3.0, 3.0);
  const Quat<double> over(0.0, std::cos(angle), std::sin(angle), 0.0);
  return {.p_WB = pose.p_WB, .q_WB = (pose.q_WB * over).normalized()};
}

Measurement measure_motions(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(10000, 50000); ++i) {
    const Pair pair = draw_pair(context, i);
    const Specimen& one = pair.first;
    const double width = outer_width(one.stone);
    const Motion motion = draw_motion(context, width);
    const double distance = (pair.pose.p_WB - pair.other_pose.p_WB).norm();
    const auto see = [&](double error, double scale, const char* check, const char* what) {
      checks[check].see(error, scale, [&] {
        return fmt::format("{} ({}): {}", what, pair_strata[static_cast<std::size_t>(i % pair_strata_count)],
                           describe(pair));
      });
    };

    const Plane<double> plane{.n_W = draw_unit(context), .offset = width * context.uniform(-1.0, 1.0)};
    const Vec3<double> n = (motion.turn * plane.n_W).normalized();
    const Plane<double> moved{.n_W = n, .offset = plane.offset + n.dot(motion.shift)};
    const double reach = std::max(width, pair.pose.p_WB.norm()) + width;
    const double gap = context.produced(separation(one.stone, pair.pose, plane).gap);
    see(std::fabs(separation(one.stone, motion(pair.pose), moved).gap - gap), reach, "plane", "moved");
    see(std::fabs(separation(one.stone, turned_over(context, pair.pose), plane).gap - gap), reach, "plane",
        "turned over");

    const Separation<double> at = separation(pair);
    if (at.certified) {
      const Separation<double> other =
          separation(one.stone, motion(pair.pose), pair.second.stone, turned_over(context, motion(pair.other_pose)));
      // Thin stones: the roundings of their spheres, that of the axis about their centres.
      const double scale = 2.0 * reach_of(pair) + distance + pair.pose.p_WB.norm() + one.stone.sphere_radius +
                           pair.second.stone.sphere_radius;
      see(std::fabs(other.gap - context.produced(at.gap)), scale, "pair", "moved and turned over");
    }
  }
  for (int i = 0; i < context.samples(10000, 50000); ++i) {
    const Specimen specimen = draw_stone(context, i / 8);
    const Board<double> board = draw_board(context, i / 48);
    const Pose<double> pose = draw_board_pose(context, specimen.stone, board, i);
    const Separation<double> at = separation(specimen.stone, pose, board);
    const auto see = [&](const Pose<double>& other_pose, const Board<double>& other_board, const char* name) {
      const double gap = separation(specimen.stone, other_pose, other_board).gap;
      const double scale = outer_width(specimen.stone) + pose.p_WB.norm() + specimen.stone.sphere_radius;
      checks["board"].see(std::fabs(gap - context.produced(at.gap)), scale, [&] {
        return fmt::format("{} ({}): {}", name, board_strata[static_cast<std::size_t>(i % 8)],
                           describe(specimen, pose));
      });
    };
    see(mirrored(pose, 0), board, "left and right exchanged");
    see(mirrored(pose, 1), board, "top and bottom exchanged");
    see(turned_over(context, pose), board, "turned over");
    Board<double> quarter = board;
    std::swap(quarter.half_width, quarter.half_length);
    const Quat<double> turn(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));
    see({.p_WB = {-pose.p_WB.y(), pose.p_WB.x(), pose.p_WB.z()}, .q_WB = (turn * pose.q_WB).normalized()}, quarter,
        "by a right angle");
  }
  return checks.measurement();
}

// --- a million poses

/// What is wrong with a result, whatever the bodies; empty if nothing.
std::string defect(const Separation<double>& at) {
  const double all = at.gap + at.n_W.sum() + at.p_stone.sum() + at.p_other.sum();
  if (!std::isfinite(all)) {
    return "not a number";
  }
  if (!(std::fabs(at.n_W.norm() - 1.0) < 1e-14)) {
    return "no unit normal";
  }
  if (at.status != SeparationStatus::not_converged && (at.status == SeparationStatus::overlapping) != (at.gap < 0.0)) {
    return "status and gap disagree";
  }
  return "";
}

Measurement measure_million(Context& context) {
  Checks checks;
  int pairs = 0, not_converged = 0;
  Specimen specimen;
  Board<double> board;
  const auto see = [&](const Separation<double>& at, double scale, auto&& describe_case) {
    const std::string wrong = defect(at);
    checks["defects"].see(wrong.empty() ? 0.0 : 1.0, [&] { return wrong + ": " + describe_case(); });
    // One rule: the gap is what lies between the two points along the normal, < 0 where they overlap.
    if (wrong.empty()) {
      const double between = at.n_W.dot(at.p_stone - at.p_other);
      checks["gap"].see(std::fabs(between - context.produced(at.gap)), scale, describe_case);
    }
  };
  const int count = context.samples(30000, 1000000);
  for (int i = 0; i < count; ++i) {
    if (i % 64 == 0) {
      specimen = draw_stone(context, i / 64);
      board = draw_board(context, i / 384);
    }
    const Stone<double>& stone = specimen.stone;
    const double width = outer_width(stone), wide = board.half_width + width, long_ = board.half_length + width;
    Pose<double> pose{
        .p_WB = {context.uniform(-wide, wide), context.uniform(-long_, long_), width * context.uniform(-1.0, 1.0)},
        .q_WB = draw_attitude(context.random())};
    if (i % 2 == 0) {  // at a side
      pose.p_WB[i / 2 % 2] = std::copysign(i % 4 == 0 ? board.half_width : board.half_length, pose.p_WB[i / 2 % 2]) +
                             width * context.uniform(-1.0, 1.0);
    }
    const double scale = wide + long_ + stone.sphere_radius;
    const auto describe_case = [&] {
      return fmt::format("{}, board {:a} × {:a}", describe(specimen, pose), board.half_width, board.half_length);
    };
    const Separation<double> at = separation(stone, pose, board);
    see(at, scale, describe_case);
    const bool certified = at.certified && at.status != SeparationStatus::not_converged;
    checks["defects"].see(certified ? 0.0 : 1.0, [&] { return "not certified: " + describe_case(); });
    if (i % 8 == 0) {
      see(separation(stone, pose, Plane<double>{}), scale, describe_case);
      const Pair pair = draw_pair(context, i / 8);
      const Separation<double> of_pair = separation(pair);
      see(of_pair,
          2.0 * reach_of(pair) + (pair.pose.p_WB - pair.other_pose.p_WB).norm() + pair.first.stone.sphere_radius +
              pair.second.stone.sphere_radius,
          [&] { return describe(pair); });
      ++pairs;
      not_converged += of_pair.status == SeparationStatus::not_converged;
    }
  }
  checks["defects"].see(not_converged * 1000 > pairs ? 1.0 : 0.0,
                        [&] { return fmt::format("{} of {} pairs not converged", not_converged, pairs); });
  return checks.measurement(
      {{"pairs of stones that are said not to have converged", fmt::format("{} of {}", not_converged, pairs)}});
}

}  // namespace

std::vector<Claim> contact_law_claims() {
  return {
      {.id = "CONTACT-8",
       .statement =
           "A moved world has the same gaps; so has a board in a mirror or turned by a right angle, and a stone "
           "that is turned over.",
       .function = "separation (plane, board, stones)",
       .family = OracleFamily::relation,
       .oracle = "the same bodies, moved",
       .checks = {within("plane", 4e-15, "of the width or the distance",
                         "two gaps of 1e-15, and the motion itself: positions, normals and attitudes are rounded; "
                         "measured 2026-11-30 with 13 seeds: up to 1.2e-15",
                         epsilon),
                  within("board", 2e-15, "of width, distance and the sphere's radius together",
                         "the same, its axes exchanged; measured 2026-11-30 with 13 seeds: up to 3.7e-16", epsilon),
                  within("pair", 4e-15, "of width, distance and the sphere's radius together",
                         "the same; measured 2026-11-30 with 13 seeds: up to 5.6e-16", epsilon)},
       .measure = measure_motions},
      {.id = "CONTACT-9",
       .statement = "A million poses: no NaN, no exception; status, gap, normal and points agree; at the board all are "
                    "certified, of two "
                    "stones fewer than one in a thousand is said not to have converged.",
       .function = "separation (plane, board, stones)",
       .family = OracleFamily::invariant,
       .oracle = "one rule: the gap lies between the two points, along the normal",
       .checks = {within("gap", 5e-15, "of width, distance and the sphere's radius together",
                         "the points are rounded; measured 2026-11-30 with 13 seeds: up to 1.1e-15", epsilon),
                  none("defects", "faults")},
       .measure = measure_million},
  };
}

}  // namespace goishi::verify
