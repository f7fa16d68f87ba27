#include "body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <stdexcept>

#include "file.hpp"
#include "formats/body_formats.hpp"
#include "quantity.hpp"

namespace goishi::cli {

namespace {

namespace fs = std::filesystem;

struct BodyFormat {
  std::string_view name;
  std::string_view extension;
  std::string (*print)(const BodyFile&);
};

constexpr std::array<BodyFormat, 4> body_formats = {
    {{"urdf", "urdf", as_urdf}, {"sdf", "sdf", as_sdf}, {"mjcf", "mjcf", as_mjcf}, {"mjcf", "xml", as_mjcf}}};

const BodyFormat& body_format_of(const BodyOptions& options) {
  const auto* format = options.format
                           ? std::ranges::find(body_formats, *options.format, &BodyFormat::name)
                           : std::ranges::find(body_formats, extension_of(*options.output), &BodyFormat::extension);
  if (format != body_formats.end()) {
    return *format;
  }
  if (options.format) {
    throw InvalidArgument("format", *options.format, "must be urdf, sdf or mjcf");
  }
  throw InvalidArgument("output", *options.output, "must end in .urdf, .sdf, .mjcf or .xml, or --format be given too");
}

/// The name of the mesh's file, beside the body's.
fs::path mesh_beside(const std::string& output) {
  if (output == "-") {
    throw InvalidArgument("output", output, "must be a file: the mesh is written beside it");
  }
  const fs::path body(output);
  fs::path mesh = body;
  mesh.replace_extension(".obj");
  if (mesh == body) {
    throw InvalidArgument("output", output, "must not end in .obj, as the mesh beside it does");
  }
  if (!is_plain_name(mesh.filename().string())) {
    throw InvalidArgument(
        "output", output,
        "must have a file name of ASCII letters, digits, '.', '_', '-' and '+': the body's file holds "
        "the name of the mesh's");
  }
  return mesh;
}

}  // namespace

int run_body(const BodyOptions& options) {
  check_one_stone(options.stone);
  if (!options.output) {
    throw std::runtime_error("a file is needed: --output, such as --output stone.urdf");
  }
  const BodyFormat& format = body_format_of(options);
  const fs::path mesh_file = mesh_beside(*options.output);
  const Subject subject = subject_of(options.stone);
  const MassProperties<Number> properties = properties_of(stone_of(subject), options.stone, subject.assumed_density);
  static_cast<void>(to_double("mass", properties.mass, "a simulator", mesh_order));
  const StoneMesh mesh = mesh_of(subject, options.choice, default_body_level);
  const BodyFile body{.comment = fmt::format("{}. SI units; Bz is the symmetry axis.", described(subject)),
                      .mesh = mesh_file.filename().string(),
                      .properties = properties,
                      .color = color_of(options.stone)};
  const std::string mesh_text = as_obj(mesh.mesh, mesh_comment(subject, "m"));
  const std::string text = format.print(body);
  write_pair("output", {mesh_file.string(), mesh_text}, {*options.output, text});
  return 0;
}

}  // namespace goishi::cli
