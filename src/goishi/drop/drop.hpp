#pragma once
/// \file
/// One stone from any state to rest: flight → certified first impact → impulse → … → contact phase → rest, event by
/// event. There is no time step in the air.

#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/contact_phase.hpp>
#include <goishi/drop/events.hpp>
#include <goishi/drop/flight_phase.hpp>
#include <goishi/drop/run.hpp>
#include <goishi/drop/settings.hpp>

namespace goishi {

namespace detail {

/// A drop that is to begin. The stone, the body and the board must outlive it.
template <Ordered T>
[[nodiscard]] Run<T> make_run(const Stone<T>& stone, const RigidBody<T>& body, const Board<T>* board,
                              const State<T>& start, const DropSettings<T>& settings, const T& time) {
  require_settings(settings, stone);
  require_state(start);
  require_positive("mass", body.mass);
  const Moments<T> moments{.axial = body.moments.z(), .transverse = body.moments.x()};
  require_physical(moments);
  require(!(body.moments.x() < body.moments.y()) && !(body.moments.y() < body.moments.x()), "moments",
          body.moments.transpose(), "must be those of a body with symmetry axis Bz");
  const T reach =
      outer_width(stone) / T(2) < stone.height / T(2) ? T(stone.height / T(2)) : T(outer_width(stone) / T(2));
  const T motion = scalar::sqrt(formula::dot(start.v_WB, start.v_WB)) +
                   reach / body.moments.minCoeff() * scalar::sqrt(formula::dot(start.L_W, start.L_W));
  const T strength = strength_of(settings.gravity, stone.width, motion);
  const DropSettings<T> all = filled(settings, stone, strength);
  return {.stone = stone,
          .body = body,
          .board = board,
          .settings = all,
          .scales = contact_scales(stone, strength),
          .rates = formula::top_rates(moments),
          .mobility = formula::mobility(body.mass, moments),
          .contact_body =
              contact_body(stone, Moments<T>{moments.axial / body.mass, moments.transverse / body.mass}, all, strength),
          .reach = reach,
          .state = start,
          .time = time};
}

template <Ordered T>
[[nodiscard]] Drop<T> dropped(const Stone<T>& stone, const RigidBody<T>& body, const Board<T>* board,
                              const State<T>& start, const DropSettings<T>& settings, const T& time, EventKind first) {
  Run<T> run = make_run(stone, body, board, start, settings, time);
  // A run that is to stop after so many impacts gets the room for them at once.
  run.result.events.reserve(settings.maximum_impacts < 100000 ? static_cast<std::size_t>(settings.maximum_impacts) + 64
                                                              : 64);
  run.record(first, start);
  FlightPhase<T> flight(run);
  flight();
  run.result.state = run.state;
  run.result.time = run.time;
  return std::move(run.result);
}

}  // namespace detail

/// Drops a stone on the plane z = 0. (`Ground::board` in the result stands for it.)
///
/// Domain  a stone of `make_stone`; a body of `make_rigid_body` with symmetry axis Bz; a finite start with a unit
///         attitude; settings in range; else InvalidArgument. A start inside the plane is a status, with the depth.
/// Result  every event with time, states, impulse and energy; the status says how it ended. It ends: all work is under
///         one budget, `maximum_steps`.
/// Rest    is a statement of statics, for one contact or several: there are forces inside the cones of friction, and
///         torques inside the resistance, that balance gravity where the stone is; what was left of its motion is less
///         than they take in turning it by the tolerance. Its time and place are those of the stop. Claim DROP-20.
/// Scale   none of its own: DROP-25, DROP-26. Stones as thin as 1e-7 of their width come to rest as others do; thinner
///         ones bounce and rock so often that they may be given up (DropLimits.ThinStonesComeToRest).
/// Error   every link of a drop against witnesses: DROP-18, at tolerance 1e-12 to 1e-9. Bounces: DROP-1, DROP-2. The
///         contact phase against exact answers: DROP-3 … DROP-14, and against Lagrange's equations: DROP-17. Where the
///         stone comes to rest, by tolerance: DROP-19. Energy never rises but by the tolerance: DROP-20.
/// Cost    in the air none but the impacts' own; the events are the only allocation.
template <Ordered T>
[[nodiscard]] Drop<T> drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start,
                           const DropSettings<T>& settings = {}) {
  return detail::dropped<T>(stone, body, nullptr, start, settings, T(0), EventKind::start);
}

/// Drops a stone on the board; it may fall off, onto the floor.
/// Domain  as above; a board of `make_board`.
template <Ordered T>
[[nodiscard]] Drop<T> drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start,
                           const Board<T>& board, const DropSettings<T>& settings = {}) {
  return detail::dropped<T>(stone, body, &board, start, settings, T(0), EventKind::start);
}

/// Goes on from where a drop ended, under other settings: a stone at rest wakes if the gravity that they hold moves it,
/// and else stays at rest. The horizon counts from the first start. `board` is null for the plane.
template <Ordered T>
[[nodiscard]] Drop<T> woken(const Drop<T>& before, const Stone<T>& stone, const RigidBody<T>& body,
                            const Board<T>* board, const DropSettings<T>& settings) {
  return detail::dropped<T>(stone, body, board, before.state, settings, before.time, EventKind::woken);
}

}  // namespace goishi
