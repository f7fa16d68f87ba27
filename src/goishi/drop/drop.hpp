#pragma once
/// \file
/// One stone from any state to rest: flight → certified first impact → impulse → … → contact phase → rest, event by
/// event. There is no time step in the air.

#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/events.hpp>
#include <goishi/drop/motion/motion_log.hpp>
#include <goishi/drop/motion/stretch.hpp>
#include <goishi/drop/phases/contact_phase.hpp>
#include <goishi/drop/phases/flight_phase.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/drop/state/run.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace goishi {

/// What a drop carries along besides its state.
template <class T>
struct DropPast {
  T time = T(0);       // [s] that it has come to
  bool begun = false;  // and was told
  DropCounters counters = {};
  Ground ground = Ground::none;
  bool lower_order = false;
};

/// A stone under way, on the plane z = 0 or on a board, off which it may fall to the floor. It is a value: it can be
/// stored, copied, stopped and continued, and a copy goes on as the original does, bit for bit.
///
///     Drop<double> drop(stone, body, start);
///     drop.keep_motion();
///     drop.advance_to_rest();
///     drop.state_at(0.1);                       // any time of the past, in any order
///     drop.apply_impulse(p_W, {0.001, 0, 0});   // and on
///     drop.advance(1.0);
///
/// It works stretch by stretch: a flight up to where it touches, an accepted step of the contact phase, the way to rest.
/// Stretches end where the motion has them end, never where the caller's time does: that is looked up along them. So the
/// answer does not depend on how time is cut, to the last bit, and what happens later than `time` is not told before.
///
/// Domain  a stone of `make_stone`; a body of `make_rigid_body` with symmetry axis Bz; a finite start with a unit
///         attitude; settings in range; else InvalidArgument. A start inside the ground is a status, with the depth.
/// Ends    all work of a call is under one budget, `maximum_steps`, or the one that is given; it is looked at after each
///         stretch, whose own work is bounded. A call that ends by it can be followed by another.
/// Rest    is a statement of statics, for one contact or several: there are forces inside the cones of friction, and
///         torques inside the resistance, that balance gravity where the stone is; what was left of its motion is less
///         than they take in turning it by the tolerance. Its time and place are those of the stop. Claim DROP-20.
/// Scale   none of its own: DROP-25, DROP-26. Stones as thin as 1e-7 of their width come to rest as others do; thinner
///         ones bounce and rock so often that they may be given up (DropLimits.ThinStonesComeToRest).
/// Error   every link of a drop against witnesses: DROP-18, at tolerance 1e-12 to 1e-9. Bounces: DROP-1, DROP-2. The
///         contact phase against exact answers: DROP-3 … DROP-14, and against Lagrange's equations: DROP-17. Where the
///         stone comes to rest, by tolerance: DROP-19. Energy never rises but by the tolerance: DROP-20.
/// Cost    in the air none but the impacts' own. Without `keep_motion` nothing is allocated.
template <Ordered T>
class Drop {
 public:
  Drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start, const DropSettings<T>& settings = {})
      : Drop(stone, body, start, std::nullopt, settings) {}

  /// Domain  as above; a board of `make_board`.
  Drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start, const Board<T>& board,
       const DropSettings<T>& settings = {})
      : Drop(stone, body, start, std::optional<Board<T>>(board), settings) {}

  /// A drop that was left in a state, taken up again. (One that stands still needs no more than these to be kept.)
  Drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start, const std::optional<Board<T>>& board,
       const DropSettings<T>& settings, const DropPast<T>& past)
      : Drop(stone, body, start, board, settings) {
    run_.time = now_ = past.time;
    run_.counters = past.counters;
    run_.ground = past.ground;
    run_.lower_order = past.lower_order;
    begun_ = past.begun;
    present_ = stand();
  }

  [[nodiscard]] DropPast<T> past() const { return {now_, begun_, run_.counters, run_.ground, run_.lower_order}; }

  // --- going on

  /// Goes on for a time, and tells of the events on its way, those at its end included. The status is `moving` where that
  /// time is over or `maximum_impacts` have happened since; time goes on for a stone at rest, too.
  /// Domain  dt >= 0 and finite; 0 < budget; else InvalidArgument.
  DropStatus advance(const T& dt, EventSink<T> sink = {}, std::optional<int> budget = {}) {
    require(T(0) <= dt && scalar::is_finite(T(now_ + dt)), "dt", dt,
            "must be finite, the time after it too, and at least 0");
    return go(T(now_ + dt), false, sink, budget);
  }

  /// The same up to a time. (In many calls, sums of `dt` have a round-off of their own.)
  /// Domain  a finite time, not before `time()`.
  DropStatus advance_to(const T& time, EventSink<T> sink = {}, std::optional<int> budget = {}) {
    require(now_ <= time && scalar::is_finite(time), "time", time, "must be finite, and not before the present, ",
            now_);
    return go(time, false, sink, budget);
  }

  /// Goes on until it ends, for no longer than the settings' horizon.
  DropStatus advance_to_rest(EventSink<T> sink = {}, std::optional<int> budget = {}) {
    return go(T(now_ + *run_.settings.horizon), true, sink, budget);
  }

  // --- what it is

  [[nodiscard]] const T& time() const { return now_; }
  [[nodiscard]] State<T> state() const { return state_in_present(now_); }
  [[nodiscard]] DropStatus status() const { return status_; }
  [[nodiscard]] Ground ground() const { return run_.ground; }
  [[nodiscard]] const T& depth() const { return run_.depth; }          // [m] of `start_inside`
  [[nodiscard]] bool lower_order() const { return run_.lower_order; }  // an edge, a side or two places were passed
  [[nodiscard]] const DropCounters& counters() const { return run_.counters; }
  [[nodiscard]] T energy() const { return formula::energy(state(), run_.body, run_.settings.gravity); }  // [J]
  [[nodiscard]] const Stone<T>& stone() const { return run_.stone; }
  [[nodiscard]] const RigidBody<T>& body() const { return run_.body; }
  [[nodiscard]] const std::optional<Board<T>>& board() const { return run_.board; }
  [[nodiscard]] const DropSettings<T>& settings() const { return given_; }

  // --- what it was

  /// Keeps the motion from now on: the last `most` stretches, of `sizeof(detail::Stretch<T>)` bytes each, 736 in
  /// double (a flight, a step of the contact phase or a hop along an edge is one). 0 keeps none.
  void keep_motion(std::size_t most = 100000) { log_.keep(most); }

  /// The state at a time of the past. Where an event changes it at once, before or after that; after several, if they are
  /// at one time.
  ///
  /// Domain  from `motion_begin()` to `time()`; else InvalidArgument.
  /// Error   flights: as `free_flight`. Contact: of a polynomial of degree 5 along a step, 3 where friction is stiff; some
  ///         tolerances at most, as a rule (claim DROP-33).
  /// Cost    a search among the stretches, a polynomial, an attitude: bench, drop-state-at.
  [[nodiscard]] State<T> state_at(const T& time, Side side = Side::after) const {
    require(time <= now_, "time", time, "is after what has been computed, up to ", now_);
    require(motion_begin() <= time, "time", time,
            log_.keeps() ? "is before the motion that is kept, from " : "has no motion kept, which there is from ",
            motion_begin());
    const bool earlier = !log_.empty() && (side == Side::after ? time < present_.begin : time <= present_.begin);
    return earlier ? state_of(log_.at(time, side), time) : state_in_present(time);
  }

  /// How many stretches of motion are kept.
  [[nodiscard]] std::size_t kept() const { return log_.size(); }

  /// From when on the state can be told: without motion kept the present alone.
  [[nodiscard]] T motion_begin() const { return !log_.keeps() ? now_ : log_.empty() ? present_.begin : log_.begin(); }

  // --- what it will be, unless something is done to it

  /// The stretch that the present time is in.
  [[nodiscard]] const detail::Stretch<T>& stretch() const { return present_; }

  /// The state at a time of that stretch.
  [[nodiscard]] State<T> state_ahead(const T& time) const { return state_in_present(time); }

  [[nodiscard]] const detail::ContactBody<T>& contact_body() const { return run_.contact_body; }

  // --- what is done to it

  /// An impulse P at a point of W   [N s].
  /// Domain  both finite; else InvalidArgument.
  void apply_impulse(const Vec3<T>& p_W, const Vec3<T>& P_W, EventSink<T> sink = {}) {
    require(scalar::is_finite(p_W), "p_W", p_W.transpose(), "must be finite");
    require(scalar::is_finite(P_W), "P_W", P_W.transpose(), "must be finite");
    const State<T> before = state();
    begin(sink);
    State<T> after = before;
    after.v_WB = after.v_WB + P_W / run_.body.mass;
    after.L_W = after.L_W + formula::cross(Vec3<T>(p_W - before.p_WB), P_W);
    restart(after);
    tell(sink, EventKind::push, before, [&](Event<T>& event) {
      event.impulse_W = P_W;
      event.contact_W = p_W;
    });
  }

  /// An impulse at a contact with something that moves, after which the stone has these velocities.
  void collide(const Separation<T>& contact, const Impulse<T>& impulse, const BodyVelocity<T>& after_it,
               EventSink<T> sink = {}) {
    const State<T> before = state();
    begin(sink);
    State<T> after = before;
    after.v_WB = after_it.v_WB;
    after.L_W = after_it.L_W;
    restart(after);
    ++run_.counters.impacts;
    tell(sink, EventKind::impact, before, [&](Event<T>& event) {
      event.impulse_W = impulse.impulse_W;
      event.outcome = impulse.outcome;
      detail::note_contact(event, contact);
    });
  }

  /// Other settings from now on, gravity among them. A stone at rest wakes if they move it, and else stays at rest.
  /// Domain  as above.
  void change(const DropSettings<T>& settings, EventSink<T> sink = {}) { change(run_.board, settings, sink); }

  /// Another board from now on, or none: the plane z = 0.
  void change(const std::optional<Board<T>>& board, EventSink<T> sink = {}) { change(board, given_, sink); }

 private:
  enum class Stage { begin, flight, contact, over };

  Drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start, const std::optional<Board<T>>& board,
       const DropSettings<T>& settings)
      : given_(settings),
        run_(detail::make_run(stone, body, board, start, settings, T(0))),
        flight_(run_),
        contact_(run_),
        present_(stand()) {}

  [[nodiscard]] detail::Stretch<T> stand() const {
    return {run_.time, std::numeric_limits<T>::infinity(), detail::Standing<T>{run_.state}};
  }

  [[nodiscard]] State<T> state_of(const detail::Stretch<T>& stretch, const T& time) const {
    return detail::state_in(stretch, time, run_.contact_body, run_.mobility, run_.body.mass);
  }
  [[nodiscard]] State<T> state_in_present(const T& time) const { return state_of(present_, time); }

  void change(const std::optional<Board<T>>& board, const DropSettings<T>& settings, EventSink<T> sink) {
    const State<T> now = state();
    static_cast<void>(detail::make_run(run_.stone, run_.body, board, now, settings, now_));  // refuses what is wrong
    begin(sink);
    given_ = settings;
    run_.board = board;
    restart(now);
    tell(sink, EventKind::woken, now);
  }

  template <class... Fill>
  void tell(EventSink<T> sink, EventKind kind, const State<T>& before, Fill&&... fill) {
    run_.sink = sink;
    run_.record(kind, before, std::forward<Fill>(fill)...);
    run_.sink = {};
  }

  /// Tells that it has begun, if it has just now.
  void begin(EventSink<T> sink) {
    if (!begun_) {
      begun_ = true;
      tell(sink, EventKind::start, run_.state);
    }
  }

  /// From the present time, in another state or under other settings.
  void restart(const State<T>& state) {
    detail::Run<T> run = detail::make_run(run_.stone, run_.body, run_.board, state, given_, now_);
    if (log_.keeps() && present_.begin < now_) {
      present_.end = now_;
      log_.add(present_);
    }
    run.counters = run_.counters;
    run.ground = run_.ground;
    run.lower_order = run_.lower_order;
    run_ = run;
    flight_ = detail::FlightPhase<T>(run_);
    contact_ = detail::ContactPhase<T>(run_);
    stage_ = Stage::begin;
    planned_ = false;
    present_ = stand();
    status_ = DropStatus::moving;
  }

  DropStatus go(const T& until, bool to_rest, EventSink<T> sink, const std::optional<int>& budget) {
    const int most = budget.value_or(run_.settings.maximum_steps);
    require(0 < most, "budget", most, "must be at least 1");
    begin(sink);
    run_.sink = sink;
    status_ = gone(until, to_rest, most, run_.counters);
    run_.sink = {};
    return status_;
  }

  [[nodiscard]] DropStatus gone(const T& until, bool to_rest, int budget, const DropCounters at_first) {
    while (true) {
      if (!planned_) {
        const DropCounters& now = run_.counters;
        const std::optional<DropStatus> limit =
            stage_ == Stage::over                                             ? std::nullopt
            : run_.settings.maximum_impacts <= now.impacts - at_first.impacts ? std::optional(DropStatus::moving)
            : run_.settings.maximum_events <= now.events - at_first.events ? std::optional(DropStatus::too_many_events)
            : budget <= now.work() - at_first.work()                       ? std::optional(DropStatus::too_many_steps)
                                                                           : std::nullopt;
        if (limit) {
          now_ = run_.time;
          if (stage_ == Stage::contact) {
            contact_.update(run_);
          }
          present_ = stand();
          return *limit;
        }
        plan();
        planned_ = true;
      }
      const bool ends = stage_ == Stage::over && to_rest;
      if (ends || until < end_) {
        now_ = !ends ? until : now_ < run_.time ? run_.time : now_;
        present_ = planned();
        return stage_ == Stage::over ? run_.status : DropStatus::moving;
      }
      if (log_.keeps()) {
        log_.add(planned());
      }
      complete();
      planned_ = false;
    }
  }

  /// Looks ahead as far as nothing happens.
  void plan() {
    if (stage_ == Stage::begin) {
      stage_ = flight_.begin(run_) ? Stage::flight : Stage::over;
    }
    while (stage_ == Stage::contact && !contact_.plan(run_)) {
      follow(flight_.after(run_, contact_.end(), contact_.feature()));
    }
    if (stage_ == Stage::flight && !flight_.plan(run_)) {
      stage_ = Stage::over;
    }
    end_ = stage_ == Stage::over ? std::numeric_limits<T>::infinity()
                                 : T(run_.time + (stage_ == Stage::contact ? contact_.length() : flight_.length()));
  }

  [[nodiscard]] detail::Stretch<T> planned() const {
    detail::Stretch<T> stretch = stand();
    stretch.end = end_;
    if (stage_ == Stage::contact) {
      stretch.motion = contact_.motion();
    } else if (stage_ == Stage::flight || run_.status == DropStatus::flies_on) {
      stretch.motion = flight_.motion(run_);
    }
    return stretch;
  }

  void complete() {
    if (stage_ == Stage::contact) {
      contact_.complete(run_);
    } else {
      follow(flight_.complete(run_));
    }
  }

  void follow(detail::Next next) {
    switch (next) {
      case detail::Next::flight:
        stage_ = Stage::flight;
        break;
      case detail::Next::contact:
        stage_ = Stage::contact;
        contact_.enter(run_, flight_.feature());
        break;
      case detail::Next::over:
        stage_ = Stage::over;
        break;
    }
  }

  DropSettings<T> given_;
  detail::Run<T> run_;  // where the stretch begins that is planned
  detail::FlightPhase<T> flight_;
  detail::ContactPhase<T> contact_;
  Stage stage_ = Stage::begin;
  bool begun_ = false;    // and was told
  bool planned_ = false;  // a stretch, up to
  T end_ = T(0);
  T now_ = T(0);                // <= end_
  detail::Stretch<T> present_;  // that `now_` is in
  DropStatus status_ = DropStatus::moving;
  detail::MotionLog<T> log_;
};

