#pragma once
/// \file
/// Error against run time of all contestants on one scene.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/work_precision/contact/contestant.hpp"

namespace goishi::verify::bench::contact {

/// Of the gap [m], over all poses that were answered; of a time of impact, the error times the speed of approach.
struct Errors {
  double greatest = 0;
  double median = 0;
  std::size_t unanswered = 0;
};

struct Point {
  double setting = 0;
  Timing cost;  // [ns] a query
  Errors errors;
};

struct Curve {
  const Contestant* contestant = nullptr;
  std::vector<Point> points;  // from coarse to fine
};

struct Race {
  const Problem* problem = nullptr;
  std::string witness;
  std::size_t poses = 0;
  std::vector<Curve> curves;
};

/// All contestants take turns, round after round. A round of one that is quick asks about the poses again and again, a
/// round of one that is slow about a part of them; after all rounds each was asked about all.
[[nodiscard]] Race run_race(const Scene& scene, const Effort& effort, const std::function<void()>& round_done);

/// By the contestant's name; null if it was not there.
[[nodiscard]] const Curve* curve_named(const Race& race, std::string_view name);

/// "Goishi, double", "FCL, hull of 256 points".
[[nodiscard]] std::string point_name(const Contestant& who, double setting);

}  // namespace goishi::verify::bench::contact
