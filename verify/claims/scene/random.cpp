/// SCENE: the random boards of the stress test.

#include <fmt/format.h>

#include <array>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/stress/heaps.hpp"

#ifdef GOISHI_DROP_IN_EVERY_FILE
template class goishi::Scene<double>;  // so that a change of the source reaches the judge
#endif

namespace goishi::verify {

namespace {

// --- SCENE-15

/// What was wrong once: thin stones whose contacts turn fast blew up in a step that was taken again and again.
constexpr std::array<std::uint64_t, 6> once_wrong = {1, 24, 30, 105, 111, 117};

Measurement measure_random(Context& context) {
  Checks checks;
  SceneCounters all;
  std::size_t stones = 0;
  const auto see = [&](const char* check, std::uint64_t seed, std::uint64_t index) {
    const stress::HeapVerdict verdict = stress::judge_heap(seed, index);
    checks[check].see(static_cast<double>(verdict.faults.size()), [&] {
      return fmt::format("{} (goishi-verify stress --of scenes --seed {} --case {})",
                         verdict.faults.empty() ? "sound" : verdict.faults.front(), seed, index);
    });
    stones += verdict.stones;
    all.pair_impacts += verdict.counters.pair_impacts;
    all.stone_steps += verdict.counters.stone_steps;
  };
  for (const std::uint64_t index : once_wrong) {
    see("once wrong", 1, index);
  }
  const std::uint64_t seed = context.random()();
  for (int i = 0; i < context.samples(20, 150); ++i) {
    see("random", seed, static_cast<std::uint64_t>(i));
  }
  return checks.measurement({{"stones, impacts of two, steps of stones in clusters",
                              fmt::format("{}, {}, {}", stones, all.pair_impacts, all.stone_steps)}});
}

}  // namespace

std::vector<Claim> scene_random_claims() {
  return {
      {.id = "SCENE-15",
       .statement =
           "Random boards with 2 to 50 stones of any shape, over edges and corners, with blows, hands and tilts: no "
           "NaN, "
           "nothing goes through anything, no energy from nothing, overlaps are refused, and nothing else, an end, "
           "within a budget of work.",
       .function = "Scene",
       .family = OracleFamily::invariant,
       .oracle = "the stress test's judge: gaps and energy 60 times a second, the refusals' own gaps",
       .checks = {none("random", "faults"), none("once wrong", "faults")},
       .measure = measure_random},
  };
}

}  // namespace goishi::verify
