#pragma once
/// \file
/// Inputs of the set: exact, the same with every library, and short to write.

#include <array>
#include <cstdint>
#include <random>

namespace goishi::verify::reference {

/// Whole numbers and short decimals at random. No function of the mathematics library, no distribution of the standard's:
/// their values are not everywhere the same.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  /// From low to high, both included.
  [[nodiscard]] int whole(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low + 1);
    return low + static_cast<int>(random_() % count);
  }
  /// A whole number of parts, from low to high.
  [[nodiscard]] double part(int low, int high, int parts) { return static_cast<double>(whole(low, high)) / parts; }

  /// A direction, an axis, a quaternion: whole components, not all 0.
  template <std::size_t count>
  [[nodiscard]] std::array<double, count> wholes(int most) {
    std::array<double, count> result{};
    bool nothing = true;
    while (nothing) {
      for (double& x : result) {
        x = whole(-most, most);
        nothing = nothing && !(x < 0.0) && !(0.0 < x);
      }
    }
    return result;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace goishi::verify::reference
