/// Files of meshes, read back by Assimp, which holds coordinates in float.

#include "formats/mesh_formats.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <cstdint>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/shape/catalogue.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace goishi::cli {
namespace {

/// A corner of a triangle as it is read.
struct Corner {
  Vec3<double> point;
  Vec3<double> normal;
};

using ReadTriangles = std::vector<std::array<Corner, 3>>;

Vec3<double> vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// The triangles of a file in the file's frame; none when Assimp does not read it, or it is no single mesh of triangles.
ReadTriangles read_back(const std::string& bytes, const char* format) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_ValidateDataStructure, format);
  if (scene == nullptr || scene->mNumMeshes != 1 || !scene->mMeshes[0]->HasNormals()) {
    return {};
  }
  const aiMesh& mesh = *scene->mMeshes[0];
  ReadTriangles triangles;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) {
      return {};
    }
    triangles.emplace_back();
    for (unsigned j = 0; j < 3; ++j) {
      triangles.back()[j] = {vector_of(mesh.mVertices[face.mIndices[j]]), vector_of(mesh.mNormals[face.mIndices[j]])};
    }
  }
  return triangles;
}

double volume_of(const ReadTriangles& triangles) {
  double volume = 0;
  for (const auto& [a, b, c] : triangles) {
    volume += a.point.dot(b.point.cross(c.point)) / 6;
  }
  return volume;
}

ReadTriangles triangles_of(const Mesh<double>& mesh, bool facet_normals) {
  ReadTriangles triangles;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Corner, 3>& corners = triangles.emplace_back();
    for (std::size_t j = 0; j < 3; ++j) {
      corners[j] = {mesh.points[triangle[j]], mesh.normals[triangle[j]]};
    }
    if (facet_normals) {
      const Vec3<double> edge = corners[1].point - corners[0].point;
      const Vec3<double> normal = edge.cross(corners[2].point - corners[0].point).normalized();
      corners[0].normal = corners[1].normal = corners[2].normal = normal;
    }
  }
  return triangles;
}

/// The largest difference between corners, in float's ε of their coordinates' size; infinite when there are not as many.
double difference(const ReadTriangles& read, const ReadTriangles& expected) {
  if (read.size() != expected.size() || read.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  double size = 0;
  for (const auto& corners : expected) {
    for (const Corner& corner : corners) {
      size = std::max(size, corner.point.cwiseAbs().maxCoeff());
    }
  }
  double worst = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double point = (read[i][j].point - expected[i][j].point).cwiseAbs().maxCoeff() / size;
      const double normal = (read[i][j].normal - expected[i][j].normal).cwiseAbs().maxCoeff();
      if (!(std::max(point, normal) <= worst)) {
        worst = std::max(point, normal);
      }
    }
  }
  return worst / std::numeric_limits<float>::epsilon();
}

/// A box with its corner at the origin and three edges that differ: 24 vertices, 8 points.
Mesh<double> box() {
  const Vec3<double> edges(0.03, 0.02, 0.01);
  Mesh<double> mesh;
  for (const int axis : {0, 1, 2}) {
    for (const int side : {0, 1}) {
      const auto first = static_cast<std::uint32_t>(mesh.points.size());
      const Vec3<double> out = Vec3<double>::Unit(axis) * (2 * side - 1);
      for (const int corner : {0, 1, 2, 3}) {
        Vec3<double> p = side * Vec3<double>::Unit(axis);
        p[(axis + 1) % 3] = corner % 2;
        p[(axis + 2) % 3] = corner / 2;
        mesh.points.emplace_back(p.cwiseProduct(edges));
        mesh.normals.push_back(out);
      }
      const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back(side == 1 ? Triangle{first + a, first + b, first + c}
                                           : Triangle{first + a, first + c, first + b});
      };
      add(0, 1, 3);
      add(0, 3, 2);
    }
  }
  return mesh;
}

Stone<double> some_stone() {
  return make_stone(catalogue_stone(33, StoneColor::white), 0.001);
}

std::string glb_of(const Mesh<double>& mesh) {
  return as_glb(mesh, some_stone(), {1, 1, 1}, "test");
}

struct Written {
  const char* format;
  std::string bytes;
  bool facet_normals;
};

std::vector<Written> files_of(const Mesh<double>& mesh) {
  return {{"obj", as_obj(mesh, "a comment"), false},
          {"stl", as_stl(mesh, "a comment"), true},
          {"ply", as_ply(mesh, "a comment"), false},
          {"glb", glb_of(mesh), false}};
}

TEST(MeshFormats, AssimpReadsTheSameTriangles) {
  const double box_volume = 0.03 * 0.02 * 0.01;
  EXPECT_NEAR(volume_of(triangles_of(box(), false)), box_volume, 1e-15 * box_volume);
  const Stone<double> sharp = make_stone(catalogue_stone(22, StoneColor::black));
  for (const Mesh<double>& mesh :
       {box(), tessellate(sharp, Tessellation::rings, 3), tessellate(some_stone(), Tessellation::subdivision, 3)}) {
    const double volume = volume_of(triangles_of(mesh, false));
    for (const Written& file : files_of(mesh)) {
      const ReadTriangles read = read_back(file.bytes, file.format);
      // Half an ε is the rounding to float.
      EXPECT_LE(difference(read, triangles_of(mesh, file.facet_normals)), 0.5) << file.format;
      EXPECT_NEAR(volume_of(read), volume, 1e-6 * volume) << file.format;
    }
  }
}

