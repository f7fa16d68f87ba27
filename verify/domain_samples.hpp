#pragma once
/// \file
/// What the claims that walk a domain to its ends share: numbers of any size, rounding modes, refusals.

#include <array>
#include <cfenv>
#include <cmath>
#include <goishi/error.hpp>
#include <limits>
#include <optional>
#include <random>

namespace goishi::verify {

inline constexpr std::array rounding_modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// What f gives under a rounding mode, the witness's stays as it is; nothing if it refuses its arguments.
template <class F>
[[nodiscard]] auto answer_of(int mode, F&& f) -> std::optional<decltype(f())> {
  struct Mode {
    explicit Mode(int mode) { std::fesetround(mode); }
    ~Mode() { std::fesetround(FE_TONEAREST); }
  } const held(mode);
  try {
    return f();
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

/// 10^x, x from −reach to reach.
template <class T>
[[nodiscard]] T any_size(std::mt19937_64& random, double reach) {
  return static_cast<T>(std::pow(10.0L, std::uniform_real_distribution<double>(-reach, reach)(random)));
}

/// By how much |q|² or |n|² may be off 1, and nearly is: in ε.
inline constexpr std::array unit_defects = {0, 60, -60};

/// Whether a type of this range holds an exact value as a normal number.
template <class T, class Exact>
[[nodiscard]] bool holds(const Exact& value) {
  return Exact(std::numeric_limits<T>::min()) <= value && value <= Exact(std::numeric_limits<T>::max());
}

}  // namespace goishi::verify
