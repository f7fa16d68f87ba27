#include "scene/scene_command.hpp"

#include "command.hpp"
#include "scene/play.hpp"

namespace goishi::cli {

namespace {

constexpr const char* about_scene =
    "A board with many stones, from a file: what is dropped, thrown, pushed, held and\n"
    "removed, impacts, clusters, and how all come to rest";

constexpr const char* scene_notes = R"(
The file is JSON in SI units, by the schema that --schema prints, which says what each member
is; src/cli/scene/examples has six. The shortest that moves:

  {
    "stone": {"size": 33, "bevel": 0.001},
    "groups": [{"points": "19x19", "from": 0.02, "random": {"seed": 1, "tilt_deg": 10}}]
  }

Stones have numbers, from 0 on, in the order in which they are added. World frame: the playing
surface is z = 0, its middle the origin. Computed in double; one file gives one result.
text: the setting, the actions, how it ends, what touches, the energy and its loss.
json: SI units, 17 digits; events of each stone as goishi drop has them, with other, the stone
that did it; final has time, energy, each stone's state and mode (flight, contact, cluster,
rest, held), what touches and how it pushes (null where it is not known), what was computed.
csv: a row for each stone and time, from the start to the end, both included.

Examples:
  goishi scene board.json
  goishi scene board.json --format json
  goishi scene board.json --series 101 --csv board.csv
  goishi scene --schema

Exit status: 0 done, 1 the stones did not come to rest in the time that the file gives (what
they reached is printed), 2 bad usage, a file that breaks a rule (with the place in it), or a
failed write.)";

}  // namespace

void add_scene(CLI::App& app, SceneOptions& options) {
  CLI::App& scene = *app.add_subcommand("scene", about_scene);
  add_value(scene, options.file, "FILE", "", "The scene");
  add_value(scene, options.format, "--format", "FORMAT",
            "text: a summary; json: every event, 17 digits [default: text]");
  add_value(scene, options.series, "--series", "N",
            fmt::format("Also write CSV, N times evenly, to the file of --csv; N from 2, and no more than\n{} rows",
                        most_scene_rows));
  add_value(scene, options.csv, "--csv", "FILE", "Where to, all or nothing");
  scene.add_flag("--schema", options.schema, "Print the schema of such files, and nothing else")
      ->disable_flag_override();
  scene.footer(scene_notes);
}

}  // namespace goishi::cli
