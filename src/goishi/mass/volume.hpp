#pragma once
/// \file
/// Volume and surface area in closed form: of the sharp lens by width and height, of the bevelled stone by its parts
/// (two caps of height k = (h − b)/2 and base radius P_x, and the band cut from the torus).

#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>

namespace goishi {

namespace formula {

/// Volume of the sharp lens   [m³].
///
///     V = (π/3) a (3c² + a²),   a = h/2, c = w/2
///
/// Taken in the scalar Wide.
/// Domain  0 < h <= w.   Limits  h = w: π w³/6 (ball).   h -> 0: π h w²/8.
/// Error   all terms positive; claim MASS-1.   Proof  derivations/lens.cpp.
template <Elementary T, Elementary Wide = T>
[[nodiscard]] constexpr Wide lens_volume(const T& width, const T& height) {
  const T a = height / T(2), c = width / T(2);
  const Wide sum = scalar::product<Wide>(c, c) * T(3) + scalar::product<Wide>(a, a);
  return Wide(scalar::pi<Wide>() / Wide(3) * (sum * a));
}

/// Surface area of the sharp lens   [m²].
///
///     S = π (w² + h²) / 2
///
/// Domain  0 < h <= w.   Limits  h = w: π w² (ball).   h -> 0: π w²/2 (both faces of a disc).
/// Error   claim MASS-1.   Proof  derivations/lens.cpp.
template <Elementary T>
[[nodiscard]] constexpr T lens_surface_area(const T& width, const T& height) {
  return T(scalar::pi<T>() * (scalar::sq(width) + scalar::sq(height)) / T(2));
}

/// Integrals over the bevel's arc, from the plane of the rim to the joint, α = the angle of the joint's normal:
/// C_n = ∫₀^α cosⁿφ dφ and D_n = ∫₀^α sin²φ cosⁿφ dφ.
template <class T>
struct ArcIntegrals {
  T c2, three_c3, c4, fifteen_c5;
  T d1, d2, fifteen_d3;
};

///     C₂ = (α + s c)/2,   3 C₃ = s (c² + 2),   C₄ = (c³ s + 3 C₂)/4,   15 C₅ = s (8 + c² (4 + 3 c²)),   c = cos α, s = sin α
///     D₁ = s³/3,   D₂ = (α − s c + 2 s³ c)/8,   15 D₃ = s³ (2 + 3c²)
///
/// Domain  0 <= α <= π/2.   Error  D₂ alone cancels, for small α, where its share of a moment is below round-off.
/// Proof   derivations/bevel_mass.cpp.
template <Field T>
[[nodiscard]] constexpr ArcIntegrals<T> arc_integrals(const T& angle, const T& cosine, const T& sine) {
  const T square = scalar::sq(cosine);
  const T product = sine * cosine;
  const T cube = scalar::sq(sine) * sine;
  const T c2 = (product + angle) / T(2);
  return {.c2 = c2,
          .three_c3 = T((square + T(2)) * sine),
          .c4 = T((square * product + T(3) * c2) / T(4)),
          .fifteen_c5 = T((T(8) + square * (T(4) + T(3) * square)) * sine),
          .d1 = T(cube * (T(1) / T(3))),
          .d2 = T(((angle - product) + T(2) * cube * cosine) / T(8)),
          .fifteen_d3 = T(cube * (T(2) + T(3) * square))};
}

/// What the mass formulas of a bevelled stone share.
template <class T>
struct BevelTerms {
  T cap_height;  // k = (h − b)/2
  T half_band;   // g = b/2
  T angle;       // α
  ArcIntegrals<T> arc;
};

/// Domain  a bevelled stone (also b = 0 with d > 0); angle α = atan2(joint sine, joint cosine).
template <Field T>
[[nodiscard]] constexpr BevelTerms<T> bevel_terms(const Stone<T>& stone, const T& angle) {
  return {.cap_height = T((stone.height - stone.bevel) / T(2)),
          .half_band = T(stone.bevel / T(2)),
          .angle = angle,
          .arc = formula::arc_integrals(angle, stone.joint_cosine, stone.joint_sine)};
}

/// Volume of the bevelled stone   [m³].
///
///     V = (π/3) [ 2 r₂² (3 C₃ r₂) + (k (3 P_x² + k²) + 6g r₁² + 12 r₁ r₂² C₂) ]
///
/// The caps are π k (P_x² + k²/3), the rest is the band: π ∫ (r₁ + r₂ cos φ)² r₂ cos φ dφ. The first term, all that a ball has, is
/// taken in the scalar Wide, and so are the sum and its factor.
/// Limits  b -> 0: `lens_volume`.   Error  all terms positive; claim MASS-2.   Proof  derivations/bevel_mass.cpp.
template <Elementary T, Elementary Wide = T>
[[nodiscard]] Wide bevelled_volume(const Stone<T>& stone, const BevelTerms<T>& terms) {
  const T& r1 = stone.bevel_major_radius;
  const T& r2 = stone.bevel_minor_radius;
  const T& k = terms.cap_height;
  const T caps = k * (T(3) * scalar::sq(stone.joint_radius) + scalar::sq(k));
  const T band = T(6) * r1 * (terms.half_band * r1 + T(2) * scalar::sq(r2) * terms.arc.c2);
  const Wide round = scalar::product<Wide>(r2, r2) * T(T(2) * r2 * terms.arc.three_c3);
  return Wide(scalar::pi<Wide>() / Wide(3) * (round + T(caps + band)));
}

/// Surface area of the bevelled stone   [m²].
///
///     S = 2π [ (P_x² + k²) + 2 r₂ (r₁ α + g) ]
///
/// The first term is the two caps (4π r k), the second the band: 2π ∫ (r₁ + r₂ cos φ) r₂ dφ.
/// Limits  b -> 0: `lens_surface_area`.   Error  all terms positive; claim MASS-2.   Proof  derivations/bevel_mass.cpp.
template <Elementary T>
[[nodiscard]] T bevelled_surface_area(const Stone<T>& stone, const BevelTerms<T>& terms) {
  const T caps = scalar::sq(stone.joint_radius) + scalar::sq(terms.cap_height);
  const T band = (terms.angle * stone.bevel_major_radius + terms.half_band) * stone.bevel_minor_radius;
  return T(T(2) * scalar::pi<T>() * (caps + T(2) * band));
}

}  // namespace formula
}  // namespace goishi
