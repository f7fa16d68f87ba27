#pragma once
/// \file
/// Every way in which production moves a body, behind one interface.

#include <cmath>
#include <functional>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/steppers.hpp>
#include <limits>
#include <string_view>
#include <vector>

#include "verify/claims/motion/convergence.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

[[nodiscard]] inline Moments<double> top_moments(const Flight& flight) {
  return {.axial = flight.body.moments.z(), .transverse = flight.body.moments.x()};
}

/// What `free_flight` may be off in the attitude, as it documents   [rad].
[[nodiscard]] inline double flight_error(const Flight& flight, double t) {
  const auto [axial, transverse] = top_moments(flight);
  const double spin = formula::axial_momentum(flight.start.q_WB, flight.start.L_W) / axial;
  return 8.0 * epsilon *
         (1.0 + std::fabs(t) * (flight.start.L_W.norm() / transverse + std::fabs(spin * (1.0 - axial / transverse))));
}

/// How far a body can have come   [m].
[[nodiscard]] inline double reach(const Flight& flight, const Vec3<double>& gravity, double t) {
  const double time = std::fabs(t);
  return flight.start.p_WB.norm() + (flight.start.v_WB.norm() + gravity.norm() * time) * time;
}

/// One way to move a body for 64 Δt under gravity, and how far its attitude may be off   [rad].
struct Mover {
  std::string_view name;
  std::function<State<double>(const Flight&, const Vec3<double>& gravity, double dt, Freedom)> move;
  std::function<double(const Flight&, double dt)> attitude_error;
  bool keeps_momentum = true;
  int pieces = 64;  // in which it moves the body
};
inline constexpr int steps = 64;

/// Calls f(flight, mover) for drawn bodies: `free_flight`, and 64 steps of each scheme that fits the body.
template <class F>
void for_each_motion(Context& context, int count, F&& f) {
  std::vector<Mover> movers;
  for (const SchemeInfo& info : schemes) {
    const Scheme scheme = info.scheme;
    movers.push_back({.name = info.name,
                      .move =
                          [scheme](const Flight& flight, const Vec3<double>& gravity, double dt, Freedom freedom) {
                            const Stepper<double> stepper(scheme, flight.body, gravity, freedom);
                            return stepper.advance(flight.start, dt, steps).state;
                          },
                      .attitude_error = [scheme](const Flight&, double) { return round_off(scheme, steps); },
                      .keeps_momentum = scheme != Scheme::published});
  }
  movers.push_back({.name = "free_flight",
                    .move =
                        [](const Flight& flight, const Vec3<double>& gravity, double dt, Freedom freedom) {
                          return free_flight(flight.start, top_moments(flight), gravity, steps * dt, freedom);
                        },
                    .attitude_error = [](const Flight& flight, double dt) { return flight_error(flight, steps * dt); },
                    .pieces = 1});
  for (int i = 0; i < count; ++i) {
    const bool symmetric = i % 2 == 0;
    const Flight flight = draw_flight(context.random(), symmetric ? BodyKind::symmetric : BodyKind::asymmetric);
    for (const Mover& mover : movers) {
      if (symmetric || (mover.name != "exact" && mover.name != "free_flight")) {
        f(flight, mover);
      }
    }
  }
}

}  // namespace goishi::verify
