#pragma once
/// \file
/// The library side by side with the engines that others use: single problems with an exact answer, and a whole board.

#include <vector>

#include "verify/bench/race.hpp"
#include "verify/bench/rivals/engine.hpp"

namespace goishi::verify::bench::rivals {

/// Free spin, elastic bounces, rocking, one impact, a drop to rest.
[[nodiscard]] std::vector<Problem> single_problems();

/// The full board: its first second, and until it rests.
[[nodiscard]] std::vector<Problem> board_problems();

/// Steps of whole fractions of a frame of 1/60 s, from coarse to fine.
[[nodiscard]] inline std::vector<double> steps_of(std::initializer_list<double> per_second) {
  std::vector<double> steps;
  for (const double count : per_second) {
    steps.push_back(1 / count);
  }
  return steps;
}

[[nodiscard]] Subject subject();

}  // namespace goishi::verify::bench::rivals
