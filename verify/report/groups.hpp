#pragma once
/// \file
/// Claims belong together by the first part of their id: MASS-1, MASS-2.

#include <string>
#include <string_view>
#include <vector>

#include "verify/suite/run.hpp"

namespace goishi::verify {

struct Group {
  std::string prefix;                  // "MASS"
  std::string title;                   // for people; the prefix itself if nobody gave it one
  std::vector<const Result*> results;  // in the order of the run
};

/// In the order in which the prefixes first occur.
[[nodiscard]] std::vector<Group> grouped_results(const Run& run);

/// How many digits it takes to tell the slack from the limits that it must keep to.
[[nodiscard]] int slack_digits(double slack);

/// "32 claims", "1 claim".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// The whole run in one line: "All 32 claims hold", "2 of 32 claims do not hold", "No claim was measured".
[[nodiscard]] std::string verdict_line(const Run& run);

}  // namespace goishi::verify
