#pragma once
/// \file
/// Contacts that last on an edge, on a side, or at two places: a scheme of lower order. Such a contact is a series of
/// elastic micro-impacts, with friction and resistance taken from their impulses; the result says that it was used.

#include <goishi/contact/contact.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/drop/rest/statics.hpp>
#include <goishi/drop/state/run.hpp>
#include <goishi/impact/laws.hpp>
#include <limits>

namespace goishi::detail {

/// The run's body as an impact sees it.
template <Ordered T>
[[nodiscard]] ImpactBody<T> impact_body(const Run<T>& run) {
  return {run.mobility, run.state.p_WB, symmetry_axis(run.state.q_WB), run.state.v_WB, run.state.L_W};
}

/// What a run notes of a contact.
template <Ordered T>
void note_contact(Event<T>& event, const Separation<T>& contact) {
  event.contact_W = contact.p_stone;
  event.normal_W = contact.n_W;
  event.feature = contact.feature;
  event.other_feature = contact.other_feature;
}

template <Ordered T>
class EdgeHops {
 public:
  [[nodiscard]] static bool is_floor(const Run<T>& run, const Separation<T>& contact) {
    return run.board && contact.other_feature == OtherFeature::surface &&
           contact.p_other.z() < -(run.board->thickness / T(2));
  }

  /// The side was touched just now: what lasts on the floor is then a second contact.
  void touch_side(const Run<T>& run) { last_side_ = run.time; }

  /// Whether the contact point is at the surface's edge, or the stone, touching the floor, has just touched the side.
  [[nodiscard]] bool is_beside(const Run<T>& run, const Separation<T>& contact) const {
    if (!run.board) {
      return false;
    }
    if (is_floor(run, contact)) {
      return run.time - last_side_ < T(0.15) / run.scales.frequency;  // longer than a hop takes
    }
    const Board<T>& board = *run.board;
    const T margin = T(1e-6) * run.reach;  // the contact phase ends at the edge: not to enter it again there
    return !(scalar::abs(contact.p_other.x()) < board.half_width - margin &&
             scalar::abs(contact.p_other.y()) < board.half_length - margin);
  }

  /// A micro-impact: elastic, so that it takes no energy. One that is too slow to go on from is made as fast as a third
  /// of `edge_speed`: friction takes that again, and `keep_energy` what it leaves. True where the stone is then at rest.
  [[nodiscard]] bool hop(Run<T>& run, const Separation<T>& contact, const T& approach) {
    run.lower_order = true;
    const T energy = run.energy();
    least_energy_ = energy < least_energy_ ? energy : least_energy_;
    ++run.counters.edge_impacts;
    const ImpactBody<T> body = impact_body(run);
    const Impact<T> impact = resolve(ImpactLaw::chatterjee_ruina, Material<T>{T(1), run.settings.friction},
                                     contact.p_stone, contact.n_W, body);
    const State<T> before = run.state;
    run.state.v_WB = impact.body.v_WB;
    run.state.L_W = impact.body.L_W;
    resist(run, contact.n_W, impact.impulse.normal);
    const T lacking = *run.settings.edge_speed / T(3) - scalar::abs(approach);
    if (T(0) < lacking) {
      lift(run, contact, lacking);
    }
    keep_energy(run);
    if (contact.other_feature != OtherFeature::surface) {
      last_side_ = run.time;
    }
    if (T(1.5) / run.scales.frequency < run.time - last_hop_) {
      run.record(EventKind::contact, before, [&](Event<T>& event) {
        event.impulse_W = impact.impulse.impulse_W;
        note_contact(event, contact);
        event.outcome = impact.impulse.outcome;
      });
    }
    last_hop_ = run.time;
    return rests_leaning(run, contact);
  }

 private:
  /// Rolling resistance and pivot friction over the time that a normal impulse stands for; they do not reverse the
  /// turning.
  static void resist(Run<T>& run, const Vec3<T>& n, const T& normal) {
    if (!run.contact_body.resists) {
      return;
    }
    const Vec3<T> u = impact_body(run).u_W;
    const Vec3<T> w = formula::turning(run.mobility, u, run.state.L_W);
    const Vec3<T> change = normal * resistance_about(run.contact_body, n, w);
    const Vec3<T> w_change = formula::turning(run.mobility, u, change);
    // The energy of rotation is least at the share −change · ω / change · Δω.
    const T power = -formula::dot(change, w), most = formula::dot(change, w_change);
    run.state.L_W = run.state.L_W + (power < most ? T(power / most) : T(1)) * change;
  }

