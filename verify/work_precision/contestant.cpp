#include "verify/work_precision/contestant.hpp"

#include <limits>

namespace goishi::verify::bench {

const std::vector<Contestant>& contestants() {
  static const std::vector<Contestant> all = [] {
    std::vector<Contestant> result = our_contestants();
    for (Contestant& other : odeint_contestants()) {
      result.push_back(std::move(other));
    }
    return result;
  }();
  return all;
}

namespace {

Quad angle_between(const std::array<Quad, 4>& right, const Quat<Quad>& found) {
  const Quat<Quad> difference = Quat<Quad>(right[0], right[1], right[2], right[3]).conjugate() * found;
  return 2 * atan2(Quad(difference.vec().norm()), Quad(abs(difference.w())));
}

double relative(const Quad& found, const Quad& right, const Quad& scale) {
  return static_cast<double>(Quad(abs(Quad(found - right)) / scale));
}

}  // namespace

Errors errors_of(const Outcome& outcome, const Problem& problem, const Reference& reference) {
  if (!outcome.completed) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {.attitude = none, .energy = none, .momentum = none};
  }
  const RigidBody<Quad> body{.mass = problem.body.mass, .moments = problem.body.moments.cast<Quad>()};
  State<Quad> end{.p_WB = outcome.p_WB.cast<Quad>(),
                  .q_WB = outcome.q_WB.cast<Quad>().normalized(),
                  .v_WB = outcome.v_WB.cast<Quad>(),
                  .L_W = outcome.rotation.cast<Quad>()};
  if (outcome.holds_spin) {
    end.L_W = formula::angular_momentum_W(end.q_WB, body, end.L_W);
  }
  const Quad energy = formula::energy(end, body, Vec3<Quad>(problem.gravity.cast<Quad>()));
  return {.attitude = static_cast<double>(angle_between(reference.attitude, end.q_WB)),
          .energy = relative(energy, reference.energy, reference.kinetic),
          .momentum = relative(end.L_W.norm(), reference.momentum, reference.momentum)};
}

}  // namespace goishi::verify::bench
