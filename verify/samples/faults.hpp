#pragma once
/// \file
/// The check of all that is right or wrong: a status, a choice, an event, a number as it was printed.

#include <string>
#include <utility>

#include "verify/suite/claim.hpp"

namespace goishi::verify {

[[nodiscard]] inline Check no_faults(std::string name = "faults") {
  return {.name = std::move(name), .unit = "faults", .bound = 0.0, .reason = "there must be none", .counts = true};
}

}  // namespace goishi::verify
