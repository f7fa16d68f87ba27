#pragma once
/// \file
/// The contact phase: from the moment at which a contact stays until it ends or the stone rests. The equations change
/// where friction, the feature in contact or the sign of the normal force does; each change is located and recorded.

#include <goishi/drop/contact_state.hpp>
#include <goishi/drop/gliding.hpp>
#include <goishi/drop/integrator.hpp>
#include <goishi/drop/locked.hpp>
#include <goishi/drop/onset.hpp>
#include <goishi/drop/rolling.hpp>
#include <goishi/drop/sliding.hpp>

namespace goishi::detail {

template <Ordered T>
class ContactPhase {
 public:
  explicit ContactPhase(Run<T>& run) : run_(run), contact_(run), integrate_(contact_), body_(run.contact_body) {}

  /// From the run's state, which touches the plane and moves along it, with the feature in contact.
  [[nodiscard]] ContactEnd operator()(Feature feature) {
    contact_.enter(feature);
    T last = run_.time;
    int stalled = 0;
    while (true) {
      stalled = last < run_.time ? 0 : stalled + 1;
      last = run_.time;
      if (most_stalled < stalled) {
        return leave(ContactEnd::stuck);
      }
      if (!run_.has_room()) {
        return leave(ContactEnd::too_many_events);
      }
      bool over = false;
      switch (contact_.mode) {
        case ContactMode::rolling:
          over = roll();
          break;
        case ContactMode::sliding:
          over = slide();
          break;
        case ContactMode::gliding: {
          Gliding<T> gliding(body_, contact_.feature, contact_.origin);
          over = goes_over(integrated(gliding));
          break;
        }
      }
      if (over) {
        return leave(end_);
      }
    }
  }

  /// What of the stone touches now, or did last.
  [[nodiscard]] Feature feature() const { return contact_.feature; }

 private:
  [[nodiscard]] ContactEnd leave(ContactEnd end) {
    contact_.update_state();
    return end;
  }

  // One set of equations, up to where another holds. True when the contact phase is over; `end_` says how.

  [[nodiscard]] bool roll() {
    Rolling<T> rolling(body_, contact_.feature, contact_.origin);
    const Guard guard = integrated(rolling);
    if (guard != Guard::grip) {
      return goes_over(guard);
    }
    return hardly_turns(rolling.now) || !begin_slip(rolling.now, rolling.force) ? settle() : false;
  }

  [[nodiscard]] bool slide() {
    if (!(body_.friction < std::numeric_limits<T>::infinity())) {
      return settle();
    }
    Sliding<T> sliding(body_, contact_.feature, contact_.origin);
    const Guard guard = integrated(sliding);
    if (guard != Guard::slip) {
      return goes_over(guard);
    }
    contact_.y[at::slip] = T(0);
    return hardly_turns(sliding.now) || !end_slip() ? settle() : false;
  }

  template <class Equations>
  [[nodiscard]] Guard integrated(Equations& equations) {
    const bool begun = begun_;
    begun_ = false;
    return integrate_(equations, begun);
  }

  [[nodiscard]] bool goes_over(Guard guard) {
    switch (guard) {
      case Guard::none:
        end_ = integrate_.end();
        return true;
      case Guard::lift_off:
        end_ = ContactEnd::lift_off;
        return true;
      case Guard::support:
        end_ = beyond_support();
        return true;
      case Guard::turning:
        return slide_locked();
      case Guard::feature:
        change_feature();
        return false;
      case Guard::jam:
      case Guard::onset:
      case Guard::grip:
      case Guard::slip:
        break;
    }
    return settle();
  }

  [[nodiscard]] ContactEnd beyond_support() const {
    return T(0) <= run_.level ? ContactEnd::board_edge : ContactEnd::side;
  }

  void change_feature() {
    contact_.feature = contact_.feature != Feature::rim ? Feature::rim
                       : T(0) < contact_.y[at::u + 2]   ? Feature::lower_cap
                                                        : Feature::upper_cap;
    contact_.note(EventKind::feature);
  }

