#pragma once
/// \file
/// Many random poses of a stone in the board, and of two stones in each other, each judged by a proof over all normals.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verify/samples/pose.hpp"
#include "verify/stress/stress.hpp"

namespace goishi::verify::stress {

/// One pose in so many is one of two stones.
inline constexpr std::uint64_t poses_per_pair = 64;

/// A gap that is off by more than this is wrong   [width].
inline constexpr double pose_tolerance = 1e-13;
inline constexpr double pair_tolerance = 1e-12;

struct BoardPose {
  Specimen specimen;
  Board<double> board;
  Pose<double> pose;
};

/// The pose of an index: h/w from 1e-4 to 1; at sides, edges and corners, by depths of all magnitudes; in one of eight,
/// exactly singular, or but for one number.
[[nodiscard]] BoardPose draw_board_pose(std::uint64_t seed, std::uint64_t index);
[[nodiscard]] Pair draw_pair_pose(std::uint64_t seed, std::uint64_t index);

struct PoseVerdict {
  std::string fault;  // empty: sound
  bool certified = false;
  bool overlapping = false;
  bool proved = false;  // over all normals; else by a dense search
  double error = 0.0;   // of the gap from that of its own normal [width]
};

/// `searched`: by a dense search of the normals too.
[[nodiscard]] PoseVerdict judge(const BoardPose& drawn, bool searched);
[[nodiscard]] PoseVerdict judge(const Pair& drawn, bool searched);

struct PoseTally {
  std::uint64_t samples = 0, pairs = 0, overlapping = 0, uncertified = 0, uncertified_pairs = 0;
  std::uint64_t proved = 0, searched = 0;
  double error = 0.0;  // [width]
  double seconds = 0.0;
  std::vector<Failure> failures;
};

[[nodiscard]] PoseVerdict judge_pose(std::uint64_t seed, std::uint64_t index);
[[nodiscard]] std::string describe_pose(std::uint64_t seed, std::uint64_t index);

/// Poses 0 … samples − 1. `progress` is told how many are done.
[[nodiscard]] PoseTally run_poses(const Order& order, const std::function<void(std::uint64_t)>& progress);

}  // namespace goishi::verify::stress
