#include "verify/work_precision/timing.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace goishi::verify::bench {

namespace {

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Loop& loop, std::size_t calls) {
  const double start = processor_seconds();
  loop(calls);
  return processor_seconds() - start;
}

/// Linear between the sorted values.
double quantile(const std::vector<double>& sorted, double part) {
  const double at = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

}  // namespace

Batch make_batch(const Loop& loop, double wanted) {
  Batch batch;
  double taken = seconds_of(loop, batch.calls);
  while (taken < wanted) {
    const double factor = std::clamp(1.2 * wanted / std::max(taken, 1e-9), 2.0, 100.0);
    batch.calls = static_cast<std::size_t>(factor * static_cast<double>(batch.calls));
    taken = seconds_of(loop, batch.calls);
  }
  batch.rough = 1e9 * taken / static_cast<double>(batch.calls);
  return batch;
}

double time_batch(const Loop& loop, const Batch& batch) {
  return 1e9 * seconds_of(loop, batch.calls) / static_cast<double>(batch.calls);
}

Timing summary(std::vector<double> each) {
  std::sort(each.begin(), each.end());
  return {.median = quantile(each, 0.5), .lower = quantile(each, 0.25), .upper = quantile(each, 0.75)};
}

Timing time_of(const Loop& loop, const Effort& effort) {
  const Batch batch = make_batch(loop, effort.batch);
  std::vector<double> each;
  for (int i = 0; i < effort.repeats; ++i) {
    each.push_back(time_batch(loop, batch));
  }
  return summary(std::move(each));
}

}  // namespace goishi::verify::bench
