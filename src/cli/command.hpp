#pragma once
/// \file
/// What the command lines of all commands share.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <goishi/shape/catalogue.hpp>
#include <string>

#include "quantity.hpp"

namespace goishi::cli {

inline std::string units_note() {
  return fmt::format(
      "A number may carry a unit: 22mm, \"2.2 cm\". Without one it is in the first of\n"
      "  lengths    {}\n  densities  {}\n  masses     {}\n  times      {}\n",
      length_units, density_units, mass_units, time_units);
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
