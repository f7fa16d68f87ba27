#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/steppers.hpp>
#include <goishi/vector.hpp>
#include <vector>

#include "arguments.hpp"

namespace goishi::c {

namespace {

static_assert(is(Freedom::linear, GOISHI_LINEAR) && is(Freedom::angular, GOISHI_ANGULAR) &&
              is(Freedom::both, GOISHI_BOTH));
static_assert(is(Scheme::published, GOISHI_PUBLISHED) && is(Scheme::explicit_euler, GOISHI_EXPLICIT_EULER) &&
              is(Scheme::exponential_euler, GOISHI_EXPONENTIAL_EULER) &&
              is(Scheme::implicit_midpoint, GOISHI_IMPLICIT_MIDPOINT) &&
              is(Scheme::runge_kutta_4, GOISHI_RUNGE_KUTTA_4) && is(Scheme::splitting_2, GOISHI_SPLITTING_2) &&
              is(Scheme::splitting_4, GOISHI_SPLITTING_4) && is(Scheme::splitting_6, GOISHI_SPLITTING_6) &&
              is(Scheme::exact, GOISHI_EXACT));
static_assert(is(StepStatus::completed, GOISHI_COMPLETED) && is(StepStatus::diverged, GOISHI_DIVERGED) &&
              is(StepStatus::not_converged, GOISHI_STEP_NOT_CONVERGED));

/// The angle between two attitudes   [rad].
[[nodiscard]] double angle_between(const Quat<double>& a, const Quat<double>& b) {
  const Quat<double> turn = formula::product(Quat<double>(a.conjugate()), b);
  return 2.0 * scalar::atan2(detail::length(Vec3<double>(turn.vec())), std::abs(turn.w()));
}

/// q/|q|. Sums have one order, whatever vectors the processor has, so that the bits are the same everywhere.
[[nodiscard]] Quat<double> unit(const char* name, const Quat<double>& q) {
  double most = 0.0, square = 0.0;
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
    require(std::isfinite(part), name, part, "must be finite");
    most = std::max(most, std::abs(part));
  }
  require(0.0 < most, name, most, "must have a length that is not 0");
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
    square += scalar::sq(part / most);
  }
  const double length = std::sqrt(square);
  return {q.w() / most / length, q.x() / most / length, q.y() / most / length, q.z() / most / length};
}

}  // namespace
}  // namespace goishi::c

using namespace goishi;
using namespace goishi::c;

extern "C" {

int goishi_state(const double* stone, size_t stone_size, const double* pose, size_t pose_size, const double* velocity,
                 size_t velocity_size, const double* spin, size_t spin_size, double* state, size_t state_size) {
  return guarded([&] {
    const RigidBody<double> body = read_stone("stone", stone, stone_size).rigid();
    const Pose<double> there = read_pose("pose", pose, pose_size);
    const Vec v_WB = read_vector("velocity", velocity, velocity_size), w_WB_B = read_vector("spin", spin, spin_size);
    require_array("state", state, state_size, GOISHI_STATE_SIZE);
    const Quat<double> q_WB = unit("attitude", there.q_WB);
    require(scalar::is_finite(w_WB_B), "spin", w_WB_B.transpose(), "must be finite");
    const State<double> result{
        .p_WB = there.p_WB, .q_WB = q_WB, .v_WB = v_WB, .L_W = formula::angular_momentum_W<double>(q_WB, body, w_WB_B)};
    require_state(result);
    std::vector<double> row;
    Row(row) << result;
    write(row, state);
  });
}

int goishi_free_flight(const double* stone, size_t stone_size, const double* state, size_t state_size,
                       const double* gravity, size_t gravity_size, int freedom, double time, double* motion,
                       size_t motion_size) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    const State<double> start = read_state("state", state, state_size);
    const Vec g_W = read_vector("gravity", gravity, gravity_size);
    require_array("motion", motion, motion_size, GOISHI_MOTION_SIZE);
    const State<double> there =
        free_flight(start, make_mobility(body.mass.moments), g_W, time, chosen("freedom", freedom, Freedom::both));
    std::vector<double> row;
    put_motion(Row(row), there, body.rigid(), g_W);
    write(row, motion);
  });
}

int goishi_free_rotation(const double* moments, size_t moments_size, const double* attitude, size_t attitude_size,
                         const double* momentum, size_t momentum_size, double time, double* rotation,
                         size_t rotation_size) {
  return guarded([&] {
    const auto [axial, transverse] = read<GOISHI_MOMENTS_SIZE>("moments", moments, moments_size);
    const auto [q_w, q_x, q_y, q_z] = read<4>("attitude", attitude, attitude_size);
    const Vec L_W = read_vector("momentum", momentum, momentum_size);
    require_array("rotation", rotation, rotation_size, 7);
    const Moments<double> body{.axial = axial, .transverse = transverse};
    const State<double> start{
        .p_WB = Vec::Zero(), .q_WB = Quat<double>(q_w, q_x, q_y, q_z), .v_WB = Vec::Zero(), .L_W = L_W};
    const State<double> there = free_flight(start, make_mobility(body), Vec(Vec::Zero()), time, Freedom::angular);
    std::vector<double> row;
    Row(row) << there.q_WB << formula::angular_velocity_W(there, make_rigid_body(1.0, body));
    write(row, rotation);
  });
}

int goishi_flight(const double* stone, size_t stone_size, const double* state, size_t state_size, const double* gravity,
                  size_t gravity_size, int freedom, int scheme, double step, int steps, double* rows, size_t rows_size,
                  size_t* done, int* ended) {
  return guarded([&] {
    constexpr int most_steps = 100'000'000;
    const Body body = read_stone("stone", stone, stone_size);
    const State<double> start = read_state("state", state, state_size);
    const Vec g_W = read_vector("gravity", gravity, gravity_size);
    const std::size_t count = count_rows("rows", rows, rows_size, GOISHI_FLIGHT_SIZE);
    require_pointer("done", done);
    require_pointer("ended", ended);
    const Freedom what = chosen("freedom", freedom, Freedom::both);
    const RigidBody<double> rigid = body.rigid();
    const Stepper<double> stepper(chosen("scheme", scheme, Scheme::exact), rigid, g_W, what);
    const Mobility<double> mobility = make_mobility(body.mass.moments);
    require_positive("step", step);
    require(1 <= steps, "steps", steps, "must be at least 1");
    require(count - 1 <= static_cast<std::size_t>(most_steps / steps), "steps", steps, "must be so few that ", count,
            " rows are at most ", most_steps, " of them");
    std::vector<double> result;
    Stepped<double> stepped{.state = start};
    for (std::size_t i = 0; i < count; ++i) {
      if (0 < i) {
        stepped = stepper.advance(stepped.state, step, steps);
        if (stepped.status != StepStatus::completed) {
          break;
        }
      }
      const double time = static_cast<double>(i * static_cast<std::size_t>(steps)) * step;
      const State<double> exact = free_flight(start, mobility, g_W, time, what);
      Row row(result);
      row << time;
      put_motion(row, stepped.state, rigid, g_W);
      put_motion(row, exact, rigid, g_W);
      row << angle_between(exact.q_WB, stepped.state.q_WB)
          << detail::length(Vec3<double>(stepped.state.p_WB - exact.p_WB));
    }
    write(result, rows);
    *done = result.size() / GOISHI_FLIGHT_SIZE;
    *ended = static_cast<int>(stepped.status);
  });
}

}  // extern "C"
