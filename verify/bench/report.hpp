#pragma once
/// \file
/// What a bench measured, and its reports.

#include <optional>
#include <string>
#include <vector>

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
/// One line a point. SI units, times in nanoseconds; `nan` where there was no answer, empty what a race does not have.
[[nodiscard]] std::string csv_report(const Bench& bench);

/// Nanoseconds for people: "15.5 ns", "6.33 µs", "7.24 ms".
[[nodiscard]] std::string time_text(double nanoseconds);
/// "FCL, hull of 256 points".
[[nodiscard]] std::string point_name(const Who& who, double setting);
/// "3.1e-5 m", "3".
[[nodiscard]] std::string value_text(const Quantity& quantity, double value);

}  // namespace goishi::verify::bench
