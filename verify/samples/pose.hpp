#pragma once
/// \file
/// Stones at the board and in pairs, the hard places on purpose.

#include <array>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <string>

#include "verify/samples/contact.hpp"

namespace goishi::verify {

/// The real board; smaller than a stone; narrow; nine lines.
[[nodiscard]] Board<double> draw_board(Context& context, int i);

/// The attitude whose axis is u, spun at random.
[[nodiscard]] Quat<double> attitude_with_axis(Context& context, const Vec3<double>& u);

/// An axis at an angle with n such that n is at the switch of cap and rim, to 1e-17 of it.
[[nodiscard]] Vec3<double> axis_at_switch(Context& context, const Stone<double>& stone, const Vec3<double>& n);

/// An axis such that the stone meets n with its rim, turned about n.
[[nodiscard]] Vec3<double> axis_on_rim(Context& context, const Stone<double>& stone, const Vec3<double>& n,
                                       double turn);

/// One of eight attitudes that are exact: the identity, quarter turns, thirds.
[[nodiscard]] Quat<double> draw_exact_attitude(Context& context);

/// Exactly where queries are singular: axes along the board's, centres on its lines or as far from its sides as the stone
/// reaches, touching to the bit.
[[nodiscard]] Pose<double> draw_singular_pose(Context& context, const Stone<double>& stone, const Board<double>& board);

inline constexpr std::array board_strata = {"surface", "edge",     "corner", "deep",
                                            "beside",  "touching", "switch", "aligned"};

/// A pose of stratum i at the board.
[[nodiscard]] Pose<double> draw_board_pose(Context& context, const Stone<double>& stone, const Board<double>& board,
                                           int i);

inline constexpr std::array pair_strata = {"near",    "overlapping", "deep",   "concentric", "parallel", "touching",
                                           "aligned", "far",         "switch", "point",      "crossed"};
inline constexpr int pair_strata_count = static_cast<int>(pair_strata.size());

/// Two stones.
struct Pair {
  Specimen first, second;
  Pose<double> pose, other_pose;
};

[[nodiscard]] Separation<double> separation(const Pair& pair);

/// As far apart as the centres can be when the stones touch.
[[nodiscard]] double reach_of(const Pair& pair);

/// Puts the first stone where it touches the second along n.
void touch_along(Pair& pair, const Vec3<double>& n);

/// A pair of stratum i.
[[nodiscard]] Pair draw_pair(Context& context, int i);

[[nodiscard]] std::string describe(const Pair& pair);

/// < 0 inside the board, 0 on it.
[[nodiscard]] double outside_board(const Board<double>& board, const Vec3<double>& p);

[[nodiscard]] double outside_stone(const Hull<long double>& hull, const Pose<double>& pose, const Vec3<double>& p_W);

/// A search that is not as good finds nothing: one in a thousand may fall short.
void see_search(Worst& worst, int short_of, int count);

}  // namespace goishi::verify
