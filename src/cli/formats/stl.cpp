#include "formats/bytes.hpp"
#include "formats/mesh_formats.hpp"

namespace goishi::cli {

std::string as_stl(const Mesh<double>& mesh, std::string_view comment) {
  constexpr std::size_t header_size = 80;
  constexpr std::size_t facet_size = 50;
  std::string bytes(comment.substr(0, header_size));
  bytes.resize(header_size, ' ');
  bytes.reserve(header_size + sizeof(std::uint32_t) + mesh.triangles.size() * facet_size);
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3<double>& corner = mesh.points[a];
    append<float>(bytes, Vec3<double>((mesh.points[b] - corner).cross(mesh.points[c] - corner).normalized()));
    for (const std::size_t vertex : {a, b, c}) {
      append<float>(bytes, mesh.points[vertex]);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace goishi::cli
