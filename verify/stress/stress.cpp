#include "verify/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace goishi::verify::stress {

namespace {

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
  Tally tally;
  tally.seconds = work_through(
      order, [&](std::uint64_t index) { return judge_index(order.seed, index); },
      [&](std::uint64_t index, const Verdict& verdict, double seconds) {
        add(tally, index, verdict, seconds);
        progress(tally.samples);
      },
      overdue);
  std::sort(tally.failures.begin(), tally.failures.end(),
            [](const Failure& a, const Failure& b) { return a.index < b.index; });
  return tally;
}

}  // namespace goishi::verify::stress
