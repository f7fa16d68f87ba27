#pragma once
/// \file
/// Messages for standard error.

#include <string>
#include <string_view>
#include <vector>

namespace goishi::cli {

/// Prints "goishi: MESSAGE" as one line, whatever control characters the message holds.
void report(std::string_view message);

/// What should be known about an answer that is printed next.
void report_notes(const std::vector<std::string>& notes);

}  // namespace goishi::cli
