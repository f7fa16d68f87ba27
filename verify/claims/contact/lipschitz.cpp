/// CONTACT: a gap changes by no more than the stone moves.

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

/// A pose, moved and turned by a step, and how far that takes any point of the stone at most.
struct Step {
  Pose<double> pose;
  double most;
};

/// A thin stone in the board at a corner, and a step over the line from where one side is within its reach.
template <class See>
void see_crossing(Context& context, See&& see) {
  const double height = 0.022 * draw_small(context, 3.0);
  const Specimen specimen{{0.022, height, 0.0}, make_stone(0.022, height)};
  const Board<double> board = make_board<double>();
  const double reach = 0.011, step = reach * draw_small(context, 12.0);
  Pose<double> pose{
      .p_WB = {board.half_width - reach + step * context.uniform(0.0, 1.0),
               board.half_length - reach * context.uniform(-1.0, 0.3), reach * context.uniform(-0.4, 0.2)},
      .q_WB = draw_attitude(context.random())};
  const Separation<double> from = separation(specimen.stone, pose, board);
  const std::string start = describe(specimen, pose);
  pose.p_WB.x() -= step;
  see(from, separation(specimen.stone, pose, board), step, 1.0, [&] { return "over the line: " + start; });
}

/// A step of 1e-12 … 1 of the reach, in any direction or along x or y; every third only moves, every third only turns.
Step draw_step(Context& context, const Pose<double>& pose, double reach, int i) {
  const double size = reach * draw_small(context, 12.0);
  Step step{pose, 0.0};
  if (i % 3 != 1) {
    Vec3<double> along = draw_unit(context);
    if (i % 4 == 0) {
      along = (context.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * Vec3<double>::Unit(i / 4 % 3);
    }
    step.pose.p_WB += size * along;
    step.most += (step.pose.p_WB - pose.p_WB).norm();
  }
  if (i % 3 != 0) {
    const double angle = size / reach;
    step.pose.q_WB = (Quat<double>(Eigen::AngleAxisd(angle, draw_unit(context))) * pose.q_WB).normalized();
    step.most += angle * reach;
  }
  return step;
}

Measurement measure_steps(Context& context) {
  Worst worst;
  int uncertified = 0;
  const int count = context.samples(20000, 400000);
  const auto see = [&](const Separation<double>& from, const Separation<double>& to, double most, double scale,
                       auto&& describe_case) {
    if (!from.certified || !to.certified) {
      ++uncertified;
      return;
    }
    worst.see(std::max(std::fabs(context.produced(to.gap) - from.gap) - most, 0.0) / scale, describe_case);
  };
  Specimen specimen;
  Board<double> board;
  for (int i = 0; i < count; ++i) {
    if (i % 64 == 0) {
      specimen = draw_stone(context, i / 64);
      board = draw_board(context, i / 384);
    }
    const Stone<double>& stone = specimen.stone;
    const double reach = outer_width(stone) / 2.0;
    Pose<double> pose = draw_board_pose(context, stone, board, i / 4);
    const Step step = draw_step(context, pose, reach, i / 5);
    const auto describe_case = [&] {
      return fmt::format("{}, to p = {}, board {:a} × {:a}", describe(specimen, pose), describe(step.pose.p_WB),
                         board.half_width, board.half_length);
    };
    see(separation(stone, pose, board), separation(stone, step.pose, board), step.most,
        2.0 * reach + pose.p_WB.norm() + step.pose.p_WB.norm(), describe_case);
    see_crossing(context, see);
    if (i % 4 == 0) {
      const Plane<double> plane{.n_W = i % 8 == 0 ? Vec3<double>(0.0, 0.0, 1.0) : draw_unit(context),
                                .offset = reach * context.uniform(-1.0, 1.0)};
      see(separation(stone, pose, plane), separation(stone, step.pose, plane), step.most,
          2.0 * reach + pose.p_WB.norm() + step.pose.p_WB.norm(), describe_case);
    }
    if (i % 4 == 1) {
      Pair pair = draw_pair(context, i / 4);
      const Separation<double> from = separation(pair);
      const Step moved = draw_step(context, pair.pose, outer_width(pair.first.stone) / 2.0, i / 4);
      const double distance = (pair.pose.p_WB - pair.other_pose.p_WB).norm();
      const Pose<double> start = pair.pose;
      pair.pose = moved.pose;
      see(from, separation(pair), moved.most, 2.0 * reach_of(pair) + distance + moved.most + start.p_WB.norm(),
          [&] { return describe(pair) + ", from p = " + describe(start.p_WB); });
    }
  }
  return worst.measurement({{"not certified, and left out", fmt::format("{} of {}", uncertified, count * 5 / 2)}});
}

}  // namespace

std::vector<Claim> contact_lipschitz_claims() {
  return {
      {.id = "CONTACT-10",
       .statement =
           "A gap, or a depth, changes by no more than the stone is moved, and turned times its reach, by steps "
           "from 1e-12 of the reach to all of it, also over the lines where other parts of the board count.",
       .function = "separation (plane, board, stones)",
       .family = OracleFamily::relation,
       .oracle = "the same bodies, one of them a step away",
       .checks = {within("", 1e-15, "of width and distances together",
                         "two gaps, each of some roundings of the widths and of where the stones are; measured "
                         "2026-11-30 with 23 seeds: up to 1.7e-16",
                         epsilon / 4.0)},
       .measure = measure_steps},
  };
}

}  // namespace goishi::verify
