#pragma once
/// \file
/// Random boards with 2 to 50 stones, judged by what every scene has to keep, each with a budget of work.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compiled/scene.hpp"
#include "verify/stress/stress.hpp"

namespace goishi::verify::stress {

/// What is done to a scene, and when.
struct Deed {
  enum class Kind { push, hold, release, remove, tilt };
  Kind kind;
  double time;
  StoneId stone;
  Vec3<double> v, w;      // velocity that a push gives; of a hand; v of a tilt: gravity
  double duration = 0.0;  // of a hand
};

inline constexpr double longest_scene = 1.0;  // [s] in which deeds are done

struct Heap {
  goishi::Scene<double> scene;
  std::vector<Deed> deeds;  // by their times
  int refused = 0;          // starts that overlap something
  bool ends = false;        // friction and resistance bring it to rest
};

/// Stones   of one size, or of several; thin to h/w = 0.02, nearly round, balls; sharp, and with bevels of all sizes.
/// Starts   in layers over the middle, over edges and corners, on top of each other, overlapping (which is to be refused), by
///          themselves beside the board; at rest or thrown, with spins up to 100 rad/s.
/// Laws     e and μ over their ranges with 0 and 1; resistance as usual, more, none; level and tilted gravity.
/// Deeds    blows, hands that take a stone up and let it go, stones taken away, a board that is tilted and laid flat again.
[[nodiscard]] Heap draw_heap(std::uint64_t seed, std::uint64_t index);

struct HeapVerdict {
  std::vector<std::string> faults;  // none: it is sound
  std::size_t stones = 0;
  int refused = 0;
  bool rests = false;
  double energy_rise = 0.0;  // greatest between two frames, over what a cluster's step allows
  double depth = 0.0;        // [width] the deepest seen
  SceneCounters counters;
};

/// Goes on by 1/60 s and judges: no NaN, nothing inside of anything, no energy but from hands and blows, nothing below the
/// floor, a refusal for each overlap and no other, an end, and no more work than its budget.
[[nodiscard]] HeapVerdict judge_heap(std::uint64_t seed, std::uint64_t index);
[[nodiscard]] std::string describe_heap(std::uint64_t seed, std::uint64_t index);

struct HeapTally : Cases {
  std::uint64_t stones = 0, refused = 0, rest = 0;
  SceneCounters counters;
  double energy_rise = 0.0, depth = 0.0;
};

/// Scenes 0 … samples − 1.
[[nodiscard]] HeapTally run_heaps(const Order& order, const std::function<void(std::uint64_t)>& progress,
                                  const std::function<void(std::uint64_t)>& overdue);

}  // namespace goishi::verify::stress
