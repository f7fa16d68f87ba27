#pragma once
/// \file
/// The table's five formats.

#include "document.hpp"
#include "table_rows.hpp"

namespace goishi::cli {

[[nodiscard]] Document as_text(const Table& table);
[[nodiscard]] Document as_markdown(const Table& table);
[[nodiscard]] Document as_csv(const Table& table);
[[nodiscard]] Document as_json(const Table& table);

/// The header `goishi/mass/inertia_table.hpp`. Domain  a table in SI units.
[[nodiscard]] Document as_cpp(const Table& table);

}  // namespace goishi::cli
