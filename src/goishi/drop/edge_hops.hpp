#pragma once
/// \file
/// Contacts that last on an edge, on a side, or at two places: a scheme of lower order. Such a contact is a series of
/// elastic micro-impacts, with friction and resistance taken from their impulses; the result says that it was used.

#include <goishi/contact/contact.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/drop/run.hpp>
#include <goishi/drop/statics.hpp>
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
  explicit EdgeHops(Run<T>& run) : run_(run) {}

  enum class End { none, rests, too_many };

  [[nodiscard]] bool is_floor(const Separation<T>& contact) const {
    return run_.board != nullptr && contact.other_feature == OtherFeature::surface &&
           contact.p_other.z() < -(run_.board->thickness / T(2));
  }

  /// The side was touched just now: what lasts on the floor is then a second contact.
  void touch_side() { last_side_ = run_.time; }

  /// Whether the contact point is at the surface's edge, or the stone, touching the floor, has just touched the side.
  [[nodiscard]] bool is_beside(const Separation<T>& contact) const {
    if (run_.board == nullptr) {
      return false;
    }
    if (is_floor(contact)) {
      return run_.time - last_side_ < T(0.15) / run_.scales.frequency;  // longer than a hop takes
    }
    const auto magnitude = [](const T& x) { return x < T(0) ? T(-x) : x; };
    const Board<T>& board = *run_.board;
    const T margin = T(1e-6) * run_.reach;  // the contact phase ends at the edge: not to enter it again there
    return !(magnitude(contact.p_other.x()) < board.half_width - margin &&
             magnitude(contact.p_other.y()) < board.half_length - margin);
  }

  /// A micro-impact: elastic, so that it takes no energy. One that is too slow to go on from is made as fast as a third
  /// of `edge_speed`: friction takes that again, and `keep_energy` what it leaves.
  [[nodiscard]] End hop(const Separation<T>& contact, const T& approach) {
    run_.result.lower_order = true;
    const T energy = run_.energy();
    least_energy_ = energy < least_energy_ ? energy : least_energy_;
    ++run_.result.counters.edge_impacts;
    const ImpactBody<T> body = impact_body(run_);
    const Impact<T> impact = resolve(ImpactLaw::chatterjee_ruina, Material<T>{T(1), run_.settings.friction},
                                     contact.p_stone, contact.n_W, body);
    const State<T> before = run_.state;
    run_.state.v_WB = impact.body.v_WB;
    run_.state.L_W = impact.body.L_W;
    resist(contact.n_W, impact.impulse.normal);
    const T lacking = *run_.settings.edge_speed / T(3) - (approach < T(0) ? T(-approach) : approach);
    if (T(0) < lacking) {
      lift(contact, lacking);
    }
    keep_energy();
    if (contact.other_feature != OtherFeature::surface) {
      last_side_ = run_.time;
    }
    if (T(1.5) / run_.scales.frequency < run_.time - last_hop_) {
      Event<T>& event = run_.record(EventKind::contact, before);
      event.impulse_W = impact.impulse.impulse_W;
      note_contact(event, contact);
      event.outcome = impact.impulse.outcome;
    }
    last_hop_ = run_.time;
    return rests_leaning(contact);
  }

 private:
  /// Rolling resistance and pivot friction over the time that a normal impulse stands for; they do not reverse the
  /// turning.
  void resist(const Vec3<T>& n, const T& normal) {
    if (!run_.contact_body.resists) {
      return;
    }
    const Vec3<T> u = impact_body(run_).u_W;
    const Vec3<T> w = formula::turning(run_.mobility, u, run_.state.L_W);
    const Vec3<T> change = normal * resistance_about(n, w);
    const Vec3<T> w_change = formula::turning(run_.mobility, u, change);
    // The energy of rotation is least at the share −change · ω / change · Δω.
    const T power = -formula::dot(change, w), most = formula::dot(change, w_change);
    run_.state.L_W = run_.state.L_W + (power < most ? T(power / most) : T(1)) * change;
  }

  /// The torque per normal force where the normal is n: pivot friction is against turning about it.
  [[nodiscard]] Vec3<T> resistance_about(const Vec3<T>& n, const Vec3<T>& w) const {
    const T pivot = formula::dot(n, w);
    const Vec3<T> rolling = formula::plus(w, T(-pivot), n);
    const T size = scalar::sqrt(formula::dot(rolling, rolling));
    const Vec3<T> torque = resistance_torque(run_.contact_body, Vec3<T>(size, T(0), pivot));
    return formula::combination(T(0) < size ? T(torque.x() / size) : T(0), rolling, torque.z(), n);
  }

  [[nodiscard]] T kinetic_energy_now() const {
    return formula::rotational_energy(run_.state, run_.body) + formula::translational_energy(run_.state, run_.body);
  }

  /// Makes the contact point leave faster by `lacking`. (With the energy of the rest of the motion, a stone that slides
  /// down between two contacts would only creep: it would pay for all its hops.)
  void lift(const Separation<T>& contact, const T& lacking) {
    const ImpactBody<T> body = impact_body(run_);
    const Vec3<T> r = contact.p_stone - body.p_WB;
    const ContactMatrix<T> W = formula::contact_matrix(run_.mobility, body.u_W, r);
    const Vec3<T>& n = contact.n_W;
    const BodyVelocity<T> lifted =
        formula::pushed(body, r, Vec3<T>(lacking / formula::dot(n, formula::product(W, n)) * n));
    run_.state.v_WB = lifted.v_WB;
    run_.state.L_W = lifted.L_W;
  }

  /// However many hops are lifted: never more than one hop's energy above the least that there was.
  void keep_energy() {
    const T excess = run_.energy() - least_energy_ - run_.body.mass * scalar::sq(*run_.settings.edge_speed) / T(2);
    const T kinetic = kinetic_energy_now();
    if (T(0) < excess && T(0) < kinetic) {
      const T scale = excess < kinetic ? formula::slowing(excess, kinetic) : T(0);
      run_.state.v_WB = scale * run_.state.v_WB;
      run_.state.L_W = scale * run_.state.L_W;
    }
  }

  /// Whether the stone moves no faster than its hops, and what it touches holds it where it is.
  [[nodiscard]] End rests_leaning(const Separation<T>& contact) {
    if (!run_.has_budget()) {
      return End::too_many;
    }
    const T speed2 = scalar::sq(*run_.settings.edge_speed);
    // Statics costs more than a hop.
    if (run_.result.counters.edge_impacts % 16 != 0 || T(2) * run_.body.mass * speed2 < kinetic_energy_now() ||
        !is_held_here(contact)) {
      return End::none;
    }
    run_.state.v_WB = run_.state.L_W = Vec3<T>::Zero();
    return End::rests;
  }

  /// By the contact of the hop, and by the floor or the board if that is within a hop's height too.
  [[nodiscard]] bool is_held_here(const Separation<T>& contact) const {
    const Vec3<T>& p = run_.state.p_WB;
    std::array<Support<T>, 2> supports = {Support<T>{contact.p_stone - p, contact.n_W}};
    std::size_t count = 1;
    if (run_.board != nullptr) {
      const Pose<T> pose{p, run_.state.q_WB};
      const Separation<T> other = is_floor(contact) ? separation(run_.stone, pose, *run_.board)
                                                    : separation(run_.stone, pose, floor_of(*run_.board));
      if (other.gap < hop_height(run_.settings, run_.contact_body.strength)) {
        supports[count++] = {other.p_stone - p, other.n_W};
      }
    }
    return is_held(run_.contact_body, supports, count);
  }

  Run<T>& run_;
  T least_energy_ = std::numeric_limits<T>::infinity();  // [J] at any hop
  T last_hop_ = -std::numeric_limits<T>::infinity(), last_side_ = -std::numeric_limits<T>::infinity();  // [s]
};

}  // namespace goishi::detail
