/// Odeint's steppers on the raw Newton–Euler equations. All of Odeint's templates are instantiated here, and only here.

#include <algorithm>
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

#include "verify/bench/motion/motion.hpp"

namespace goishi::verify::bench::motion {

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
class Equations {
 public:
  explicit Equations(const Motion& motion)
      : gyroscopic_{(motion.body.moments.y() - motion.body.moments.z()) / motion.body.moments.x(),
                    (motion.body.moments.z() - motion.body.moments.x()) / motion.body.moments.y(),
                    (motion.body.moments.x() - motion.body.moments.y()) / motion.body.moments.z()},
        gravity_{motion.gravity.x(), motion.gravity.y(), motion.gravity.z()} {}

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
Values<flies> start_of(const Motion& motion) {
  const Quat<double>& q = motion.start.q_WB;
  const Vec3<double>& w = motion.spin_B;
  Values<flies> values{q.w(), q.x(), q.y(), q.z(), w.x(), w.y(), w.z()};
  if constexpr (flies) {
    for (int i = 0; i < 3; ++i) {
      values[static_cast<std::size_t>(7 + i)] = motion.start.p_WB[i];
      values[static_cast<std::size_t>(10 + i)] = motion.start.v_WB[i];
    }
  }
  return values;
}

struct RungeKutta4 {
  template <bool flies>
  static void integrate(Equations<flies>& equations, Values<flies>& values, double duration, double step) {
    odeint::integrate_n_steps(odeint::runge_kutta4<Values<flies>>(), std::ref(equations), values, 0.0, step,
                              static_cast<std::size_t>(duration / step));
  }
};

template <template <class...> class Method>
struct Controlled {
  template <bool flies>
  static void integrate(Equations<flies>& equations, Values<flies>& values, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::make_controlled<Method<Values<flies>>>(tolerance, tolerance),
                               std::ref(equations), values, 0.0, duration, duration / 1024);
  }
};

struct BulirschStoer {
  template <bool flies>
  static void integrate(Equations<flies>& equations, Values<flies>& values, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::bulirsch_stoer<Values<flies>>(tolerance, tolerance), std::ref(equations), values,
                               0.0, duration, duration / 1024);
  }
};

template <bool flies>
struct End {
  Values<flies> values;
  std::uint64_t evaluations = 0;
  bool completed = false;
};

template <bool flies>
Outcome outcome_of(const End<flies>& end) {
  const Values<flies>& at = end.values;
  Outcome result{
      .completed = end.completed && std::all_of(at.begin(), at.end(), [](double x) { return std::isfinite(x); }),
      .work = end.evaluations,
      .p_WB = Vec3<double>::Zero(),
      .v_WB = Vec3<double>::Zero(),
      .q_WB = Quat<double>(at[0], at[1], at[2], at[3]),
      .holds_spin = true,
      .rotation = {at[4], at[5], at[6]}};
  if constexpr (flies) {
    result.p_WB = {at[7], at[8], at[9]};
    result.v_WB = {at[10], at[11], at[12]};
  }
  return result;
}

template <class Method, bool flies>
Entry integrated(const Motion& motion, double setting) {
  const auto fly = [equations = Equations<flies>(motion), start = start_of<flies>(motion), duration = motion.duration,
                    setting]() mutable {
    End<flies> end{.values = start};
    equations.evaluations = 0;
    try {
      Method::integrate(equations, end.values, duration, setting);
      end.completed = true;
    } catch (const std::runtime_error&) {  // Odeint's own: no step is small enough
    }
    end.evaluations = equations.evaluations;
    return end;
  };
  return make_flight(motion, fly, outcome_of<flies>);
}

template <class Method>
Contestant<Motion> contestant(const char* name, const char* label, Kind kind) {
  Contestant<Motion> result{{.name = name, .label = label, .family = "odeint", .kind = kind},
                            [](const Motion& motion, double setting) {
                              return motion.freedom == Freedom::angular ? integrated<Method, false>(motion, setting)
                                                                        : integrated<Method, true>(motion, setting);
                            }};
  if (kind == Kind::tolerance) {
    result.who.settings.clear();
    for (int exponent = -2; exponent >= -15; --exponent) {
      result.who.settings.push_back(std::pow(10.0, exponent));
    }
  }
  return result;
}

}  // namespace

std::vector<Contestant<Motion>> odeint_contestants() {
  return {contestant<RungeKutta4>("odeint-runge-kutta-4", "Odeint Runge–Kutta 4", Kind::step),
          contestant<Controlled<odeint::runge_kutta_dopri5>>("odeint-dopri5", "Odeint Dopri5", Kind::tolerance),
          contestant<Controlled<odeint::runge_kutta_fehlberg78>>("odeint-fehlberg78", "Odeint Fehlberg 7(8)",
                                                                 Kind::tolerance),
          contestant<BulirschStoer>("odeint-bulirsch-stoer", "Odeint Bulirsch–Stoer", Kind::tolerance)};
}

}  // namespace goishi::verify::bench::motion
