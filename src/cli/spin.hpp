#pragma once
/// \file
/// `goishi spin`: how a body with a symmetry axis turns when nothing touches it.

#include <optional>
#include <string>

#include "subject.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct SpinOptions {
  StoneOptions stone;
  std::optional<std::string> axial;
  std::optional<std::string> transverse;
  std::optional<std::string> spin;
  std::optional<std::string> attitude;
  std::optional<std::string> time;
  std::string method = "exact";
  std::optional<std::string> step;
  std::optional<std::string> format;
  std::optional<std::string> series;
};

/// A series has from 2 to this many rows.
inline constexpr int most_rows = 100'000;

/// Prints to standard output. Exit status: 0, or 1 when the method broke down on the way, which is said on standard
/// error; printed is then what it reached. InvalidArgument for the options' errors.
[[nodiscard]] int run_spin(const SpinOptions& options);

}  // namespace goishi::cli
