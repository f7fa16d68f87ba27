#include "verify/stress/poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <thread>

#include "verify/oracles/contact/all_normals.hpp"

namespace goishi::verify::stress {

namespace {

constexpr std::uint64_t block = 64;  // poses of one stone
constexpr std::uint64_t poses_per_search = 1000;

Context context_of(std::uint64_t seed, std::uint64_t index) {
  return Context(Tier::full, seed + 0x9E3779B97F4A7C15ULL * (index + 1), "STRESS");
}

bool chance(Context& context, double share) {
  return context.uniform(0.0, 1.0) < share;
}

Specimen draw_shape(Context& context) {
  const double w = 0.022 * (chance(context, 0.5) ? 1.0 : std::pow(10.0, context.uniform(-2.0, 2.0)));
  const double thin = std::pow(10.0, -4.0 * context.uniform(0.0, 1.0));
  const double h = chance(context, 0.05) ? w : chance(context, 0.1) ? w * (1.0 - thin * thin) : w * thin;
  const double b = chance(context, 0.3)   ? 0.0
                   : chance(context, 0.5) ? h * context.uniform(0.001, 0.99)
                                          : h * std::pow(10.0, -10.0 * context.uniform(0.0, 1.0)) * 0.999;
  const ShapeSample<double> shape{w, h, b};
  return {shape, make_stone(w, h, b)};
}

Board<double> draw_board_for(Context& context, double reach) {
  const auto half = [&] { return reach * std::pow(10.0, context.uniform(-1.5, 1.0)); };
  return chance(context, 0.6)   ? make_board<double>()
         : chance(context, 0.5) ? make_board<double>({.lines = 1, .border_x = half(), .border_y = half()})
                                : make_board<double>({.lines = 1, .border_x = half(), .border_y = 20.0 * reach});
}

/// Where along an axis of the board: about its side, far more often inside than out.
double draw_along(Context& context, double half, double reach) {
  const double side = chance(context, 0.5) ? -1.0 : 1.0;
  switch (context.random()() % 4) {
    case 0:
      return half * context.uniform(-1.0, 1.0);
    case 1:
      return side * (half + reach * context.uniform(-1.2, 1.0));
    case 2:
      return side * (half - reach * context.uniform(0.95, 1.4));
    default:
      return side * (half - reach * context.uniform(-1.0, 4.0));
  }
}

Quat<double> draw_turn(Context& context) {
  if (!chance(context, 0.25)) {
    return draw_attitude(context.random());
  }
  // Nearly lying, or nearly on edge: thin stones meet what they meet with their rims.
  const double lean =
      (chance(context, 0.5) ? std::numbers::pi / 2.0 : 0.0) + draw_small(context, 9.0) * context.uniform(-1.0, 1.0);
  const Vec3<double> about = Vec3<double>(context.uniform(-1.0, 1.0), 1.0, 0.0).normalized();
  return Quat<double>(Eigen::AngleAxisd(lean, about)).normalized();
}

PoseVerdict verdict_of(const Separation<double>& at, double along_normal, double scale, double tolerance,
                       const AllNormals& all, const Best* search) {
  PoseVerdict verdict;
  verdict.certified = at.certified;
  verdict.overlapping = at.gap < 0.0;
  verdict.proved = all.answer != AllNormals::Answer::too_many;
  verdict.error = std::fabs(along_normal - at.gap) / scale;
  // Each condition is the one that must hold, negated: a NaN fails.
  if (!(verdict.error <= tolerance)) {
    verdict.fault = fmt::format("the gap {:.17g} is not that of its normal, {:.17g}", at.gap, along_normal);
  } else if (at.status != SeparationStatus::not_converged &&
             (at.status == SeparationStatus::overlapping) != (at.gap < 0.0)) {
    verdict.fault = "status and gap disagree";
  } else if (at.certified && all.answer == AllNormals::Answer::better) {
    verdict.fault =
        fmt::format("certified, but n = ({:.17g}, {:.17g}, {:.17g}) separates by {:.17g}, {:.3g} widths more", all.n[0],
                    all.n[1], all.n[2], all.value, (all.value - at.gap) / scale);
  } else if (at.certified && search != nullptr && !(static_cast<double>(search->value) - at.gap <= tolerance * scale)) {
    verdict.fault = fmt::format("certified, but a search finds {:.17g}", static_cast<double>(search->value));
  }
  return verdict;
}

}  // namespace

BoardPose draw_board_pose(std::uint64_t seed, std::uint64_t index) {
  Context of_block = context_of(seed, ~(index / block));
  BoardPose drawn{draw_shape(of_block), {}, {}};
  const Stone<double>& stone = drawn.specimen.stone;
  const double reach = outer_width(stone) / 2.0;
  drawn.board = draw_board_for(of_block, reach);
  Context context = context_of(seed, index);
  Pose<double>& pose = drawn.pose;
  const bool singular = index % 8 == 0;
  if (singular) {
    pose = draw_singular_pose(context, stone, drawn.board);
    if (chance(context, 0.5)) {  // but for one number
      const double moved = reach * context.uniform(-1.0, 1.0);
      pose.p_WB[static_cast<Eigen::Index>(context.random()() % 3)] += moved;
    }
    return drawn;
  }
  pose.q_WB = draw_turn(context);
  pose.p_WB = {draw_along(context, drawn.board.half_width, reach), draw_along(context, drawn.board.half_length, reach),
               0.0};
  // Into the board by a depth of any size, along the normal of the moment or straight down.
  pose.p_WB.z() = reach * context.uniform(-1.0, 1.0);
  const double deeper = reach * (chance(context, 0.5) ? draw_small(context, 12.0) : context.uniform(0.0, 2.0));
  const Separation<double> at = separation(stone, pose, drawn.board);
  if (chance(context, 0.5)) {
    pose.p_WB -= (at.gap + deeper) * at.n_W;
  } else if (!(at.gap < 0.0)) {
    pose.p_WB.z() -= at.gap + deeper;
  }
  return drawn;
}

Pair draw_pair_pose(std::uint64_t seed, std::uint64_t index) {
  Context context = context_of(seed, index);
  const std::uint64_t turn = context.random()();
  if (turn % 2 == 0) {
    return draw_pair(context, static_cast<int>(turn % 36000));
  }
  // As thin as those at the board, in each other along any normal by a depth of any size.
  Pair pair{draw_shape(context), draw_shape(context), {}, {}};
  const double share = outer_width(pair.first.stone) / outer_width(pair.second.stone);
  if (share < 0.05 || 20.0 < share) {
    pair.second = pair.first;
  }
  pair.other_pose = {.p_WB = Vec3<double>::Zero(), .q_WB = draw_turn(context)};
  pair.pose.q_WB = draw_turn(context);
  const Vec3<double> n = draw_unit(context);
  touch_along(pair, n);
  pair.pose.p_WB -= reach_of(pair) * (turn % 4 == 1 ? draw_small(context, 12.0) : context.uniform(0.0, 1.0)) * n;
  return pair;
}

PoseVerdict judge(const BoardPose& drawn, bool searched) {
  // The hull in 50 digits takes longer than the rest: of each stone once.
  thread_local ShapeSample<double> shape{0.0, 0.0, 0.0};
  thread_local Hull<long double> hull;
  const ShapeSample<double>& now = drawn.specimen.shape;
  if (now.width != shape.width || now.height != shape.height || now.bevel != shape.bevel) {
    shape = now;
    hull = narrow(hull_of(drawn.specimen));
  }
  const Standing stone = standing(hull, drawn.pose);
  const double width = outer_width(drawn.specimen.stone), X = drawn.board.half_width, Y = drawn.board.half_length;
  const double scale = std::max({width, X / 10.0, Y / 10.0});  // whose round-off a gap has
  const Separation<double> at = separation(drawn.specimen.stone, drawn.pose, drawn.board);
  const Triple<long double> n = triple(Vec3<long double>(at.n_W.cast<long double>().normalized()));
  const double along = static_cast<double>(nearest_along(stone, n) - static_cast<long double>(X) * std::fabs(n[0]) -
                                           static_cast<long double>(Y) * std::fabs(n[1]));
  const AllNormals all = ask_all_normals(stone, X, Y, at.gap + pose_tolerance * scale);
  if (searched || all.answer == AllNormals::Answer::too_many) {
    const Best best = search_board(stone, static_cast<long double>(X), static_cast<long double>(Y), 20);
    return verdict_of(at, along, scale, pose_tolerance, all, &best);
  }
  return verdict_of(at, along, scale, pose_tolerance, all, nullptr);
}

PoseVerdict judge(const Pair& drawn, bool searched) {
  const Standing one = standing(narrow(hull_of(drawn.first)), drawn.pose);
  const Standing two = standing(narrow(hull_of(drawn.second)), drawn.other_pose);
  const Separation<double> at = separation(drawn);
  const double scale = std::max(2.0 * reach_of(drawn), (drawn.pose.p_WB - drawn.other_pose.p_WB).norm());
  const Triple<long double> n = triple(Vec3<long double>(at.n_W.cast<long double>().normalized()));
  const double along = static_cast<double>(nearest_along(one, n) + nearest_along(two, {-n[0], -n[1], -n[2]}));
  const AllNormals all = ask_all_normals(one, two, at.gap + pair_tolerance * scale);
  if (searched || all.answer == AllNormals::Answer::too_many) {
    const Best best = search_pair(one, two, 20);
    return verdict_of(at, along, scale, pair_tolerance, all, &best);
  }
  return verdict_of(at, along, scale, pair_tolerance, all, nullptr);
}

PoseVerdict judge_pose(std::uint64_t seed, std::uint64_t index) {
  try {
    const bool searched = index % poses_per_search == 0;
    return index % poses_per_pair == poses_per_pair - 1 ? judge(draw_pair_pose(seed, index), searched)
                                                        : judge(draw_board_pose(seed, index), searched);
  } catch (const std::exception& error) {
    return {.fault = fmt::format("throws: {}", error.what())};
  }
}

std::string describe_pose(std::uint64_t seed, std::uint64_t index) {
  if (index % poses_per_pair == poses_per_pair - 1) {
    return describe(draw_pair_pose(seed, index));
  }
  const BoardPose drawn = draw_board_pose(seed, index);
  return fmt::format("{}, board {:a} × {:a}", describe(drawn.specimen, drawn.pose), drawn.board.half_width,
                     drawn.board.half_length);
}

PoseTally run_poses(const Order& order, const std::function<void(std::uint64_t)>& progress) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  PoseTally tally;
  std::mutex mutex;
  std::atomic<std::uint64_t> next{0};
  const auto work = [&] {
    while (order.seconds <= 0.0 || elapsed() < order.seconds) {
      const std::uint64_t first = next.fetch_add(block);
      if (order.samples <= first) {
        return;
      }
      const std::uint64_t last = std::min(order.samples, first + block);
      std::vector<PoseVerdict> verdicts;
      for (std::uint64_t index = first; index < last; ++index) {
        verdicts.push_back(judge_pose(order.seed, index));
      }
      const std::lock_guard lock(mutex);
      for (std::uint64_t index = first; index < last; ++index) {
        const PoseVerdict& verdict = verdicts[index - first];
        const bool pair = index % poses_per_pair == poses_per_pair - 1;
        ++tally.samples;
        tally.pairs += pair ? 1 : 0;
        tally.overlapping += verdict.overlapping ? 1 : 0;
        (pair ? tally.uncertified_pairs : tally.uncertified) += verdict.certified ? 0 : 1;
        ++(verdict.proved ? tally.proved : tally.searched);
        tally.error = std::max(tally.error, verdict.error);
        if (!verdict.fault.empty()) {
          tally.failures.push_back({index, verdict.fault});
        }
      }
      progress(tally.samples);
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < order.threads; ++i) {
      workers.emplace_back(work);
    }
  }
  std::sort(tally.failures.begin(), tally.failures.end(),
            [](const Failure& a, const Failure& b) { return a.index < b.index; });
  tally.seconds = elapsed();
  return tally;
}

}  // namespace goishi::verify::stress
