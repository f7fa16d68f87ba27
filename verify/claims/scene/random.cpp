/// SCENE: the random boards of the stress test.

#include <fmt/format.h>

#include <array>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/stress/heaps.hpp"

namespace goishi::verify {

namespace {

// --- SCENE-15

/// What was wrong once: thin stones whose contacts turn fast blew up in a step that was taken again and again; impulses that did
/// not settle threw stones up; stones slid into the board's side; the end of a slide on a slope took a million steps.
struct Once {
  std::uint64_t seed, index;
};
constexpr std::array once_wrong = {Once{1, 1},
                                   Once{1, 24},
                                   Once{1, 30},
                                   Once{1, 105},
                                   Once{1, 111},
                                   Once{1, 117},
                                   Once{7, 14},
                                   Once{7, 1285},
                                   Once{7, 1299},
                                   Once{7, 1891},
                                   Once{7, 1984},
                                   Once{7, 2473},
                                   Once{7, 1040},
                                   Once{7, 1351},
                                   Once{7, 1936},
                                   Once{11056155301723908466U, 11},
                                   Once{13350154690961565887U, 15}};

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
  for (const Once& board : once_wrong) {
    see("once wrong", board.seed, board.index);
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
