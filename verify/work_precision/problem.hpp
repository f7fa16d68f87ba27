#pragma once
/// \file
/// The motions on which everything is raced, with the right end of each.

#include <array>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <string>
#include <vector>

#include "verify/oracles/motion/free_body.hpp"

namespace goishi::verify::bench {

/// A body in free flight. Moments and angular velocity have no more than 24 bits each, so L = I ω is exact in double:
/// who integrates L and who integrates ω start from the same motion. The attitude at the start is the identity.
struct Problem {
  std::string name;   // "spin", as on the command line
  std::string title;  // for people
  RigidBody<double> body;
  Vec3<double> spin_B;  // ω at the start [rad/s]
  State<double> start;
  Vec3<double> gravity;
  double duration;  // [s], an integer: dividing it by a power of two is exact
  Freedom freedom;  // `angular`: nothing but the rotation is integrated, by anyone

  [[nodiscard]] bool is_symmetric() const { return body.moments.x() == body.moments.y(); }
};

[[nodiscard]] const std::vector<Problem>& problems();

/// The right answer, and what must not have changed.
struct Reference {
  std::array<Quad, 4> attitude;  // w, x, y, z at the end
  Quad energy;                   // of the start, with that of place in gravity [J]
  Quad kinetic;                  // of the start: what an error in energy is measured against [J]
  Quad momentum;                 // |L| [kg m²/s]
  std::string source;            // which witness gave the attitude
};

/// By the closed form in 50 digits for a body with a symmetry axis, by high-order integration in 34 digits for others.
[[nodiscard]] Reference reference_of(const Problem& problem);

}  // namespace goishi::verify::bench
