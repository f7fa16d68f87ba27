#pragma once
/// \file
/// The contact phase: from the moment at which a contact stays until it ends or the stone rests. The equations change
/// where friction, the feature in contact or the sign of the normal force does; each change is located and recorded.

#include <goishi/drop/phases/locked.hpp>
#include <goishi/drop/phases/onset.hpp>
#include <goishi/drop/state/contact_state.hpp>
#include <goishi/drop/steps/integrator.hpp>
#include <optional>

namespace goishi::detail {

/// Why the contact phase ended.
enum class ContactEnd { rest, lift_off, board_edge, side, stuck };

/// It goes stretch by stretch: `plan` looks ahead as far as nothing happens, `complete` goes there.
template <Ordered T>
class ContactPhase {
 public:
  explicit ContactPhase(const Run<T>& run) : integrate_(run) {}

  /// From the run's state, which touches the plane and moves along it, with the feature in contact.
  void enter(const Run<T>& run, Feature feature) {
    contact_.enter(run, feature);
    task_ = Task::begin;
    stalled_ = 0;
    last_ = run.time;
  }

  /// Plans the next stretch, and records what happens before it. False where the phase is over: `end` says how, and the
  /// run has the state.
  [[nodiscard]] bool plan(Run<T>& run) {
    while (task_ != Task::over) {
      if (looks_ahead(run)) {
        return true;
      }
    }
    contact_.update(run);
    return false;
  }

  /// How long the stretch that is planned takes   [s].
  [[nodiscard]] const T& length() const { return ahead_.length; }

  [[nodiscard]] Touching<T> motion() const {
    return {contact_, ahead_.known ? ahead_.along : integrate_.along(contact_.y, ahead_), ahead_.length, ahead_.ledger};
  }

  /// Goes to its end.
  void complete(Run<T>& run) {
    contact_.y = ahead_.to;
    contact_.unwind();
    run.time = run.time + ahead_.length;
  }

  /// Takes the run's state to where it is.
  void update(Run<T>& run) const { contact_.update(run); }

  [[nodiscard]] ContactEnd end() const { return end_; }

  /// What of the stone touches now, or did last.
  [[nodiscard]] Feature feature() const { return contact_.feature; }

 private:
  /// What is to be done where the stone is.
  enum class Task { begin, step, after_step, guard, settle, after_onset, slide_locked, after_locked, rest, over };

  /// Does it. True where a stretch is planned.
  [[nodiscard]] bool looks_ahead(Run<T>& run) {
    switch (task_) {
      case Task::begin:
        return begin(run);
      case Task::step:
        return step(run);
      case Task::after_step:
        return follow(integrate_.after(run, contact_, ahead_));
      case Task::guard:
        meet(run, integrate_.guard());
        return false;
      case Task::settle:
        return settle(run);
      case Task::after_onset:
        after_onset(run);
        return false;
      case Task::slide_locked:
        slide_locked(run);
        return true;
      case Task::after_locked:
        after_locked(run);
        return false;
      case Task::rest:
        leave(ContactEnd::rest);
        break;
      case Task::over:
        break;
    }
    return false;
  }

  void leave(ContactEnd end) {
    end_ = end;
    task_ = Task::over;
  }

  // --- one set of equations, up to where another holds

  [[nodiscard]] bool begin(Run<T>& run) {
    stalled_ = last_ < run.time ? 0 : stalled_ + 1;
    last_ = run.time;
    if (most_stalled < stalled_) {
      leave(ContactEnd::stuck);
      return false;
    }
    if (contact_.mode == ContactMode::sliding && !(run.contact_body.friction < std::numeric_limits<T>::infinity())) {
      task_ = Task::settle;
      return false;
    }
    const bool begun = begun_;
    begun_ = false;
    return follow(integrate_.begin(run, contact_, begun, ahead_));
  }

  [[nodiscard]] bool step(Run<T>& run) {
    const Course course = integrate_.plan(run, contact_, ahead_);
    if (course != Course::steps) {
      return follow(course);
    }
    task_ = Task::after_step;
    return true;
  }

