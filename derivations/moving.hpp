#pragma once
/// \file
/// Symbols for a body in motion, for a torque-free top, and for a turn.

#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>

#include "relations.hpp"

namespace derivation {

using State = goishi::State<ex>;
using Body = goishi::RigidBody<ex>;

/// A body in motion, as its points know it. B lies along the principal axes: ∫ x dm = 0, ∫ x_i x_j dm = 0 for i ≠ j.
struct Moving {
  Vector p = letters("p");  // centre of mass
  Quaternion q = quaternion_letters("q");
  Vector v = letters("v");           // its velocity
  Vector w = letters("w");           // angular velocity in B
  Vector x = letters("x");           // a point of the body, in B
  Vector E = positive_letters("E");  // ∫ x_i² dm
  ex mass = possymbol("m");
  Vector moments = Vector(E.y() + E.z(), E.z() + E.x(), E.x() + E.y());
  Relations relations = Relations().unit(q);
  Vector w_W = turned(q, w);
  Vector arm = turned(q, x);             // from the centre of mass to the point, in W
  Vector swing = w_W.cross(arm);         // velocity of the point, less the centre's
  Vector spin = over(arm.cross(swing));  // angular momentum about the centre of mass

  /// ∫ of a polynomial of degree 2 in x over the body.
  [[nodiscard]] ex over(const ex& integrand) const {
    const ex e = relations(integrand);
    ex sum = e.subs(exmap{{x.x(), 0}, {x.y(), 0}, {x.z(), 0}}) * mass;
    for (int i = 0; i < 3; ++i) {
      sum += e.coeff(x(i), 2) * E(i);
    }
    return relations(sum);
  }
  [[nodiscard]] Vector over(const Vector& integrand) const {
    return {over(integrand.x()), over(integrand.y()), over(integrand.z())};
  }
};

/// A torque-free top: any attitude, any L = Λ n, any moments, and the shipped attitude after a time t.
struct Top {
  possymbol t{"t"};
  possymbol axial{"Ia", "I_a"};
  possymbol transverse{"It", "I_t"};
  possymbol length{"Lambda", R"(\Lambda)"};
  Vector n = letters("n");
  Vector L = Vector(length * n);
  Quaternion q = quaternion_letters("q");
  realsymbol C{"C"};
  realsymbol S{"S"};
  realsymbol c{"c"};
  realsymbol s{"s"};
  ex axial_momentum = goishi::formula::axial_momentum(q, L);
  Body body = {.mass = possymbol("m"), .moments = Vector(transverse, transverse, axial)};
  ex precession_angle = t * length / transverse / 2;
  ex spin_angle = axial_momentum * t * (1 / axial - 1 / transverse) / 2;
  Relations relations = Relations().unit(q).unit(n).angle(precession_angle, C, S).angle(spin_angle, c, s);
  goishi::Mobility<ex> mobility = goishi::formula::mobility<ex>(1, {.axial = axial, .transverse = transverse});
  Quaternion path = relations(goishi::formula::free_rotation<ex>(q, L, axial_momentum, mobility, t));
};

/// A turn of a body with ω_B = Ω n about its angular velocity: q (C, S n), cosine and sine of half the angle.
struct Turn {
  possymbol C{"C"};
  realsymbol S{"S"};
  possymbol rate{"Omega", R"(\Omega)"};
  Vector n = letters("n");
  Quaternion q = quaternion_letters("q");
  Relations relations = Relations().unit(q).unit(n).square(S, 1 - pow(C, 2));
  Vector w = Vector(rate * n);
  Vector w_W = relations(turned(q, w));
  Quaternion turn = quaternion(C, Vector(n* S));
  Quaternion end = relations(hamilton(q, turn));
};

}  // namespace derivation
