#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "formats/mesh_formats.hpp"

namespace goishi::cli {

std::string as_obj(const Mesh<double>& mesh, std::string_view comment) {
  const Mesh<double> solid = weld(mesh, Weld::position);
  std::string text = fmt::format("# {}\n", comment);
  const auto out = std::back_inserter(text);
  for (const Vec3<double>& p : solid.points) {
    fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  }
  for (const Vec3<double>& n : mesh.normals) {
    fmt::format_to(out, "vn {} {} {}\n", n.x(), n.y(), n.z());
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += 'f';
    for (std::size_t corner = 0; corner < 3; ++corner) {
      fmt::format_to(out, " {}//{}", solid.triangles[i][corner] + 1, mesh.triangles[i][corner] + 1);
    }
    text += '\n';
  }
  return text;
}

}  // namespace goishi::cli
