#pragma once
/// \file
/// `goishi-verify reference`.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace goishi::verify::reference {

struct Options {
  std::string folder = "verify/reference";  // of the files
  std::string write;                        // the folder to write them to
  std::string answers;                      // the file to write the library's own to
  std::vector<std::string> check;           // files with answers, "-": standard input
  std::optional<double> within;             // ulps
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_reference(CLI::App& app, Options& options);

/// Compares, writes or checks. True when nothing differs and no error is above the limit.
[[nodiscard]] bool run_reference_command(const Options& options);

}  // namespace goishi::verify::reference
