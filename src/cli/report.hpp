#pragma once
/// \file
/// Messages for standard error.

#include <string_view>

namespace goishi::cli {

/// Prints "goishi: MESSAGE" as one line, whatever control characters the message holds.
void report(std::string_view message);

}  // namespace goishi::cli
