#pragma once
/// \file
/// What a scene asks before it asks for a contact: the region of the board, the gap alone, the gaps of many stones.

#include <optional>

#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench::contact {

/// Nanoseconds per stone of size 33, of so many, which stay in the cache.
struct Speed {
  std::size_t stones = 0;
  Timing region;                // `region_of`, over the board, beside it, and above
  Timing gap;                   // `surface_gap`
  std::optional<Timing> batch;  // `PlaneBatch::gaps`; nothing where the processor lacks what it was compiled for
  std::size_t lanes = 0;
};

/// Throws std::runtime_error when batch and scalar do not agree: speed is of no interest then.
[[nodiscard]] Speed measure_speed(const Effort& effort);

}  // namespace goishi::verify::bench::contact
