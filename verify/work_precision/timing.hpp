#pragma once
/// \file
/// How long a call takes, on a machine that others use too: processor time of the thread, not the clock on the wall.

#include <functional>
#include <vector>

namespace goishi::verify::bench {

/// How much time is spent on measuring.
struct Effort {
  double batch;       // a call is repeated until all together take this long [s]
  int repeats;        // of the batch: the median and the quartiles are over these
  double dearest;     // a curve of a motion ends when a single run takes longer [s]
  std::size_t poses;  // that contact is asked about: a power of two, more than a branch predictor learns by heart
};
inline constexpr Effort quick_effort{.batch = 0.4e-3, .repeats = 5, .dearest = 5e-3, .poses = 512};
inline constexpr Effort report_effort{.batch = 1e-3, .repeats = 5, .dearest = 20e-3, .poses = 1024};
inline constexpr Effort full_effort{.batch = 2e-3, .repeats = 7, .dearest = 30e-3, .poses = 1024};

/// The median of the repeats, and the quartiles about it.
struct Timing {
  double median = 0;
  double lower = 0;
  double upper = 0;

  [[nodiscard]] Timing per(double count) const { return {median / count, lower / count, upper / count}; }
};

/// Makes the compiler form all of a result, and not only what is read of it.
template <class T>
void keep(const T& result) {
#if defined(__GNUC__)
  asm volatile("" : : "r"(&result) : "memory");
#else
  static const volatile void* volatile kept;
  kept = &result;
#endif
}

using Loop = std::function<void(std::size_t)>;  // makes so many calls

/// How many calls take `wanted` seconds together, and what one took on the way to finding out [ns].
struct Batch {
  std::size_t calls = 1;
  double rough = 0;
};
[[nodiscard]] Batch make_batch(const Loop& loop, double wanted);

/// One batch, in nanoseconds per call.
[[nodiscard]] double time_batch(const Loop& loop, const Batch& batch);

[[nodiscard]] Timing summary(std::vector<double> each);

/// All repeats in a row.
[[nodiscard]] Timing time_of(const Loop& loop, const Effort& effort);

}  // namespace goishi::verify::bench
