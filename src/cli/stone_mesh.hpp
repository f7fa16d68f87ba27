#pragma once
/// \file
/// The mesh that the options of a command ask for.

#include <goishi/mesh/mesh.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/shape/stone.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "formats/mesh_formats.hpp"
#include "subject.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct MeshChoice {
  std::optional<std::string> method;
  std::optional<std::string> level;
  std::optional<std::string> tolerance;
  bool cache_order = false;
};

/// A mesh, in B and in metres, and what it is a mesh of.
struct StoneMesh {
  Stone<double> stone;
  Tessellation method = Tessellation::subdivision;
  Fineness fineness;
  Mesh<double> mesh;
};

/// The levels when none is given: for the eye, and for collisions.
inline constexpr int default_mesh_level = 5;
inline constexpr int default_body_level = 4;

/// Lengths of stones that become meshes are from 1e-20 to 1e20 m.
inline constexpr int mesh_order = 20;

/// InvalidArgument when the stone's options contradict each other, or std::runtime_error when there is no stone.
void check_one_stone(const StoneOptions& options);

/// The mesh of a stone; InvalidArgument for what was chosen.
[[nodiscard]] StoneMesh mesh_of(const Subject& subject, const MeshChoice& choice, int default_level);

/// "goishi: lengths in mm. The white stone of size 33, sharp", for the head of a file.
[[nodiscard]] std::string mesh_comment(const Subject& subject, std::string_view unit);

/// Shell or slate.
[[nodiscard]] Color color_of(const StoneOptions& options);

}  // namespace goishi::cli
