#pragma once
/// \file
/// Who is raced: one interface for what the library ships and for Odeint's steppers.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verify/work_precision/problem.hpp"

namespace goishi::verify::bench {

enum class Family { ours, odeint };
enum class Kind {
  step,        // setting: the number of equal steps
  tolerance,   // setting: the tolerance, relative and absolute
  closed_form  // one call, no setting
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

/// One contestant on one problem.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// From the start to the end. This alone is timed.
  virtual void run(double setting) = 0;
  /// Of the last run.
  [[nodiscard]] virtual Outcome outcome() const = 0;
};

struct Contestant {
  std::string name;   // "runge-kutta-4", for the CSV file
  std::string label;  // for people
  Family family;
  Kind kind;
  bool needs_symmetry;
  std::function<std::unique_ptr<Solver>(const Problem&)> enter;

  /// Of the closed forms the one that is meant for the body: for a symmetric one the elliptic flight is the exact flight.
  [[nodiscard]] bool can_enter(const Problem& problem) const {
    return kind == Kind::closed_form ? needs_symmetry == problem.is_symmetric()
                                     : !needs_symmetry || problem.is_symmetric();
  }
};

[[nodiscard]] std::vector<Contestant> our_contestants();
/// In double, on the raw Newton–Euler equations of (q_WB, ω_B), with (p_WB, v_WB) where the problem has them.
[[nodiscard]] std::vector<Contestant> odeint_contestants();
[[nodiscard]] const std::vector<Contestant>& contestants();

/// What an outcome is worth. NaN where the run did not complete.
struct Errors {
  double attitude;  // angle of the rotation from the right attitude to the one found [rad]
  double energy;    // relative to the kinetic energy at the start
  double momentum;  // of |L|, relative
};

/// In 34 digits, so that only the contestant's own error counts. A quaternion off the unit sphere is normalised first.
[[nodiscard]] Errors errors_of(const Outcome& outcome, const Problem& problem, const Reference& reference);

}  // namespace goishi::verify::bench
