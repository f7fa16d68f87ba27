#pragma once
/// \file
/// Whose dimensions the stones and the board have. They are decimal data, held as whole micrometres, so that every
/// scalar gets them exactly: T(22000) / T(1000000).

#include <array>
#include <goishi/scalar.hpp>
#include <optional>
#include <string_view>

namespace goishi {

/// By the talk, the default: what its program used. By the Nihon Ki-in: what the association's pages on stones and
/// boards give.
enum class Standard { talk, nihon_kiin };

inline constexpr std::array<Standard, 2> standards = {Standard::talk, Standard::nihon_kiin};

[[nodiscard]] constexpr std::string_view to_string(Standard standard) {
  return standard == Standard::talk ? "talk" : "nihon-kiin";
}

[[nodiscard]] constexpr std::optional<Standard> standard_named(std::string_view name) {
  for (const Standard standard : standards) {
    if (name == to_string(standard)) {
      return standard;
    }
  }
  return std::nullopt;
}

/// A length of whole micrometres in metres, rounded once (exact in exact arithmetic).
template <Field T>
[[nodiscard]] constexpr T metres(int micrometres) {
  return T(T(micrometres) / T(1000000));
}

}  // namespace goishi
