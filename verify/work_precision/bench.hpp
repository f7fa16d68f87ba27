#pragma once
/// \file
/// The whole race: every contestant on every problem, the speed of the exact flight, and the bars.

#include <functional>
#include <string>
#include <vector>

#include "verify/report/report.hpp"
#include "verify/work_precision/curve.hpp"
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
  double seconds = 0;
};

/// `done` is told how many rounds of measurements are over, of how many.
[[nodiscard]] Bench run_bench(const std::vector<const Problem*>& problems, const Effort& effort, const Stamp& stamp,
                              const std::function<void(std::size_t, std::size_t)>& done);

/// What the library promises about run time, beside what was measured.
struct Bar {
  std::string name;
  std::string wanted;
  std::string measured;
  bool held;
};
[[nodiscard]] std::vector<Bar> bars_of(const Bench& bench);

/// At which errors the tables compare: these powers of ten.
inline constexpr int compared_errors[] = {-2, -4, -6, -8, -10, -12};

/// Nanoseconds for people: "15.5 ns", "6.33 µs", "7.24 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

[[nodiscard]] std::string text_report(const Bench& bench);
[[nodiscard]] std::string csv_report(const Bench& bench);
/// Of the page.
[[nodiscard]] Section page_section(const Bench& bench);

}  // namespace goishi::verify::bench
