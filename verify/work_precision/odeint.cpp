/// Odeint's steppers on the raw Newton–Euler equations. All of Odeint's templates are instantiated here, and only here.

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

#include "verify/work_precision/contestant.hpp"

namespace goishi::verify::bench {

namespace {

namespace odeint = boost::numeric::odeint;

/// A tolerance below round-off can make a controlled stepper go on for ever.
constexpr std::uint64_t most_evaluations = 5'000'000;
struct TooDear : std::runtime_error {
  TooDear() : std::runtime_error("too many evaluations") {}
};

/// (q_w, q_x, q_y, q_z, ω_x, ω_y, ω_z), and where the body flies (p, v).
template <bool flies>
using Values = std::array<double, flies ? 13 : 7>;

/// q̇ = ½ q (0, ω), I ω̇ = I ω × ω, ṗ = v, v̇ = g; the quotients of the moments are formed once.
template <bool flies>
class Motion {
 public:
  explicit Motion(const Problem& problem)
      : gyroscopic_{(problem.body.moments.y() - problem.body.moments.z()) / problem.body.moments.x(),
                    (problem.body.moments.z() - problem.body.moments.x()) / problem.body.moments.y(),
                    (problem.body.moments.x() - problem.body.moments.y()) / problem.body.moments.z()},
        gravity_{problem.gravity.x(), problem.gravity.y(), problem.gravity.z()} {}

  void operator()(const Values<flies>& at, Values<flies>& rate, double /*time*/) {
    if (++evaluations > most_evaluations) {
      throw TooDear();
    }
    const auto [w, x, y, z] = std::array{at[0], at[1], at[2], at[3]};
    const auto [a, b, c] = std::array{at[4], at[5], at[6]};
    rate[0] = -0.5 * (x * a + y * b + z * c);
    rate[1] = 0.5 * (w * a + y * c - z * b);
    rate[2] = 0.5 * (w * b + z * a - x * c);
    rate[3] = 0.5 * (w * c + x * b - y * a);
    rate[4] = gyroscopic_[0] * b * c;
    rate[5] = gyroscopic_[1] * c * a;
    rate[6] = gyroscopic_[2] * a * b;
    if constexpr (flies) {
      for (std::size_t i = 0; i < 3; ++i) {
        rate[7 + i] = at[10 + i];
        rate[10 + i] = gravity_[i];
      }
    }
  }

  std::uint64_t evaluations = 0;

 private:
  std::array<double, 3> gyroscopic_;
  std::array<double, 3> gravity_;
};

template <bool flies>
Values<flies> start_of(const Problem& problem) {
  const Quat<double>& q = problem.start.q_WB;
  const Vec3<double>& w = problem.spin_B;
  Values<flies> values{q.w(), q.x(), q.y(), q.z(), w.x(), w.y(), w.z()};
  if constexpr (flies) {
    for (int i = 0; i < 3; ++i) {
      values[static_cast<std::size_t>(7 + i)] = problem.start.p_WB[i];
      values[static_cast<std::size_t>(10 + i)] = problem.start.v_WB[i];
    }
  }
  return values;
}

struct RungeKutta4 {
  template <bool flies>
  static void integrate(Motion<flies>& motion, Values<flies>& values, double duration, double steps) {
    odeint::integrate_n_steps(odeint::runge_kutta4<Values<flies>>(), std::ref(motion), values, 0.0, duration / steps,
                              static_cast<std::size_t>(steps));
  }
};

template <template <class...> class Method>
struct Controlled {
  template <bool flies>
  static void integrate(Motion<flies>& motion, Values<flies>& values, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::make_controlled<Method<Values<flies>>>(tolerance, tolerance), std::ref(motion),
                               values, 0.0, duration, duration / 1024);
  }
};

struct BulirschStoer {
  template <bool flies>
  static void integrate(Motion<flies>& motion, Values<flies>& values, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::bulirsch_stoer<Values<flies>>(tolerance, tolerance), std::ref(motion), values,
                               0.0, duration, duration / 1024);
  }
};

template <class Method, bool flies>
class Integration final : public Solver {
 public:
  explicit Integration(const Problem& problem)
      : motion_(problem), start_(start_of<flies>(problem)), duration_(problem.duration) {}

  void run(double setting) override {
    end_ = start_;
    motion_.evaluations = 0;
    try {
      Method::integrate(motion_, end_, duration_, setting);
      completed_ = true;
    } catch (const std::runtime_error&) {  // Odeint's own: no step is small enough
      completed_ = false;
    }
  }

  [[nodiscard]] Outcome outcome() const override {
    Outcome result{.completed = completed_,
                   .work = motion_.evaluations,
                   .p_WB = Vec3<double>::Zero(),
                   .v_WB = Vec3<double>::Zero(),
                   .q_WB = Quat<double>(end_[0], end_[1], end_[2], end_[3]),
                   .holds_spin = true,
                   .rotation = {end_[4], end_[5], end_[6]}};
    if constexpr (flies) {
      result.p_WB = {end_[7], end_[8], end_[9]};
      result.v_WB = {end_[10], end_[11], end_[12]};
    }
    for (const double value : end_) {
      result.completed = result.completed && std::isfinite(value);
    }
    return result;
  }

 private:
  Motion<flies> motion_;
  Values<flies> start_;
  Values<flies> end_{};
  double duration_;
  bool completed_ = false;
};

template <class Method>
Contestant integrated(const char* name, const char* label, Kind kind) {
  return {.name = name,
          .label = label,
          .family = Family::odeint,
          .kind = kind,
          .needs_symmetry = false,
          .enter = [](const Problem& problem) -> std::unique_ptr<Solver> {
            if (problem.freedom == Freedom::angular) {
              return std::make_unique<Integration<Method, false>>(problem);
            }
            return std::make_unique<Integration<Method, true>>(problem);
          }};
}

}  // namespace

std::vector<Contestant> odeint_contestants() {
  return {integrated<RungeKutta4>("odeint-runge-kutta-4", "Odeint Runge–Kutta 4", Kind::step),
          integrated<Controlled<odeint::runge_kutta_dopri5>>("odeint-dopri5", "Odeint Dopri5", Kind::tolerance),
          integrated<Controlled<odeint::runge_kutta_fehlberg78>>("odeint-fehlberg78", "Odeint Fehlberg 7(8)",
                                                                 Kind::tolerance),
          integrated<BulirschStoer>("odeint-bulirsch-stoer", "Odeint Bulirsch–Stoer", Kind::tolerance)};
}

}  // namespace goishi::verify::bench
