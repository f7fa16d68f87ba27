#pragma once
/// \file
/// A promise about run time, and what the reports show times with.

#include <string>

#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench {

/// What the library promises about run time or error, beside what was measured.
struct Bar {
  std::string name;
  std::string wanted;
  std::string measured;
  bool held;
};

/// Nanoseconds for people: "15.5 ns", "6.33 µs", "7.24 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

/// "15.5 ns (15.3 … 15.9)": the median and the quartiles.
[[nodiscard]] std::string with_spread(const Timing& time);

}  // namespace goishi::verify::bench
