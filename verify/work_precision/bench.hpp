#pragma once
/// \file
/// The whole race: every contestant on every problem of motion and of contact, the speed of single calls, whole drops,
/// the bars.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/report/report.hpp"
#include "verify/work_precision/bar.hpp"
#include "verify/work_precision/contact/race.hpp"
#include "verify/work_precision/contact/speed.hpp"
#include "verify/work_precision/curve.hpp"
#include "verify/work_precision/drop/drops.hpp"
#include "verify/work_precision/flight_speed.hpp"

namespace goishi::verify::bench {

struct Race {
  const Problem* problem;
  std::string witness;  // who gave the right answer
  std::vector<Curve> curves;
};

struct Bench {
  Stamp stamp;
  std::vector<Race> races;
  FlightSpeed speed;
  std::vector<contact::Race> contact_races;
  contact::Speed contact_speed;
  std::optional<drops::Measured> drops;
  double seconds = 0;
};

/// What is raced.
struct Programme {
  std::vector<const Problem*> motion;
  std::vector<const contact::Problem*> contact;
  bool drops;
};

/// `done` is told how many rounds of measurements are over, of how many.
[[nodiscard]] Bench run_bench(const Programme& programme, const Effort& effort, const Stamp& stamp,
                              const std::function<void(std::size_t, std::size_t)>& done);

[[nodiscard]] std::vector<Bar> bars_of(const Bench& bench);

/// At which errors the tables compare: these powers of ten.
inline constexpr int compared_errors[] = {-2, -4, -6, -8, -10, -12};

[[nodiscard]] std::string text_report(const Bench& bench);
[[nodiscard]] std::string csv_report(const Bench& bench);
/// Of the page.
[[nodiscard]] Section page_section(const Bench& bench);

}  // namespace goishi::verify::bench
