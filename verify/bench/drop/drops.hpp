#pragma once
/// \file
/// The drops that are timed: size 33, bevel 1 mm, let go 5 cm over the plane, in random attitude, with a random spin of
/// up to 30 rad/s. Restitution, friction and resistance are the defaults.

#include <goishi/mass/inertia.hpp>
#include <memory>
#include <string>
#include <vector>

#include "compiled/drop.hpp"
#include "verify/bench/race.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench::drops {

struct Scene {
  Stone<double> stone;
  MassProperties<double> mass;
  RigidBody<double> body;
  std::vector<State<double>> starts;

  [[nodiscard]] DropResult<double> fall(std::size_t i, const DropSettings<double>& settings = {}) const {
    return goishi::drop(stone, body, starts[i], settings);
  }
};
[[nodiscard]] std::shared_ptr<const Scene> make_scene(const Effort& effort);

inline constexpr double reference_tolerance = 1e-12;  // of the runs that errors are taken against

/// The median of f(value) over some.
template <class Values, class F>
[[nodiscard]] double median_of(const Values& values, F f) {
  std::vector<double> numbers;
  for (const auto& value : values) {
    numbers.push_back(static_cast<double>(f(value)));
  }
  return quantile(numbers, 0.5);
}

/// From flight to rest at each tolerance; ten thousand elastic bounces; single impacts.
[[nodiscard]] std::vector<Problem> whole_drops();

/// What a drop does not do where a scene does not need it, and what doing it would cost.
[[nodiscard]] std::vector<Problem> skipped_work();

/// The talk's loop beside the drop, on the same drops and under the same rules.
[[nodiscard]] std::vector<Problem> published_loops();

[[nodiscard]] Subject subject();

}  // namespace goishi::verify::bench::drops
