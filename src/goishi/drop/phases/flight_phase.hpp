#pragma once
/// \file
/// Flight and impacts, until a contact stays; and what follows it.

#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/motion/stretch.hpp>
#include <goishi/drop/phases/contact_phase.hpp>
#include <goishi/drop/phases/edge_hops.hpp>
#include <goishi/drop/phases/next_impact.hpp>
#include <goishi/drop/state/run.hpp>
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

/// What follows a flight.
enum class Next { flight, contact, over };

/// It goes flight by flight: `plan` looks ahead to the next touch, `complete` goes there, and through what happens there.
template <Ordered T>
class FlightPhase {
 public:
  explicit FlightPhase(const Run<T>& run) : material_(make_material(run.settings.restitution, run.settings.friction)) {}

  /// From the run's state. False where nothing follows.
  [[nodiscard]] bool begin(Run<T>& run) {
    if (starts_inside(run)) {
      return false;
    }
    if (is_left_alone(run)) {
      end(run, DropStatus::rest);
      return false;
    }
    return true;
  }

  /// Plans the next flight. False where nothing ends it, or nothing can be said; the run's status tells which.
  [[nodiscard]] bool plan(Run<T>& run) {
    if (leg_ != Leg::on) {  // what has happened says it already
      return true;
    }
    constexpr int most_pushes = 64;
    for (int pushes = 0; pushes < most_pushes; ++pushes) {
      const T window = *run.settings.horizon;
      hit_ = next_impact(run, window);
      run.counters.root_steps += hit_.steps;
      run.counters.separations += hit_.separations;
      switch (hit_.status) {
        case ImpactStatus::hit:
          stretches_ = 0;
          margin_ = T(0) < hit_.time ? T(2) : margin_;
          leg_ = Leg::to_touch;
          length_ = hit_.time;
          return true;
        case ImpactStatus::none:
          leg_ = Leg::on;
          length_ = window;
          if (window < std::numeric_limits<T>::infinity()) {
            return true;
          }
          end(run, DropStatus::flies_on);
          return false;
        case ImpactStatus::not_converged:
          // Nothing is touched until then: on from there. A gap that stays at zero is a contact.
          if (most_stretches < ++stretches_) {
            end(run, DropStatus::not_converged);
            return false;
          }
          leg_ = hit_.contact.gap < run.settings.touching * outer_width(run.stone) ? Leg::to_touch : Leg::on;
          length_ = hit_.time;
          return true;
        case ImpactStatus::overlapping:
          push_out(run, hit_.contact);
          break;
      }
    }
    end(run, DropStatus::not_converged);
    return false;
  }

  /// How long the flight that is planned takes   [s].
  [[nodiscard]] const T& length() const { return length_; }

  /// What is planned, as a stretch that begins now.
  [[nodiscard]] auto motion(const Run<T>& run) const -> decltype(Stretch<T>::motion) {
    if (leg_ == Leg::closing) {
      return Bouncing<T>{run.state, T(-run.settings.gravity.z()), material_.restitution};
    }
    return Flying<T>{run.state, run.settings.gravity};
  }

  /// Goes to its end.
  [[nodiscard]] Next complete(Run<T>& run) {
    const Leg leg = leg_;
    leg_ = Leg::on;
    if (leg == Leg::closing) {
      return close_bounces(run);
    }
    advance(run, length_);
    return leg == Leg::to_touch ? meet(run, hit_.contact) : Next::flight;
  }

  /// What touches, where a contact follows.
  [[nodiscard]] Feature feature() const { return hit_.contact.feature; }

  /// The contact phase is over, with this feature.
  [[nodiscard]] Next after(Run<T>& run, ContactEnd contact, Feature feature) {
    switch (contact) {
      case ContactEnd::rest:
        run.state.v_WB = run.state.L_W = Vec3<T>::Zero();
        return end(run, DropStatus::rest);
      case ContactEnd::stuck:
        return end(run, DropStatus::not_converged);
      case ContactEnd::lift_off:
        lift_off(run, feature);
        break;
      case ContactEnd::board_edge:
        note(run, EventKind::board_edge, feature);
        break;
      case ContactEnd::side:
        hops_.touch_side(run);
        note(run, EventKind::side, feature);
        break;
    }
    return Next::flight;
  }

 private:
  /// What a flight leads to: on, the next touch, a gap that is open for sure, the end of all bounces.
  enum class Leg { on, to_touch, opening, closing };

  static Next end(Run<T>& run, DropStatus status) {
    run.status = status;
    run.record(status == DropStatus::rest || status == DropStatus::rest_leaning ? EventKind::rest : EventKind::end,
               run.state);
    return Next::over;
  }

