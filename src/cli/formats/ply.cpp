#include <fmt/format.h>

#include "formats/bytes.hpp"
#include "formats/mesh_formats.hpp"

namespace goishi::cli {

std::string as_ply(const Mesh<double>& mesh, std::string_view comment) {
  std::string bytes =
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n", comment, mesh.points.size());
  for (const std::string_view property : {"x", "y", "z", "nx", "ny", "nz"}) {
    bytes += fmt::format("property double {}\n", property);
  }
  bytes += fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    append<double>(bytes, mesh.points[i]);
    append<double>(bytes, mesh.normals[i]);
  }
  for (const Triangle& triangle : mesh.triangles) {
    append(bytes, static_cast<std::uint8_t>(triangle.size()));
    for (const std::uint32_t vertex : triangle) {
      append(bytes, vertex);
    }
  }
  return bytes;
}

}  // namespace goishi::cli
