#pragma once
/// \file
/// Many cases on several threads, each judged; somebody watches the time.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace goishi::verify::stress {

struct Order {
  std::uint64_t seed = 1;
  std::uint64_t samples = 1000;
  double seconds = 0.0;  // stop after so long; 0: never
  unsigned threads = 1;
};

struct Failure {
  std::uint64_t index;
  std::string fault;
};

/// What is counted of cases of any kind.
struct Cases {
  std::uint64_t samples = 0;
  double slowest = 0.0;  // [s]
  std::uint64_t slowest_index = 0;
  double seconds = 0.0;  // for all
  std::vector<Failure> failures;

  void count(std::uint64_t index, const std::vector<std::string>& faults, double took) {
    ++samples;
    if (slowest < took) {
      slowest = took;
      slowest_index = index;
    }
    if (!faults.empty()) {
      failures.push_back({index, faults.front()});
    }
  }
};

/// A verdict, by `judge`; what that throws is a fault.
template <class Verdict, class Judge>
[[nodiscard]] Verdict verdict_of(Judge&& judge) {
  try {
    return judge();
  } catch (const std::exception& error) {
    Verdict verdict;
    verdict.faults.push_back(std::string("throws: ") + error.what());
    return verdict;
  }
}

/// A case that runs for longer than this is a failure of its own: the test names it and stops the program.
inline constexpr double longest_case = 60.0;  // [s]

namespace workers {

using Clock = std::chrono::steady_clock;

/// Processor time of this thread, which other programs do not lengthen   [s].
inline double busy_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a worker is busy with, for the one who watches the time.
struct Desk {
  std::mutex mutex;
  std::uint64_t index = 0;
  Clock::time_point since;
  bool busy = false;

  void begin(std::uint64_t next) {
    const std::lock_guard lock(mutex);
    index = next;
    since = Clock::now();
    busy = true;
  }
  void end() {
    const std::lock_guard lock(mutex);
    busy = false;
  }
};

}  // namespace workers

/// Cases 0 … samples − 1: `judge(index)`, and what comes of it to `add(index, verdict, busy seconds)`, one at a time;
/// `overdue` gets the index of a case that does not end. How long all took   [s].
template <class Judge, class Add, class Overdue>
double work_through(const Order& order, Judge&& judge, Add&& add, Overdue&& overdue) {
  using namespace workers;
  const Clock::time_point start = Clock::now();
  std::mutex mutex;
  std::atomic<std::uint64_t> next{0};
  std::atomic<unsigned> working{order.threads};
  std::vector<Desk> desks(order.threads);
  const auto work = [&](Desk& desk) {
    while (order.seconds <= 0.0 || seconds_since(start) < order.seconds) {
      const std::uint64_t index = next++;
      if (order.samples <= index) {
        break;
      }
      desk.begin(index);
      const double before = busy_seconds();
      const auto verdict = judge(index);
      const double seconds = busy_seconds() - before;
      desk.end();
      const std::lock_guard lock(mutex);
      add(index, verdict, seconds);
    }
    --working;
  };
  std::vector<std::jthread> threads;
  for (Desk& desk : desks) {
    threads.emplace_back(work, std::ref(desk));
  }
  while (0 < working) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (Desk& desk : desks) {
      const std::lock_guard lock(desk.mutex);
      if (desk.busy && longest_case < seconds_since(desk.since)) {
        overdue(desk.index);
      }
    }
  }
  threads.clear();
  return seconds_since(start);
}

/// The same as a tally: its cases, and what `add(tally, index, verdict, busy seconds)` counts besides. `progress` is told how many
/// are done.
template <class Tally, class Judge, class Add, class Progress, class Overdue>
[[nodiscard]] Tally tally_of(const Order& order, Judge&& judge, Add&& add, Progress&& progress, Overdue&& overdue) {
  Tally tally;
  tally.seconds = work_through(
      order, judge,
      [&](std::uint64_t index, const auto& verdict, double seconds) {
        tally.count(index, verdict.faults, seconds);
        add(tally, index, verdict, seconds);
        progress(tally.samples);
      },
      overdue);
  std::sort(tally.failures.begin(), tally.failures.end(),
            [](const Failure& a, const Failure& b) { return a.index < b.index; });
  return tally;
}

}  // namespace goishi::verify::stress