/// Follows a drop to its end, or for the settings' horizon, and tells everything from where it is.
/// Result  every event with time, states, impulse and energy; the status says how it ended.
template <Ordered T>
[[nodiscard]] DropResult<T> followed(Drop<T>& drop) {
  DropResult<T> result;
  // A drop that is to stop after so many impacts gets the room for them at once.
  const int impacts = drop.settings().maximum_impacts;
  result.events.reserve(impacts < 100000 ? static_cast<std::size_t>(impacts) + 64 : 64);
  result.status = drop.advance_to_rest(result.events);
  result.ground = drop.ground();
  result.state = drop.state();
  result.time = drop.time();
  result.depth = drop.depth();
  result.lower_order = drop.lower_order();
  result.counters = drop.counters();
  if (is_under_way(result.status)) {
    Event<T>& end = result.events.emplace_back();
    end.kind = EventKind::end;
    end.time = result.time;
    end.before = end.after = result.state;
    end.energy = drop.energy();
  }
  return result;
}

/// Drops a stone on the plane z = 0, to the end. (`Ground::board` in the result stands for the plane.)
/// Domain  as `Drop`.
template <Ordered T>
[[nodiscard]] DropResult<T> drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start,
                                 const DropSettings<T>& settings = {}) {
  Drop<T> drop(stone, body, start, settings);
  return followed(drop);
}

/// The same on the board.
template <Ordered T>
[[nodiscard]] DropResult<T> drop(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start,
                                 const Board<T>& board, const DropSettings<T>& settings = {}) {
  Drop<T> drop(stone, body, start, board, settings);
  return followed(drop);
}

}  // namespace goishi