TEST(MeshFormats, AWrongByteIsNoticed) {
  const Mesh<double> mesh = box();
  for (Written& file : files_of(mesh)) {
    std::string& bytes = file.bytes;
    const ReadTriangles expected = triangles_of(mesh, file.facet_normals);
    ASSERT_LE(difference(read_back(bytes, file.format), expected), 0.5);
    if (std::string(file.format) == "obj") {
      char& point = bytes[bytes.rfind(' ') + 1];
      point = point == '1' ? '2' : '1';
    } else {
      // The last triangle's last corner; in STL and glTF two bytes stand behind it, or none.
      const std::size_t at = bytes.size() - (std::string(file.format) == "stl" ? 4 : 2);
      bytes[at] = static_cast<char>(bytes[at] ^ 0x40);
    }
    EXPECT_GT(difference(read_back(bytes, file.format), expected), 1e3) << file.format;
  }
}

TEST(MeshFormats, ATruncatedFileIsNoticed) {
  const Mesh<double> mesh = box();
  for (const Written& file : files_of(mesh)) {
    const std::string half = file.bytes.substr(0, file.bytes.size() / 2);
    EXPECT_GT(difference(read_back(half, file.format), triangles_of(mesh, file.facet_normals)), 1e3) << file.format;
  }
}

/// The lines of an OBJ file that begin with a word.
std::size_t lines_with(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("\n" + word + " ", at)) != std::string::npos; ++at) {
    ++count;
  }
  return count;
}

TEST(MeshFormats, ObjHasEachPointOnce) {
  const std::string text = as_obj(box(), "a comment");
  EXPECT_EQ(lines_with(text, "v"), 8U);
  EXPECT_EQ(lines_with(text, "vn"), 24U);
  EXPECT_EQ(lines_with(text, "f"), 12U);
  Mesh<double> zeros = box();
  zeros.points[0] = -zeros.points[0];  // -0, -0, -0: the same point
  EXPECT_EQ(lines_with(as_obj(zeros, ""), "v"), 8U);
}

TEST(MeshFormats, ObjGivesTheDoubleBack) {
  Mesh<double> mesh = box();
  for (Vec3<double>& p : mesh.points) {
    p = p / 3 + Vec3<double>(0.1, 1e-7, 1);
  }
  const std::string text = as_obj(mesh, "a comment");
  std::size_t at = text.find("\nv ");
  for (const Vec3<double>& p : weld(mesh, Weld::position).points) {
    const char* rest = text.c_str() + at + 2;
    for (const double c : p) {
      char* end = nullptr;
      EXPECT_EQ(std::strtod(rest, &end), c);
      rest = end;
    }
    at = text.find("\nv ", at + 1);
  }
  EXPECT_EQ(at, std::string::npos);
}

TEST(MeshFormats, PlyHoldsDoubles) {
  const Mesh<double> mesh = box();
  const std::string bytes = as_ply(mesh, "a comment");
  const std::string end = "end_header\n";
  const std::size_t start = bytes.find(end) + end.size();
  ASSERT_EQ(bytes.size(), start + 24 * 6 * 8 + 12 * 13);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (int c = 0; c < 6; ++c) {
      std::uint64_t bits = 0;
      for (std::size_t byte = 8; 0 < byte--;) {
        const std::size_t place = start + (6 * i + static_cast<std::size_t>(c)) * 8 + byte;
        bits = bits << 8 | static_cast<unsigned char>(bytes[place]);
      }
      EXPECT_EQ(std::bit_cast<double>(bits), c < 3 ? mesh.points[i][c] : mesh.normals[i][c - 3]);
    }
  }
}

TEST(MeshFormats, StlHasItsSize) {
  const std::string bytes = as_stl(box(), std::string(100, 'x'));
  EXPECT_EQ(bytes.size(), 84U + 12 * 50);
  EXPECT_EQ(bytes.substr(0, 80), std::string(80, 'x'));
  EXPECT_EQ(as_stl(box(), "x").substr(0, 84), "x" + std::string(79, ' ') + std::string("\x0C\0\0\0", 4));
}

TEST(MeshFormats, GltfIndicesAreAsShortAsTheyCanBe) {
  const auto size_of = [](std::size_t vertices) {
    Mesh<double> mesh;
    mesh.points.assign(vertices, Vec3<double>(1, 2, 3));
    mesh.normals.assign(vertices, Vec3<double>(0, 0, 1));
    mesh.triangles.assign(1000, {0, 0, static_cast<std::uint32_t>(vertices - 1)});
    return glb_of(mesh).size() - vertices * 24;
  };
  EXPECT_LT(size_of(65535), 3000 * 2 + 2000U);  // the JSON chunk has less than 2000 bytes
  EXPECT_GT(size_of(65536), 3000 * 4U);
}

}  // namespace
}  // namespace goishi::cli
