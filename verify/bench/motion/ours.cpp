#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/steppers.hpp>

#include "verify/bench/motion/motion.hpp"

namespace goishi::verify::bench::motion {

namespace {

Outcome outcome_of(const State<double>& end, bool completed, std::int64_t work) {
  return {.completed = completed,
          .work = static_cast<std::uint64_t>(work),
          .p_WB = end.p_WB,
          .v_WB = end.v_WB,
          .q_WB = end.q_WB,
          .holds_spin = false,
          .rotation = end.L_W};
}

Contestant<Motion> stepped(Scheme scheme, const char* label) {
  const auto enter = [scheme](const Motion& motion, double step) {
    const auto steps = static_cast<std::int64_t>(motion.duration / step);
    return make_flight(
        motion,
        [stepper = Stepper<double>(scheme, motion.body, motion.gravity, motion.freedom), start = motion.start, step,
         steps] { return stepper.advance(start, step, steps); },
        [steps](const Stepped<double>& end) {
          return outcome_of(end.state, end.status == StepStatus::completed && end.steps == steps, end.steps);
        });
  };
  return {{.name = std::string(info(scheme).name), .label = label, .family = "ours", .kind = Kind::step}, enter};
}

/// Of the closed forms the one that is meant for the body: for a symmetric one the elliptic flight is the exact flight.
template <class Fly>
Contestant<Motion> closed_form(const char* name, const char* label, bool symmetric, Fly fly) {
  return {{.name = name, .label = label, .family = "ours"},
          [fly](const Motion& motion, double /*no setting*/) {
            return make_flight(
                motion, [&motion, fly] { return fly(motion); },
                [](const State<double>& end) { return outcome_of(end, true, 1); });
          },
          [symmetric](const Motion& motion) { return symmetric == motion.is_symmetric(); }};
}

State<double> exact(const Motion& motion) {
  const Vec3<double>& moments = motion.body.moments;
  return free_flight(motion.start, Moments<double>{.axial = moments.z(), .transverse = moments.x()}, motion.gravity,
                     motion.duration, motion.freedom);
}

State<double> elliptic(const Motion& motion) {
  return elliptic_flight(motion.start, motion.body, motion.gravity, motion.duration, motion.freedom);
}

}  // namespace

std::vector<Contestant<Motion>> our_contestants() {
  std::vector<Contestant<Motion>> result = {closed_form("exact", "exact flight", true, exact),
                                            closed_form("elliptic", "elliptic flight", false, elliptic)};
  const std::pair<Scheme, const char*> steppers[] = {{Scheme::published, "published loop"},
                                                     {Scheme::explicit_euler, "explicit Euler"},
                                                     {Scheme::exponential_euler, "exponential Euler"},
                                                     {Scheme::implicit_midpoint, "implicit midpoint"},
                                                     {Scheme::runge_kutta_4, "Runge–Kutta 4"},
                                                     {Scheme::splitting_2, "splitting 2"},
                                                     {Scheme::splitting_4, "splitting 4"},
                                                     {Scheme::splitting_6, "splitting 6"}};
  for (const auto& [scheme, label] : steppers) {
    result.push_back(stepped(scheme, label));
  }
  return result;
}

}  // namespace goishi::verify::bench::motion
