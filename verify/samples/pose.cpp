#include "verify/samples/pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/samples/attitude.hpp"

namespace goishi::verify {

Board<double> draw_board(Context& context, int i) {
  switch (i % 6) {
    case 0:
      return make_board<double>(
          {.lines = 1, .border_x = context.uniform(0.001, 0.02), .border_y = context.uniform(0.001, 0.02)});
    case 1:
      return make_board<double>({.lines = 1, .border_x = context.uniform(0.002, 0.02), .border_y = 0.2});
    case 2:
      return make_board<double>({.lines = 9});
    default:
      return make_board<double>();
  }
}

Quat<double> attitude_with_axis(Context& context, const Vec3<double>& u) {
  const Quat<double> spin(Eigen::AngleAxisd(context.uniform(-3.1, 3.1), Vec3<double>::UnitZ()));
  return (turn_between(Vec3<double>::UnitZ(), u) * spin).normalized();
}

Vec3<double> axis_at_switch(Context& context, const Stone<double>& stone, const Vec3<double>& n) {
  const double joint = std::atan2(stone.joint_cosine, stone.joint_sine);
  const double angle = joint * (1.0 + context.uniform(-1.0, 1.0) * draw_small(context, 17.0));
  const Vec3<double> across = n.unitOrthogonal();
  const double turn = context.uniform(-3.1, 3.1);
  return std::cos(angle) * n + std::sin(angle) * (std::cos(turn) * across + std::sin(turn) * n.cross(across));
}

Vec3<double> axis_on_rim(Context& context, const Stone<double>& stone, const Vec3<double>& n, double turn) {
  const double axial = context.uniform(-1.0, 1.0) * stone.joint_sine;
  const Vec3<double> across = n.unitOrthogonal();
  return axial * n + std::sqrt(1.0 - axial * axial) * (std::cos(turn) * across + std::sin(turn) * n.cross(across));
}

Quat<double> draw_exact_attitude(Context& context) {
  const double root = std::sqrt(0.5);
  const std::array<Quat<double>, 8> exact = {Quat<double>(1.0, 0.0, 0.0, 0.0),   Quat<double>(0.0, 1.0, 0.0, 0.0),
                                             Quat<double>(root, root, 0.0, 0.0), Quat<double>(root, 0.0, root, 0.0),
                                             Quat<double>(0.5, 0.5, 0.5, 0.5),   Quat<double>(0.5, 0.5, -0.5, 0.5),
                                             Quat<double>(0.0, 0.0, 1.0, 0.0),   Quat<double>(0.8, 0.6, 0.0, 0.0)};
  return exact[context.random()() % exact.size()];
}

Pose<double> draw_singular_pose(Context& context, const Stone<double>& stone, const Board<double>& board) {
  const double reach = outer_width(stone) / 2.0, half = stone.height / 2.0;
  const auto one_of = [&](std::initializer_list<double> values) {
    return values.begin()[context.random()() % values.size()];
  };
  const auto along = [&](double side) {
    return one_of({-1.0, 1.0}) * one_of({0.0, side, side - reach, side + reach, side - 2.0 * reach, reach});
  };
  const double x = along(board.half_width), y = along(board.half_length);
  Pose<double> pose{.p_WB = {x, y, one_of({0.0, half, -half, reach, -reach, -3.0 * reach, half / 2.0})},
                    .q_WB = draw_exact_attitude(context)};
  if (context.random()() % 4 == 0) {  // touching to the bit
    const Separation<double> at = separation(stone, pose, board);
    pose.p_WB -= at.gap * at.n_W;
  }
  return pose;
}

Pose<double> draw_board_pose(Context& context, const Stone<double>& stone, const Board<double>& board, int i) {
  const double reach = outer_width(stone) / 2.0;
  const auto about = [&](double width) { return reach * width * context.uniform(-1.0, 1.0); };
  const auto sign = [&] { return context.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0; };
  const double X = sign() * board.half_width, Y = sign() * board.half_length;
  Pose<double> pose{.p_WB = Vec3<double>::Zero(), .q_WB = draw_attitude(context.random())};
  const auto near_edge = [&](double width) {
    const double along = context.uniform(-1.0, 1.0);
    pose.p_WB = context.uniform(0.0, 1.0) < 0.5 ? Vec3<double>(X + about(width), along * Y, about(width))
                                                : Vec3<double>(along * X, Y + about(width), about(width));
  };
  switch (i % 8) {
    case 0:
      pose.p_WB = {context.uniform(-1.0, 1.0) * X, context.uniform(-1.0, 1.0) * Y, about(1.5)};
      break;
    case 1:
      near_edge(1.2);
      break;
    case 2:
      pose.p_WB = {X + about(1.2), Y + about(1.2), about(1.2)};
      if (i % 16 < 8) {  // farther inside one side than the stone reaches, as deep as it may be pushed out there
        pose.p_WB.x() = X - std::copysign(reach * context.uniform(0.99, 1.4), X);
        pose.p_WB.z() = about(0.3);
      }
      break;
    case 3:
      pose.p_WB = {X * context.uniform(-1.0, 1.0), Y - about(3.0), -reach * context.uniform(0.0, 5.0)};
      break;
    case 4:
      pose.p_WB = {X + about(2.0), context.uniform(0.0, 1.0) < 0.5 ? Y + about(2.0) : context.uniform(-1.0, 1.0) * Y,
                   -reach * context.uniform(0.0, 20.0)};
      break;
    case 5: {
      if (i % 16 < 8) {
        near_edge(1.1);
      } else {
        pose.p_WB = {X + about(1.1), Y + about(1.1), about(1.1)};
      }
      const Separation<double> at = separation(stone, pose, board);
      pose.p_WB += (sign() * 2e-6 * reach - at.gap) * at.n_W;
      break;
    }
    case 6: {
      Vec3<double> n(std::fabs(context.uniform(-1.0, 1.0)), std::fabs(context.uniform(-1.0, 1.0)),
                     std::fabs(context.uniform(-1.0, 1.0)));
      n[i % 3] *= i % 16 < 8 ? 0.0 : 1.0;
      n = Vec3<double>(std::copysign(n.x(), X), std::copysign(n.y(), Y), n.z()).normalized();
      pose.q_WB = attitude_with_axis(context, axis_at_switch(context, stone, n));
      const Vec3<double> towards = pose.q_WB.conjugate() * n;
      pose.p_WB = Vec3<double>(X, Y, 0.0) + pose.q_WB * support(stone, Vec3<double>(towards.normalized())).p_B +
                  about(draw_small(context, 16.0)) * n;
      break;
    }
    default: {
      if (i / 8 % 2 == 0) {
        return draw_singular_pose(context, stone, board);
      }
      const std::array<Vec3<double>, 6> axes = {Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0), Vec3<double>(0, 0, 1),
                                                Vec3<double>(1, 1, 0), Vec3<double>(0, 1, 1), Vec3<double>(1, 1, 1)};
      pose.q_WB = attitude_with_axis(context, axes[context.random()() % 6].normalized());
      pose.p_WB = {X + (i % 32 < 16 ? 0.0 : about(1.0)), i % 64 < 32 ? 0.0 : Y, about(1.0)};
      break;
    }
  }
  return pose;
}