  /// The torque per normal force where the normal is n: pivot friction is against turning about it.
  [[nodiscard]] static Vec3<T> resistance_about(const ContactBody<T>& body, const Vec3<T>& n, const Vec3<T>& w) {
    const T pivot = formula::dot(n, w);
    const Vec3<T> rolling = formula::plus(w, T(-pivot), n);
    const T size = scalar::sqrt(formula::dot(rolling, rolling));
    const Vec3<T> torque = resistance_torque(body, Vec3<T>(size, T(0), pivot));
    return formula::combination(T(0) < size ? T(torque.x() / size) : T(0), rolling, torque.z(), n);
  }

  [[nodiscard]] static T kinetic_energy_of(const Run<T>& run) {
    return formula::rotational_energy(run.state, run.body) + formula::translational_energy(run.state, run.body);
  }

  /// Makes the contact point leave faster by `lacking`. (With the energy of the rest of the motion, a stone that slides
  /// down between two contacts would only creep: it would pay for all its hops.)
  static void lift(Run<T>& run, const Separation<T>& contact, const T& lacking) {
    const ImpactBody<T> body = impact_body(run);
    const Vec3<T> r = contact.p_stone - body.p_WB;
    const ContactMatrix<T> W = formula::contact_matrix(run.mobility, body.u_W, r);
    const Vec3<T>& n = contact.n_W;
    const BodyVelocity<T> lifted =
        formula::pushed(body, r, Vec3<T>(lacking / formula::dot(n, formula::product(W, n)) * n));
    run.state.v_WB = lifted.v_WB;
    run.state.L_W = lifted.L_W;
  }

  /// However many hops are lifted: never more than one hop's energy above the least that there was.
  void keep_energy(Run<T>& run) const {
    const T excess = run.energy() - least_energy_ - run.body.mass * scalar::sq(*run.settings.edge_speed) / T(2);
    const T kinetic = kinetic_energy_of(run);
    if (T(0) < excess && T(0) < kinetic) {
      const T scale = excess < kinetic ? formula::slowing(excess, kinetic) : T(0);
      run.state.v_WB = scale * run.state.v_WB;
      run.state.L_W = scale * run.state.L_W;
    }
  }

  /// Whether the stone moves no faster than its hops, and what it touches holds it where it is.
  [[nodiscard]] static bool rests_leaning(Run<T>& run, const Separation<T>& contact) {
    const T speed2 = scalar::sq(*run.settings.edge_speed);
    // Statics costs more than a hop.
    if (run.counters.edge_impacts % 16 != 0 || T(2) * run.body.mass * speed2 < kinetic_energy_of(run) ||
        !is_held_here(run, contact)) {
      return false;
    }
    run.state.v_WB = run.state.L_W = Vec3<T>::Zero();
    return true;
  }

  /// By the contact of the hop, and by the floor or the board if that is within a hop's height too.
  [[nodiscard]] static bool is_held_here(const Run<T>& run, const Separation<T>& contact) {
    const Vec3<T>& p = run.state.p_WB;
    std::array<Support<T>, 2> supports = {Support<T>{contact.p_stone - p, contact.n_W}};
    std::size_t count = 1;
    if (run.board) {
      const Pose<T> pose{p, run.state.q_WB};
      const Separation<T> other = is_floor(run, contact) ? separation(run.stone, pose, *run.board)
                                                         : separation(run.stone, pose, floor_of(*run.board));
      if (other.gap < hop_height(run.settings, run.contact_body.strength)) {
        supports[count++] = {other.p_stone - p, other.n_W};
      }
    }
    return is_held(run.contact_body, supports, count);
  }

  T least_energy_ = std::numeric_limits<T>::infinity();  // [J] at any hop
  T last_hop_ = -std::numeric_limits<T>::infinity(), last_side_ = -std::numeric_limits<T>::infinity();  // [s]
};

}  // namespace goishi::detail