  [[nodiscard]] bool follow(Course course) {
    switch (course) {
      case Course::steps:
        task_ = Task::step;
        return false;
      case Course::guard:
        task_ = Task::guard;
        return false;
      case Course::rests:
        task_ = Task::rest;
        return true;
      case Course::slip_stops:
        task_ = Task::guard;
        return true;
      case Course::fails:
        break;
    }
    leave(ContactEnd::stuck);
    return false;
  }

  void meet(Run<T>& run, Guard guard) {
    task_ = Task::settle;
    switch (guard) {
      case Guard::lift_off:
        leave(ContactEnd::lift_off);
        break;
      case Guard::support:
        leave(beyond_support());
        break;
      case Guard::turning:
        lock(run);
        break;
      case Guard::feature:
        change_feature(run);
        break;
      case Guard::grip:
        if (!hardly_turns(run.contact_body, integrate_.now()) && begins_slip(run)) {
          task_ = Task::begin;
        }
        break;
      case Guard::slip:
        contact_.y[at::slip] = T(0);
        if (!hardly_turns(run.contact_body, integrate_.now()) && ends_slip(run)) {
          task_ = Task::begin;
        }
        break;
      case Guard::jam:
      case Guard::onset:
      case Guard::none:
        break;
    }
  }

  [[nodiscard]] ContactEnd beyond_support() const {
    return T(0) <= contact_.level ? ContactEnd::board_edge : ContactEnd::side;
  }

  void change_feature(Run<T>& run) {
    contact_.feature = contact_.feature != Feature::rim ? Feature::rim
                       : T(0) < contact_.y[at::u + 2]   ? Feature::lower_cap
                                                        : Feature::upper_cap;
    contact_.note(run, EventKind::feature);
    task_ = Task::begin;
  }

  /// Slip starts against the friction that rolling would need, in the direction that its own rate keeps. False if there is
  /// none.
  [[nodiscard]] bool begins_slip(Run<T>& run) {
    const Vec3<T>& force = integrate_.force();
    T phi = scalar::atan2(T(-force.y()), T(-force.x()));
    if (!outgoing(run.contact_body, integrate_.now(), phi, run.counters)) {
      return false;
    }
    contact_.mode = ContactMode::sliding;
    contact_.y[at::slip] = T(0);
    contact_.y[at::direction] = phi;
    contact_.note(run, EventKind::slip);
    return true;
  }

  [[nodiscard]] static SlipRate<T> slip_towards(const ContactBody<T>& body, const Kinetics<T>& now, const T& phi) {
    const auto [s, c] = scalar::sincos(phi);
    return formula::slip_rate(now.W, now.brake, now.need, body.friction, c, s);
  }

  /// From a first guess: the direction in which a slip that begins goes on, its rate pointing along it. False where no
  /// direction is such a one.
  [[nodiscard]] static bool outgoing(const ContactBody<T>& body, const Kinetics<T>& now, T& phi,
                                     DropCounters& counters) {
    constexpr int directions = 64;
    for (int i = 0; i < directions; ++i) {
      T found = phi + T(2 * i) / T(directions) * scalar::pi<T>();
      refine(body, now, found, counters);
      ++counters.evaluations_located;
      const SlipRate<T> rate = slip_towards(body, now, found);
      // At the cone's edge the slip has no rate yet, but for round-off.
      const T nothing = T(1e-6) * body.strength;
      if (jam_margin(now.W.zz) < rate.denominator && rate.across_slope < T(0) && -nothing < rate.along &&
          rate.across < nothing && -nothing < rate.across) {
        phi = found;
        return true;
      }
    }
    return false;
  }

  /// Newton towards a stable zero of σ φ̇.
  static void refine(const ContactBody<T>& body, const Kinetics<T>& now, T& phi, DropCounters& counters) {
    for (int i = 0; i < 50; ++i) {
      ++counters.evaluations_located;
      const SlipRate<T> rate = slip_towards(body, now, phi);
      if (!(rate.across_slope < T(0))) {
        break;
      }
      const T turn = -rate.across / rate.across_slope;
      phi = phi + (turn < T(-1) ? T(-1) : T(1) < turn ? T(1) : turn);
      if (scalar::sq(turn) < T(1e-28)) {
        break;
      }
    }
  }

