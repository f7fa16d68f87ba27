#pragma once
/// \file
/// How long a call takes, by Google Benchmark: processor time of the thread, so that others may use the machine too.

#include <cstddef>
#include <functional>
#include <vector>

namespace goishi::verify::bench {

/// How much time is spent on measuring.
struct Effort {
  double batch;       // a call is repeated until all together take this long [s]
  int repeats;        // of the batch: the median and the quartiles are over these
  double dearest;     // a curve ends when a single run takes longer [s]
  std::size_t poses;  // that contact is asked about: more than a branch predictor learns by heart
  bool thorough;      // longer curves of drops
};
inline constexpr Effort quick_effort{.batch = 0.4e-3, .repeats = 5, .dearest = 5e-3, .poses = 512, .thorough = false};
inline constexpr Effort report_effort{.batch = 1e-3, .repeats = 5, .dearest = 20e-3, .poses = 1024, .thorough = true};
inline constexpr Effort full_effort{.batch = 2e-3, .repeats = 7, .dearest = 30e-3, .poses = 1024, .thorough = true};

/// The median of many times [ns], the quartiles about it, and the ninetieth percentile.
struct Timing {
  double median = 0;
  double lower = 0;
  double upper = 0;
  double late = 0;
};
[[nodiscard]] Timing summary(const std::vector<double>& times);

/// Of each call, its time in each repeat [ns]. The repeats of all calls take turns at random, so whatever slows the
/// machine for a while slows them all.
[[nodiscard]] std::vector<std::vector<double>> time_by_turns(const std::vector<std::function<void()>>& calls,
                                                             double batch, int repeats);

}  // namespace goishi::verify::bench