  /// Slip starts against the friction that rolling would need, in the direction that its own rate keeps. False if there is
  /// none.
  [[nodiscard]] bool begin_slip(const Kinetics<T>& now, const Vec3<T>& force) {
    T phi = scalar::atan2(T(-force.y()), T(-force.x()));
    if (!outgoing(now, phi)) {
      return false;
    }
    contact_.mode = ContactMode::sliding;
    contact_.y[at::slip] = T(0);
    contact_.y[at::direction] = phi;
    contact_.note(EventKind::slip);
    return true;
  }

  [[nodiscard]] SlipRate<T> slip_towards(const Kinetics<T>& now, const T& phi) const {
    return formula::slip_rate(now.W, now.brake, now.need, body_.friction, T(scalar::cos(phi)), T(scalar::sin(phi)));
  }

  /// From a first guess: the direction in which a slip that begins goes on, its rate pointing along it. False where no
  /// direction is such a one.
  [[nodiscard]] bool outgoing(const Kinetics<T>& now, T& phi) const {
    constexpr int directions = 64;
    for (int i = 0; i < directions; ++i) {
      T found = phi + T(2 * i) / T(directions) * scalar::pi<T>();
      refine(now, found);
      const SlipRate<T> rate = slip_towards(now, found);
      // At the cone's edge the slip has no rate yet, but for round-off.
      const T nothing = T(1e-6) * body_.strength;
      if (jam_margin(now.W.zz) < rate.denominator && rate.across_slope < T(0) && -nothing < rate.along &&
          rate.across < nothing && -nothing < rate.across) {
        phi = found;
        return true;
      }
    }
    return false;
  }

