#pragma once
/// \file
/// The command lines of `goishi mesh` and `goishi body`.

#include <CLI/CLI.hpp>

#include "body.hpp"
#include "mesh.hpp"

namespace goishi::cli {

void add_mesh(CLI::App& app, MeshOptions& options);
void add_body(CLI::App& app, BodyOptions& options);

}  // namespace goishi::cli
