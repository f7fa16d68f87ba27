#include "verify/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <mutex>
#include <thread>

namespace goishi::verify::stress {

namespace {

using Clock = std::chrono::steady_clock;

/// Processor time of this thread, which other programs do not lengthen   [s].
double busy_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_since(Clock::time_point start) {
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

void add(Tally& tally, std::uint64_t index, const Verdict& verdict, double seconds) {
  ++tally.samples;
  ++tally.by_status[static_cast<std::size_t>(verdict.status)];
  tally.lower_order += verdict.lower_order ? 1 : 0;
  tally.energy_rise = std::max(tally.energy_rise, verdict.energy_rise);
  tally.depth = std::max(tally.depth, verdict.depth);
  if (tally.slowest < seconds) {
    tally.slowest = seconds;
    tally.slowest_index = index;
  }
  if (!verdict.faults.empty()) {
    tally.failures.push_back({index, verdict.faults.front()});
  } else if (long_drop < seconds) {
    tally.failures.push_back({index, fmt::format("takes {:.2f} s", seconds)});
  }
}

}  // namespace

Verdict judge_index(std::uint64_t seed, std::uint64_t index) {
  try {
    const Scene scene = draw_scene(seed, index);
    return judge(scene, run(scene));
  } catch (const std::exception& error) {
    Verdict verdict;
    verdict.faults.push_back(fmt::format("throws: {}", error.what()));
    return verdict;
  }
}

Tally run_stress(const Order& order, const std::function<void(std::uint64_t)>& progress,
                 const std::function<void(std::uint64_t)>& overdue) {
  const Clock::time_point start = Clock::now();
  Tally tally;
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
      const Verdict verdict = judge_index(order.seed, index);
      const double seconds = busy_seconds() - before;
      desk.end();
      const std::lock_guard lock(mutex);
      add(tally, index, verdict, seconds);
      progress(tally.samples);
    }
    --working;
  };
  std::vector<std::jthread> workers;
  for (Desk& desk : desks) {
    workers.emplace_back(work, std::ref(desk));
  }
  while (0 < working) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (Desk& desk : desks) {
      const std::lock_guard lock(desk.mutex);
      if (desk.busy && longest_drop < seconds_since(desk.since)) {
        overdue(desk.index);
      }
    }
  }
  workers.clear();
  std::sort(tally.failures.begin(), tally.failures.end(),
            [](const Failure& a, const Failure& b) { return a.index < b.index; });
  tally.seconds = seconds_since(start);
  return tally;
}

}  // namespace goishi::verify::stress
