#pragma once
/// \file
/// What a drop does not do where a scene does not need it, and what doing it would cost: each pair measured in one run,
/// by turns.

#include <string>
#include <vector>

#include "verify/work_precision/drop/scene.hpp"
#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench::drops {

struct Skip {
  std::string name;
  std::string ours;     // what is done, with what its counters say
  std::string instead;  // what is not
  Timing time;          // [ns] of ours
  Timing time_instead;  // [ns]

  [[nodiscard]] double worth() const { return time_instead.median / time.median; }
};

[[nodiscard]] std::vector<Skip> measure_skips(const Scene& scene, const Effort& effort);

}  // namespace goishi::verify::bench::drops
