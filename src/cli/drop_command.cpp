#include "drop_command.hpp"

#include <goishi/drop/settings.hpp>

#include "command.hpp"
#include "drop_scene.hpp"

namespace goishi::cli {

namespace {

constexpr const char* about_drop =
    "A stone dropped on the board, to rest: every impact and every change of the contact,\n"
    "with time, pose, velocities and energy";

constexpr const char* drop_notes = R"(
Everything is in the world frame but the spin: the playing surface is z = 0, its middle the
origin. Tilt is the angle of the stone's symmetry axis from the vertical: 180 degrees when it
has turned over. The energy counts heights from the surface. What is printed with an event
is so after it. Computed in double; every number given but the tilt and its axis must be 0
or from 1e-20 to 1e20 in SI units.
JSON: SI units; an event has impulse, contact_point, normal, feature (of the stone), touched
and touched_feature where there are such, and velocity_before, spin_body_before where they
change; final has the state at the end, its status and what it cost. lower_order: a contact
at an edge, a side or two places was passed by micro-impacts.
CSV: times from the start to the end of the drop, both included; height is that of the
centre. In flight a row is exact, in contact it is interpolated along the steps.

Examples:
  goishi drop --size 33 --bevel 1mm --from 5cm --tilt 20 --spin 0,0,10
  goishi drop --size 33 --from 1m --restitution 0.6 --until 3-impacts --format json
  goishi drop --size 33 --bevel 1mm --from 3cm --tilt 30 --position 0.21,0 --velocity 0.2,0,0
  goishi drop --size 33 --from 5mm --spin 0,1,60 --friction-model slip-proportional --until 1s
  goishi drop --size 33 --standard nihon-kiin --from 5cm --velocity 0.5,0,0 --on floor-board
  goishi drop --width 22mm --height 9.2mm --mass 5g --from 2cm --gravity 1,0,-9.7 --on plane

With --series 501 --csv drop.csv there is a table to plot, too.

Exit status: 0 done, 1 the drop was given up (what it reached is printed), 2 bad usage or a
failed write, 3 the stone starts inside what it is dropped on (the depth is printed).)";

void add_scene(CLI::App& drop, DropOptions& options) {
  add_catalogue_stone(drop, options.stone, "--width and --height");
  add_value(drop, options.stone.width, "--width", "LENGTH", "Diameter of the lens");
  add_value(drop, options.stone.height, "--height", "LENGTH", "Thickness, at most the width");
  add_value(drop, options.stone.bevel, "--bevel", "LENGTH",
            "Height of the bevel; as published, it shrinks the stone [default: 0, sharp]");
  add_value(drop, options.stone.mass, "--mass", "MASS", "Mass of the stone, instead of a density");
  add_value(drop, options.stone.density, "--density", "DENSITY", "Density of the stone\n" + assumed_densities());
  add_value(drop, options.from, "--from", "LENGTH", "Height of the centre of mass above the surface");
  add_value(drop, options.position, "--position", "X,Y", "Where over the surface it starts [default: 0,0]");
  add_value(drop, options.tilt, "--tilt", "ANGLE", "How far the stone is turned from lying flat [default: 0]");
  add_value(drop, options.tilt_axis, "--tilt-axis", "X,Y,Z", "What it is turned about [default: 0,1,0]");
  add_value(drop, options.velocity, "--velocity", "X,Y,Z", "Velocity of the centre [default: 0,0,0]");
  add_value(drop, options.spin, "--spin", "X,Y,Z", "Angular velocity, in the body frame [default: 0,0,0]");
  add_value(drop, options.on, "--on", "WHAT",
            fmt::format("board: 19 lines, {:.6g} mm thick, off which a stone may fall to the floor;\n"
                        "floor-board: {:.6g} mm thick, on legs of {:.6g} mm; plane: z = 0 without end\n"
                        "[default: board]",
                        boards::thickness / 1e3, boards::floor_board_thickness / 1e3, boards::short_legs / 1e3));
}

void add_settings(CLI::App& drop, DropOptions& options) {
  const DropSettings<double> settings;
  const auto value = [](double number) { return fmt::format(" [default: {:.6g}]", number); };
  add_value(drop, options.restitution, "--restitution", "E", "From 0 to 1" + value(settings.restitution));
  add_value(drop, options.friction, "--friction", "MU", "At least 0, or inf" + value(settings.friction));
  add_value(drop, options.friction_model, "--friction-model", "MODEL",
            "Friction of a contact that lasts: dry, slip-proportional or coulomb-contensou,\n"
            "under which two a stone may creep on without end [default: dry]");
  add_value(drop, options.slip_coefficient, "--slip-coefficient", "C",
            "Of slip-proportional [default: 1/(2 √(w g)), 1.08 s/m for size 33]");
  add_value(drop, options.patch_radius, "--patch-radius", "LENGTH",
            "Of coulomb-contensou [default: w/220, 0.1 mm for size 33]");
  add_value(drop, options.rolling_resistance, "--rolling-resistance", "LENGTH",
            "Times the normal force, the torque against rolling\n[default: w/220, 0.1 mm for size 33]");
  add_value(drop, options.pivot_radius, "--pivot-radius", "LENGTH",
            "Times the normal force, the torque against turning on the spot\n[default: w/440, 0.05 mm for size 33]");
  add_value(drop, options.gravity, "--gravity", "G",
            fmt::format("Downwards, or a vector x,y,z [default: {:.6g} m/s²]", -settings.gravity.z()));
  add_value(drop, options.law, "--law", "LAW",
            "Law of impacts: chatterjee-ruina, published or stronge\n[default: chatterjee-ruina]");
  add_value(drop, options.until, "--until", "WHEN",
            fmt::format("rest; a time, such as 500ms; or a count, such as 5-impacts; but for a\n"
                        "time, no longer than {} s [default: rest]",
                        longest_drop));
  add_value(drop, options.tolerance, "--tolerance", "T",
            "Of a step of the contact phase, relative to the stone" + value(settings.tolerance));
}

}  // namespace

void add_drop(CLI::App& app, DropOptions& options) {
  CLI::App& drop = *app.add_subcommand("drop", about_drop);
  add_scene(drop, options);
  add_settings(drop, options);
  add_value(drop, options.format, "--format", "FORMAT", "text: a line for each event; json: 17 digits [default: text]");
  add_value(
      drop, options.series, "--series", "N",
      fmt::format("Also write N rows of CSV, evenly in time, to the file of --csv;\nN from 2 to {}", most_drop_rows));
  add_value(drop, options.csv, "--csv", "FILE", "Where to, all or nothing");
  add_value(drop, options.at, "--at", "TIME", "Also print the state at this time");
  drop.footer(numbers_note({measure::length, measure::velocity, measure::acceleration, measure::spin, measure::angle,
                            measure::density, measure::mass, measure::time, measure::slip_coefficient}) +
              drop_notes);
}

}  // namespace goishi::cli
