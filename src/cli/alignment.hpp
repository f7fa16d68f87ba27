#pragma once
/// \file
/// Columns for people: words from the left, numbers point below point.

#include <string>
#include <string_view>
#include <vector>

namespace goishi::cli {

/// The cells of a line.
using Line = std::vector<std::string>;

enum class Align { left, number };

/// Pads the cells with spaces until each column has one width. In a number column, what is no number
/// stands at the right.
/// Domain  every line has as many cells as `columns`.
void align(std::vector<Line>& lines, const std::vector<Align>& columns);

/// The cells with separators between them.
[[nodiscard]] std::string joined(const Line& line, std::string_view separator);

/// The same without spaces at the end, and with an end of line.
[[nodiscard]] std::string as_row(const Line& line);

}  // namespace goishi::cli
