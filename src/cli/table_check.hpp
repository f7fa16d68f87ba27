#pragma once
/// \file
/// `goishi table --check`: a file against the table that should be in it.

#include <optional>
#include <string>
#include <string_view>

#include "document.hpp"

namespace goishi::cli {

/// Names the first row that differs (outside of the rows: the line) and shows both texts, briefly;
/// nothing when they agree.
[[nodiscard]] std::optional<std::string> first_difference(const Document& expected, std::string_view found);

}  // namespace goishi::cli
