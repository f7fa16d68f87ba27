#pragma once
/// \file
/// A drop as `goishi drop` prints it.

#include <goishi/drop/events.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drop_motion.hpp"

namespace goishi::cli {

/// For people: the stone and the settings, a line for each event, the end and what it cost.
/// A state at a time that was asked for stands in its place among them.
[[nodiscard]] std::string to_block(const DropScene& scene, const DropResult<double>& drop,
                                   const std::optional<DropSample>& asked);

/// For programs: 17 digits, SI units.
[[nodiscard]] std::string to_json(const DropScene& scene, const DropResult<double>& drop,
                                  const std::optional<DropSample>& asked);

[[nodiscard]] std::string to_csv(const std::vector<DropSample>& samples);

/// "at rest on the board after 0.5 s", "given up after 12 s: too many events".
[[nodiscard]] std::string end_of(const DropScene& scene, const DropResult<double>& drop);

}  // namespace goishi::cli
