#pragma once
/// \file
/// Catalogue stones by what was typed.

#include <goishi/error.hpp>
#include <goishi/shape/catalogue.hpp>
#include <string>

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

}  // namespace goishi::cli
