#pragma once
/// \file
/// `goishi body`: a stone as a rigid body for a simulator.

#include <optional>
#include <string>

#include "stone_mesh.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct BodyOptions {
  StoneOptions stone;
  MeshChoice choice;
  std::optional<std::string> format;
  std::optional<std::string> output;
};

/// Writes the body's file, and the mesh beside it. Exit status: 0. InvalidArgument for the options' errors.
[[nodiscard]] int run_body(const BodyOptions& options);

}  // namespace goishi::cli
