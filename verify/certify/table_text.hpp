#pragma once
/// \file
/// A printed inertia table, whatever its format, as columns and rows of text.

#include <string>
#include <string_view>
#include <vector>

namespace goishi::verify::certify {

struct Column {
  std::string key;      // of `witness_of`; or "number", "color"
  std::string unit;     // "kg m²"; empty where there is none
  bool printed = true;  // else the marker's command fixes it
};

struct TableText {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
  bool doubles = false;  // each number is a double, as the shortest decimal that reads back to it
};

/// Reads what `goishi table` prints: JSON, C++, CSV, Markdown or text, told apart by how they begin.
/// Throws std::runtime_error that says what is wrong with the text.
[[nodiscard]] TableText read_table(std::string_view text);

/// Reads the Markdown table below the first marker `<!-- goishi table … -->` of a document. The colour and the bevel
/// that the marker's command fixes become columns.
[[nodiscard]] TableText read_marked_table(std::string_view document);

}  // namespace goishi::verify::certify
