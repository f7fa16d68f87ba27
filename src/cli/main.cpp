/// \file
/// The program `goishi`: its command line.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <goishi/error.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/steppers.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "contact.hpp"
#include "drop_command.hpp"
#include "file.hpp"
#include "inertia.hpp"
#include "mesh_command.hpp"
#include "report.hpp"
#include "scene/scene_command.hpp"
#include "spin.hpp"
#include "table.hpp"
#include "version.hpp"

namespace goishi::cli {

namespace {

constexpr int bad_usage = 2;

constexpr const char* about =
    "Shape, mass, moments of inertia, free rotation, contacts, drops and scenes of Go stones,\n"
    "and their surfaces and bodies as files for other programs.\n"
    "The program computes with 50 digits, so that every digit it prints is right; what no\n"
    "closed form gives, drops, times of impact and methods that take steps, in double.";

constexpr const char* about_table =
    "The inertia of each stone size: 24 numbers, white and black,\n"
    "sharp and with a bevel of 1 mm (as published: the bevel shrinks the stone)";

constexpr const char* about_inertia = "Everything about one stone, of the catalogue or any other";

constexpr const char* examples =
    "goishi COMMAND --help explains a command.\n\n"
    "Examples:\n"
    "  goishi table\n"
    "  goishi inertia --size 33 --bevel 1mm\n"
    "  goishi spin --size 33 --spin 0,5,60 --time 2.5\n"
    "  goishi contact --size 33 --position 0,0,0.01\n"
    "  goishi drop --size 33 --bevel 1mm --from 5cm --tilt 20\n"
    "  goishi scene board.json\n"
    "  goishi mesh --size 33 --bevel 1mm --output stone.glb\n"
    "  goishi body --size 33 --bevel 1mm --output stone.urdf";

constexpr const char* table_examples = R"(
Examples:
  goishi table
  goishi table --color black --bevel 0.5mm --units cgs
  goishi table --standard nihon-kiin --format markdown
  goishi table --density 2.7g/cm3 --output stones.csv
  goishi table --check src/goishi/mass/inertia_table.hpp

Exit status: 0 done, 1 --check found a difference, 2 bad usage or a failed write.)";

constexpr const char* inertia_examples = R"(
Examples:
  goishi inertia --size 33 --color black --bevel 1mm
  goishi inertia --width 22mm --height 9.2mm --bevel 1mm --measured --mass 5.2g
  goishi inertia --width 2.2cm --height 0.92cm --density 2.7g/cm3 --format json

Exit status: 0 done, 2 bad usage or a failed write.)";

constexpr const char* about_spin =
    "How a stone, or any body with a symmetry axis, turns when nothing touches it:\n"
    "attitude, spin, angular momentum and energy after a time";

constexpr const char* spin_examples = R"(
Examples:
  goishi spin --size 33 --bevel 1mm --spin 0,5,60 --time 2.5
  goishi spin --axial 0.02 --transverse 0.04 --spin 2,4,6 --time 10 --format json
  goishi spin --size 33 --spin 1,2,8 --time -1 --attitude 0.6,0,0.8,0
  goishi spin --size 33 --spin 1,2,8 --time 10 --series 101
  goishi spin --size 33 --spin 1,2,8 --time 10 --method published --step 10ms

Exit status: 0 done, 1 the method broke down with this step (the last good state is
printed), 2 bad usage or a failed write.)";

constexpr const char* about_contact =
    "Where a stone stands to the board, to a plane or to another stone: gap or depth,\n"
    "normal and contact points; and when a flying one touches";

constexpr const char* contact_examples = R"(
The gap is the distance, or, below 0, the depth: moving the stone by that depth along the
normal, which points to it, is the shortest way out. Everything is in the world frame:
the playing surface is z = 0, its middle the origin. The board has no bottom: below the
surface its sides go on for ever. Computed with 50 digits; a number below 1e-28 of the
lengths given is printed as 0. Only the time of impact is computed in double: for it, every
number given but an attitude must be 0 or from 1e-20 to 1e20 in SI units.
JSON: region is null but for the board; time_of_impact is null unless there is a hit.

Examples:
  goishi contact --size 33 --position 0,0,0.01
  goishi contact --size 33 --bevel 1mm --position 216.1mm,0,2mm --attitude 0.8,0,0.6,0
  goishi contact --size 33 --position 0,0,0.1 --velocity 0,0,0 --spin 3,0,40 --horizon 1
  goishi contact --width 2 --height 1 --position 0,0,3 --against plane --format json
  goishi contact --size 45 --standard nihon-kiin --lines 13 --position 0.14,0,0.01
  goishi contact --size 36 --position 0,0,0.005 --against stone --other-position 0.02,0,0.005

Exit status: 0 done, 1 a search did not converge (what it reached is printed), 2 bad usage
or a failed write.)";

