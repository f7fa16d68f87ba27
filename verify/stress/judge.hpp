#pragma once
/// \file
/// What every drop has to keep, whatever the stone, the law and the start.

#include <string>
#include <vector>

#include "verify/stress/scene.hpp"

namespace goishi::verify::stress {

struct Verdict {
  std::vector<std::string> faults;  // none: the drop is sound
  DropStatus status = DropStatus::not_converged;
  bool lower_order = false;
  double energy_rise = 0.0;  // greatest between two events, over what the tolerance allows
  double depth = 0.0;        // [width] the deepest seen
};

/// Judges a drop: no NaN, times in order, no tunnelling (at every event, along every flight, and on a board in contact),
/// energy never rises by more than the contact phase's tolerance, and a status that is true: what rests does rest, and goes
/// on resting; what moves has run out of time; what gave up had the reason that it names.
[[nodiscard]] Verdict judge(const Scene& scene, const DropResult<double>& drop);

}  // namespace goishi::verify::stress
