#include "verify/certify/table_text.hpp"

#include <fmt/format.h>
#include <rapidjson/document.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace goishi::verify::certify {

namespace {

using Cells = std::vector<std::string>;

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// The parts between separators, trimmed.
Cells split(std::string_view text, std::string_view separator) {
  Cells parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + separator.size();
  }
  return parts;
}

/// The key of a quantity from any of its names.
std::string key_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> names = {{{"size", "number"},
                                                                                   {"outer width", "outer_width"},
                                                                                   {"surface area", "surface_area"},
                                                                                   {"I_a", "axial"},
                                                                                   {"I_t", "transverse"},
                                                                                   {"I_a/m", "axial_per_mass"},
                                                                                   {"I_t/m", "transverse_per_mass"}}};
  const auto* const found = std::ranges::find(names, name, &std::pair<std::string_view, std::string_view>::first);
  return std::string(found == names.end() ? name : found->second);
}

/// "I_a [kg m²]". A head of two quantities, "width × height [cm]", makes two columns, and its cells are split alike.
void add_columns(TableText& table, const std::string& head) {
  const std::size_t bracket = std::min(head.find(" ["), head.size());
  const std::string unit = bracket < head.size() ? head.substr(bracket + 2, head.size() - bracket - 3) : "";
  for (const std::string& name : split(std::string_view(head).substr(0, bracket), " × ")) {
    table.columns.push_back({key_of(name), unit});
  }
}

void add_row(TableText& table, const Cells& cells) {
  Cells row;
  for (const std::string& cell : cells) {
    const Cells parts = split(cell, " × ");
    row.insert(row.end(), parts.begin(), parts.end());
  }
  table.rows.push_back(row);
}

/// The first run of lines that begin with a bar: heads, rule, rows.
TableText read_markdown(std::string_view text) {
  TableText table;
  std::size_t index = 0;
  for (const std::string& line : split(text, "\n")) {
    if (!line.starts_with('|')) {
      if (index == 0) {
        continue;
      }
      break;
    }
    const Cells cells = split(std::string_view(line).substr(1, line.size() - 2), "|");
    if (index == 0) {
      for (const std::string& head : cells) {
        add_columns(table, head);
      }
    } else if (index > 1) {
      add_row(table, cells);
    }
    ++index;
  }
  return table;
}

/// Columns stand two blanks or more apart; names, units, then rows, after an empty line.
TableText read_text(std::string_view text) {
  TableText table;
  const std::size_t begin = text.find("\n\n");
  Cells lines = split(begin == std::string_view::npos ? "" : text.substr(begin + 2), "\n");
  std::erase(lines, "");
  std::vector<Cells> grid;
  for (const std::string& line : lines) {
    Cells cells = split(line, "  ");
    std::erase(cells, "");
    grid.push_back(cells);
  }
  if (grid.size() < 2 || grid[0].size() < grid[1].size()) {
    return table;
  }
  const std::size_t unitless = grid[0].size() - grid[1].size();
  for (std::size_t i = 0; i < grid[0].size(); ++i) {
    table.columns.push_back({key_of(grid[0][i]), i < unitless ? "" : grid[1][i - unitless]});
  }
  table.rows.assign(grid.begin() + 2, grid.end());
  return table;
}

/// "axial_per_mass_m2": the longest quantity that fits in front, then its unit.
Column csv_column(const std::string& head) {
  constexpr std::array<std::string_view, 12> keys = {"axial_per_mass", "transverse_per_mass",
                                                     "outer_width",    "surface_area",
                                                     "bevel",          "width",
                                                     "height",         "volume",
                                                     "density",        "mass",
                                                     "axial",          "transverse"};
  for (const std::string_view key : keys) {
    if (head.starts_with(std::string(key) + "_")) {
      return {std::string(key), head.substr(key.size() + 1)};
    }
  }
  return {head, ""};
}

TableText read_csv(std::string_view text) {
  TableText table;
  for (const std::string& line : split(text, "\n")) {
    if (line.empty()) {
      continue;
    }
    const Cells cells = split(line, ",");
    if (!table.columns.empty()) {
      table.rows.push_back(cells);
      continue;
    }
    for (const std::string& head : cells) {
      table.columns.push_back(csv_column(head));
    }
  }
  return table;
}

