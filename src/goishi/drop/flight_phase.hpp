#pragma once
/// \file
/// Flight and impacts, until a contact stays; and what follows it.

#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/contact_phase.hpp>
#include <goishi/drop/edge_hops.hpp>
#include <goishi/drop/next_impact.hpp>
#include <goishi/drop/run.hpp>
#include <goishi/impact/laws.hpp>

namespace goishi {

namespace formula {

/// How long bounces take in all that leave the plane with v, e v, e² v …   [s]: 2 v/(g (1 − e)).
/// Domain  g > 0, e < 1.   Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] T bounces_time(const T& v, const T& g, const T& restitution) {
  return T(2) * v / (g * (T(1) - restitution));
}

}  // namespace formula

namespace detail {

template <Ordered T>
class FlightPhase {
 public:
  explicit FlightPhase(Run<T>& run)
      : run_(run),
        contact_(run),
        hops_(run),
        material_(make_material(run.settings.restitution, run.settings.friction)) {}

  /// Runs the drop to its end, and sets the status.
  void operator()() {
    if (starts_inside()) {
      return;
    }
    if (is_left_alone()) {
      return end(DropStatus::rest);
    }
    while (true) {
      if (!run_.has_room()) {
        return end(DropStatus::too_many_events);
      }
      if (!run_.has_budget()) {
        return end(DropStatus::too_many_steps);
      }
      const T left = run_.left();
      if (!(T(0) < left)) {
        return end(DropStatus::moving);
      }
      const TimeOfImpact<T> hit = next_impact(run_, left);
      run_.result.counters.root_steps += hit.steps;
      run_.result.counters.separations += hit.separations;
      if (hit.status == ImpactStatus::none) {
        if (!(left < std::numeric_limits<T>::infinity())) {
          return end(DropStatus::flies_on);
        }
        advance(left);
        return end(DropStatus::moving);
      }
      if (hit.status == ImpactStatus::not_converged) {
        // Nothing is touched until then: on from there. A gap that stays at zero is a contact.
        if (most_stretches < ++stretches_) {
          return end(DropStatus::not_converged);
        }
        advance(hit.time);
        if (hit.contact.gap < run_.settings.touching * outer_width(run_.stone) && meet(hit.contact)) {
          return;
        }
        continue;
      }
      if (hit.status == ImpactStatus::overlapping) {
        push_out(hit.contact);
        continue;
      }
      stretches_ = 0;
      margin_ = T(0) < hit.time ? T(2) : margin_;
      advance(hit.time);
      if (meet(hit.contact)) {
        return;
      }
    }
  }

 private:
  void end(DropStatus status) {
    run_.result.status = status;
    run_.record(status == DropStatus::rest || status == DropStatus::rest_leaning ? EventKind::rest : EventKind::end,
                run_.state);
  }

  void advance(const T& t) {
    if (T(0) < t) {
      run_.state = formula::free_flight(run_.state, run_.rates, run_.settings.gravity, t);
      run_.time = run_.time + t;
    }
  }

  /// Nothing moves, and without gravity nothing will.
  [[nodiscard]] bool is_left_alone() const {
    const Vec3<T>& g = run_.settings.gravity;
    const State<T>& now = run_.state;
    return !(T(0) < formula::dot(g, g)) && now.v_WB == Vec3<T>::Zero() && now.L_W == Vec3<T>::Zero();
  }

  [[nodiscard]] Pose<T> pose() const { return {run_.state.p_WB, run_.state.q_WB}; }

  [[nodiscard]] bool starts_inside() {
    T gap;
    if (run_.board == nullptr) {
      gap = separation(run_.stone, pose(), Plane<T>{}).gap;
    } else {
      gap = separation(run_.stone, pose(), *run_.board).gap;
      const T over_floor = separation(run_.stone, pose(), floor_of(*run_.board)).gap;
      gap = over_floor < gap ? over_floor : gap;
    }
    if (gap < -(run_.settings.touching * outer_width(run_.stone))) {
      run_.result.depth = -gap;
      end(DropStatus::start_inside);
      return true;
    }
    return false;
  }

