#include "mesh_command.hpp"

#include "command.hpp"

namespace goishi::cli {

namespace {

constexpr const char* about_mesh = "A stone's surface as triangles, in a file that other programs read";

constexpr const char* mesh_notes = R"(
The stone's centre is the origin, its symmetry axis z; in a glb file, where y points up, the
node turns it there. Points lie on the stone, normals are the stone's own.
obj: text, 17 digits; stl: binary, float; ply: binary, double; glb: glTF 2.0, float, in metres,
with width, height and bevel as extras. Computed in double; lengths must be 0 or from 1e-20
to 1e20 in SI units.

Examples:
  goishi mesh --size 33 --bevel 1mm --output stone.glb
  goishi mesh --size 33 --color black --tolerance 1um --units mm --output black.stl --stats
  goishi mesh --width 22mm --height 9.2mm --method rings --level 5 --output stone.ply
  goishi mesh --size 40 --standard nihon-kiin --level 3 --format obj --output -

Exit status: 0 done, 2 bad usage or a failed write.)";

constexpr const char* about_body = "A stone as a rigid body for a simulator: exact mass and inertia, and a mesh";

constexpr const char* body_notes = R"(
The body's origin is the centre of mass, its z the symmetry axis. Mass and moments are
computed with 50 digits and printed with 17, in SI units. The mesh, for the eye and for
collisions, is written beside the file, under its name with .obj, in metres; both or neither.

Examples:
  goishi body --size 33 --bevel 1mm --format urdf --output stone.urdf
  goishi body --size 33 --color black --mass 5.5g --output black.sdf
  goishi body --width 22mm --height 9.2mm --bevel 1mm --measured --level 5 --output stone.xml

Exit status: 0 done, 2 bad usage or a failed write.)";

void add_choice(CLI::App& command, MeshChoice& choice, int default_level) {
  add_value(command, choice.method, "--method", "METHOD",
            "subdivision: triangles alike; rings: by longitude and latitude, as a globe\n[default: subdivision]");
  add_value(command, choice.level, "--level", "L",
            fmt::format("How fine, from 0 to {}: 2^L rings of triangles on each cap [default: {}]", finest_level,
                        default_level));
  add_value(command, choice.tolerance, "--tolerance", "LENGTH",
            "Instead: as few triangles as are nowhere farther from the stone");
  command
      .add_flag("--cache-order", choice.cache_order,
                "Triangles and vertices in the order in which a graphics card\n"
                "reads them with the fewest repetitions (meshoptimizer)")
      ->disable_flag_override();
}

}  // namespace

void add_mesh(CLI::App& app, MeshOptions& options) {
  CLI::App& mesh = *app.add_subcommand("mesh", about_mesh);
  add_shape(mesh, options.stone);
  add_choice(mesh, options.choice, default_mesh_level);
  add_value(mesh, options.units, "--units", "UNIT",
            "Unit of length in an obj, stl or ply file: m, cm or mm [default: m]");
  add_value(mesh, options.format, "--format", "FORMAT",
            "obj, stl, ply or glb [default: what the extension of FILE says]");
  add_value(mesh, options.output, "--output", "FILE", "Write to FILE, all or nothing; -: to standard output");
  mesh.add_flag("--stats", options.stats, "Print counts, volume and distance from the stone; needs no FILE")
      ->disable_flag_override();
  mesh.footer(numbers_note({measure::length}) + mesh_notes);
}

void add_body(CLI::App& app, BodyOptions& options) {
  CLI::App& body = *app.add_subcommand("body", about_body);
  add_shape(body, options.stone);
  add_mass(body, options.stone);
  add_choice(body, options.choice, default_body_level);
  add_value(body, options.format, "--format", "FORMAT",
            "urdf, sdf or mjcf [default: what the extension of FILE says, .xml: mjcf]");
  add_value(body, options.output, "--output", "FILE", "Write to FILE, and the mesh beside it, all or nothing");
  body.footer(numbers_note({measure::length, measure::density, measure::mass}) + body_notes);
}

}  // namespace goishi::cli