/// Numbers stay as they are printed.
TableText read_json(std::string_view text) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseNumbersAsStringsFlag>(text.data(), text.size());
  if (document.HasParseError() || !document.IsObject() || !document.HasMember("units") ||
      !document.HasMember("stones") || !document["stones"].IsArray() || !document["units"].IsObject()) {
    throw std::runtime_error("is not the JSON of an inertia table");
  }
  TableText table;
  table.columns = {{"number", ""}, {"color", ""}};
  for (const auto& [key, unit] : document["units"].GetObject()) {
    table.columns.push_back({key.GetString(), unit.GetString()});
  }
  for (const auto& stone : document["stones"].GetArray()) {
    Cells row;
    if (stone.MemberCount() != table.columns.size()) {
      throw std::runtime_error("has a stone with other quantities than units");
    }
    for (const Column& column : table.columns) {
      row.emplace_back(stone.HasMember(column.key.c_str()) ? stone[column.key.c_str()].GetString() : "");
    }
    table.rows.push_back(row);
  }
  return table;
}

/// Columns from the fields of struct InertiaRow and the units in their comments.
TableText read_cpp(std::string_view text) {
  TableText table{.columns = {}, .rows = {}, .doubles = true};
  for (const std::string& line : split(text, "\n")) {
    for (const std::string type : {"int ", "StoneColor ", "double "}) {
      if (line.starts_with(type) && line.find("; ") != std::string::npos) {
        const std::string key = line.substr(type.size(), line.find(';') - type.size());
        const std::size_t bracket = line.rfind('[');
        const bool has_unit = type == "double " && bracket != std::string::npos;
        table.columns.push_back({key, has_unit ? line.substr(bracket + 1, line.size() - bracket - 2) : ""});
      }
    }
    if (line.starts_with('{') && line.ends_with("},")) {
      Cells cells = split(std::string_view(line).substr(1, line.size() - 3), ",");
      if (1 < cells.size() && cells[1].starts_with("StoneColor::")) {
        cells[1].erase(0, cells[1].rfind(':') + 1);
      }
      table.rows.push_back(cells);
    }
  }
  return table;
}

TableText checked(TableText table) {
  if (table.columns.empty() || table.rows.empty()) {
    throw std::runtime_error("has no inertia table");
  }
  for (const Cells& row : table.rows) {
    if (row.size() != table.columns.size()) {
      throw std::runtime_error(fmt::format("has a row of {} cells below {} heads: {}", row.size(), table.columns.size(),
                                           fmt::join(row, " ")));
    }
  }
  return table;
}

/// A length of the command line, "1mm" or, in metres, "0.001", as a cell below its unit.
void move_unit(std::string& cell, Column& column) {
  const std::size_t unit = cell.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
  if (unit < cell.size()) {
    column.unit = cell.substr(unit);
    cell.erase(unit);
  }
}

}  // namespace

TableText read_table(std::string_view text) {
  if (text.starts_with('{')) {
    return checked(read_json(text));
  }
  if (text.starts_with("#pragma once")) {
    return checked(read_cpp(text));
  }
  if (text.starts_with("number,")) {
    return checked(read_csv(text));
  }
  return checked(text.find("\n|") == std::string_view::npos ? read_text(text) : read_markdown(text));
}

TableText read_marked_table(std::string_view document) {
  constexpr std::string_view mark = "<!-- goishi table ";
  const std::size_t begin = document.find(mark);
  const std::size_t end = begin == std::string_view::npos ? begin : document.find(" -->", begin);
  if (end == std::string_view::npos) {
    throw std::runtime_error(fmt::format("has no marker {}… -->", mark));
  }
  const Cells words = split(document.substr(begin + mark.size(), end - begin - mark.size()), " ");
  TableText table = read_markdown(document.substr(end));
  const auto fix = [&](std::string_view option, const Column& column) {
    const auto found = std::ranges::find(words, option);
    if (found != words.end() && found + 1 != words.end() && *(found + 1) != "both") {
      table.columns.push_back(column);
      for (Cells& row : table.rows) {
        row.push_back(*(found + 1));
      }
    }
  };
  fix("--color", {"color", "", false});
  fix("--bevel", {"bevel", "m", false});
  if (table.columns.back().key == "bevel") {
    for (Cells& row : table.rows) {
      move_unit(row.back(), table.columns.back());
    }
  }
  return checked(table);
}

}  // namespace goishi::verify::certify