  /// A slip has come to zero: it sticks if friction can hold that, else goes on in another direction. False if it can
  /// neither.
  [[nodiscard]] bool ends_slip(Run<T>& run) {
    Rolling<T> rolling(run.contact_body, contact_.feature, contact_.origin);
    static_cast<void>(rolling(contact_.y));
    ++run.counters.contact_evaluations;
    T phi = scalar::atan2(T(-rolling.force.y()), T(-rolling.force.x()));
    if (-guard_noise<T>() <= rolling.guards().value[2]) {
      contact_.mode = ContactMode::rolling;
      contact_.y[at::direction] = T(0);
      contact_.note(run, EventKind::stick);
      return true;
    }
    if (!outgoing(run.contact_body, rolling.now, phi, run.counters)) {
      return false;
    }
    contact_.y[at::direction] = phi;
    return true;
  }

  // --- where the equations do not say how it goes on

  /// Whether turning is so slow that what begins now decides about it.
  [[nodiscard]] bool hardly_turns(const ContactBody<T>& body, const Kinetics<T>& now) const {
    const std::array<T, 2> slip = contact_.slip();
    return resistance_is_stiff(body, contact_.y, body.strength, onset_time(body, now, slip[0], slip[1]));
  }

  /// Slip, turning and normal force chosen together. True where that takes a time.
  [[nodiscard]] bool settle(Run<T>& run) {
    const ContactBody<T>& body = run.contact_body;
    Variables<T>& y = contact_.y;
    Kinetics<T> now = kinetics(body, contact_.feature, y);
    if (body.resists && !contact_.turns(run, now.w)) {
      y[at::L] = y[at::L + 1] = y[at::L + 2] = T(0);
      now = kinetics(body, contact_.feature, y);
    }
    const std::array<T, 2> slip = contact_.slip();
    // What begins slowly is followed until it has a direction, as long as that costs less than a step's error, h² at most.
    const T most = T(0.1) * scalar::sqrt(run.settings.tolerance) / run.scales.frequency;
    T h = onset_time(body, now, slip[0], slip[1]);
    while (true) {
      ++run.counters.steps_accepted;
      OnsetSolver<T> solver(body, now, slip[0], slip[1], h);
      next_ = solver();
      run.counters.evaluations_located += solver.evaluations();
      if (!body.resists || !next_.closed || !next_.turns ||
          contact_.turns(run, formula::turning(body.mobility, now.u, next_.L)) || !(T(8) * h < most)) {
        break;
      }
      h = T(8) * h;
    }
    if (!next_.closed) {
      leave(ContactEnd::lift_off);
      return false;
    }
    contact_.update(run);
    const State<T> before = run.state;
    mode_before_ = contact_.mode;
    for (std::size_t i = 0; i < 3; ++i) {
      y[at::L + i] = next_.L[static_cast<Eigen::Index>(i)];
    }
    contact_.set_mode(body, next_.slips, next_.slip_x, next_.slip_y);
    task_ = Task::after_onset;
    // What it takes to keep the contact point where it is, within h, is no impulse.
    const T usual_force = body.strength + scalar::sqrt(formula::dot(now.need, now.need));
    jams_ = scalar::sq(T(T(1e3) * h * usual_force)) < formula::dot(next_.impulse, next_.impulse);
    if (jams_) {
      note_jam(run, before);
      return false;
    }
    const Kinetics<T> then = kinetics(body, contact_.feature, y);
    const Variables<T> rate =
        rates(body, then, formula::scaled(T(T(1) / h), next_.impulse), next_.slip_x, next_.slip_y, contact_.origin);
    ahead_.length = h;
    ahead_.to = y;
    for (std::size_t i = 0; i < at::loss; ++i) {
      ahead_.to[i] = y[i] + h * rate[i];
    }
    ahead_.straight(y);
    reunite(ahead_.to);
    return true;
  }