  /// Out of an overlap of round-off, by a little more than that; by twice as much if it comes again at once.
  void push_out(const Separation<T>& contact) {
    const T along = formula::dot(contact.n_W, run_.state.p_WB);
    const T p = along < T(0) ? T(-along) : along;
    margin_ = margin_ + margin_;
    const T more = margin_ * std::numeric_limits<T>::epsilon() * (p + outer_width(run_.stone));
    run_.state.p_WB = run_.state.p_WB + (more - contact.gap) * contact.n_W;
  }

  // --- what happens there

  /// The stone touches. True when the drop has ended.
  [[nodiscard]] bool meet(const Separation<T>& contact) {
    const bool lasting_here = contact.other_feature == OtherFeature::surface && !hops_.is_beside(contact);
    run_.level = hops_.is_floor(contact) ? run_.board->floor : T(0);
    run_.result.ground = hops_.is_floor(contact) ? Ground::floor : Ground::board;
    run_.contact_W = contact.p_stone;
    const Vec3<T> r = contact.p_stone - run_.state.p_WB;
    const T approach = -formula::dot(formula::point_velocity(impact_body(run_), r), contact.n_W);
    if (lasting_here) {
      if (approach < *run_.settings.contact_speed) {
        push(contact, T(0), EventKind::contact);
        return stay(contact.feature);
      }
    } else if (approach < *run_.settings.edge_speed) {
      switch (hops_.hop(contact, approach)) {
        case EdgeHops<T>::End::none:
          return false;
        case EdgeHops<T>::End::rests:
          end(DropStatus::rest_leaning);
          return true;
        case EdgeHops<T>::End::too_many:
          end(DropStatus::too_many_steps);
          return true;
      }
    }
    const Event<T>& event = push(contact, material_.restitution, EventKind::impact);
    ++run_.result.counters.impacts;
    if (run_.settings.maximum_impacts <= run_.result.counters.impacts) {
      end(DropStatus::moving);
      return true;
    }
    if (lasting_here && bounces_flat(event) && closing_time() < run_.left() && stays_beside()) {
      close_bounces(contact);
      return stay(contact.feature);
    }
    return false;
  }

  /// An impulse, recorded.
  const Event<T>& push(const Separation<T>& contact, const T& restitution, EventKind kind) {
    // What closes the bounces has to leave no normal velocity, which only one law promises.
    const ImpactLaw law = kind == EventKind::contact ? ImpactLaw::chatterjee_ruina : run_.settings.law;
    const Impact<T> impact =
        resolve(law, Material<T>{restitution, material_.friction}, contact.p_stone, contact.n_W, impact_body(run_));
    const State<T> before = run_.state;
    run_.state.v_WB = impact.body.v_WB;
    run_.state.L_W = impact.body.L_W;
    Event<T>& event = run_.record(kind, before);
    event.impulse_W = impact.impulse.impulse_W;
    note_contact(event, contact);
    event.outcome = impact.impulse.outcome;
    return event;
  }

  /// Whether all further bounces are like this one: the lever is zero and stays so, nothing slips.
  [[nodiscard]] bool bounces_flat(const Event<T>& event) const {
    const Vec3<T>& g = run_.settings.gravity;
    if (T(0) < scalar::sq(g.x()) + scalar::sq(g.y()) || !(g.z() < T(0)) || !(material_.restitution < T(1)) ||
        !(run_.state.v_WB.z() < *run_.settings.closing_speed)) {
      return false;
    }
    // Moves the end by less than 1e-10 of what is summed.
    const T small = detail::at_least(T(1e-10), T(16) * std::numeric_limits<T>::epsilon());
    const Vec3<T> r = event.contact_W - run_.state.p_WB;
    if (small * run_.reach < scalar::sqrt(T(scalar::sq(r.x()) + scalar::sq(r.y())))) {
      return false;
    }
    const bool ball = !(T(0) < run_.stone.sphere_offset);
    const Vec3<T>& L = run_.state.L_W;
    const T nothing =
        small * (run_.body.mass * run_.reach * *run_.settings.closing_speed + (L.z() < T(0) ? T(-L.z()) : L.z()));
    if (!ball && scalar::sq(nothing) < scalar::sq(L.x()) + scalar::sq(L.y())) {
      return false;
    }
    if (!(T(0) < material_.friction)) {
      return true;
    }
    const Vec3<T> v = formula::point_velocity(impact_body(run_), r);
    return scalar::sqrt(T(scalar::sq(v.x()) + scalar::sq(v.y()))) <= small * *run_.settings.closing_speed;
  }

