#pragma once
/// \file
/// The part of drops in the bench: what is measured, and in its reports.

#include <functional>
#include <string>
#include <vector>

#include "verify/report/report.hpp"
#include "verify/work_precision/bar.hpp"
#include "verify/work_precision/drop/race.hpp"
#include "verify/work_precision/drop/skips.hpp"
#include "verify/work_precision/drop/speed.hpp"

namespace goishi::verify::bench::drops {

inline constexpr const char* name = "drop";
inline constexpr const char* title = "A stone from flight to rest, what is skipped, and the talk's loop beside it";
inline constexpr std::size_t rounds = 3;

struct Measured {
  Speed speed;
  std::vector<Skip> skips;
  std::vector<Race> races;
};

/// `round_done` is called `rounds` times.
[[nodiscard]] Measured measure(const Effort& effort, const std::function<void()>& round_done);

void add_bars(const Measured& measured, std::vector<Bar>& bars);
[[nodiscard]] std::string text_tables(const Measured& measured);
/// In columns of their own after those of `csv_report`'s motion and contact: see `csv_columns`.
[[nodiscard]] std::string csv_rows(const Measured& measured);
inline constexpr const char* csv_columns =
    "ns_per_drop,ns_per_drop_q1,ns_per_drop_q3,ns_per_drop_p90,median_place_error_m,p90_place_error_m";
[[nodiscard]] std::vector<Section> page_parts(const Measured& measured);

}  // namespace goishi::verify::bench::drops
