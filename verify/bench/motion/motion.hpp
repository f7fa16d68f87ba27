#pragma once
/// \file
/// The motions on which steppers and closed forms are raced, with the right end of each.

#include <array>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <string>
#include <vector>

#include "verify/bench/race.hpp"
#include "verify/oracles/motion/free_body.hpp"

namespace goishi::verify::bench::motion {

/// A body in free flight. Moments and angular velocity have no more than 24 bits each, so L = I ω is exact in double:
/// who integrates L and who integrates ω start from the same motion. The attitude at the start is the identity.
struct Motion {
  std::string name, title;
  RigidBody<double> body;
  Vec3<double> spin_B;  // ω at the start [rad/s]
  State<double> start;
  Vec3<double> gravity;
  double duration;  // [s], an integer: dividing it by a power of two is exact
  Freedom freedom;  // `angular`: nothing but the rotation is integrated, by anyone

  // The right answer, and what must not have changed.
  std::array<Quad, 4> attitude = {};  // w, x, y, z at the end
  Quad energy = 0;                    // of the start, with that of place in gravity [J]
  Quad kinetic = 0;                   // of the start: what an error in energy is measured against [J]
  Quad momentum = 0;                  // |L| [kg m²/s]

  [[nodiscard]] bool is_symmetric() const { return body.moments.x() == body.moments.y(); }
};

/// Where a run ended, as the contestant holds it; made after the clock has stopped.
struct Outcome {
  bool completed = false;
  std::uint64_t work = 0;  // steps; for Odeint evaluations of the equations of motion
  Vec3<double> p_WB;
  Vec3<double> v_WB;
  Quat<double> q_WB;        // of any length
  bool holds_spin = false;  // the rotation is ω_B, else L_W
  Vec3<double> rotation;
};

/// What it is worth: attitude, energy and |L|, and the work. In 34 digits, so that only the contestant's own error
/// counts. A quaternion off the unit sphere is normalised first.
[[nodiscard]] std::vector<double> judge(const Outcome& outcome, const Motion& motion);

/// `fly()` flies, `read` makes an outcome of what it returns.
template <class Fly, class Read>
[[nodiscard]] Entry make_flight(const Motion& motion, Fly fly, Read read) {
  Entry entry = make_entry(
      1, [fly](std::size_t /*the only case*/) mutable { return fly(); },
      [&motion, read](const auto& ends) { return judge(read(ends.front()), motion); });
  entry.items = motion.duration;
  return entry;
}

[[nodiscard]] std::vector<Contestant<Motion>> our_contestants();
/// In double, on the raw Newton–Euler equations of (q_WB, ω_B), with (p_WB, v_WB) where the problem has them.
[[nodiscard]] std::vector<Contestant<Motion>> odeint_contestants();

/// The exact flight of many stones, one by one and in a SIMD batch.
[[nodiscard]] Problem flight();

[[nodiscard]] Subject subject();

}  // namespace goishi::verify::bench::motion
