#pragma once
/// \file
/// What the exact flight costs: one stone at a time, and many in a SIMD batch.

#include <optional>

#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench {

inline constexpr std::size_t few_stones = 1024;      // stay in the cache
inline constexpr std::size_t many_stones = 100'000;  // come from memory, or from a large cache

/// Nanoseconds per stone.
struct FlightSpeed {
  Timing scalar_few;  // `free_flight`, one stone after the other, their rates kept
  Timing scalar_many;
  std::optional<Timing> batch_few;  // `StoneBatch::fly`; nothing where the processor lacks what it was compiled for
  std::optional<Timing> batch_many;
  std::size_t lanes = 0;
};

/// Throws std::runtime_error when batch and scalar do not agree: speed is of no interest then.
[[nodiscard]] FlightSpeed measure_flight_speed(const Effort& effort);

}  // namespace goishi::verify::bench
