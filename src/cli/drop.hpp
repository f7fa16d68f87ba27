#pragma once
/// \file
/// `goishi drop`: one stone from any state to rest, event by event.

#include <optional>
#include <string>

#include "subject.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct DropOptions {
  StoneOptions stone;
  std::optional<std::string> from;
  std::optional<std::string> position;
  std::optional<std::string> tilt;
  std::optional<std::string> tilt_axis;
  std::optional<std::string> velocity;
  std::optional<std::string> spin;
  std::optional<std::string> restitution;
  std::optional<std::string> friction;
  std::optional<std::string> friction_model;
  std::optional<std::string> slip_coefficient;
  std::optional<std::string> patch_radius;
  std::optional<std::string> rolling_resistance;
  std::optional<std::string> pivot_radius;
  std::optional<std::string> gravity;
  std::optional<std::string> law;
  std::optional<std::string> on;
  std::optional<std::string> until;
  std::optional<std::string> tolerance;
  std::optional<std::string> format;
  std::optional<std::string> series;
  std::optional<std::string> csv;
  std::optional<std::string> at;
};

/// A series has from 2 to this many rows.
inline constexpr int most_drop_rows = 1'000'000;

/// Prints to standard output, and the series to its file. Exit status: 0; 1 when the drop was given up, 3 when the stone
/// starts inside what it is dropped on, both of which are said on standard error, too. InvalidArgument for the options'
/// errors.
[[nodiscard]] int run_drop(const DropOptions& options);

}  // namespace goishi::cli
