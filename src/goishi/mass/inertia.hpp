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
/// Domain  0 < h <= w.   Limits  h = w: both π w⁵/60 (ball).   h -> 0: π h w⁴/96 and half of it.
/// Error   all terms positive; claim MASS-1.   Proof  derivations/lens.cpp.
template <Elementary T>
[[nodiscard]] constexpr Moments<T> lens_moments(const T& width, const T& height) {
  const T half = height / T(2);
  const T a2 = scalar::sq(half);
  const T c2 = scalar::sq(T(width / T(2)));
  const T c4 = scalar::sq(c2);
  const T unit = scalar::pi<T>() / T(60) * half;
  return {.axial = T(T(2) * unit * (T(10) * c4 + a2 * (T(5) * c2 + a2))),
          .transverse = T(unit * (T(10) * c4 + a2 * (T(15) * c2 + T(7) * a2)))};
}

/// Moments of the sharp lens per unit mass, the squared radii of gyration   [m²].
///
///     I_a/m = (10c⁴ + 5a²c² + a⁴) / (10 (3c² + a²)),   I_t/m = (10c⁴ + 15a²c² + 7a⁴) / (20 (3c² + a²))
///
/// with a = h/2, c = w/2.
///
/// Domain  0 < h <= w.   Limits  h = w: both w²/10 (ball).   h -> 0: w²/12 and w²/24.
/// Error   all terms positive; claim MASS-1.   Proof  derivations/lens.cpp.
template <Field T>
[[nodiscard]] constexpr Moments<T> lens_moments_per_mass(const T& width, const T& height) {
  const T a2 = scalar::sq(T(height / T(2)));
  const T c2 = scalar::sq(T(width / T(2)));
  const T c4 = scalar::sq(c2);
  const T unit = T(1) / (T(20) * (T(3) * c2 + a2));
  return {.axial = T(T(2) * unit * (T(10) * c4 + a2 * (T(5) * c2 + a2))),
          .transverse = T(unit * (T(10) * c4 + a2 * (T(15) * c2 + T(7) * a2)))};
}

