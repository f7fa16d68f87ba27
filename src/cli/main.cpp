/// \file
/// The program `goishi`: its command line.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <goishi/shape/catalogue.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "file.hpp"
#include "inertia.hpp"
#include "quantity.hpp"
#include "report.hpp"
#include "table.hpp"
#include "version.hpp"

namespace goishi::cli {

namespace {

constexpr int bad_usage = 2;

constexpr const char* about =
    "Shape, mass and moments of inertia of Go stones.\n"
    "The program computes with 50 digits, so that every digit it prints is right.";

constexpr const char* about_table =
    "The inertia of each stone size: 14 numbers, white and black,\n"
    "sharp and with a bevel of 1 mm (as published: the bevel shrinks the stone)";

constexpr const char* about_inertia = "Everything about one stone, of the catalogue or any other";

constexpr const char* examples =
    "goishi COMMAND --help explains a command.\n\n"
    "Examples:\n"
    "  goishi table\n"
    "  goishi inertia --size 33 --bevel 1mm";

constexpr const char* table_examples = R"(
Examples:
  goishi table
  goishi table --color black --bevel 0.5mm --units cgs
  goishi table --density 2.7g/cm3 --output stones.csv
  goishi table --check src/goishi/mass/inertia_table.hpp

Exit status: 0 done, 1 --check found a difference, 2 bad usage or a failed write.)";

constexpr const char* inertia_examples = R"(
Examples:
  goishi inertia --size 33 --color black --bevel 1mm
  goishi inertia --width 22mm --height 9.2mm --bevel 1mm --measured --mass 5.2g
  goishi inertia --width 2.2cm --height 0.92cm --density 2.7g/cm3 --format json

Exit status: 0 done, 2 bad usage or a failed write.)";

std::string units_note() {
  return fmt::format(
      "A number may carry a unit: 22mm, \"2.2 cm\". Without one it is in the first of\n"
      "  lengths    {}\n  densities  {}\n  masses     {}\n",
      length_units, density_units, mass_units);
}

std::string assumed_densities() {
  return fmt::format("[default, assumed: {} white, {} black, in kg/m³]", catalogue::assumed_white_density,
                     catalogue::assumed_black_density);
}

/// An option with a value, which is read as text.
template <class Text>
void add_value(CLI::App& command, Text& target, const char* name, const char* type, const std::string& help) {
  command.add_option(name, target, help)->type_name(type);
}

void add_table(CLI::App& app, TableOptions& options) {
  CLI::App& table = *app.add_subcommand("table", about_table);
  add_value(table, options.color, "--color", "COLOR", "white, black or both [default: both]");
  add_value(table, options.bevel, "--bevel", "LENGTH",
            "Height of every stone's bevel [default: a row with 0 and a row with 1mm]");
  add_value(table, options.density, "--density", "DENSITY", "Density of every stone\n" + assumed_densities());
  add_value(table, options.units, "--units", "UNITS",
            "Units of the printed table: si (m, kg) or cgs (cm, g) [default: si]");
  add_value(table, options.format, "--format", "FORMAT",
            "text or markdown: 6 significant digits; csv or json: 17;\n"
            "cpp: the library's header inertia_table.hpp, SI units only\n"
            "[default: what the extension of FILE says, else text]");
  add_value(table, options.output, "--output", "FILE", "Write to FILE, all or nothing [default: standard output]");
  add_value(table, options.check, "--check", "FILE", "Compare FILE with the table, name the first row that differs");
  table.footer(units_note() + table_examples);
}

void add_inertia(CLI::App& app, InertiaOptions& options) {
  CLI::App& inertia = *app.add_subcommand("inertia", about_inertia);
  add_value(inertia, options.size, "--size", "N",
            "Number of a catalogue stone, such as 33 (or give --width and --height)");
  add_value(inertia, options.color, "--color", "COLOR", "white or black, with --size [default: white]");
  add_value(inertia, options.width, "--width", "LENGTH", "Diameter of the lens (see --measured)");
  add_value(inertia, options.height, "--height", "LENGTH", "Thickness, at most the width");
  add_value(inertia, options.bevel, "--bevel", "LENGTH", "Height of the bevel, below the height [default: 0, sharp]");
  inertia
      .add_flag("--measured", options.measured,
                "The width is that of the finished stone; without this,\n"
                "as published, the bevel shrinks the stone")
      ->disable_flag_override();
  add_value(inertia, options.mass, "--mass", "MASS", "Mass of the stone, instead of a density");
  add_value(inertia, options.density, "--density", "DENSITY",
            "Density of the stone; --width without one is taken as white\n" + assumed_densities());
  add_value(inertia, options.format, "--format", "FORMAT",
            "text: 6 significant digits, two unit systems; json: 17, SI units\n[default: text]");
  inertia.footer(units_note() + inertia_examples);
}

int run(int count, char** arguments) {
  TableOptions table;
  InertiaOptions inertia;
  CLI::App app(about, "goishi");
  app.set_version_flag("--version", version());
  app.require_subcommand(0, 1);
  app.footer(examples);
  add_table(app, table);
  add_inertia(app, inertia);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw;
    }
    std::ostringstream text;
    app.exit(error, text, text);
    write_standard_output(text.str());
    return 0;
  }
  if (app.got_subcommand("table")) {
    return run_table(table);
  }
  if (!app.got_subcommand("inertia")) {
    throw std::runtime_error("a command is needed: table or inertia");
  }
  run_inertia(inertia);
  return 0;
}

}  // namespace
}  // namespace goishi::cli

int main(int count, char** arguments) {
  // A file that reaches the size limit is then a failed write, which cleans up.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return goishi::cli::run(count, arguments);
  } catch (const std::exception& error) {
    goishi::cli::report(fmt::format("error: {}", error.what()));
    return goishi::cli::bad_usage;
  }
}
