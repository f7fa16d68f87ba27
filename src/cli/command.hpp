#pragma once
/// \file
/// What the command lines of all commands share.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <goishi/shape/catalogue.hpp>
#include <string>
#include <vector>

#include "quantity.hpp"

namespace goishi::cli {

/// How the numbers of a command, which measure these things, are typed.
inline std::string numbers_note(const std::vector<Measure>& measures) {
  std::string text =
      "A number is decimal, with a point: 22, 022, -2.2, +.5, 5. or 1e-3; one that must be whole may\n"
      "be typed 5, 5.0 or 50e-1. Blanks around it do not count. It may have a unit, 22mm or \"2.2 cm\",\n"
      "in a vector each its own, 216mm,10mm,0. Without one it is in the first of these (µ, ² and ³\n"
      "may be typed u, 2 or ^2, 3 or ^3):\n";
  std::size_t longest = 0;
  for (const Measure& measure : measures) {
    longest = std::max(longest, measure.plural.size());
  }
  for (const Measure& measure : measures) {
    text += fmt::format("  {:<{}}  {}\n", measure.plural, longest, names_of(measure));
  }
  return text;
}

inline std::string assumed_densities() {
  return fmt::format("[default, assumed: {} white, {} black, in kg/m³]", catalogue::assumed_white_density,
                     catalogue::assumed_black_density);
}

/// An option with a value, which is read as text.
template <class Text>
void add_value(CLI::App& command, Text& target, const char* name, const char* type, const std::string& help) {
  command.add_option(name, target, help)->type_name(type);
}

}  // namespace goishi::cli
