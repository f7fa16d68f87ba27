#pragma once
/// \file
/// Many random drops, each judged by what every drop has to keep.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verify/stress/judge.hpp"
#include "verify/stress/workers.hpp"

namespace goishi::verify::stress {

struct Tally : Cases {
  std::array<std::uint64_t, 8> by_status = {};  // of DropStatus
  std::uint64_t lower_order = 0;
  double energy_rise = 0.0;
  double depth = 0.0;  // [width]
};

/// A drop that computes for longer, its judgement included, is reported as a failure.
inline constexpr double long_drop = 0.5;  // [s]

/// The drop of an index, judged; what it throws is a fault.
[[nodiscard]] Verdict judge_index(std::uint64_t seed, std::uint64_t index);

/// Drops 0 … samples − 1. `progress` is told how many are done; `overdue` the index of a drop that does not end.
[[nodiscard]] Tally run_stress(const Order& order, const std::function<void(std::uint64_t)>& progress,
                               const std::function<void(std::uint64_t)>& overdue);

}  // namespace goishi::verify::stress
