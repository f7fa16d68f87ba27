#include "alignment.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace goishi::cli {

namespace {

/// Characters, not bytes: "m³" has two.
std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; }));
}

bool is_number(std::string_view text) {
  text.remove_prefix(text.starts_with('-') ? 1 : 0);
  return !text.empty() && '0' <= text.front() && text.front() <= '9';
}

/// What stands behind the whole part: the point, the decimals, the exponent.
std::size_t tail(std::string_view number) {
  return number.size() - std::min(number.find_first_of(".e"), number.size());
}

std::string spaces(std::size_t count) {
  return std::string(count, ' ');
}

void align_points(std::vector<Line>& lines, std::size_t column) {
  std::size_t longest = 0;
  for (const Line& line : lines) {
    if (is_number(line[column])) {
      longest = std::max(longest, tail(line[column]));
    }
  }
  for (Line& line : lines) {
    if (is_number(line[column])) {
      line[column] += spaces(longest - tail(line[column]));
    }
  }
}

}  // namespace

void align(std::vector<Line>& lines, const std::vector<Align>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool left = columns[i] == Align::left;
    if (!left) {
      align_points(lines, i);
    }
    std::size_t width = 0;
    for (const Line& line : lines) {
      width = std::max(width, length(line[i]));
    }
    for (Line& line : lines) {
      line[i].insert(left ? line[i].size() : 0, spaces(width - length(line[i])));
    }
  }
}

std::string joined(const Line& line, std::string_view separator) {
  return fmt::format("{}", fmt::join(line, separator));
}

std::string as_row(const Line& line) {
  std::string row = joined(line, "  ");
  row.erase(row.find_last_not_of(' ') + 1);
  return row + "\n";
}

}  // namespace goishi::cli