  /// Painlevé's case: no normal force fits slip and resistance, and an impulse stops one or both.
  void note_jam(Run<T>& run, const State<T>& before) {
    contact_.update(run);
    run.record(EventKind::jam, before, [&](Event<T>& event) {
      contact_.fill(run, event);
      event.impulse_W = run.body.mass * next_.impulse;
      event.outcome = next_.slips ? ImpactOutcome::slid : ImpactOutcome::stuck;
    });
  }

  void after_onset(Run<T>& run) {
    if (!jams_ && mode_before_ != contact_.mode) {
      contact_.note(run, contact_.mode == ContactMode::sliding ? EventKind::slip : EventKind::stick);
    }
    begun_ = true;
    task_ = Task::begin;
    if (next_.turns) {
      return;
    }
    if (next_.slips) {
      lock(run);
    } else if (!jams_ && is_held_here(run)) {
      leave(ContactEnd::rest);
    }
  }

  [[nodiscard]] bool is_held_here(const Run<T>& run) const {
    return is_held(run.contact_body, place_of(run.contact_body, contact_.feature, contact_.y).r);
  }

  // --- sliding while resistance holds the attitude

  void lock(Run<T>& run) {
    const std::array<T, 2> slip = contact_.slip();
    Variables<T>& y = contact_.y;
    // The centre keeps its velocity, not the contact point its slip.
    const ContactPlace<T> now = place_of(run.contact_body, contact_.feature, y);
    const Vec3<T> v = formula::centre_velocity(now, slip[0], slip[1]);
    y[at::L] = y[at::L + 1] = y[at::L + 2] = T(0);
    locked_.emplace(run, now.r, typename LockedSlide<T>::Motion{y[at::x], y[at::y], v.x(), v.y()});
    contact_.mode = ContactMode::gliding;  // the slip as a vector
    y[at::slip] = v.x();
    y[at::direction] = v.y();
    task_ = Task::slide_locked;
  }

  void slide_locked(Run<T>& run) {
    const ContactPlace<T> now = place_of(run.contact_body, contact_.feature, contact_.y);
    Interpolant<T, 4> along;
    ahead_.length = locked_->plan(run, contact_, now, along);
    ahead_.to = contact_.y;
    ahead_.straight(contact_.y);
    constexpr std::array<std::size_t, 4> moves = {at::x, at::y, at::slip, at::direction};
    for (std::size_t i = 0; i < moves.size(); ++i) {
      ahead_.to[moves[i]] = locked_->motion()[i];
      for (std::size_t power = 1; power < along.c.size(); ++power) {
        ahead_.along.c[power][moves[i]] = along.c[power][i];
      }
    }
    task_ = Task::after_locked;
  }

  void after_locked(Run<T>& run) {
    if (locked_->end() == LockedEnd::none) {
      task_ = Task::slide_locked;
      return;
    }
    contact_.set_slip(run.contact_body, contact_.y[at::slip], contact_.y[at::direction]);
    task_ = Task::begin;
    if (locked_->end() == LockedEnd::fails) {
      leave(ContactEnd::stuck);
    } else if (locked_->end() == LockedEnd::support) {
      leave(beyond_support());
    } else if (locked_->end() == LockedEnd::stopped) {
      if (is_held_here(run)) {
        leave(ContactEnd::rest);
      } else {
        // Friction has kept the stone leaning while it slid: without it the stone rocks back.
        contact_.set_slip(run.contact_body, T(0), T(0));
        contact_.note(run, EventKind::stick);
      }
    }
  }

  ContactState<T> contact_;
  ContactIntegrator<T> integrate_;
  std::optional<LockedSlide<T>> locked_;
  Ahead<T> ahead_;
  Onset<T> next_;  // and of it:
  ContactMode mode_before_ = ContactMode::rolling;
  bool jams_ = false;
  bool begun_ = false;  // a slip or a turning, just now
  Task task_ = Task::over;
  ContactEnd end_ = ContactEnd::rest;
  T last_ = T(0);  // [s] when equations began last
  int stalled_ = 0;
  static constexpr int most_stalled = 50;  // changes of equations while no time passes: a few are in order
};

}  // namespace goishi::detail
