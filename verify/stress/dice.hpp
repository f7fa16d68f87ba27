#pragma once
/// \file
/// The random numbers of a case: the same for a seed and an index, whatever else runs.

#include <cmath>
#include <cstdint>
#include <goishi/rotation.hpp>
#include <random>

namespace goishi::verify::stress {

class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t index) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                           static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32U)};
    random_.seed(sequence);
  }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  double normal() { return std::normal_distribution<double>()(random_); }
  Vec3<double> normal3() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }
  /// One of 0 … sides − 1.
  int of(int sides) { return std::uniform_int_distribution<int>(0, sides - 1)(random_); }

 private:
  std::mt19937_64 random_;
};

}  // namespace goishi::verify::stress