Separation<double> separation(const Pair& pair) {
  return separation(pair.first.stone, pair.pose, pair.second.stone, pair.other_pose);
}

double reach_of(const Pair& pair) {
  return (outer_width(pair.first.stone) + outer_width(pair.second.stone)) / 2.0;
}

void touch_along(Pair& pair, const Vec3<double>& n) {
  const auto point = [&](const Specimen& specimen, const Pose<double>& pose) {
    const Vec3<double> n_B = pose.q_WB.conjugate() * n;
    return Vec3<double>(pose.q_WB * support(specimen.stone, Vec3<double>(n_B.normalized())).p_B);
  };
  pair.pose.p_WB = pair.other_pose.p_WB + point(pair.second, pair.other_pose) + point(pair.first, pair.pose);
}

Pair draw_pair(Context& context, int i) {
  const int stratum = i % pair_strata_count, turn = i / pair_strata_count;
  Pair pair{draw_stone(context, turn), draw_stone(context, i % 3 == 0 ? turn : turn / 6), {}, {}};
  pair.other_pose = {.p_WB = 0.02 * draw_unit(context), .q_WB = draw_attitude(context.random())};
  pair.pose.q_WB = draw_attitude(context.random());
  const double reach = reach_of(pair);
  Vec3<double> away = draw_unit(context);
  const auto u = [](const Pose<double>& pose) { return Vec3<double>(pose.q_WB * Vec3<double>::UnitZ()); };
  const auto put = [&](double distance) { pair.pose.p_WB = pair.other_pose.p_WB + distance * away; };
  switch (stratum) {
    case 0:
      put(reach * context.uniform(0.5, 1.3));
      break;
    case 1: {  // by no more than the bevels, or a thousandth
      put(reach);
      const Separation<double> at = separation(pair);
      const double bevels = pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius;
      pair.pose.p_WB -= (at.gap + context.uniform(0.0, 1.0) * std::max(bevels, 1e-3 * reach)) * at.n_W;
      break;
    }
    case 2:
      put(reach * context.uniform(0.0, 0.5));
      break;
    case 3:
      pair.pose.p_WB = pair.other_pose.p_WB;
      pair.pose.q_WB = turn % 2 == 0 ? pair.other_pose.q_WB : pair.pose.q_WB;
      break;
    case 4:
      pair.pose.q_WB = attitude_with_axis(context, u(pair.other_pose));
      put(reach * context.uniform(0.0, 1.2));
      break;
    case 5: {  // to a millionth of the diameter, apart or overlapping
      put(reach);
      const Separation<double> at = separation(pair);
      pair.pose.p_WB += ((turn % 2 == 0 ? 2e-6 : -2e-6) * reach - at.gap) * at.n_W;
      break;
    }
    case 6: {              // coaxial, or side by side in one plane
      if (turn % 8 < 2) {  // exactly so
        pair.other_pose = {.p_WB = Vec3<double>::Zero(), .q_WB = draw_exact_attitude(context)};
        pair.pose = {.p_WB = Vec3<double>::Zero(), .q_WB = draw_exact_attitude(context)};
        const std::array<double, 5> apart = {0.0, 0.1, 0.5, 0.9, 1.0};
        pair.pose.p_WB[static_cast<Eigen::Index>(context.random()() % 3)] =
            reach * apart[context.random()() % apart.size()];
        break;
      }
      const bool coaxial = turn % 2 == 0;
      away = coaxial ? u(pair.other_pose) : Vec3<double>(u(pair.other_pose).unitOrthogonal());
      pair.pose.q_WB = attitude_with_axis(context, turn % 4 < 2 ? u(pair.other_pose) : away);
      put(reach * context.uniform(0.0, 1.2));
      break;
    }
    case 7:
      put(reach / draw_small(context, 6.0));
      break;
    case 8: {  // touching where cap and rim meet, of one stone or of both
      if (turn % 3 != 0) {
        pair.pose.q_WB = attitude_with_axis(context, axis_at_switch(context, pair.first.stone, away));
      }
      if (turn % 3 != 1) {
        pair.other_pose.q_WB = attitude_with_axis(context, axis_at_switch(context, pair.second.stone, away));
      }
      touch_along(pair, away);
      pair.pose.p_WB += reach * context.uniform(-1.0, 1.0) * draw_small(context, 16.0) * away;
      break;
    }
    case 9: {  // a bevelled ball, whose core is a point, with that at the other's core where cap and rim meet
      const double width = 0.022 * context.uniform(0.5, 1.0), bevel = width * context.uniform(0.01, 0.9);
      pair.second = {{width, width, bevel}, make_stone(width, width, bevel)};
      pair.pose.q_WB = attitude_with_axis(context, axis_at_switch(context, pair.first.stone, away));
      touch_along(pair, away);
      pair.pose.p_WB -= (pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius) * away;
      pair.pose.p_WB += reach * draw_small(context, 17.0) * draw_unit(context);
      if (turn % 2 == 0) {
        std::swap(pair.first, pair.second);
        std::swap(pair.pose, pair.other_pose);
      }
      break;
    }
    default: {  // rim in rim, nearly as deep as the normal there stays a maximum: of several, the one that is hard to find
      const double first_turn = context.uniform(-3.1, 3.1), between = context.uniform(-3.1, 3.1);
      pair.pose.q_WB = attitude_with_axis(context, axis_on_rim(context, pair.first.stone, away, first_turn));
      pair.other_pose.q_WB =
          attitude_with_axis(context, axis_on_rim(context, pair.second.stone, away, first_turn + between));
      touch_along(pair, away);
      const double bevels = pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius;
      const double deepest = std::min(pair.first.stone.bevel_major_radius, pair.second.stone.bevel_major_radius) *
                             std::pow(std::sin(between), 2);
      pair.pose.p_WB -= (bevels + context.uniform(0.5, 1.0) * deepest) * away;
      break;
    }
  }
  return pair;
}

std::string describe(const Pair& pair) {
  return describe(pair.first, pair.pose) + " and " + describe(pair.second, pair.other_pose);
}

double outside_board(const Board<double>& board, const Vec3<double>& p) {
  return std::max({std::fabs(p.x()) - board.half_width, std::fabs(p.y()) - board.half_length, p.z()});
}

double outside_stone(const Hull<long double>& hull, const Pose<double>& pose, const Vec3<double>& p_W) {
  const Quat<long double> q = pose.q_WB.cast<long double>().normalized();
  const Vec3<long double> p_B = q.conjugate() * Vec3<long double>((p_W - pose.p_WB).cast<long double>());
  return static_cast<double>(outside(hull, std::hypot(p_B.x(), p_B.y()), p_B.z()));
}

void see_search(Worst& worst, int short_of, int count) {
  worst.see(1000 * short_of <= count ? 0.0 : 1.0,
            [&] { return fmt::format("the search fell short {} times", short_of); });
}

}  // namespace goishi::verify
