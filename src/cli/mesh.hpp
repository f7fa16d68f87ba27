#pragma once
/// \file
/// `goishi mesh`: a stone's surface as a file for other programs.

#include <optional>
#include <string>

#include "stone_mesh.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct MeshOptions {
  StoneOptions stone;
  MeshChoice choice;
  std::optional<std::string> units;
  std::optional<std::string> format;
  std::optional<std::string> output;
  bool stats = false;
};

/// Writes the file, or prints it; prints the statistics to standard output. Exit status: 0. InvalidArgument for the
/// options' errors.
[[nodiscard]] int run_mesh(const MeshOptions& options);

}  // namespace goishi::cli
