#pragma once
/// \file
/// Mass and principal moments in closed form, about the centre of mass, in frame B (Bz the symmetry axis), uniform
/// density.

#include <concepts>
#include <goishi/error.hpp>
#include <goishi/mass/volume.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>

namespace goishi {

/// Principal moments of a body with a symmetry axis.
template <class T>
struct Moments {
  T axial = scalar::unset<T>();       // I_a, about Bz
  T transverse = scalar::unset<T>();  // I_t, about every axis across Bz
};

namespace formula {

/// Moments of the sharp lens at density 1   [m⁵].
///
///     I_a = (π/30) a (10c⁴ + 5a²c² + a⁴),   I_t = (π/60) a (10c⁴ + 15a²c² + 7a⁴),   a = h/2, c = w/2
///
/// Taken in the scalar Wide.
/// Domain  0 < h <= w.   Limits  h = w: both π w⁵/60 (ball).   h -> 0: π h w⁴/96 and half of it.
/// Error   all terms positive; claim MASS-1.   Proof  derivations/lens.cpp.
template <Elementary T, Elementary Wide = T>
[[nodiscard]] constexpr Moments<Wide> lens_moments(const T& width, const T& height) {
  const T a = height / T(2), c = width / T(2);
  const Wide a2 = scalar::product<Wide>(a, a), c2 = scalar::product<Wide>(c, c);
  const Wide unit = scalar::pi<Wide>() / Wide(60) * a, leading = scalar::sq(c2) * T(10);
  return {.axial = Wide(unit * ((leading + a2 * (c2 * T(5) + a2)) * T(2))),
          .transverse = Wide(unit * (leading + a2 * (c2 * T(15) + a2 * T(7))))};
}

/// Moments of the sharp lens per unit mass, the squared radii of gyration   [m²].
///
///     I_a/m = (10c⁴ + 5a²c² + a⁴) / (10 (3c² + a²)),   I_t/m = (10c⁴ + 15a²c² + 7a⁴) / (20 (3c² + a²))
///
/// with a = h/2, c = w/2. Taken in the scalar Wide.
///
/// Domain  0 < h <= w.   Limits  h = w: both w²/10 (ball).   h -> 0: w²/12 and w²/24.
/// Error   all terms positive; claim MASS-1.   Proof  derivations/lens.cpp.
template <Field T, Field Wide = T>
[[nodiscard]] constexpr Moments<Wide> lens_moments_per_mass(const T& width, const T& height) {
  const T a = height / T(2), c = width / T(2);
  const Wide a2 = scalar::product<Wide>(a, a), c2 = scalar::product<Wide>(c, c);
  const Wide unit = Wide(1) / ((c2 * T(3) + a2) * T(20)), leading = scalar::sq(c2) * T(10);
  return {.axial = Wide(unit * ((leading + a2 * (c2 * T(5) + a2)) * T(2))),
          .transverse = Wide(unit * (leading + a2 * (c2 * T(15) + a2 * T(7))))};
}

/// Moments of the bevelled stone at density 1   [m⁵].
///
///     I_a = (π/15) (15 C₅ r₂⁵ + A),   I_t = (π/30) ((15 C₅ + 60 D₃) r₂⁵ + A + B)
///     A = 5k P_x⁴ + 15g r₁⁴ + (k³/2)(5 P_x² + k²) + 15 r₁ r₂² (4 r₁² C₂ + 6 r₁ r₂ C₃ + 4 r₂² C₄)
///     B = k (10 g² (3P_x² + k²) + 10 g k (2P_x² + k²) + k² (5P_x² + 3k²)) + 60 r₁ r₂³ (r₁ D₁ + 2 r₂ D₂)
///
/// Of the caps ½∫ρ⁴ dz, and ∫ρ²z² dz, integrated in the depth below the joint, where every term is positive; of the band
/// likewise. Fourth powers are taken in the scalar Wide, and so are the term of fifth degree, all that a ball has, and
/// the factors before the brackets.
/// Limits  b -> 0: `lens_moments`.   Error  claim MASS-2.   Proof  derivations/bevel_mass.cpp.
template <Elementary T, Elementary Wide = T>
[[nodiscard]] Moments<Wide> bevelled_moments(const Stone<T>& stone, const BevelTerms<T>& terms) {
  const T& r1 = stone.bevel_major_radius;
  const T& r2 = stone.bevel_minor_radius;
  const T& k = terms.cap_height;
  const T& g = terms.half_band;
  const ArcIntegrals<T>& arc = terms.arc;
  const T k2 = scalar::sq(k), p2 = scalar::sq(stone.joint_radius), r1_2 = scalar::sq(r1), r2_2 = scalar::sq(r2);

  const auto fourth = [](const T& x) { return Wide(scalar::sq(scalar::product<Wide>(x, x))); };
  const Wide wide_r2_2 = scalar::product<Wide>(r2, r2);

  const T torus = T(4) * (r1_2 * arc.c2 + r2_2 * arc.c4) + T(2) * arc.three_c3 * r1 * r2;
  const T axial_rest = T(5) * (T(fourth(stone.joint_radius)) + (p2 + k2 * (T(1) / T(5))) * k2 / T(2)) * k +
                       T(15) * (T(fourth(r1)) * g + T(wide_r2_2 * r1) * torus);
  const T caps = (T(10) * ((T(3) * p2 + k2) * g + (T(2) * p2 + k2) * k) * g + k2 * (T(5) * p2 + T(3) * k2)) * k;
  const T across_rest = caps + T(60) * r1 * r2_2 * r2 * (r1 * arc.d1 + T(2) * arc.d2 * r2);

  const Wide r2_4 = scalar::sq(wide_r2_2);
  const Wide axial = r2_4 * T(r2 * arc.fifteen_c5) + axial_rest;
  const Wide across = r2_4 * T(T(4) * r2 * arc.fifteen_d3) + across_rest;
  return {.axial = Wide(scalar::pi<Wide>() / Wide(15) * axial),
          .transverse = Wide(scalar::pi<Wide>() / Wide(30) * (axial + across))};
}

}  // namespace formula

/// A uniform density   [kg/m³].
template <class T>
struct Density {
  T value;
};
template <class T>
Density(T) -> Density<T>;
template <std::integral T>
Density(T) -> Density<double>;  // Density{2800}

/// A total mass   [kg].
template <class T>
struct Mass {
  T value;
};
template <class T>
Mass(T) -> Mass<T>;
template <std::integral T>
Mass(T) -> Mass<double>;

/// Everything about a stone's mass. SI units, about the centre of mass, frame B.
template <class T>
struct MassProperties {
  T volume = scalar::unset<T>();        // V [m³]
  T surface_area = scalar::unset<T>();  // [m²]
  T density = scalar::unset<T>();       // ρ [kg/m³]
  T mass = scalar::unset<T>();          // m [kg]
  Moments<T> moments;                   // [kg m²]
  Moments<T> moments_per_mass;          // [m²]
};

namespace detail {

/// What the formulas run in: float in double, so that the rest is the same for both.
template <class T>
using Computed = std::conditional_t<std::is_same_v<T, float>, double, T>;

/// Everything at density 1 of the stone in units of a length 2^exponent, so that no power of a length leaves the range of
/// its type.
template <class T>
struct UnitBody {
  T surface_area, volume;
  Moments<T> moments, moments_per_mass;
  int exponent;
};

/// In units of 2^exponent lengths.
template <Ordered T>
[[nodiscard]] Stone<T> scaled(const Stone<T>& stone, int exponent) {
  const auto in = [&](const T& length) { return scalar::scaled(length, -exponent); };
  return {.width = in(stone.width),
          .height = in(stone.height),
          .bevel = in(stone.bevel),
          .sphere_radius = in(stone.sphere_radius),
          .sphere_offset = in(stone.sphere_offset),
          .bevel_major_radius = in(stone.bevel_major_radius),
          .bevel_minor_radius = in(stone.bevel_minor_radius),
          .core_sphere_radius = in(stone.core_sphere_radius),
          .joint_radius = in(stone.joint_radius),
          .joint_cosine = stone.joint_cosine,
          .joint_sine = stone.joint_sine};
}

/// What is of a high degree in lengths is taken in the next wider type, and rounded.
template <Ordered T>
[[nodiscard]] UnitBody<T> unit_body_of(const Stone<T>& stone, int exponent) {
  using Wide = scalar::wider_t<T>;
  const auto rounded = [](const Moments<Wide>& wide) { return Moments<T>{T(wide.axial), T(wide.transverse)}; };
  if (!(T(0) < stone.bevel)) {
    const T &w = stone.width, &h = stone.height;
    return {formula::lens_surface_area(w, h), T(formula::lens_volume<T, Wide>(w, h)),
            rounded(formula::lens_moments<T, Wide>(w, h)), rounded(formula::lens_moments_per_mass<T, Wide>(w, h)),
            exponent};
  }
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const T volume = formula::bevelled_volume<T, Wide>(stone, terms);
  const Moments<T> moments = rounded(formula::bevelled_moments<T, Wide>(stone, terms));
  return {formula::bevelled_surface_area(stone, terms),
          volume,
          moments,
          {T(moments.axial / volume), T(moments.transverse / volume)},
          exponent};
}

/// Lengths are in metres, but for sizes that no stone has.
template <Ordered T>
[[nodiscard]] UnitBody<Computed<T>> unit_body(const Stone<T>& stone) {
  const int exponent = scalar::far_exponent(stone.width);
  if constexpr (std::is_same_v<T, Computed<T>>) {
    if (exponent == 0) [[likely]] {
      return detail::unit_body_of(stone, 0);
    }
  }
  return detail::unit_body_of(stone_cast<Computed<T>>(detail::scaled(stone, exponent)), exponent);
}

/// If T can hold them: a volume is a cube, a moment of fifth degree.
template <Ordered T>
[[nodiscard]] MassProperties<T> checked(const Stone<T>& stone, const MassProperties<T>& body) {
  const T least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
  // Rounding towards zero, what overflows is `most`.
  const auto holds = [&](const T& value) { return least <= value && value < most; };
  const auto both = [&](const Moments<T>& moments) { return holds(moments.axial) && holds(moments.transverse); };
  require(holds(body.volume) && holds(body.surface_area) && holds(body.density) && holds(body.mass) &&
              both(body.moments) && both(body.moments_per_mass),
          "width", stone.width,
          "must be such that volume, area, density, mass and moments are numbers that its type can hold");
  return body;
}

}  // namespace detail

/// Mass properties of a stone of uniform density. Closed forms, sharp or bevelled; one stone size needs this once.
///
/// Domain  a stone from `make_stone` or `make_measured_stone`; density > 0 and finite; what follows from them normal numbers
///         of T, with I_a <= 2 I_t (DOMAIN-2); else InvalidArgument.
/// Error   sharp <= 4 ulp (MASS-1), bevelled <= 8 ulp (MASS-2), float and double, over the whole domain of
///         `make_stone`.
/// Source  volume and both moments by GSL quadrature (GSL-1 … GSL-4).
template <Ordered T>
[[nodiscard]] MassProperties<T> mass_properties(const Stone<T>& stone, const Density<T>& density) {
  require_positive("density", density.value);
  using S = detail::Computed<T>;
  const auto unit = detail::unit_body(stone);
  const int n = unit.exponent, m = scalar::far_exponent(density.value);
  const S rho(scalar::scaled(density.value, -m));
  const auto in = [](const auto& value, int exponent) { return scalar::scaled(T(S(value)), exponent); };
  return detail::checked<T>(
      stone,
      {.volume = in(unit.volume, 3 * n),
       .surface_area = in(unit.surface_area, 2 * n),
       .density = density.value,
       .mass = in(unit.volume * rho, 3 * n + m),
       .moments = {in(unit.moments.axial * rho, 5 * n + m), in(unit.moments.transverse * rho, 5 * n + m)},
       .moments_per_mass = {in(unit.moments_per_mass.axial, 2 * n), in(unit.moments_per_mass.transverse, 2 * n)}});
}

/// The same for a stone of known mass; the density follows.
/// Domain  mass > 0 and finite; all as above.   Error  as above.
template <Ordered T>
[[nodiscard]] MassProperties<T> mass_properties(const Stone<T>& stone, const Mass<T>& mass) {
  require_positive("mass", mass.value);
  using S = detail::Computed<T>;
  const auto unit = detail::unit_body(stone);
  const int n = unit.exponent, m = scalar::far_exponent(mass.value);
  const S share(scalar::scaled(mass.value, -m));
  const auto in = [](const auto& value, int exponent) { return scalar::scaled(T(S(value)), exponent); };
  return detail::checked<T>(stone, {.volume = in(unit.volume, 3 * n),
                                    .surface_area = in(unit.surface_area, 2 * n),
                                    .density = in(share / unit.volume, m - 3 * n),
                                    .mass = mass.value,
                                    .moments = {in(unit.moments_per_mass.axial * share, 2 * n + m),
                                                in(unit.moments_per_mass.transverse * share, 2 * n + m)},
                                    .moments_per_mass = {in(unit.moments_per_mass.axial, 2 * n),
                                                         in(unit.moments_per_mass.transverse, 2 * n)}});
}

}  // namespace goishi
