#pragma once
/// \file
/// The talk's loop beside the drop, on the same drops and under the same rules: the published law, no resistance, no
/// damping. Error at the end against run time.

#include <optional>
#include <string>
#include <vector>

#include "verify/oracles/published/loop.hpp"
#include "verify/work_precision/drop/scene.hpp"
#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench::drops {

/// Of all drops of a race.
struct Point {
  double setting = 0;   // tolerance, or step [s]
  Timing time;          // [ns] a drop
  double place = 0;     // [m] median error
  double attitude = 0;  // [rad]
};

struct Curve {
  std::string name;   // for the CSV file
  std::string label;  // for people
  bool ours = false;
  std::vector<Point> points;  // from coarse to fine
};

struct Race {
  std::string name, title;
  std::size_t drops = 0;
  double time = 0;  // [s] simulated, median
  Curve ours;
  std::vector<Curve> loops;
};

/// Where errors are compared: whole drops magnify them.
inline constexpr double compared_place = 1e-5;     // [m]
inline constexpr double compared_attitude = 1e-4;  // [rad]

/// Run time at which both errors are no greater than that   [ns].
struct Cost {
  double time = 0;
  bool reached = true;  // else by the order that the last two points show
};
/// Nothing where the errors do not fall.
[[nodiscard]] std::optional<Cost> cost_of(const Curve& curve);

/// The loop down to steps of that rate [1/s]; a fourth of it where drops are long.
[[nodiscard]] std::vector<Race> run_races(const Scene& scene, double finest_rate, const Effort& effort);

}  // namespace goishi::verify::bench::drops
