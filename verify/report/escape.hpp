#pragma once
/// \file
/// Text from elsewhere, made fit for a report: whatever bytes come in, valid UTF-8 goes out.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace goishi::verify {

/// The same text; each byte that is not UTF-8 becomes U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// For one line on a terminal: valid, control characters become spaces.
[[nodiscard]] std::string printable(std::string_view text);

/// For XML text and attributes: valid, `& < > " '` escaped, the control characters that XML forbids removed.
[[nodiscard]] std::string xml(std::string_view text);

/// An identifier for an anchor: letters, digits, `-`, `_` and `.` stay, the rest becomes `-`.
[[nodiscard]] std::string anchor(std::string_view text);

/// Columns on a terminal: East Asian wide characters count two, combining marks none.
[[nodiscard]] std::size_t columns(std::string_view text);

/// As wide as its text, and no less than `width` columns: filled up with spaces behind it, or before it.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);
[[nodiscard]] std::string right_aligned(std::string_view text, std::size_t width);

/// Lines of at most `width` columns, broken at spaces; a longer word stays whole. At least one line.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// At most `width` columns, the rest is an ellipsis.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t width);

}  // namespace goishi::verify
