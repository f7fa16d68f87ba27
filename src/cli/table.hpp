#pragma once
/// \file
/// `goishi table`: the inertia of the catalogue's stones.

#include <optional>
#include <string>

namespace goishi::cli {

/// As typed; what is not there was not given.
struct TableOptions {
  std::string color = "both";
  std::optional<std::string> standard;
  std::optional<std::string> bevel;
  std::optional<std::string> density;
  std::string units = "si";
  std::optional<std::string> format;
  std::optional<std::string> output;
  std::optional<std::string> check;
};

/// Prints, writes or checks the table. Exit status: 0, or 1 when --check finds a difference, which it
/// names on standard error. InvalidArgument for the options' errors.
[[nodiscard]] int run_table(const TableOptions& options);

}  // namespace goishi::cli
