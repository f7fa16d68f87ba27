#pragma once
/// \file
/// Bodies of revolution in flight, by integration of Newton's and Euler's equations (Odeint) in long double, and the
/// first time at which a function of their places changes sign.

#include <array>
#include <functional>
#include <vector>

namespace goishi::verify {

/// A body at t = 0, and its constant acceleration. Attitude (w, x, y, z; body to world; unit), spin ω in B, whose z is
/// the symmetry axis.
struct FlyingBody {
  std::array<long double, 3> p, v, a;
  std::array<long double, 4> attitude;
  std::array<long double, 3> spin;
  long double axial, transverse;  // moments
};

/// Where it is, and where its symmetry axis points, in the world.
struct FlyingPlace {
  std::array<long double, 3> p, u;
};
using FlyingPlaces = std::vector<FlyingPlace>;
using Gap = std::function<long double(const FlyingPlaces&)>;

struct FlyingEvent {
  bool found = false;        // the gap was negative at an instant
  long double time = 0.0L;   // then: where it changes sign, bisected
  long double least = 0.0L;  // the least gap at the instants seen, but for that after the event
};

/// Looks at the gap every `step` until `end`.
[[nodiscard]] FlyingEvent first_event(const std::vector<FlyingBody>& bodies, const Gap& gap, long double end,
                                      long double step);

[[nodiscard]] FlyingPlaces places_at(const std::vector<FlyingBody>& bodies, long double time);

}  // namespace goishi::verify