  static void advance(Run<T>& run, const T& t) {
    if (T(0) < t) {
      run.state = formula::free_flight(run.state, run.mobility, run.settings.gravity, t);
      run.time = run.time + t;
    }
  }

  /// Nothing moves, and without gravity nothing will.
  [[nodiscard]] static bool is_left_alone(const Run<T>& run) {
    const Vec3<T>& g = run.settings.gravity;
    const State<T>& now = run.state;
    return !(T(0) < formula::dot(g, g)) && now.v_WB == Vec3<T>::Zero() && now.L_W == Vec3<T>::Zero();
  }

  [[nodiscard]] static Pose<T> pose_of(const Run<T>& run) { return {run.state.p_WB, run.state.q_WB}; }

  [[nodiscard]] static bool starts_inside(Run<T>& run) {
    T gap;
    if (!run.board) {
      gap = surface_separation(run.stone, pose_of(run)).gap;
    } else {
      gap = separation(run.stone, pose_of(run), *run.board).gap;
      const T over_floor = surface_separation(run.stone, pose_of(run), run.board->floor).gap;
      gap = over_floor < gap ? over_floor : gap;
    }
    if (gap < -(run.settings.touching * outer_width(run.stone))) {
      run.depth = -gap;
      end(run, DropStatus::start_inside);
      return true;
    }
    return false;
  }

  /// Out of an overlap of round-off, by a little more than that; by twice as much if it comes again at once.
  void push_out(Run<T>& run, const Separation<T>& contact) {
    const T along = formula::dot(contact.n_W, run.state.p_WB);
    const T p = scalar::abs(along);
    margin_ = margin_ + margin_;
    const T more = margin_ * std::numeric_limits<T>::epsilon() * (p + outer_width(run.stone));
    run.state.p_WB = run.state.p_WB + (more - contact.gap) * contact.n_W;
  }

  // --- what happens there

  /// The stone touches.
  [[nodiscard]] Next meet(Run<T>& run, const Separation<T>& contact) {
    const bool on_floor = hops_.is_floor(run, contact);
    const bool lasting_here = contact.other_feature == OtherFeature::surface && !hops_.is_beside(run, contact);
    run.level = on_floor ? run.board->floor : T(0);
    run.ground = on_floor ? Ground::floor : Ground::board;
    run.contact_W = contact.p_stone;
    const Vec3<T> r = contact.p_stone - run.state.p_WB;
    const T approach = -formula::dot(formula::point_velocity(impact_body(run), r), contact.n_W);
    if (lasting_here) {
      if (approach < *run.settings.contact_speed) {
        push(run, contact, T(0), EventKind::contact);
        return Next::contact;
      }
    } else if (approach < *run.settings.edge_speed) {
      return hops_.hop(run, contact, approach) ? end(run, DropStatus::rest_leaning) : Next::flight;
    }
    push(run, contact, material_.restitution, EventKind::impact);
    ++run.counters.impacts;
    if (lasting_here && bounces_flat(run, contact.p_stone) && stays_beside(run)) {
      leg_ = Leg::closing;
      length_ = closing_time(run);
    }
    return Next::flight;
  }

  /// An impulse, recorded.
  void push(Run<T>& run, const Separation<T>& contact, const T& restitution, EventKind kind) const {
    // What closes the bounces has to leave no normal velocity, which only one law promises.
    const ImpactLaw law = kind == EventKind::contact ? ImpactLaw::chatterjee_ruina : run.settings.law;
    const Impact<T> impact =
        resolve(law, Material<T>{restitution, material_.friction}, contact.p_stone, contact.n_W, impact_body(run));
    run.counters.root_steps += impact.impulse.rounds;
    const State<T> before = run.state;
    run.state.v_WB = impact.body.v_WB;
    run.state.L_W = impact.body.L_W;
    run.record(kind, before, [&](Event<T>& event) {
      event.impulse_W = impact.impulse.impulse_W;
      note_contact(event, contact);
      event.outcome = impact.impulse.outcome;
    });
  }

