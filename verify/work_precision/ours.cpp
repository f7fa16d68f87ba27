#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/steppers.hpp>

#include "verify/work_precision/contestant.hpp"

namespace goishi::verify::bench {

namespace {

Outcome outcome_of(const State<double>& end, bool completed, std::uint64_t work) {
  return {.completed = completed,
          .work = work,
          .p_WB = end.p_WB,
          .v_WB = end.v_WB,
          .q_WB = end.q_WB,
          .holds_spin = false,
          .rotation = end.L_W};
}

class SteppedFlight final : public Solver {
 public:
  SteppedFlight(Scheme scheme, const Problem& problem)
      : stepper_(scheme, problem.body, problem.gravity, problem.freedom),
        start_(problem.start),
        duration_(problem.duration) {}

  void run(double setting) override {
    steps_ = static_cast<std::int64_t>(setting);
    end_ = stepper_.advance(start_, duration_ / setting, steps_);
  }

  [[nodiscard]] Outcome outcome() const override {
    return outcome_of(end_.state, end_.status == StepStatus::completed && end_.steps == steps_,
                      static_cast<std::uint64_t>(end_.steps));
  }

 private:
  Stepper<double> stepper_;
  State<double> start_;
  double duration_;
  std::int64_t steps_ = 0;
  Stepped<double> end_;
};

template <class Fly>
class ClosedForm final : public Solver {
 public:
  ClosedForm(const Problem& problem, Fly fly) : problem_(problem), fly_(fly) {}

  void run(double) override { end_ = fly_(problem_); }
  [[nodiscard]] Outcome outcome() const override { return outcome_of(end_, true, 1); }

 private:
  Problem problem_;
  Fly fly_;
  State<double> end_;
};

template <class Fly>
Contestant closed_form(const char* name, const char* label, bool needs_symmetry, Fly fly) {
  return {.name = name,
          .label = label,
          .family = Family::ours,
          .kind = Kind::closed_form,
          .needs_symmetry = needs_symmetry,
          .enter = [fly](const Problem& problem) { return std::make_unique<ClosedForm<Fly>>(problem, fly); }};
}

Contestant stepped(Scheme scheme, const char* label) {
  return {.name = std::string(info(scheme).name),
          .label = label,
          .family = Family::ours,
          .kind = Kind::step,
          .needs_symmetry = info(scheme).needs_symmetry,
          .enter = [scheme](const Problem& problem) { return std::make_unique<SteppedFlight>(scheme, problem); }};
}

State<double> exact(const Problem& problem) {
  const Vec3<double>& moments = problem.body.moments;
  return free_flight(problem.start, Moments<double>{.axial = moments.z(), .transverse = moments.x()}, problem.gravity,
                     problem.duration, problem.freedom);
}

const char* label_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::published:
      return "published loop";
    case Scheme::explicit_euler:
      return "explicit Euler";
    case Scheme::exponential_euler:
      return "exponential Euler";
    case Scheme::implicit_midpoint:
      return "implicit midpoint";
    case Scheme::runge_kutta_4:
      return "Runge–Kutta 4";
    case Scheme::splitting_2:
      return "splitting 2";
    case Scheme::splitting_4:
      return "splitting 4";
    case Scheme::splitting_6:
      return "splitting 6";
    case Scheme::exact:
      break;
  }
  return "exact";
}

}  // namespace

std::vector<Contestant> our_contestants() {
  std::vector<Contestant> result = {
      closed_form("exact", "exact flight", true, exact),
      closed_form("elliptic", "elliptic flight", false,
                  [](const Problem& p) { return elliptic_flight(p.start, p.body, p.gravity, p.duration, p.freedom); }),
  };
  for (const SchemeInfo& one : schemes) {
    if (one.scheme != Scheme::exact) {  // one step of it is the exact flight
      result.push_back(stepped(one.scheme, label_of(one.scheme)));
    }
  }
  return result;
}

}  // namespace goishi::verify::bench
