#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verify/bench/native.hpp"
#include "verify/bench/report.hpp"
#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench {

namespace {

using Row = std::vector<std::string>;

/// The head first; a verdict is a word.
std::vector<Row> rows_of(const Table& table) {
  std::vector<Row> rows = {table.head};
  for (const Table::Row& row : table.rows) {
    rows.push_back(row.cells);
    if (row.holds) {
      rows.back().emplace_back(*row.holds ? "held" : "NOT HELD");
    }
  }
  return rows;
}

/// Words are aligned to the left, and so is every first cell; numbers to the right.
std::string aligned(const Table& table) {
  const std::vector<Row> rows = rows_of(table);
  const bool words = !table.rows.empty() && table.rows.front().holds.has_value();
  std::vector<std::size_t> widths(table.head.size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns(row[i]));
    }
  }
  std::string out = table.caption.empty() ? "" : fmt::format("  {}\n", table.caption);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += "  " + (words || i == 0 ? padded(row[i], widths[i]) : right_aligned(row[i], widths[i]));
    }
    out += "\n";
  }
  return out;
}

}  // namespace

std::string piped(const Table& table) {
  std::vector<Row> rows = rows_of(table);
  rows.insert(rows.begin() + 1, Row(table.head.size(), "---"));
  std::string out = table.caption.empty() ? "" : table.caption + ":\n\n";
  for (const Row& row : rows) {
    out += fmt::format("| {} |\n", fmt::join(row, " | "));
  }
  return out;
}

std::string text_report(const Bench& bench) {
  const Stamp& stamp = bench.stamp;
  std::string out = fmt::format("Medians of processor time.\n{}\n{}\ncommit {}, {}\nSIMD batch compiled for {}\n",
                                stamp.machine, stamp.compiler, stamp.commit, stamp.time,
                                native_level().empty() ? "the compiler's default" : native_level());
  const Section section = page_section(bench);
  for (std::size_t i = 0; i < bench.races.size(); ++i) {
    const Section& part = section.parts[i];
    out += fmt::format("\n{}: {}\n", bench.races[i].name, part.title);
    for (const std::string& line : wrapped(part.paragraphs.front(), 118)) {
      out += fmt::format("  {}\n", line);
    }
    out += aligned(part.tables.front());
  }
  return out + fmt::format("\nBars\n{}\nTook {}\n", aligned(section.tables.front()), duration(bench.seconds));
}

std::string markdown_report(const Bench& bench) {
  const Stamp& stamp = bench.stamp;
  const Section section = page_section(bench);
  std::string out = fmt::format("{}; {}; commit {}, {}.\n\n{}\n\n{}", stamp.machine, stamp.compiler, stamp.commit,
                                stamp.time, fmt::join(section.paragraphs, "\n\n"), piped(section.tables.front()));
  for (const Section& part : section.parts) {
    out += fmt::format("\n## {}\n\n{}\n\n{}", part.title, part.paragraphs.front(), piped(part.tables.front()));
  }
  return out;
}

}  // namespace goishi::verify::bench
