#pragma once
/// \file
/// Symbols for a stone in contact with a plane: any axis, any momentum, any support function, any force.

#include <goishi/drop/equations/contact_motion.hpp>
#include <string>

#include "impact.hpp"

namespace derivation {

using goishi::ContactGeometry;
using goishi::ContactMotion;
using Geometry = ContactGeometry<ex>;
using Motion = ContactMotion<ex>;

inline const Vector up = Vector(0, 0, 1);

/// A stone of sphere radius r, offset d and rim radii r₁, r₂; what the formulas of contact read of it.
struct Shape {
  possymbol r{"r"};
  possymbol d{"d"};
  possymbol r1{"r1", "r_1"};
  possymbol r2{"r2", "r_2"};
  goishi::Stone<ex> stone = [this] {
    goishi::Stone<ex> made;
    made.height = 2 * (r - d);
    made.sphere_radius = r;
    made.sphere_offset = d;
    made.bevel_major_radius = r1;
    made.bevel_minor_radius = r2;
    return made;
  }();
};

/// A moving stone, per unit of mass. Its support function is any: S(u_z) is its Taylor polynomial of degree 2 about η,
/// and η = u_z after what has to be differentiated is.
struct Touching {
  Vector u = letters("u");
  Vector L = letters("L");
  Vector g = letters("g");
  possymbol transverse{"B"};
  realsymbol axial{"C"};
  realsymbol eta{"eta", R"(\eta)"};
  realsymbol height{"H", "S"};
  realsymbol slope{"H'", "S'"};
  realsymbol curvature{"H''", "S''"};
  goishi::Mobility<ex> mobility{.linear = 1, .transverse = transverse, .axial = axial};
  Geometry geometry{.height = support(u.z()), .slope = slope + curvature * (u.z() - eta), .curvature = ex(curvature)};
  Motion now = formula::contact_motion(mobility, g, geometry, u, L);

  [[nodiscard]] ex support(const ex& at) const {
    return height + slope * (at - eta) + curvature * pow(at - eta, 2) / 2;
  }
  [[nodiscard]] ex there(const ex& form) const { return form.subs(eta == u.z()); }
  [[nodiscard]] Vector there(const Vector& a) const { return {there(a.x()), there(a.y()), there(a.z())}; }

  /// J x, J = 1/I_t + (1/I_a − 1/I_t) u uᵀ.
  [[nodiscard]] Vector J(const Vector& x) const { return Vector(transverse * x) + Vector(axial * u.dot(x) * u); }

  /// From the centre to the contact, as it is proved to be.
  [[nodiscard]] Vector r() const { return -geometry.height * up - geometry.slope * Vector(u.x(), u.y(), 0); }

  /// d/dt by the chain rule, u and L at these rates.
  [[nodiscard]] ex rate(const ex& of, const Vector& u_rate, const Vector& L_rate) const {
    ex sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += of.diff(GiNaC::ex_to<symbol>(u(i))) * u_rate(i) + of.diff(GiNaC::ex_to<symbol>(L(i))) * L_rate(i);
    }
    return there(sum);
  }
  [[nodiscard]] Vector rate(const Vector& of, const Vector& u_rate, const Vector& L_rate) const {
    return {rate(of.x(), u_rate, L_rate), rate(of.y(), u_rate, L_rate), rate(of.z(), u_rate, L_rate)};
  }
};

}  // namespace derivation