/// Moments of the bevelled stone at density 1   [m⁵].
///
///     I_a = π [ (k/30)(10 P_x⁴ + 5 P_x² k² + k⁴)
///               + g r₁⁴ + r₂² (4 r₁³ C₂ + 6 r₁² r₂ C₃ + 4 r₁ r₂² C₄ + r₂³ C₅) ]
///     I_t = I_a/2 + π [ (k/30)(10 g² (3P_x² + k²) + 10 g k (2P_x² + k²) + k² (5P_x² + 3k²))
///                       + 2 r₂³ (r₁² D₁ + 2 r₁ r₂ D₂ + r₂² D₃) ]
///
/// In each bracket the first term is the caps (½∫ρ⁴ dz, and ∫ρ²z² dz), the second the band; a cap is integrated in the
/// depth below the joint, where every term is positive.
/// Limits  b -> 0: `lens_moments`.   Error  claim MASS-2.   Proof  derivations/bevel_mass.cpp.
template <Elementary T, class S>
[[nodiscard]] Moments<T> bevelled_moments(const Stone<S>& stone, const BevelTerms<T>& terms) {
  const S& r1 = stone.bevel_major_radius;
  const S& r2 = stone.bevel_minor_radius;
  const T& k = terms.cap_height;
  const T& p2 = terms.joint_square;
  const T& g = terms.half_band;
  const ArcIntegrals<T>& arc = terms.arc;
  const T k2 = scalar::sq(k);
  const T r1_2 = scalar::sq(T(r1));
  const T r2_2 = scalar::sq(T(r2));

  const T axial_caps = (T(10) * p2 * (p2 + k2 / T(2)) + scalar::sq(k2)) * k * (T(1) / T(30));
  const T axial_torus = T(4) * (r1_2 * arc.c2 + r2_2 * arc.c4) * r1 + (T(6) * r1_2 * arc.c3 + r2_2 * arc.c5) * r2;
  const T axial = axial_caps + (scalar::sq(r1_2) * g + r2_2 * axial_torus);

  const T height_caps =
      (T(10) * ((T(3) * p2 + k2) * g + (T(2) * p2 + k2) * k) * g + k2 * (T(5) * p2 + T(3) * k2)) * k * (T(1) / T(30));
  const T height_torus = r1_2 * arc.d1 + (T(2) * arc.d2 * r1 + arc.d3 * r2) * r2;

  return {.axial = T(scalar::pi<T>() * axial),
          .transverse = T(scalar::pi<T>() * (axial / T(2) + (height_caps + T(2) * r2_2 * height_torus * r2)))};
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

/// Everything at density 1, in the next wider type, to be rounded once. Two things that are only of degree 0 and 2
/// in the lengths are taken in T, for speed: the joint's angle (atan2) and the area.
template <Ordered T>
[[nodiscard]] MassProperties<scalar::wider_t<T>> unit_density_properties(const Stone<T>& stone) {
  using Wide = scalar::wider_t<T>;
  const auto all = [](const Wide& volume, const T& area, const Moments<Wide>& moments, const Moments<Wide>& per_mass) {
    return MassProperties<Wide>{.volume = volume,
                                .surface_area = Wide(area),
                                .density = Wide(1),
                                .mass = volume,
                                .moments = moments,
                                .moments_per_mass = per_mass};
  };
  if (!(T(0) < stone.bevel)) {
    const Wide w(stone.width), h(stone.height);
    return all(formula::lens_volume(w, h), formula::lens_surface_area(stone.width, stone.height),
               formula::lens_moments(w, h), formula::lens_moments_per_mass(w, h));
  }
  const T angle = scalar::atan2(stone.joint_sine, stone.joint_cosine);
  const auto terms = formula::bevel_terms(stone, Wide(angle));
  const Wide volume = formula::bevelled_volume(stone, terms);
  const Wide per_volume = Wide(1) / volume;
  const Moments<Wide> moments = formula::bevelled_moments(stone, terms);
  const T area = formula::bevelled_surface_area(stone, formula::bevel_terms(stone, angle));
  return all(volume, area, moments, {moments.axial * per_volume, moments.transverse * per_volume});
}

/// Rounded to T, if that can hold them: a volume is a cube, a moment of fifth degree.
template <Ordered T>
[[nodiscard]] MassProperties<T> rounded(const Stone<T>& stone, const MassProperties<scalar::wider_t<T>>& wide) {
  using Wide = scalar::wider_t<T>;
  const Wide least(std::numeric_limits<T>::min()), most(std::numeric_limits<T>::max());
  const auto holds = [&](const Wide& value) { return least <= value && value <= most; };
  const auto both = [&](const Moments<Wide>& moments) { return holds(moments.axial) && holds(moments.transverse); };
  require(holds(wide.volume) && holds(wide.surface_area) && holds(wide.density) && holds(wide.mass) &&
              both(wide.moments) && both(wide.moments_per_mass),
          "width", stone.width,
          "must be such that volume, area, density, mass and moments are numbers that its type can hold");
  return {.volume = T(wide.volume),
          .surface_area = T(wide.surface_area),
          .density = T(wide.density),
          .mass = T(wide.mass),
          .moments = {T(wide.moments.axial), T(wide.moments.transverse)},
          .moments_per_mass = {T(wide.moments_per_mass.axial), T(wide.moments_per_mass.transverse)}};
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
  using Wide = scalar::wider_t<T>;
  MassProperties<Wide> result = detail::unit_density_properties(stone);
  result.density = Wide(density.value);
  result.mass = result.density * result.volume;
  result.moments = {Wide(result.density * result.moments.axial), Wide(result.density * result.moments.transverse)};
  return detail::rounded(stone, result);
}

/// The same for a stone of known mass; the density follows.
/// Domain  mass > 0 and finite; all as above.   Error  as above.
template <Ordered T>
[[nodiscard]] MassProperties<T> mass_properties(const Stone<T>& stone, const Mass<T>& mass) {
  require_positive("mass", mass.value);
  using Wide = scalar::wider_t<T>;
  MassProperties<Wide> result = detail::unit_density_properties(stone);
  result.mass = Wide(mass.value);
  result.density = result.mass / result.volume;
  result.moments = {Wide(result.mass * result.moments_per_mass.axial),
                    Wide(result.mass * result.moments_per_mass.transverse)};
  return detail::rounded(stone, result);
}

}  // namespace goishi
