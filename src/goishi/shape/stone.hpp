#pragma once
/// \file
/// The stone: a core lens (sphere radius r − r₂, offset d, rim radius r₁) ⊕ a ball of radius r₂. Sharp when r₂ = 0.

#include <goishi/error.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/bevel.hpp>
#include <goishi/shape/lens.hpp>

namespace goishi {

/// A stone's shape in frame B: origin at the centre, Bz the symmetry axis. Lengths in m. Made by `make_stone` and
/// `make_measured_stone`; NaN until then.
template <class T>
struct Stone {
  T width = scalar::unset<T>();          // w, diameter of the lens that generates the stone
  T height = scalar::unset<T>();         // h, thickness
  T bevel = scalar::unset<T>();          // b, height of the bevel band; 0: sharp
  T sphere_radius = scalar::unset<T>();  // r
  T sphere_offset = scalar::unset<T>();  // d

  T bevel_major_radius = scalar::unset<T>();  // r₁, also the rim radius of the core lens
  T bevel_minor_radius = scalar::unset<T>();  // r₂
  T core_sphere_radius = scalar::unset<T>();  // r − r₂

  T joint_radius = scalar::unset<T>();  // P_x, where cap and bevel touch, at height ± b/2
  T joint_cosine = scalar::unset<T>();  // radial part of the normal there
  T joint_sine = scalar::unset<T>();    // axial part of the normal there
};

/// The same stone in another scalar, each field rounded once.
template <class To, class From>
[[nodiscard]] constexpr Stone<To> stone_cast(const Stone<From>& stone) {
  return {.width = static_cast<To>(stone.width),
          .height = static_cast<To>(stone.height),
          .bevel = static_cast<To>(stone.bevel),
          .sphere_radius = static_cast<To>(stone.sphere_radius),
          .sphere_offset = static_cast<To>(stone.sphere_offset),
          .bevel_major_radius = static_cast<To>(stone.bevel_major_radius),
          .bevel_minor_radius = static_cast<To>(stone.bevel_minor_radius),
          .core_sphere_radius = static_cast<To>(stone.core_sphere_radius),
          .joint_radius = static_cast<To>(stone.joint_radius),
          .joint_cosine = static_cast<To>(stone.joint_cosine),
          .joint_sine = static_cast<To>(stone.joint_sine)};
}

namespace formula {

/// The sharp stone: no bevel, the joint is the rim.
/// Domain  0 < h <= w.   Proof  derivations/lens.cpp.
template <Field T>
[[nodiscard]] constexpr Stone<T> sharp_stone(const T& width, const T& height) {
  const T radius = formula::sphere_radius(width, height);
  const T offset = formula::sphere_offset(width, height);
  const T rim_radius = width / T(2);
  return {.width = width,
          .height = height,
          .bevel = T(0),
          .sphere_radius = radius,
          .sphere_offset = offset,
          .bevel_major_radius = rim_radius,
          .bevel_minor_radius = T(0),
          .core_sphere_radius = radius,
          .joint_radius = rim_radius,
          .joint_cosine = T(rim_radius / radius),
          .joint_sine = T(offset / radius)};
}

/// The bevelled stone that a lens of width w, height h and sphere offset d gives.
/// Domain  that of `formula::bevel`.   Proof  derivations/bevel.cpp.
template <Elementary T>
[[nodiscard]] Stone<T> bevelled_stone(const T& width, const T& height, const T& bevel_height, const T& offset) {
  const Bevel<T> band = formula::bevel(height, bevel_height, offset);
  return {.width = width,
          .height = height,
          .bevel = bevel_height,
          .sphere_radius = T(offset + height / T(2)),
          .sphere_offset = offset,
          .bevel_major_radius = band.major_radius,
          .bevel_minor_radius = band.minor_radius,
          .core_sphere_radius = band.core_sphere_radius,
          .joint_radius = band.joint_radius,
          .joint_cosine = band.joint_cosine,
          .joint_sine = band.joint_sine};
}

}  // namespace formula

namespace detail {

template <Ordered T>
void require_bevel(const T& bevel, const T& height) {
  require(!(bevel < T(0)) && bevel < height, "bevel", bevel, "must be at least 0 and below the height (", height, ")");
  require(!(T(0) < bevel) || scalar::tiny<T>() <= bevel, "bevel", bevel,
          "must be 0 or not below the least normal number");
}

/// The stone in T. Its greatest length, the radius of the spheres, must be one that formulas take.
template <Ordered T, class Wide>
[[nodiscard]] Stone<T> checked_stone(const Stone<Wide>& wide) {
  Stone<T> stone = stone_cast<T>(wide);
  require_length("sphere_radius", stone.sphere_radius);
  return stone;
}

}  // namespace detail

/// The talk's stone: a lens of width w and height h, its rim then bevelled with height b. Bevelling shrinks it: the
/// finished stone is `outer_width` = 2(r₁ + r₂) < w wide.
///
/// Domain  0 < h <= w, b = 0 or a normal number below h, the others lengths as of `require_length`, and the radius
///         (w² + h²)/(4h) of the spheres, too; else InvalidArgument.   Limits  h = w is the ball, b = 0 the sharp lens: ordinary.
/// Error   each field within 1 ulp (float, double) for h/w from 1e-9 to 1, b/h from 1e-12 to 1 − 1e-9 (claims SHAPE-1,
///         SHAPE-2); beyond, and to the ends of the domain, within 2 (DOMAIN-1).
template <Ordered T>
[[nodiscard]] Stone<T> make_stone(const T& width, const T& height, const T& bevel = T(0)) {
  using Wide = scalar::wider_t<T>;
  detail::require_lens("width", width, height);
  detail::require_bevel(bevel, height);
  const Wide w(width), h(height), b(bevel);
  return detail::checked_stone<T>(T(0) < bevel ? formula::bevelled_stone(w, h, b, formula::sphere_offset(w, h))
                                               : formula::sharp_stone(w, h));
}

/// The same where some of the lengths, or all, are whole numbers (`scalar::promoted_t`).
template <class W, class H, class B = int>
requires scalar::detail::AnyInteger<W, H, B>
[[nodiscard]] Stone<scalar::promoted_t<W, H, B>> make_stone(const W& width, const H& height, const B& bevel = 0) {
  using T = scalar::promoted_t<W, H, B>;
  return make_stone<T>(T(width), T(height), T(bevel));
}

/// The customer's stone: the *finished* stone is `outer_width` wide and `height` thick, with a bevel band of height b.
/// `width` of the result is that of the generating lens, which is wider.
///
/// Domain  0 < h <= outer width, 0 <= b < h, lengths as of `make_stone`; else InvalidArgument.
/// Error   each field within 1 ulp (float, double), over the domain of `make_stone` (claim SHAPE-3).
template <Ordered T>
[[nodiscard]] Stone<T> make_measured_stone(const T& outer_width, const T& height, const T& bevel) {
  using Wide = scalar::wider_t<T>;
  detail::require_lens("outer_width", outer_width, height);
  detail::require_bevel(bevel, height);
  if (!(T(0) < bevel)) {
    return make_stone(outer_width, height);
  }
  const Wide h(height), b(bevel);
  const Wide offset = formula::measured_sphere_offset(Wide(outer_width), h, b);
  return detail::checked_stone<T>(formula::bevelled_stone(formula::generating_width(h, offset), h, b, offset));
}

/// The same where some of the lengths, or all, are whole numbers.
template <class W, class H, class B>
requires scalar::detail::AnyInteger<W, H, B>
[[nodiscard]] Stone<scalar::promoted_t<W, H, B>> make_measured_stone(const W& outer_width, const H& height,
                                                                     const B& bevel) {
  using T = scalar::promoted_t<W, H, B>;
  return make_measured_stone<T>(T(outer_width), T(height), T(bevel));
}

/// Diameter of the finished stone   [m]: 2 (r₁ + r₂).
template <Field T>
[[nodiscard]] constexpr T outer_width(const Stone<T>& stone) {
  return T(T(2) * (stone.bevel_major_radius + stone.bevel_minor_radius));
}

}  // namespace goishi
