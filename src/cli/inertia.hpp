#pragma once
/// \file
/// `goishi inertia`: everything about one stone.

#include <string>

#include "subject.hpp"

namespace goishi::cli {

/// As typed.
struct InertiaOptions {
  StoneOptions stone;
  std::string format = "text";
};

/// Prints to standard output. Exit status: 0. InvalidArgument for the options' errors.
[[nodiscard]] int run_inertia(const InertiaOptions& options);

}  // namespace goishi::cli
