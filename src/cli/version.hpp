#pragma once
/// \file
/// Apart from main.cpp, which takes long to compile: the commit changes often.

#include <string>

namespace goishi::cli {

/// "goishi 0.1.0 (commit)"
[[nodiscard]] std::string version();

}  // namespace goishi::cli
