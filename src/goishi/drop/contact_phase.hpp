#pragma once
/// \file
/// The contact phase: from the moment at which a contact stays until it ends or the stone rests. The equations change
/// where friction, the feature in contact or the sign of the normal force does; each change is located and recorded.

#include <goishi/drop/contact_state.hpp>
#include <goishi/drop/gliding.hpp>
#include <goishi/drop/integrator.hpp>
#include <goishi/drop/locked.hpp>
#include <goishi/drop/rolling.hpp>
#include <goishi/drop/sliding.hpp>
#include <goishi/impact/laws.hpp>

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
      if (contact_.mode == ContactMode::sliding && !(body_.friction < std::numeric_limits<T>::infinity()) && !unjam()) {
        return leave(ContactEnd::lift_off);
      }
      if (!run_.has_room()) {
        return leave(ContactEnd::too_many_events);
      }
      Guard guard = Guard::none;
      if (contact_.mode == ContactMode::rolling) {
        Rolling<T> rolling(body_, contact_.feature, contact_.origin);
        guard = integrate_(rolling);
        if (guard == Guard::grip) {
          if (!begin_slip(rolling.now, rolling.force)) {
            return leave(ContactEnd::lift_off);
          }
          continue;
        }
      } else if (contact_.mode == ContactMode::sliding) {
        Sliding<T> sliding(body_, contact_.feature, contact_.origin);
        guard = integrate_(sliding);
        if (guard == Guard::slip) {
          if (!end_slip()) {
            return leave(ContactEnd::lift_off);
          }
          continue;
        }
      } else {
        Gliding<T> gliding(body_, contact_.feature, contact_.origin);
        guard = integrate_(gliding);
      }
      if (guard == Guard::none) {
        return leave(integrate_.end());
      }
      if (guard == Guard::turning) {
        if (slide_locked()) {
          return leave(locked_end_);
        }
        continue;
      }
      if (guard == Guard::lift_off) {
        return leave(ContactEnd::lift_off);
      }
      if (guard == Guard::support) {
        return leave(T(0) <= run_.level ? ContactEnd::board_edge : ContactEnd::side);
      }
      if (guard == Guard::jam) {
        if (contact_.mode == ContactMode::rolling ? !stop() : !unjam()) {
          return leave(ContactEnd::lift_off);
        }
      } else {
        change_feature();
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
    contact_.y[at::slip] = T(0);
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

  /// No normal force fits the resistance: an impulse of both stops the stone. False if it would have to pull.
  [[nodiscard]] bool stop() {
    contact_.update_state();
    const State<T> before = run_.state;
    if (T(0) < before.v_WB.z()) {
      return false;
    }
    run_.state.v_WB = run_.state.L_W = Vec3<T>::Zero();
    note_jam(before, Vec3<T>(-run_.body.mass * before.v_WB));
    return true;
  }

  void note_jam(const State<T>& before, const Vec3<T>& impulse) {
    Event<T>& event = run_.record(EventKind::jam, before);
    event.impulse_W = impulse;
    event.contact_W = run_.contact_W;
    event.normal_W = {T(0), T(0), T(1)};
    event.feature = contact_.feature;
    event.outcome = ImpactOutcome::stuck;
    contact_.enter(contact_.feature);
  }

  /// Painlevé's case: no normal force fits the slip, so an impulse stops it. Under infinite friction any slip is such a
  /// case, and it may pull. False if the impulse would have to pull and may not.
  [[nodiscard]] bool unjam() {
    contact_.update_state();
    const State<T> before = run_.state;
    const Kinetics<T> now = kinetics(body_, contact_.feature, contact_.y);
    const Vec3<T>& r = now.r;
    const Vec3<T>& u = now.u;
    const ImpactBody<T> body{run_.mobility, before.p_WB, u, before.v_WB, before.L_W};
    const ContactMatrix<T> W = formula::contact_matrix(run_.mobility, u, r);
    const Vec3<T> impulse = -formula::solution(W, formula::point_velocity(body, r));
    if (impulse.z() < T(0) && body_.friction < std::numeric_limits<T>::infinity()) {
      return false;
    }
    const BodyVelocity<T> after = formula::pushed(body, r, impulse);
    run_.state.v_WB = after.v_WB;
    run_.state.L_W = after.L_W;
    note_jam(before, impulse);
    return true;
  }

  /// Sliding while resistance holds the attitude. True when the contact phase is over; `locked_end_` says how.
  [[nodiscard]] bool slide_locked() {
    const std::array<T, 2> slip = contact_.slip();
    // The centre keeps its velocity, not the contact point its slip.
    const Kinetics<T> turning = kinetics(body_, contact_.feature, contact_.y);
    const T v_x = slip[0] - turning.point.x(), v_y = slip[1] - turning.point.y();
    contact_.y[at::L] = contact_.y[at::L + 1] = contact_.y[at::L + 2] = T(0);
    const Kinetics<T> now = kinetics(body_, contact_.feature, contact_.y);
    LockedSlide<T> slide(run_, now.r);
    typename LockedSlide<T>::Motion motion = {contact_.y[at::x], contact_.y[at::y], v_x, v_y};
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
    locked_end_ = end == LockedEnd::stopped   ? ContactEnd::rest
                  : end == LockedEnd::support ? (T(0) <= run_.level ? ContactEnd::board_edge : ContactEnd::side)
                  : end == LockedEnd::time    ? ContactEnd::time
                                              : ContactEnd::too_many_steps;
    return end != LockedEnd::unlocked;
  }

  Run<T>& run_;
  ContactState<T> contact_;
  ContactIntegrator<T> integrate_;
  const ContactBody<T>& body_;
  ContactEnd locked_end_ = ContactEnd::time;
  static constexpr int most_stalled = 50;  // changes of equations while no time passes: a few are in order
};

}  // namespace goishi::detail
