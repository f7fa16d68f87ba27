#pragma once
/// \file
/// A stone that touches a plane, in Lagrange's coordinates (x, y, θ, φ, ψ) with contact forces as multipliers, integrated
/// by Odeint in long double with event location of its own. Shares no formula, variable or scheme with src/: there the
/// variables are axis and angular momentum in W, the force comes from a contact matrix, the pairs are of lower order.

#include <array>
#include <string>
#include <vector>

#include "verify/oracles/stone/hull.hpp"

namespace goishi::verify {

/// Everything per unit of mass. Euler angles: precession φ about z, tilt θ in (0, π), spin ψ about the axis.
struct TouchingBody {
  using Long = long double;
  enum class Law { dry, slip_proportional, patch };

  Hull<Long> hull;
  Long axial, transverse;  // I_a, I_t   [m²]
  Long gravity;            // downwards   [m/s²]
  Law law = Law::dry;
  Long mu = 0;                                    // infinity: no slip
  Long coefficient = 0;                           // of slip_proportional   [s/m]
  Long patch = 0;                                 // 8 a_c/3π   [m]
  Long creep = 0;                                 // [m/s]
  Long rolling_resistance = 0, pivot_radius = 0;  // [m]
};

/// x, y, θ, φ, ψ, ẋ, ẏ, θ̇, p_φ, p_ψ.
using TouchingState = std::array<long double, 10>;

/// The same by vectors, which no angle is in the way of: place, axis, a point of the equator, the centre's velocity along
/// the plane, angular momentum per mass.
struct TouchingPose {
  std::array<long double, 3> p, u, e;
  std::array<long double, 2> v;
  std::array<long double, 3> L;
};

struct TouchingEvent {
  long double time;
  std::string kind;  // "feature", "slip", "stick"
};

struct TouchingPath {
  TouchingState end;
  TouchingPose pose;  // the same
  std::vector<TouchingEvent> events;
  bool gave_up = false;  // micro-slip, stiff for the explicit pair; or no direction found to slip in
  bool lifted = false;   // the plane would have to pull: the path ends there
  long double time = 0;
};

/// From a start that slips or not, for `duration`. In angles about z, or where the axis is near the vertical about x.
[[nodiscard]] TouchingPath follow(const TouchingBody& body, const TouchingPose& start, long double duration);
[[nodiscard]] TouchingPath follow(const TouchingBody& body, const TouchingState& start, long double duration);

/// Velocity of the contact point   [m/s].
[[nodiscard]] std::array<long double, 2> slip_of(const TouchingBody& body, const TouchingState& state);

/// Height of the centre   [m].
[[nodiscard]] long double height_of(const TouchingBody& body, long double theta);

}  // namespace goishi::verify
