#include "verify/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace goishi::verify::stress {

namespace {

void add(Tally& tally, std::uint64_t index, const Verdict& verdict, double seconds) {
  ++tally.by_status[static_cast<std::size_t>(verdict.status)];
  tally.lower_order += verdict.lower_order ? 1 : 0;
  tally.energy_rise = std::max(tally.energy_rise, verdict.energy_rise);
  tally.depth = std::max(tally.depth, verdict.depth);
  if (verdict.faults.empty() && long_drop < seconds) {
    tally.failures.push_back({index, fmt::format("takes {:.2f} s", seconds)});
  }
}

}  // namespace

Verdict judge_index(std::uint64_t seed, std::uint64_t index) {
  return verdict_of<Verdict>([&] {
    const Scene scene = draw_scene(seed, index);
    return judge(scene, run(scene));
  });
}

Tally run_stress(const Order& order, const std::function<void(std::uint64_t)>& progress,
                 const std::function<void(std::uint64_t)>& overdue) {
  return tally_of<Tally>(
      order, [&](std::uint64_t index) { return judge_index(order.seed, index); }, add, progress, overdue);
}

}  // namespace goishi::verify::stress
