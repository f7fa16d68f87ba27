#include "table_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace goishi::cli {

namespace {

/// The line that starts at `begin`, without its end.
std::string_view line_at(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find('\n', begin) - begin);
}

bool continues_character(char c) {
  return (c & '\xC0') == '\x80';
}

/// Some forty characters of the line around `column`, from the start of a word where one is near.
std::string excerpt(std::string_view line, std::size_t column) {
  constexpr std::size_t before = 24;
  constexpr std::size_t most = 48;
  std::size_t begin = column < before ? 0 : column - before;
  if (0 < begin) {
    begin = std::min(line.find_first_of(" ,{|", begin), column);
  }
  std::size_t end = std::min(line.size(), begin + most);
  while (begin < end && continues_character(line[begin])) {
    ++begin;
  }
  while (end < line.size() && continues_character(line[end])) {
    ++end;
  }
  return fmt::format("'{}{}{}'", begin == 0 ? "" : "…", line.substr(begin, end - begin), end == line.size() ? "" : "…");
}

}  // namespace

std::optional<std::string> first_difference(const Document& expected, std::string_view found) {
  const std::string_view text = expected.text();
  const auto [mine, theirs] = std::ranges::mismatch(text, found);
  const auto offset = static_cast<std::size_t>(mine - text.begin());
  if (offset == text.size() && offset == found.size()) {
    return std::nullopt;
  }
  const std::size_t begin = text.substr(0, offset).rfind('\n') + 1;  // npos + 1 is 0
  const auto number = std::ranges::count(text.substr(0, begin), '\n') + 1;
  const std::string row = expected.row_at(begin);
  const std::string place = row.empty() ? fmt::format("line {}", number) : fmt::format("{} (line {})", row, number);
  const std::string_view is = line_at(found, begin);
  const std::string_view should_be = line_at(text, begin);
  const std::size_t column = offset - begin;
  if (begin == found.size()) {
    return fmt::format("{} is missing: {}", place, excerpt(should_be, column));
  }
  if (begin == text.size()) {
    return fmt::format("{} is too much: {}", place, excerpt(is, column));
  }
  if (is == should_be) {
    return fmt::format("{} does not end", place);
  }
  return fmt::format("{} differs: {} should be {}", place, excerpt(is, column), excerpt(should_be, column));
}

}  // namespace goishi::cli