void add_table(CLI::App& app, TableOptions& options) {
  CLI::App& table = *app.add_subcommand("table", about_table);
  add_value(table, options.color, "--color", "COLOR", "white, black or both [default: both]");
  add_standard(table, options.standard);
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
  table.footer(numbers_note({measure::length, measure::density}) + table_examples);
}

void add_inertia(CLI::App& app, InertiaOptions& options) {
  CLI::App& inertia = *app.add_subcommand("inertia", about_inertia);
  add_shape(inertia, options.stone);
  add_mass(inertia, options.stone);
  add_value(inertia, options.format, "--format", "FORMAT",
            "text: 6 significant digits, two unit systems; json: 17, SI units\n[default: text]");
  inertia.footer(numbers_note({measure::length, measure::density, measure::mass}) + inertia_examples);
}

std::string methods_note() {
  std::string text = "\nMethods:\n";
  for (const SchemeInfo& scheme : schemes) {
    text += fmt::format("  {:<18} {}\n", scheme.name, scheme.what);
  }
  return text +
         "'exact' takes any time, negative ones too; it computes with 50 digits, so that every\n"
         "digit it prints is right. (A component below 1e-28 of its vector is printed as 0;\n"
         "times that turn the body by more than 1e20 rad are refused.)\n"
         "The others compute in double, forwards, for comparison: in equal steps, as few as\n"
         "are needed for none to be longer than --step, and with --series from row to row;\n"
         "moments, spin and step must be 0 or from 1e-100 to 1e100 in SI units.\n"
         "The angular momentum is in the world frame; spin and moments are in the body frame,\n"
         "whose z is the symmetry axis.\n";
}

constexpr const char* attitude_note =
    "\nTyped with few digits it is made unit, with a note, if its length is within 1e-3 of 1";

void add_spin(CLI::App& app, SpinOptions& options) {
  CLI::App& spin = *app.add_subcommand("spin", about_spin);
  add_catalogue_stone(spin, options.stone, "--axial and --transverse");
  add_value(spin, options.stone.bevel, "--bevel", "LENGTH",
            "Height of the bevel, with --size; as published, it shrinks the stone\n[default: 0, sharp]");
  add_value(spin, options.stone.mass, "--mass", "MASS", "Mass of the stone, instead of a density");
  add_value(spin, options.stone.density, "--density", "DENSITY", "Density of the stone\n" + assumed_densities());
  add_value(spin, options.axial, "--axial", "I_A", "Moment about the symmetry axis, at most twice I_T");
  add_value(spin, options.transverse, "--transverse", "I_T", "Moment across the symmetry axis");
  add_value(spin, options.spin, "--spin", "X,Y,Z", "Angular velocity at time 0, in the body frame");
  add_value(spin, options.attitude, "--attitude", "W,X,Y,Z",
            std::string("Attitude at time 0, a unit quaternion from the body to the world [default: 1,0,0,0]") +
                attitude_note);
  add_value(spin, options.time, "--time", "TIME", "How long it turns");
  add_value(spin, options.method, "--method", "METHOD", "How to compute, see below [default: exact]");
  add_value(spin, options.step, "--step", "TIME", "Longest step; needed by every method but exact");
  add_value(spin, options.format, "--format", "FORMAT", "text: 6 significant digits; json: 17 [default: text]");
  add_value(
      spin, options.series, "--series", "N",
      fmt::format("Print N rows of CSV instead, 17 digits, evenly from time 0 to TIME,\nboth included; N from 2 to {}",
                  most_rows));
  spin.footer(
      numbers_note({measure::length, measure::density, measure::mass, measure::moment, measure::spin, measure::time}) +
      methods_note() + spin_examples);
}

void add_contact(CLI::App& app, ContactOptions& options) {
  CLI::App& contact = *app.add_subcommand("contact", about_contact);
  add_catalogue_stone(contact, options.stone, "--width and --height");
  add_value(contact, options.stone.width, "--width", "LENGTH", "Diameter of the lens");
  add_value(contact, options.stone.height, "--height", "LENGTH", "Thickness, at most the width");
  add_value(contact, options.stone.bevel, "--bevel", "LENGTH",
            "Height of the bevel; as published, it shrinks the stone [default: 0, sharp]");
  add_value(contact, options.position, "--position", "X,Y,Z", "The stone's centre");
  add_value(contact, options.attitude, "--attitude", "W,X,Y,Z",
            std::string("A unit quaternion from the body to the world [default: 1,0,0,0, lying flat]") + attitude_note);
  add_value(contact, options.against, "--against", "WHAT",
            "board; plane: z = 0 without end; stone: another of the same size\n[default: board]");
  add_value(contact, options.other_position, "--other-position", "X,Y,Z", "The other stone's centre");
  add_value(contact, options.other_attitude, "--other-attitude", "W,X,Y,Z",
            "The other stone's attitude [default: 1,0,0,0]");
  add_value(contact, options.lines, "--lines", "N",
            "Lines of the board; with 13, that of nihon-kiin has borders of its own [default: 19]");
  add_value(contact, options.velocity, "--velocity", "X,Y,Z",
            "Velocity of the centre; the other stone stays where it is [default: 0,0,0]");
  add_value(contact, options.spin, "--spin", "X,Y,Z", "Angular velocity, in the body frame [default: 0,0,0]");
  add_value(contact, options.gravity, "--gravity", "G",
            fmt::format("Downwards [default: {} m/s²]", standard_gravity<double>()));
  add_value(contact, options.horizon, "--horizon", "TIME",
            "How far ahead to look for an impact; needs --velocity or --spin");
  add_value(contact, options.format, "--format", "FORMAT", "text: 6 significant digits; json: 17 [default: text]");
  contact.footer(
      numbers_note({measure::length, measure::velocity, measure::acceleration, measure::spin, measure::time}) +
      contact_examples);
}

