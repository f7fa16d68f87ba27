#pragma once
/// \file
/// What the command lines of all commands share.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <goishi/board/board.hpp>
#include <goishi/shape/catalogue.hpp>
#include <optional>
#include <string>
#include <vector>

#include "quantity.hpp"
#include "subject.hpp"

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

/// --standard, with what each has.
inline void add_standard(CLI::App& command, std::optional<std::string>& target) {
  const auto mm = [](int micrometres) { return micrometres / 1e3; };
  std::string help = "Dimensions of catalogue stones and boards, in mm (diameters; between lines):";
  for (const Standard standard : standards) {
    const BoardDimensions<double> board = board_dimensions<double>(standard);
    help += fmt::format("\n{}: {:.6g} white, {:.6g} black; {:.6g} × {:.6g}", to_string(standard),
                        mm(catalogue_stone(33, StoneColor::white, standard).width),
                        mm(catalogue_stone(33, StoneColor::black, standard).width), 1e3 * board.spacing_x,
                        1e3 * board.spacing_y);
  }
  add_value(command, target, "--standard", "WHOSE", help + "\n[default: talk]");
}

/// The options that choose a stone of the catalogue; `otherwise` says what may be given in its place.
inline void add_catalogue_stone(CLI::App& command, StoneOptions& stone, const char* otherwise) {
  add_value(command, stone.size, "--size", "N",
            fmt::format("Number of a catalogue stone, such as 33 (or give {})", otherwise));
  add_value(command, stone.color, "--color", "COLOR", "white or black, with --size [default: white]");
  add_standard(command, stone.standard);
}

/// The options that choose any stone, but for its mass.
inline void add_shape(CLI::App& command, StoneOptions& stone) {
  add_catalogue_stone(command, stone, "--width and --height");
  add_value(command, stone.width, "--width", "LENGTH", "Diameter of the lens (see --measured)");
  add_value(command, stone.height, "--height", "LENGTH", "Thickness, at most the width");
  add_value(command, stone.bevel, "--bevel", "LENGTH", "Height of the bevel, below the height [default: 0, sharp]");
  command
      .add_flag("--measured", stone.measured,
                "The width is that of the finished stone; without this,\n"
                "as published, the bevel shrinks the stone")
      ->disable_flag_override();
}

/// What its mass follows from.
inline void add_mass(CLI::App& command, StoneOptions& stone) {
  add_value(command, stone.mass, "--mass", "MASS", "Mass of the stone, instead of a density");
  add_value(command, stone.density, "--density", "DENSITY",
            "Density of the stone; --width without one is taken as white\n" + assumed_densities());
}

}  // namespace goishi::cli
