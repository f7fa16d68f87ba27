#pragma once
/// \file
/// The part of contact in the reports of the bench.

#include <string>
#include <vector>

#include "verify/report/report.hpp"
#include "verify/work_precision/bar.hpp"
#include "verify/work_precision/contact/race.hpp"
#include "verify/work_precision/contact/speed.hpp"

namespace goishi::verify::bench::contact {

void add_bars(const std::vector<Race>& races, const Speed& speed, std::vector<Bar>& bars);

/// Nothing for no races.
[[nodiscard]] std::string text_tables(const std::vector<Race>& races);

/// In the columns of `csv_report`.
[[nodiscard]] std::string csv_rows(const Race& race);

[[nodiscard]] std::string page_paragraph();
[[nodiscard]] Section page_part(const Race& race);

}  // namespace goishi::verify::bench::contact
