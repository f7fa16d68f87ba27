#pragma once
/// \file
/// The command line of `goishi drop`.

#include <CLI/CLI.hpp>

#include "drop.hpp"

namespace goishi::cli {

void add_drop(CLI::App& app, DropOptions& options);

}  // namespace goishi::cli
