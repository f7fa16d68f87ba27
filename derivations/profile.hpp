#pragma once
/// \file
/// A stone's profile by the angle of its normal, and a profile of continuous curvature, in symbols.

#include "algebra.hpp"

namespace derivation {

inline ex cosine(const ex& half_tangent) {
  return (1 - pow(half_tangent, 2)) / (1 + pow(half_tangent, 2));
}
inline ex sine(const ex& half_tangent) {
  return 2 * half_tangent / (1 + pow(half_tangent, 2));
}

/// The unit normal n = (sin φ, cos φ) in the meridian half plane, φ from the axis. Rational in t = tan(φ/2).
struct Normal {
  possymbol phi = possymbol("phi", R"(\varphi)");
  possymbol t = possymbol("t");
  ex radial = sine(t);
  ex axial = cosine(t);

  /// d/dφ: of φ itself, and by dt/dφ = (1 + t²)/2.
  [[nodiscard]] ex slope(const ex& e) const { return e.diff(phi) + e.diff(t) * (1 + pow(t, 2)) / 2; }
  /// ρ = S + S''.
  [[nodiscard]] ex curvature_radius(const ex& support) const { return support + slope(slope(support)); }
};

/// A profile whose radius of curvature is r to the angle φ_m − δ, ρ_e from φ_m + δ on, and linear between.
struct Continuous {
  ex sphere_radius;  // r
  ex edge_radius;    // ρ_e
  ex major_radius;   // r₁ = (r − ρ_e) κ sin φ_m
  ex offset;         // d  = (r − ρ_e) κ cos φ_m
};

/// By width, height and normal of the middle of the transition; κ = sin δ / δ.
inline Continuous continuous(const ex& w, const ex& h, const ex& kappa, const ex& cos_m, const ex& sin_m) {
  const ex excess = (w - h) / (2 * (kappa * (cos_m + sin_m) - 1));  // r − ρ_e
  return {.sphere_radius = h / 2 + excess * kappa * cos_m,
          .edge_radius = (kappa * (w * cos_m + h * sin_m) - w) / (2 * (kappa * (cos_m + sin_m) - 1)),
          .major_radius = excess * kappa * sin_m,
          .offset = excess * kappa * cos_m};
}

/// Symbols for the transition: tangents of half of φ_m and δ, and the angles themselves.
struct Transition {
  possymbol m = possymbol("m");
  possymbol q = possymbol("q");
  possymbol middle = possymbol("pm", R"(\varphi_m)");
  possymbol delta = possymbol("delta", R"(\delta)");
  ex kappa = sine(q) / delta;
  ex before = (m - q) / (1 + m * q);  // tan(φ_a/2), φ_a = φ_m − δ
  ex after = (m + q) / (1 - m * q);   // tan(φ_b/2), φ_b = φ_m + δ

  [[nodiscard]] ex at_before(const ex& e, const Normal& n) const {
    return e.subs(exmap{{n.t, before}, {n.phi, middle - delta}});
  }
  [[nodiscard]] ex at_after(const ex& e, const Normal& n) const {
    return e.subs(exmap{{n.t, after}, {n.phi, middle + delta}});
  }
  [[nodiscard]] ex radius(const ex& r, const ex& edge, const Normal& n) const {
    return r - (r - edge) * (n.phi - middle + delta) / (2 * delta);
  }
};

}  // namespace derivation