  /// Infinitely many bounces   [s].
  [[nodiscard]] T closing_time() const {
    const T v = run_.state.v_WB.z();  // round-off of zero after a plastic impact
    return T(0) < v ? formula::bounces_time(v, T(-run_.settings.gravity.z()), material_.restitution) : T(0);
  }

  /// Whether the way along the plane that the bounces take meets no edge and no side.
  [[nodiscard]] bool stays_beside() const {
    if (run_.board == nullptr) {
      return true;
    }
    const Vec3<T>& v = run_.state.v_WB;
    const T way = scalar::sqrt(T(scalar::sq(v.x()) + scalar::sq(v.y()))) * closing_time();
    if (run_.level < T(0)) {
      return way < separation(run_.stone, pose(), *run_.board).gap;
    }
    const auto inside = [&](const T& x, const T& half) { return (x < T(0) ? T(-x) : x) + way < half; };
    return inside(run_.contact_W.x(), run_.board->half_width) && inside(run_.contact_W.y(), run_.board->half_length);
  }

  void close_bounces(const Separation<T>& contact) {
    const State<T> before = run_.state;
    const T v = run_.state.v_WB.z();
    const T g = -run_.settings.gravity.z();
    const T t = closing_time();
    run_.state.v_WB.z() = T(0);
    run_.state = formula::free_flight(run_.state, run_.rates, Vec3<T>(Vec3<T>::Zero()), t);
    run_.time = run_.time + t;
    Event<T>& event = run_.record(EventKind::bounces_close, before);
    event.impulse_W = {T(0), T(0), T(run_.body.mass * (g * t - v))};
    event.contact_W = contact.p_stone;
    event.normal_W = contact.n_W;
    event.feature = contact.feature;
  }

  /// The contact phase. True when the drop has ended.
  [[nodiscard]] bool stay(Feature feature) {
    switch (contact_(feature)) {
      case ContactEnd::rest:
        run_.state.v_WB = run_.state.L_W = Vec3<T>::Zero();
        end(DropStatus::rest);
        return true;
      case ContactEnd::time:
        end(DropStatus::moving);
        return true;
      case ContactEnd::too_many_events:
        end(DropStatus::too_many_events);
        return true;
      case ContactEnd::too_many_steps:
        end(DropStatus::too_many_steps);
        return true;
      case ContactEnd::stuck:
        end(DropStatus::not_converged);
        return true;
      case ContactEnd::lift_off:
        lift_off();
        return false;
      case ContactEnd::board_edge:
        note(EventKind::board_edge);
        return false;
      case ContactEnd::side:
        hops_.touch_side();
        note(EventKind::side);
        return false;
    }
    return true;
  }

  void note(EventKind kind) {
    Event<T>& event = run_.record(kind, run_.state);
    event.feature = contact_.feature();
    event.contact_W = run_.contact_W;
    event.normal_W = {T(0), T(0), T(1)};
  }

  /// The gap is zero and so is its rate, but it opens: flies until it is so wide that its sign is sure. If it does not
  /// open for a moment, round-off opens it.
  void lift_off() {
    const State<T> before = run_.state;
    const T sure_time = opening_time(run_);
    note(EventKind::lift_off);
    run_.result.events.back().before = before;
    if (T(0) < sure_time) {
      advance(sure_time < run_.left() ? sure_time : run_.left());
      return;
    }
    Vec3<T>& p = run_.state.p_WB;
    const T level = run_.level < T(0) ? T(-run_.level) : run_.level;
    p.z() = p.z() + T(64) * std::numeric_limits<T>::epsilon() * (outer_width(run_.stone) + level);
  }

  Run<T>& run_;
  ContactPhase<T> contact_;
  EdgeHops<T> hops_;
  Material<T> material_;
  static constexpr int most_stretches = 1000;  // of one flight along an edge
  int stretches_ = 0;
  T margin_ = T(2);  // [ε] of pushing out
};

}  // namespace detail
}  // namespace goishi