  /// Whether all further bounces are like this one: the lever is zero and stays so, nothing slips.
  [[nodiscard]] bool bounces_flat(const Run<T>& run, const Vec3<T>& contact_W) const {
    const Vec3<T>& g = run.settings.gravity;
    if (T(0) < scalar::sq(g.x()) + scalar::sq(g.y()) || !(g.z() < T(0)) || !(material_.restitution < T(1)) ||
        !(run.state.v_WB.z() < *run.settings.closing_speed)) {
      return false;
    }
    // Moves the end by less than 1e-10 of what is summed.
    const T small = scalar::max(T(1e-10), T(16) * std::numeric_limits<T>::epsilon());
    const Vec3<T> r = contact_W - run.state.p_WB;
    if (small * run.reach < scalar::sqrt(T(scalar::sq(r.x()) + scalar::sq(r.y())))) {
      return false;
    }
    const bool ball = !(T(0) < run.stone.sphere_offset);
    const Vec3<T>& L = run.state.L_W;
    const T nothing = small * (run.body.mass * run.reach * *run.settings.closing_speed + scalar::abs(T(L.z())));
    if (!ball && scalar::sq(nothing) < scalar::sq(L.x()) + scalar::sq(L.y())) {
      return false;
    }
    if (!(T(0) < material_.friction)) {
      return true;
    }
    const Vec3<T> v = formula::point_velocity(impact_body(run), r);
    return scalar::sqrt(T(scalar::sq(v.x()) + scalar::sq(v.y()))) <= small * *run.settings.closing_speed;
  }

  /// Infinitely many bounces   [s].
  [[nodiscard]] T closing_time(const Run<T>& run) const {
    const T v = run.state.v_WB.z();  // round-off of zero after a plastic impact
    return T(0) < v ? formula::bounces_time(v, T(-run.settings.gravity.z()), material_.restitution) : T(0);
  }

  /// Whether the way along the plane that the bounces take meets no edge and no side.
  [[nodiscard]] bool stays_beside(const Run<T>& run) const {
    if (!run.board) {
      return true;
    }
    const Vec3<T>& v = run.state.v_WB;
    const T way = scalar::sqrt(T(scalar::sq(v.x()) + scalar::sq(v.y()))) * closing_time(run);
    if (run.level < T(0)) {
      return way < separation(run.stone, pose_of(run), *run.board).gap;
    }
    const auto inside = [&](const T& x, const T& half) { return scalar::abs(x) + way < half; };
    return inside(run.contact_W.x(), run.board->half_width) && inside(run.contact_W.y(), run.board->half_length);
  }

  /// The end of all bounces, and a contact from there.
  [[nodiscard]] Next close_bounces(Run<T>& run) {
    const State<T> before = run.state;
    const T v = run.state.v_WB.z();
    const T g = -run.settings.gravity.z();
    run.state.v_WB.z() = T(0);
    run.state = formula::free_flight(run.state, run.mobility, Vec3<T>(Vec3<T>::Zero()), length_);
    run.time = run.time + length_;
    run.record(EventKind::bounces_close, before, [&](Event<T>& event) {
      event.impulse_W = {T(0), T(0), T(run.body.mass * (g * length_ - v))};
      event.contact_W = hit_.contact.p_stone;
      event.normal_W = hit_.contact.n_W;
      event.feature = hit_.contact.feature;
    });
    return Next::contact;
  }

  static void note(Run<T>& run, EventKind kind, Feature feature) {
    run.record(kind, run.state, [&](Event<T>& event) {
      event.feature = feature;
      event.contact_W = run.contact_W;
      event.normal_W = {T(0), T(0), T(1)};
    });
  }

  /// The gap is zero and so is its rate, but it opens: flies until it is so wide that its sign is sure. If it does not
  /// open for a moment, round-off opens it.
  void lift_off(Run<T>& run, Feature feature) {
    note(run, EventKind::lift_off, feature);
    length_ = opening_time(run);
    if (T(0) < length_) {
      leg_ = run.level < T(0) && meets_side(run) ? Leg::to_touch : Leg::opening;
      return;
    }
    Vec3<T>& p = run.state.p_WB;
    const T level = scalar::abs(T(run.level));
    p.z() = p.z() + T(64) * std::numeric_limits<T>::epsilon() * (outer_width(run.stone) + level);
  }

  /// Whether the way that opens a gap over the floor leads to the board's side: it is then as long as up to there.
  [[nodiscard]] bool meets_side(Run<T>& run) {
    const FlightPath<T> path = path_of(run.state, run.mobility, run.settings.gravity);
    const TimeOfImpact<T> hit = time_of_impact(run.stone, path, *run.board, length_);
    run.counters.root_steps += hit.steps;
    run.counters.separations += hit.separations;
    if (hit.status != ImpactStatus::hit) {
      return false;
    }
    hit_ = hit;
    length_ = hit.time;
    return true;
  }

  EdgeHops<T> hops_;
  Material<T> material_;
  TimeOfImpact<T> hit_ = {};
  Leg leg_ = Leg::on;
  T length_ = T(0);
  static constexpr int most_stretches = 1000;  // of one flight along an edge
  int stretches_ = 0;
  T margin_ = T(2);  // [ε] of pushing out
};

}  // namespace detail
}  // namespace goishi
