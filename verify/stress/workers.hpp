#pragma once
/// \file
/// Many cases on several threads, each judged; somebody watches the time.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <mutex>
#include <thread>
#include <vector>

namespace goishi::verify::stress {

struct Order {
  std::uint64_t seed = 1;
  std::uint64_t samples = 1000;
  double seconds = 0.0;  // stop after so long; 0: never
  unsigned threads = 1;
};

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

}  // namespace goishi::verify::stress
