#pragma once
/// \file
/// Symbols for a stone on its lower cap, per unit of mass, and for small motions about lying flat.

#include <goishi/drop/equations/contact_motion.hpp>

#include "contact.hpp"

namespace derivation {

inline const Shape shape;
inline const ex arm = shape.r - shape.d;  // a: of the centre over the plane, lying flat
inline const possymbol g("g"), axial("Ia", "I_a"), transverse("It", "I_t");
inline const goishi::Mobility<ex> mobility = formula::mobility<ex>(1, {.axial = axial, .transverse = transverse});
inline const Vector none = Vector::Zero();

/// On the lower cap, gravity along −z.
inline Motion on_cap(const Vector& u, const Vector& L, const ex& radial_square) {
  return formula::contact_motion(mobility, Vector(0, 0, -g),
                                 formula::cap_contact<ex>(shape.stone, 1, u.z(), radial_square), u, L);
}

/// Small motions about lying flat: two components times a factor ε, written as one complex number.
struct SmallMotion {
  symbol epsilon{"epsilon", R"(\epsilon)"};
  realsymbol x{"x"}, y{"y"}, lx{"lx", "l_x"}, ly{"ly", "l_y"}, sx{"sx", "s_x"}, sy{"sy", "s_y"};
  ex X = x + GiNaC::I * y;       // of the axis
  ex l = lx + GiNaC::I * ly;     // of L
  ex slip = sx + GiNaC::I * sy;  // of the slip

  /// With a momentum about the axis.
  [[nodiscard]] Motion at(const ex& momentum) const {
    return on_cap(Vector(epsilon * x, epsilon * y, 1), Vector(epsilon * lx, epsilon * ly, momentum),
                  epsilon * epsilon * (x * x + y * y));
  }

  [[nodiscard]] ex first_order(const ex& form) const { return form.diff(epsilon).subs(epsilon == 0); }
  [[nodiscard]] ex first_order(const Vector& a) const { return first_order(a.x()) + GiNaC::I * first_order(a.y()); }
};

}  // namespace derivation