/// The words of the command line, last first, as CLI11 takes them, which loses the empty value of "--option=".
std::vector<std::string> words_of(int count, char** arguments) {
  std::vector<std::string> words;
  for (int i = count - 1; 0 < i; --i) {
    std::string word = arguments[i];
    if (word.starts_with("--") && word.find('=') == word.size() - 1) {
      word.pop_back();
      words.emplace_back();
    }
    words.push_back(word);
  }
  return words;
}

/// What was typed for an option; nothing if it was not given.
std::optional<std::string> typed_for(const CLI::Option* option) {
  return option == nullptr || option->results().empty() ? std::nullopt : std::optional(option->results().front());
}

/// An error in the words of the user, who knows arguments as options (the outer width as --width) and their values as
/// they were typed; the library knows both in its own way, and with fewer digits.
InvalidArgument as_typed(const CLI::App& command, const InvalidArgument& error) {
  const auto renamed = [](std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
    return text;
  };
  const std::string argument = renamed(renamed(error.argument(), "outer_width", "width"), "_", "-");
  std::string rule = renamed(error.rule(), "outer_width", "width");
  for (const CLI::Option* option : command.get_options()) {
    const auto typed = typed_for(option);
    const std::string name = option->get_single_name();
    // "must not exceed the width (0.022)", "no principal moment above … (transverse 1)"
    for (const std::string& before : {"exceed the " + name + " (", "below the " + name + " (", "(" + name + " "}) {
      if (const std::size_t at = rule.find(before); typed && at != std::string::npos) {
        const std::size_t value = at + before.size();
        rule.replace(value, rule.find(')', value) - value, *typed);
      }
    }
  }
  return {argument, typed_for(command.get_option_no_throw("--" + argument)).value_or(error.value()), rule};
}

int run(int count, char** arguments) {
  TableOptions table;
  InertiaOptions inertia;
  SpinOptions spin;
  ContactOptions contact;
  DropOptions drop;
  SceneOptions scene;
  MeshOptions mesh;
  BodyOptions body;
  CLI::App app(about, "goishi");
  app.set_version_flag("--version", version());
  app.require_subcommand(0, 1);
  app.footer(examples);
  add_table(app, table);
  add_inertia(app, inertia);
  add_spin(app, spin);
  add_contact(app, contact);
  add_drop(app, drop);
  add_scene(app, scene);
  add_mesh(app, mesh);
  add_body(app, body);
  try {
    app.parse(words_of(count, arguments));
  } catch (const CLI::ExtrasError&) {
    throw std::runtime_error(fmt::format("not expected: {}", fmt::join(app.remaining(true), " ")));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw;
    }
    std::ostringstream text;
    app.exit(error, text, text);
    write_standard_output(text.str());
    return 0;
  }
  if (app.get_subcommands().empty()) {
    throw std::runtime_error("a command is needed: table, inertia, spin, contact, drop, scene, mesh or body");
  }
  const CLI::App& command = *app.get_subcommands().front();
  try {
    if (command.get_name() == "table") {
      return run_table(table);
    }
    if (command.get_name() == "inertia") {
      return run_inertia(inertia);
    }
    if (command.get_name() == "spin") {
      return run_spin(spin);
    }
    if (command.get_name() == "contact") {
      return run_contact(contact);
    }
    if (command.get_name() == "drop") {
      return run_drop(drop);
    }
    if (command.get_name() == "scene") {
      return run_scene(scene);
    }
    return command.get_name() == "mesh" ? run_mesh(mesh) : run_body(body);
  } catch (const InvalidArgument& error) {
    throw as_typed(command, error);
  }
}

}  // namespace
}  // namespace goishi::cli

int main(int count, char** arguments) {
  // A file that reaches the size limit is then a failed write, which cleans up.
  std::signal(SIGXFSZ, SIG_IGN);
  // Who reads no further than `| head -1` wants no message.
  std::signal(SIGPIPE, SIG_DFL);
  try {
    return goishi::cli::run(count, arguments);
  } catch (const std::exception& error) {
    goishi::cli::report(fmt::format("error: {}", error.what()));
    return goishi::cli::bad_usage;
  }
}
