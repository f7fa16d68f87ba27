#pragma once
/// \file
/// `goishi scene`: a board with many stones, and what is done to them, from a file.

#include <optional>
#include <string>

namespace goishi::cli {

/// As typed; what is not there was not given.
struct SceneOptions {
  std::optional<std::string> file;
  std::optional<std::string> format;
  std::optional<std::string> series;
  std::optional<std::string> csv;
  bool schema = false;
};

/// Prints to standard output, and the series to its file. Exit status: 0; 1 when the stones do not come to rest in the time
/// in which they must, which is said on standard error, too. Exceptions for errors of the options and the file.
[[nodiscard]] int run_scene(const SceneOptions& options);

}  // namespace goishi::cli
