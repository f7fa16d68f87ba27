#pragma once
/// \file
/// What a bench measured, and its reports.

#include <optional>
#include <string>
#include <vector>

#include "verify/bench/history/history.hpp"
#include "verify/bench/race.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify::bench {

struct Bench {
  Stamp stamp;
  std::vector<Race> races;
  double seconds = 0;
};

/// What the library promises about run time or error, beside what was measured.
struct Bar {
  std::string name;
  std::string wanted;
  std::string measured;
  bool held;
};
/// Of what was raced.
[[nodiscard]] std::vector<Bar> bars_of(const Bench& bench);

/// Of the page.
[[nodiscard]] Section page_section(const Bench& bench);
/// The page's tables, for a terminal, and in Markdown.
[[nodiscard]] std::string text_report(const Bench& bench);
[[nodiscard]] std::string markdown_report(const Bench& bench);
/// For verify/bench/README.md, of a whole run: a table for each subject, with the library's own of each problem and
/// the most accurate of the others; no steppers, of which the page has the curves.
inline constexpr const char* document_name = "verify/bench/README.md";
inline constexpr const char* document_part = "costs";
[[nodiscard]] std::string document_text(const Bench& bench);
/// How what stands there does not fit the problems that there are; times and errors are not looked at.
[[nodiscard]] std::vector<std::string> document_differences(std::string_view part);

/// What was measured of earlier commits: of the page, and for the document.
[[nodiscard]] Section history_section(const history::History& all);
inline constexpr const char* history_part = "history";
[[nodiscard]] std::string history_text(const history::History& all);

/// One line a point. SI units, times in nanoseconds; `nan` where there was no answer, empty what a race does not have.
[[nodiscard]] std::string csv_report(const Bench& bench);

/// Nanoseconds for people: "15.5 ns", "6.33 µs", "7.24 ms".
[[nodiscard]] std::string time_text(double nanoseconds);
/// A table in Markdown.
[[nodiscard]] std::string piped(const Table& table);
/// "FCL, hull of 256 points".
[[nodiscard]] std::string point_name(const Who& who, double setting);
/// "3.1e-5 m", "3".
[[nodiscard]] std::string value_text(const Quantity& quantity, double value);

}  // namespace goishi::verify::bench