  /// Newton towards a stable zero of σ φ̇.
  void refine(const Kinetics<T>& now, T& phi) const {
    for (int i = 0; i < 50; ++i) {
      const SlipRate<T> rate = slip_towards(now, phi);
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
  [[nodiscard]] bool end_slip() {
    Rolling<T> rolling(body_, contact_.feature, contact_.origin);
    static_cast<void>(rolling(contact_.y));
    ++run_.result.counters.contact_evaluations;
    T phi = scalar::atan2(T(-rolling.force.y()), T(-rolling.force.x()));
    if (-guard_noise<T>() <= rolling.guards().value[2]) {
      contact_.mode = ContactMode::rolling;
      contact_.y[at::direction] = T(0);
      contact_.note(EventKind::stick);
      return true;
    }
    if (!outgoing(rolling.now, phi)) {
      return false;
    }
    contact_.y[at::direction] = phi;
    return true;
  }

  /// Whether turning is so slow that what begins now decides about it.
  [[nodiscard]] bool hardly_turns(const Kinetics<T>& now) const {
    const std::array<T, 2> slip = contact_.slip();
    return resistance_is_stiff(body_, contact_.y, body_.strength, onset_time(body_, now, slip[0], slip[1]));
  }

  /// Slip, turning and normal force chosen together. True when the contact phase is over; `end_` says how.
  [[nodiscard]] bool settle() {
    Variables<T>& y = contact_.y;
    Kinetics<T> now = kinetics(body_, contact_.feature, y);
    if (body_.resists && !contact_.turns(now.w)) {
      y[at::L] = y[at::L + 1] = y[at::L + 2] = T(0);
      now = kinetics(body_, contact_.feature, y);
    }
    const std::array<T, 2> slip = contact_.slip();
    const T usual = onset_time(body_, now, slip[0], slip[1]), left = run_.left();
    // What begins slowly is followed until it has a direction, as long as that costs less than a step's error, h² at most.
    const T most = T(0.1) * scalar::sqrt(run_.settings.tolerance) / contact_.scales.frequency;
    T h = usual;
    Onset<T> next;
    while (true) {
      h = left < h ? left : h;
      ++run_.result.counters.steps_accepted;
      next = OnsetSolver<T>(body_, now, slip[0], slip[1], h)();
      if (!body_.resists || !next.closed || !next.turns ||
          contact_.turns(formula::turning(body_.mobility, now.u, next.L)) || !(T(8) * h < most) || !(h < left)) {
        break;
      }
      h = T(8) * h;
    }
    if (!next.closed) {
      end_ = ContactEnd::lift_off;
      return true;
    }
    contact_.update_state();
    const State<T> before = run_.state;
    const ContactMode mode = contact_.mode;
    for (std::size_t i = 0; i < 3; ++i) {
      y[at::L + i] = next.L[static_cast<Eigen::Index>(i)];
    }
    contact_.set_mode(next.slips, next.slip_x, next.slip_y);
    // What it takes to keep the contact point where it is, within h, is no impulse.
    const T usual_force = body_.strength + scalar::sqrt(formula::dot(now.need, now.need));
    const bool jams = scalar::sq(T(T(1e3) * h * usual_force)) < formula::dot(next.impulse, next.impulse);
    if (jams) {
      note_jam(before, next);
    } else {
      const Kinetics<T> then = kinetics(body_, contact_.feature, y);
      const Variables<T> rate =
          rates(body_, then, formula::scaled(T(T(1) / h), next.impulse), next.slip_x, next.slip_y, contact_.origin);
      for (std::size_t i = 0; i < at::loss; ++i) {
        y[i] = y[i] + h * rate[i];
      }
      contact_.normalize();
      run_.time = run_.time + h;
      if (mode != contact_.mode) {
        contact_.note(contact_.mode == ContactMode::sliding ? EventKind::slip : EventKind::stick);
      }
    }
    begun_ = true;
    if (next.turns) {
      return false;
    }
    if (next.slips) {
      return slide_locked();
    }
    end_ = ContactEnd::rest;
    return !jams && is_held(body_, kinetics(body_, contact_.feature, y).r);
  }

  /// Painlevé's case: no normal force fits slip and resistance, and an impulse stops one or both.
  void note_jam(const State<T>& before, const Onset<T>& next) {
    contact_.update_state();
    Event<T>& event = run_.record(EventKind::jam, before);
    event.impulse_W = run_.body.mass * next.impulse;
    event.contact_W = run_.contact_W;
    event.normal_W = {T(0), T(0), T(1)};
    event.feature = contact_.feature;
    event.outcome = next.slips ? ImpactOutcome::slid : ImpactOutcome::stuck;
  }

  /// Sliding while resistance holds the attitude. True when the contact phase is over; `end_` says how.
  [[nodiscard]] bool slide_locked() {
    const std::array<T, 2> slip = contact_.slip();
    // The centre keeps its velocity, not the contact point its slip.
    const Kinetics<T> turning = kinetics(body_, contact_.feature, contact_.y);
    const Vec3<T> v = formula::centre_velocity(turning, slip[0], slip[1]);
    contact_.y[at::L] = contact_.y[at::L + 1] = contact_.y[at::L + 2] = T(0);
    const Kinetics<T> now = kinetics(body_, contact_.feature, contact_.y);
    LockedSlide<T> slide(run_, now.r);
    typename LockedSlide<T>::Motion motion = {contact_.y[at::x], contact_.y[at::y], v.x(), v.y()};
    Variables<T> where = contact_.y;
    const auto inside = [&](const T& x, const T& y) {
      where[at::x] = x;
      where[at::y] = y;
      return run_.board == nullptr ? T(1) : contact_.support_guard(now, where);
    };
    const LockedEnd end = slide.run(motion, inside);
    contact_.y[at::x] = motion[0];
    contact_.y[at::y] = motion[1];
    contact_.set_slip(motion[2], motion[3]);
    if (end == LockedEnd::stopped && !is_held(body_, now.r)) {
      // Friction has kept the stone leaning while it slid: without it the stone rocks back.
      contact_.set_slip(T(0), T(0));
      contact_.note(EventKind::stick);
      return false;
    }
    end_ = end == LockedEnd::stopped   ? ContactEnd::rest
           : end == LockedEnd::support ? beyond_support()
           : end == LockedEnd::time    ? ContactEnd::time
                                       : ContactEnd::too_many_steps;
    return end != LockedEnd::unlocked;
  }

  Run<T>& run_;
  ContactState<T> contact_;
  ContactIntegrator<T> integrate_;
  const ContactBody<T>& body_;
  ContactEnd end_ = ContactEnd::time;
  bool begun_ = false;                     // a slip or a turning, just now
  static constexpr int most_stalled = 50;  // changes of equations while no time passes: a few are in order
};

}  // namespace goishi::detail
