#pragma once
/// \file
/// Impacts for the claims: stones that meet the board or each other, thin ones and balls among them; and mechanics in
/// long double from the full tensors, which share no formula with src/goishi/impact.

#include <array>
#include <cmath>
#include <goishi/impact/laws.hpp>
#include <goishi/mass/inertia.hpp>
#include <limits>

#include <fmt/format.h>

#include "verify/samples/contact.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify {

inline constexpr std::array all_laws = {ImpactLaw::chatterjee_ruina, ImpactLaw::published, ImpactLaw::stronge};

/// A stone that meets another body at a point.
struct Striker {
  Specimen specimen;
  MassProperties<double> body;
  Quat<double> q_WB;
  ImpactBody<double> state;
};

struct Encounter {
  Striker first, second;
  bool two = false;  // else the second is the board
  Vec3<double> p_WC, n_W;
  Material<double> material;
};

/// A stone of `draw_stone` that touches the plane through p with the normal n from above, moving anyhow.
[[nodiscard]] inline Striker draw_striker(Context& context, int i, const Vec3<double>& p_WC, const Vec3<double>& n_W) {
  Striker result{draw_stone(context, i), {}, draw_attitude(context.random()), {}};
  const Stone<double>& stone = result.specimen.stone;
  result.body = mass_properties(stone, Mass{context.uniform(0.5, 2.0)});
  const Vec3<double> down = result.q_WB.conjugate() * Vec3<double>(-n_W);
  const Vec3<double> r = result.q_WB * support(stone, Vec3<double>(down.normalized())).p_B;
  const double spin = context.uniform(0.0, 1.0) * (i % 3 == 0 ? 0.0 : i % 3 == 1 ? 5.0 : 100.0);
  const Mat3<double> R = result.q_WB.toRotationMatrix();
  const Vec3<double> w_B = spin * draw_unit(context) / outer_width(stone);
  const Vec3<double> L_B(result.body.moments.transverse * w_B.x(), result.body.moments.transverse * w_B.y(),
                         result.body.moments.axial * w_B.z());
  result.state = {.mobility = make_mobility(result.body),
                  .p_WB = p_WC - r,
                  .u_W = formula::symmetry_axis(result.q_WB),
                  .v_WB = context.uniform(0.1, 1.0) * draw_unit(context),
                  .L_W = R * L_B};
  return result;
}

/// Restitution and friction over their whole range, the ends on purpose.
[[nodiscard]] inline Material<double> draw_material(Context& context, int i) {
  const double e = i % 5 == 0 ? 0.0 : i % 5 == 1 ? 1.0 : context.uniform(0.0, 1.0);
  const double mu = i % 7 == 0   ? 0.0
                    : i % 7 == 1 ? std::numeric_limits<double>::infinity()
                    : i % 7 == 2 ? std::pow(10.0, context.uniform(-6.0, 6.0))
                                 : context.uniform(0.0, 2.0);
  return make_material(e, mu);
}

[[nodiscard]] inline Encounter draw_encounter(Context& context, int i) {
  Encounter result;
  result.two = i % 2 == 1;
  result.n_W = draw_unit(context);
  result.p_WC = 0.1 * draw_unit(context);
  result.first = draw_striker(context, i / 2, result.p_WC, result.n_W);
  result.second = draw_striker(context, i / 2 + 1, result.p_WC, Vec3<double>(-result.n_W));
  result.material = draw_material(context, i / 2);
  return result;
}

/// Both bodies after; without a second one, that is as it was.
[[nodiscard]] inline TwoBodyImpact<double> strike(const Encounter& met, ImpactLaw law) {
  if (met.two) {
    return resolve(law, met.material, met.p_WC, met.n_W, met.first.state, met.second.state);
  }
  const Impact<double> one = resolve(law, met.material, met.p_WC, met.n_W, met.first.state);
  return {.impulse = one.impulse, .first = one.body, .second = {met.second.state.v_WB, met.second.state.L_W}};
}

// --- the witness

