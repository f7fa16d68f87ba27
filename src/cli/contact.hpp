#pragma once
/// \file
/// `goishi contact`: how far a stone is from the board, a plane or another stone, and when it will touch.

#include <optional>
#include <string>

#include "subject.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct ContactOptions {
  StoneOptions stone;
  std::optional<std::string> position;
  std::optional<std::string> attitude;
  std::optional<std::string> against;
  std::optional<std::string> other_position;
  std::optional<std::string> other_attitude;
  std::optional<std::string> lines;
  std::optional<std::string> velocity;
  std::optional<std::string> spin;
  std::optional<std::string> gravity;
  std::optional<std::string> horizon;
  std::optional<std::string> format;
};

/// Prints to standard output. Exit status: 0, or 1 when a search did not converge, which is said on standard error;
/// printed is then what it reached. InvalidArgument for the options' errors.
[[nodiscard]] int run_contact(const ContactOptions& options);

}  // namespace goishi::cli
