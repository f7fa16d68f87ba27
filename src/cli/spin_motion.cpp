#include "spin_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/error.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <string>

#include "quantity.hpp"

namespace goishi::cli {

namespace {

/// The start in the scalar T; the centre of mass rests.
template <class T>
State<T> state_of(const RigidBody<T>& body, const Quat<T>& q_WB, const Vec3<T>& w_WB_B) {
  const Vec3<T> nowhere(T(0), T(0), T(0));
  return {.p_WB = nowhere, .q_WB = q_WB, .v_WB = nowhere, .L_W = formula::angular_momentum_W(q_WB, body, w_WB_B)};
}

template <class T>
SpinSample sample_of(const Number& time, const State<T>& state, const RigidBody<T>& body) {
  const State<Number> exact{.p_WB = state.p_WB.template cast<Number>(),
                            .q_WB = Quat<Number>(state.q_WB.template cast<Number>()),
                            .v_WB = state.v_WB.template cast<Number>(),
                            .L_W = state.L_W.template cast<Number>()};
  const RigidBody<Number> same{.mass = Number(body.mass), .moments = body.moments.template cast<Number>()};
  const Vec3<Number> w = formula::angular_velocity_B(exact, same);
  const Quat<Number>& q = exact.q_WB;
  const Vec3<Number>& L = exact.L_W;
  const Number energy = formula::rotational_energy(exact, same);
  return {.time = time, .values = {q.w(), q.x(), q.y(), q.z(), w.x(), w.y(), w.z(), L.x(), L.y(), L.z(), energy}};
}

/// What is round-off, beside the vector that it is a component of, becomes 0.
template <class Vector>
void settle(Vector&& vector) {
  static const Number part{std::string(least_part)};
  const Number least = part * vector.norm();
  for (Number& component : vector) {
    if (abs(component) < least) {
      component = 0;
    }
  }
}

State<Number> settled(State<Number> state) {
  settle(state.q_WB.coeffs());
  settle(state.L_W);
  return state;
}

SpinSample settled(SpinSample sample) {
  settle(Eigen::Map<Vec3<Number>>(&sample.values[4]));
  return sample;
}

/// The methods that take steps compute in double.
double to_double(const char* argument, const Number& value) {
  return cli::to_double(argument, value, "every method but 'exact'", stepped_order);
}

}  // namespace

SpinMotion turn_exactly(const SpinStart& start, const std::vector<Number>& times) {
  const RigidBody<Number> body = make_rigid_body(Number(1), start.moments);
  const State<Number> state = state_of(body, start.q_WB, start.w_WB_B);
  const Mobility<Number> mobility = make_mobility(start.moments);
  const Number& end = times.back();
  const Number turn = abs(end) * state.L_W.norm() * (mobility.transverse + abs(mobility.axial));
  require(turn < Number(std::string(largest_turn)), "time", end,
          fmt::format("must not turn the body by more than {} rad, beyond which 50 digits are too few", largest_turn));
  SpinMotion motion;
  for (const Number& time : times) {
    const State<Number> there = free_flight(state, mobility, gravity_W(Number(0)), time, Freedom::angular);
    motion.samples.push_back(settled(sample_of(time, settled(there), body)));
  }
  return motion;
}

SpinMotion turn_in_steps(const SpinStart& start, const std::vector<Number>& times, Scheme scheme, const Number& step) {
  require_positive("step", step);
  require(!(times.back() < 0), "time", times.back(),
          fmt::format("must not be negative with --method {}, which steps forward", info(scheme).name));
  const bool series = times.size() > 1;
  const Number interval = series ? times[1] : times[0];
  // 0.3/0.1 is 3, whatever the last digits of the decimals are.
  const Number count = ceil(Number(interval / step * (1 - Number("1e-30"))));
  require(count * std::max<std::size_t>(1, times.size() - 1) <= most_steps, "step", step,
          fmt::format("must be so long that at most {} steps are taken", most_steps));
  const auto steps = count.convert_to<std::int64_t>();

  const Moments<double> moments{.axial = to_double("axial", start.moments.axial),
                                .transverse = to_double("transverse", start.moments.transverse)};
  const RigidBody<double> body = make_rigid_body(1.0, moments);
  const Vec3<double> w_WB_B(to_double("spin", start.w_WB_B.x()), to_double("spin", start.w_WB_B.y()),
                            to_double("spin", start.w_WB_B.z()));
  Stepped<double> end{.state = state_of(body, Quat<double>(start.q_WB.cast<double>()), w_WB_B)};
  const Stepper<double> stepper(scheme, body, gravity_W(0.0), Freedom::angular);

  SpinMotion motion;
  motion.step = steps == 0 ? step : Number(interval / steps);
  const double dt = to_double("step", motion.step);
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (row > 0 || !series) {
      end = stepper.advance(end.state, dt, steps);
    }
    const bool good = end.status == StepStatus::completed;
    const Number before = good ? times[row] : Number(row > 0 ? times[row - 1] : Number(0)) + end.steps * motion.step;
    motion.samples.push_back(sample_of(good ? times[row] : before, end.state, body));
    if (!good) {
      motion.status = end.status;
      break;
    }
  }
  return motion;
}

}  // namespace goishi::cli
