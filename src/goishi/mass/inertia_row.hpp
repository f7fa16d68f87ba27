#pragma once
/// \file
/// The inertia of one of the catalogue's stones by the talk's standard, looked up.

#include <goishi/error.hpp>
#include <goishi/mass/inertia_table.hpp>
#include <goishi/shape/catalogue.hpp>

namespace goishi {

/// The table's row of a stone by its number, colour and bevel   [m]: certified values, as a constant expression too.
/// Domain  a number of the catalogue; bevel 0 (sharp) or 0.001; else InvalidArgument.
[[nodiscard]] constexpr const InertiaRow& inertia_row(int number, StoneColor color, double bevel = 0) {
  const InertiaRow* of_number = nullptr;
  for (const InertiaRow& row : inertia_table) {
    if (row.number == number && row.color == color) {
      of_number = &row;
      if (row.bevel == bevel) {
        return row;
      }
    }
  }
  if (of_number == nullptr) {
    static_cast<void>(catalogue_stone(number, color));  // says which numbers there are
  }
  throw_invalid("bevel", bevel, "must be 0 or ", metres<double>(catalogue::table_bevel), ": the table has no other");
}

}  // namespace goishi
