#pragma once
/// \file
/// `goishi-verify certify`.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace goishi::verify::certify {

struct Options {
  std::vector<std::string> tables;     // files, "-": standard input
  std::vector<std::string> documents;  // files
  bool whole = false;                  // tables must have both colours, sharp and bevelled
  std::string standard = "talk";       // of the tables' stones
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_certify(CLI::App& app, Options& options);

/// Reads, judges, prints. True when every number is certified.
[[nodiscard]] bool run_certify_command(const Options& options);

}  // namespace goishi::verify::certify
