#pragma once
/// \file
/// `goishi-verify bits`.

#include <CLI/CLI.hpp>
#include <string>

namespace goishi::verify::bits {

struct Options {
  std::string check;
  std::string write;
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_bits(CLI::App& app, Options& options);

/// Prints the hash of each kind of work, with the claims that say how far off its numbers are. False where one is not that of
/// the file, or the file has others.
[[nodiscard]] bool run_bits_command(const Options& options);

}  // namespace goishi::verify::bits
