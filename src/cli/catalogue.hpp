#pragma once
/// \file
/// Catalogue stones by what was typed.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <goishi/error.hpp>
#include <goishi/shape/catalogue.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace goishi::cli {

/// InvalidArgument when the text is no colour; `rule` says which texts are.
[[nodiscard]] inline StoneColor parse_color(const std::string& text, const char* rule = "must be white or black") {
  for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
    if (text == to_string(color)) {
      return color;
    }
  }
  throw InvalidArgument("color", text, rule);
}

/// The talk's when none was typed.
[[nodiscard]] inline Standard parse_standard(const std::optional<std::string>& text) {
  const std::optional<Standard> standard = text ? standard_named(*text) : Standard::talk;
  if (!standard) {
    std::array<std::string_view, standards.size()> names;
    std::ranges::transform(standards, names.begin(), [](Standard one) { return to_string(one); });
    throw InvalidArgument("standard", *text, fmt::format("must be {}", fmt::join(names, " or ")));
  }
  return *standard;
}

/// ", nihon-kiin": behind what has other dimensions than the talk's.
[[nodiscard]] inline std::string named_unless_talk(Standard standard) {
  return standard == Standard::talk ? "" : fmt::format(", {}", to_string(standard));
}

}  // namespace goishi::cli
