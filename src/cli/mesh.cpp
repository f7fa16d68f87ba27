#include "mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <goishi/error.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <stdexcept>
#include <vector>

#include "alignment.hpp"
#include "file.hpp"
#include "formats/cache_order.hpp"
#include "version.hpp"

namespace goishi::cli {

namespace {

enum class MeshFormat { obj, stl, ply, glb };

constexpr std::array<std::string_view, 4> mesh_formats = {"obj", "stl", "ply", "glb"};

MeshFormat mesh_format_of(const MeshOptions& options) {
  const bool printed = options.output == "-";
  if (!options.format && printed) {
    throw InvalidArgument("output", *options.output, "needs --format too");
  }
  const std::string name = options.format ? *options.format : extension_of(*options.output);
  const auto* format = std::ranges::find(mesh_formats, name);
  if (format != mesh_formats.end()) {
    return static_cast<MeshFormat>(format - mesh_formats.begin());
  }
  if (options.format) {
    throw InvalidArgument("format", *options.format, "must be obj, stl, ply or glb");
  }
  throw InvalidArgument("output", *options.output, "must end in .obj, .stl, .ply or .glb, or --format be given too");
}

/// A unit of length, as many of which make a metre.
struct MeshUnit {
  std::string_view name;
  double per_metre;
};

MeshUnit unit_of(const MeshOptions& options, MeshFormat format) {
  constexpr std::array<MeshUnit, 3> units = {{{"m", 1}, {"cm", 100}, {"mm", 1000}}};
  const std::string name = options.units.value_or("m");
  const auto* unit = std::ranges::find(units, name, &MeshUnit::name);
  if (unit == units.end()) {
    throw InvalidArgument("units", name, "must be m, cm or mm");
  }
  if (format == MeshFormat::glb && unit != units.begin()) {
    throw InvalidArgument("units", name, "must be m in glb, whose unit is the metre");
  }
  return *unit;
}

void check_combination(const MeshOptions& options) {
  check_one_stone(options.stone);
  if (!options.output && !options.stats) {
    throw std::runtime_error("a file is needed: --output, such as --output stone.glb (or --stats)");
  }
  require_with("units", options.units, "output", options.output);
  require_with("format", options.format, "output", options.output);
  if (options.stats && options.output == "-") {
    throw InvalidArgument("output", *options.output, "must be a file with --stats, which are printed");
  }
}

std::string file_of(const MeshOptions& options, const Subject& subject, const StoneMesh& mesh, MeshFormat format,
                    const MeshUnit& unit) {
  if (format == MeshFormat::glb) {
    return as_glb(mesh.mesh, mesh.stone, color_of(options.stone), version());
  }
  Mesh<double> scaled = mesh.mesh;
  for (Vec3<double>& p : scaled.points) {
    p *= unit.per_metre;
  }
  const std::string comment = mesh_comment(subject, unit.name);
  switch (format) {
    case MeshFormat::obj:
      return as_obj(scaled, comment);
    case MeshFormat::stl:
      return as_stl(scaled, comment);
    default:
      return as_ply(scaled, comment);
  }
}

std::string statistics(const Subject& subject, const StoneMesh& mesh) {
  const MassProperties<Number> exact = mass_properties(stone_of(subject), Density{Number(1)});
  const MeshMass<double> enclosed = mesh_mass(mesh.mesh);
  std::vector<Line> lines;
  const auto add = [&lines](std::string_view name, const std::string& value, std::string_view unit = "",
                            std::string_view note = "") {
    lines.push_back({std::string(name), value, std::string(unit), std::string(note)});
  };
  const auto count = [&add](std::string_view name, std::size_t value, std::string_view note = "") {
    add(name, std::to_string(value), "", note);
  };
  count("rings", static_cast<std::size_t>(mesh.fineness.rings), "of triangles from the middle of a cap to its rim");
  count("rows", static_cast<std::size_t>(mesh.fineness.rows), "of triangles across the bevel");
  count("segments", 5 * static_cast<std::size_t>(mesh.fineness.segments), "around the rim");
  count("triangles", mesh.mesh.triangles.size());
  count("corners", 3 * mesh.mesh.triangles.size(), "of triangles, before they are welded");
  count("vertices", mesh.mesh.points.size(), "points with a normal");
  count("points", topology(mesh.mesh).points);
  add("cache misses", six_digits(Number(vertices_per_triangle(mesh.mesh))), "",
      "vertices a triangle, of a graphics card that remembers 16");
  add("deviation", six_digits(Number(deviation(mesh.mesh, mesh.stone))), "m", "the largest distance from the stone");
  const auto compare = [&](std::string_view name, double value, const Number& of_stone, std::string_view unit) {
    add(name, six_digits(Number(value)), unit, fmt::format("the stone's: {}", six_digits(of_stone)));
  };
  compare("volume", enclosed.volume, exact.volume, "m³");
  compare("surface area", enclosed.surface_area, exact.surface_area, "m²");
  align(lines, {Align::left, Align::number, Align::left, Align::left});
  std::string text = fmt::format("{}, as a mesh by {}\n\n", described(subject), to_string(mesh.method));
  for (const Line& line : lines) {
    text += as_row(line);
  }
  return text;
}

}  // namespace

int run_mesh(const MeshOptions& options) {
  check_combination(options);
  const Subject subject = subject_of(options.stone);
  if (options.output) {
    const MeshFormat format = mesh_format_of(options);
    const MeshUnit unit = unit_of(options, format);
    const StoneMesh mesh = mesh_of(subject, options.choice, default_mesh_level);
    const std::string bytes = file_of(options, subject, mesh, format, unit);
    if (*options.output == "-") {
      write_standard_output(bytes);
    } else {
      write_file("output", *options.output, bytes);
    }
    if (options.stats) {
      write_standard_output(statistics(subject, mesh));
    }
  } else {
    write_standard_output(statistics(subject, mesh_of(subject, options.choice, default_mesh_level)));
  }
  return 0;
}

}  // namespace goishi::cli
