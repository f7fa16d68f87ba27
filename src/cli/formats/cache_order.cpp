#include "formats/cache_order.hpp"

#include <meshoptimizer.h>

#include <cstddef>
#include <vector>

namespace goishi::cli {

namespace {

std::vector<unsigned int> corners_of(const Mesh<double>& mesh) {
  std::vector<unsigned int> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  return corners;
}

}  // namespace

Mesh<double> in_cache_order(const Mesh<double>& mesh) {
  const std::size_t count = mesh.points.size();
  const std::vector<unsigned int> corners = corners_of(mesh);
  std::vector<unsigned int> ordered(corners.size()), place(count);
  meshopt_optimizeVertexCache(ordered.data(), corners.data(), corners.size(), count);
  meshopt_optimizeVertexFetchRemap(place.data(), ordered.data(), ordered.size(), count);
  Mesh<double> result;
  result.points.resize(count);
  result.normals.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.points[place[i]] = mesh.points[i];
    result.normals[place[i]] = mesh.normals[i];
  }
  result.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < ordered.size(); i += 3) {
    result.triangles.push_back({place[ordered[i]], place[ordered[i + 1]], place[ordered[i + 2]]});
  }
  return result;
}

double vertices_per_triangle(const Mesh<double>& mesh) {
  constexpr unsigned int cache = 16;
  const std::vector<unsigned int> corners = corners_of(mesh);
  return static_cast<double>(
      meshopt_analyzeVertexCache(corners.data(), corners.size(), mesh.points.size(), cache, 0, 0).acmr);
}

}  // namespace goishi::cli
