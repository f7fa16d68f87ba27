#pragma once
/// \file
/// `goishi-verify stress`.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <thread>

#include "verify/stress/stress.hpp"

namespace goishi::verify::stress {

struct Options {
  Order order{.threads = std::max(1U, std::thread::hardware_concurrency())};
  std::optional<std::uint64_t> single;  // one drop alone, with its events
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_stress(CLI::App& app, Options& options);

/// Drops, judges, prints. True when every drop is sound.
[[nodiscard]] bool run_stress_command(const Options& options);

}  // namespace goishi::verify::stress
