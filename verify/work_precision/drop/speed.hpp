#pragma once
/// \file
/// What a drop costs from flight to rest, at each tolerance, beside the error of the place where it rests; ten thousand
/// elastic bounces; single impacts.

#include <string>
#include <vector>

#include "verify/work_precision/drop/scene.hpp"
#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench::drops {

/// All drops of a scene at one tolerance.
struct Level {
  double tolerance = 0;
  Timing time;                       // [ns] median and quartiles over the drops
  double late = 0;                   // [ns] the ninetieth percentile
  double error = 0, late_error = 0;  // [m] of the place of rest, median and ninetieth percentile
  DropCounters counters;             // medians
  std::size_t not_at_rest = 0;
};

/// A law, on random contacts of the stone with the plane.
struct LawSpeed {
  std::string name;
  Timing time;  // [ns]
};

inline constexpr int elastic_bounces = 10'000;
inline constexpr double reference_tolerance = 1e-11;  // of the runs that errors are taken against
inline constexpr double impact_friction = 0.3, impact_restitution = 0.5;

struct Speed {
  std::size_t drops = 0;
  std::vector<Level> levels;  // from coarse to fine
  Timing elastic;             // [ns] for all bounces, over the starts
  double energy_error = 0;    // relative, greatest over the bounces
  std::vector<LawSpeed> laws;
};

/// The median of so many repeats counts, of each drop.
[[nodiscard]] Speed measure_speed(const Scene& scene, const std::vector<double>& tolerances, int repeats,
                                  const Effort& effort);

/// Contacts that approach, about which laws are asked.
struct Contacts {
  std::vector<ImpactBody<double>> bodies;  // a power of two
  std::vector<Vec3<double>> points;
};
[[nodiscard]] Contacts make_contacts(const Scene& scene);

/// One `resolve` after the other   [ns].
[[nodiscard]] Loop impacts(const Contacts& contacts, ImpactLaw law, double friction);

}  // namespace goishi::verify::bench::drops
