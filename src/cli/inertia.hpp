#pragma once
/// \file
/// `goishi inertia`: everything about one stone.

#include <optional>
#include <string>

namespace goishi::cli {

/// As typed; what is not there was not given.
struct InertiaOptions {
  std::optional<std::string> size;
  std::optional<std::string> color;
  std::optional<std::string> width;
  std::optional<std::string> height;
  std::optional<std::string> bevel;
  std::optional<std::string> mass;
  std::optional<std::string> density;
  bool measured = false;
  std::string format = "text";
};

/// Prints to standard output. InvalidArgument for the options' errors.
void run_inertia(const InertiaOptions& options);

}  // namespace goishi::cli
