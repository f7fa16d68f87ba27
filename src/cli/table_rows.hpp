#pragma once
/// \file
/// The table's content, before it has a format.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <goishi/shape/catalogue.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "properties.hpp"

namespace goishi::cli {

struct TableRow {
  CatalogueStone stone;
  Values values;
};

struct Table {
  std::vector<TableRow> rows;
  Standard standard = Standard::talk;
  UnitSystem units = UnitSystem::si;
  bool density_assumed = true;
  std::string command;  // that makes this table
};

/// A column after number and colour: an index into `quantities`. A wrong key does not compile.
consteval std::size_t column(std::string_view key) {
  const auto* found = std::ranges::find(quantities, key, &Quantity::key);
  return found == quantities.end() ? throw "no such quantity" : static_cast<std::size_t>(found - quantities.begin());
}

inline constexpr std::array<std::size_t, 12> columns = {
    column("bevel"),  column("width"),        column("height"),         column("outer_width"),
    column("volume"), column("surface_area"), column("density"),        column("mass"),
    column("axial"),  column("transverse"),   column("axial_per_mass"), column("transverse_per_mass")};

[[nodiscard]] inline Unit unit_of_column(const Table& table, std::size_t column) {
  return unit_of(quantities[column].dimension, table.units);
}

/// "33 black, bevel 0.001 m"
[[nodiscard]] inline std::string name_of(const TableRow& row) {
  const Number& bevel = row.values[column("bevel")];
  return fmt::format("{} {}, {}", row.stone.number, to_string(row.stone.color),
                     bevel == 0 ? "sharp" : "bevel " + six_digits(bevel) + " m");
}

/// A value of a row in the table's unit.
[[nodiscard]] inline Number cell(const Table& table, const TableRow& row, std::size_t column) {
  return in_unit(row.values[column], unit_of_column(table, column));
}

}  // namespace goishi::cli
