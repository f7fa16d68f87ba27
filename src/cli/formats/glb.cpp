#include <tiny_gltf.h>

#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "formats/bytes.hpp"
#include "formats/mesh_formats.hpp"

namespace goishi::cli {

namespace {

/// Adds the bytes to the model's one buffer, and says what they are. Returns the number of the accessor.
int add_numbers(tinygltf::Model& model, const std::string& bytes, tinygltf::Accessor accessor, int target) {
  std::vector<unsigned char>& buffer = model.buffers.front().data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = bytes.size();
  view.target = target;
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  model.bufferViews.push_back(view);
  model.accessors.push_back(std::move(accessor));
  return accessor.bufferView;
}

/// In float, with the least and greatest coordinates that glTF wants of points.
int add_vectors(tinygltf::Model& model, const std::vector<Vec3<double>>& vectors, bool with_bounds) {
  std::string bytes;
  Vec3<float> least = Vec3<float>::Constant(std::numeric_limits<float>::infinity());
  Vec3<float> most = -least;
  for (const Vec3<double>& v : vectors) {
    append<float>(bytes, v);
    least = least.cwiseMin(v.cast<float>());
    most = most.cwiseMax(v.cast<float>());
  }
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_VEC3;
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.count = vectors.size();
  if (with_bounds) {
    accessor.minValues.assign(least.begin(), least.end());
    accessor.maxValues.assign(most.begin(), most.end());
  }
  return add_numbers(model, bytes, std::move(accessor), TINYGLTF_TARGET_ARRAY_BUFFER);
}

int add_corners(tinygltf::Model& model, const Mesh<double>& mesh) {
  // The greatest number of a type is no place: it is kept for the end of a strip.
  const bool short_places = mesh.points.size() <= std::numeric_limits<std::uint16_t>::max();
  std::string bytes;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (short_places) {
        append(bytes, static_cast<std::uint16_t>(vertex));
      } else {
        append(bytes, vertex);
      }
    }
  }
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.componentType = short_places ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.count = 3 * mesh.triangles.size();
  return add_numbers(model, bytes, std::move(accessor), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
}

tinygltf::Node node_of(const Stone<double>& stone) {
  constexpr double half_root = std::numbers::sqrt2 / 2;
  tinygltf::Node node;
  node.name = "stone";
  node.mesh = 0;
  node.rotation = {-half_root, 0, 0, half_root};  // x, y, z, w: z becomes y
  node.extras = tinygltf::Value(tinygltf::Value::Object{{"width", tinygltf::Value(stone.width)},
                                                        {"height", tinygltf::Value(stone.height)},
                                                        {"bevel", tinygltf::Value(stone.bevel)}});
  return node;
}

}  // namespace

std::string as_glb(const Mesh<double>& mesh, const Stone<double>& stone, const Color& color,
                   const std::string& generator) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = generator;
  model.buffers.resize(1);

  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.attributes["POSITION"] = add_vectors(model, mesh.points, true);
  primitive.attributes["NORMAL"] = add_vectors(model, mesh.normals, false);
  primitive.indices = add_corners(model, mesh);
  primitive.material = 0;
  model.meshes.resize(1);
  model.meshes.front().primitives.push_back(primitive);

  model.materials.resize(1);
  model.materials.front().pbrMetallicRoughness.baseColorFactor = {color[0], color[1], color[2], 1};
  model.materials.front().pbrMetallicRoughness.metallicFactor = 0;
  model.nodes.push_back(node_of(stone));
  model.scenes.resize(1);
  model.scenes.front().nodes = {0};
  model.defaultScene = 0;

  std::ostringstream bytes;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, bytes, false, true)) {
    throw std::runtime_error("the glTF file cannot be made");
  }
  return std::move(bytes).str();
}

}  // namespace goishi::cli
