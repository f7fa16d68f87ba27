#pragma once
/// \file
/// The command line of `goishi scene`.

#include <CLI/CLI.hpp>

#include "scene/scene.hpp"

namespace goishi::cli {

void add_scene(CLI::App& app, SceneOptions& options);

}  // namespace goishi::cli
