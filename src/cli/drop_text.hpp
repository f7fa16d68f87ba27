#pragma once
/// \file
/// A drop as `goishi drop` prints it.

#include <goishi/drop/events.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drop_motion.hpp"

namespace goishi::cli {

/// For people: the stone and the settings, a line for each event, the end and what it cost.
/// A state at a time that was asked for stands in its place among them.
[[nodiscard]] std::string to_block(const DropScene& scene, const DropResult<double>& drop,
                                   const std::optional<Sample>& asked);

/// For programs: 17 digits, SI units.
[[nodiscard]] std::string to_json(const DropScene& scene, const DropResult<double>& drop,
                                  const std::optional<Sample>& asked);

[[nodiscard]] std::string to_csv(const std::vector<Sample>& samples);

/// "at rest on the board after 0.5 s", "given up after 12 s: too many events".
[[nodiscard]] std::string end_of(const DropScene& scene, const DropResult<double>& drop);

/// "9.80665", or a vector where it leans.
[[nodiscard]] std::string text_of_gravity(const Vec3<double>& gravity);

/// Of a stone on the board, two lines: restitution and friction; the lengths of resistance.
[[nodiscard]] std::string text_of_laws(const DropSettings<double>& settings, const Stone<double>& stone);

/// "3 impacts, 1 step": what is not 0; else "nothing".
[[nodiscard]] std::string text_of_counts(const std::vector<std::pair<long long, std::string_view>>& counts,
                                         std::string_view plural = "s");

}  // namespace goishi::cli
