#pragma once
/// \file
/// `goishi-verify stress`.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

#include "verify/stress/heaps.hpp"
#include "verify/stress/poses.hpp"
#include "verify/stress/stress.hpp"

namespace goishi::verify::stress {

struct Options {
  Order order{.threads = std::max(1U, std::thread::hardware_concurrency())};
  std::optional<std::uint64_t> single;  // one drop alone, with its events; one pose, one scene alone
  std::string of = "drops";             // or "poses", "scenes"
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_stress(CLI::App& app, Options& options);

/// Drops, poses or scenes: runs, judges, prints. True when everything is sound.
[[nodiscard]] bool run_stress_command(const Options& options);

}  // namespace goishi::verify::stress