/// A body in long double, its tensor in W inverted in full.
struct Witness {
  long double mass;
  Long3 arm;  // from the centre of mass to the contact
  Mat3<long double> inverse;

  explicit Witness(const Striker& striker, const Vec3<double>& p_WC)
      : mass(static_cast<long double>(striker.body.mass)), arm((p_WC - striker.state.p_WB).cast<long double>()) {
    const Quat<long double> q = striker.q_WB.cast<long double>().normalized();
    const Mat3<long double> R = q.toRotationMatrix();
    Mat3<long double> principal = Mat3<long double>::Zero();
    principal.diagonal() << static_cast<long double>(striker.body.moments.transverse),
        static_cast<long double>(striker.body.moments.transverse), static_cast<long double>(striker.body.moments.axial);
    inverse = (R * principal * R.transpose()).inverse();
  }

  [[nodiscard]] Long3 contact_velocity(const Vec3<double>& v, const Vec3<double>& L) const {
    return v.cast<long double>() + Long3(inverse * L.cast<long double>()).cross(arm);
  }
  [[nodiscard]] long double energy(const Vec3<double>& v, const Vec3<double>& L) const {
    const Long3 spin = L.cast<long double>();
    return (mass * v.cast<long double>().squaredNorm() + spin.dot(Long3(inverse * spin))) / 2;
  }
  /// The contact matrix: column by column, what a unit impulse does.
  [[nodiscard]] Mat3<long double> matrix() const {
    Mat3<long double> W;
    for (int k = 0; k < 3; ++k) {
      const Long3 unit = Long3::Unit(k);
      W.col(k) = unit / mass + Long3(inverse * arm.cross(unit)).cross(arm);
    }
    return W;
  }
};

/// The witnesses of both, and what an encounter looked like before.
struct Meeting {
  const Encounter& met;
  Witness first, second;
  Long3 n, before;
  Mat3<long double> W;
  long double energy;  // of those that answer
  double scale;        // of velocities at the contact: centre and spin added up, so as not to reward cancellation

  explicit Meeting(const Encounter& encounter)
      : met(encounter),
        first(encounter.first, encounter.p_WC),
        second(encounter.second, encounter.p_WC),
        n(encounter.n_W.cast<long double>().normalized()),
        before(velocity(encounter.first.state, encounter.second.state)),
        W(first.matrix()),
        energy(energy_of(encounter.first.state, encounter.second.state)),
        scale(size(encounter.first, first) + (encounter.two ? size(encounter.second, second) : 0.0)) {
    if (met.two) {
      W += second.matrix();
    }
  }

  /// Of the contact, first less second; of two `ImpactBody` or two `BodyVelocity`.
  template <class A, class B>
  [[nodiscard]] Long3 velocity(const A& one, const B& other) const {
    const Long3 v = first.contact_velocity(one.v_WB, one.L_W);
    return met.two ? Long3(v - second.contact_velocity(other.v_WB, other.L_W)) : v;
  }
  template <class A, class B>
  [[nodiscard]] long double energy_of(const A& one, const B& other) const {
    return first.energy(one.v_WB, one.L_W) + (met.two ? second.energy(other.v_WB, other.L_W) : 0.0L);
  }
  [[nodiscard]] static double size(const Striker& striker, const Witness& witness) {
    const Long3 spin = witness.inverse * striker.state.L_W.cast<long double>();
    return static_cast<double>(spin.norm() * witness.arm.norm()) + striker.state.v_WB.norm();
  }
  [[nodiscard]] bool approaches() const { return before.dot(n) < -1e-12L * static_cast<long double>(scale); }
};

[[nodiscard]] inline std::string describe(const Encounter& met, ImpactLaw law) {
  return fmt::format("{}, {}, e = {:a}, μ = {:a}, {}{}, n = {}", to_string(law), met.two ? "two" : "one",
                     met.material.restitution, met.material.friction, describe(met.first.specimen),
                     met.two ? " and " + describe(met.second.specimen) : "", describe(met.n_W));
}

}  // namespace goishi::verify
