#pragma once
/// \file
/// The bevel: a band of height b at the rim, cut from a torus (major radius r₁, minor radius r₂) tangent to both caps.
/// The joint is the circle where cap and torus touch: radius P_x, height b/2, its normal (cos α, sin α) in the
/// meridian plane.

#include <goishi/scalar.hpp>

namespace goishi {

/// The bevel's dimensions, as functions of the sphere's. All lengths in m.
template <class T>
struct Bevel {
  T major_radius = scalar::unset<T>();        // r₁
  T minor_radius = scalar::unset<T>();        // r₂
  T core_sphere_radius = scalar::unset<T>();  // r − r₂, the sphere radius of the core lens
  T joint_radius = scalar::unset<T>();        // P_x
  T joint_cosine = scalar::unset<T>();        // cos α = P_x / r
  T joint_sine = scalar::unset<T>();          // sin α = (d + b/2) / r
};

namespace formula {

/// Torus radii and joint of the bevel of height b on the lens of height h and sphere offset d.
///
///     k = (h − b)/2 (height of the cap),   r = d + h/2,   y = d + b/2
///     P_x = √(k (2r − k)),   2r − k = 2d + (h + b)/2
///     r₁ = P_x d / y,   r₂ = r (b/2) / y,   r − r₂ = r d / y
///
/// Domain  0 < h, 0 <= b < h, 0 <= d, and not b = d = 0 (the sharp ball: 0/0).
/// Limits  b -> 0: r₁ = w/2, r₂ = 0.   d = 0: r₁ = 0, r₂ = h/2 (the ball, whatever b).
/// Error   every sum has positive terms, h − b is the data's own difference; claim SHAPE-2. The talk's r − √(d² + r₁²)
///         for r₂ loses all digits on thin stones (SHAPE-4), its √(r² + y²) for P_x is wrong (PUBLISHED-5).
/// Proof   derivations/bevel.cpp.
template <Elementary T>
[[nodiscard]] Bevel<T> bevel(const T& height, const T& bevel_height, const T& sphere_offset) {
  const T cap_height = (height - bevel_height) / T(2);
  const T sphere_radius = sphere_offset + height / T(2);
  const T joint_offset = sphere_offset + bevel_height / T(2);
  const T joint_radius = scalar::sqrt(T(cap_height * (T(2) * sphere_offset + (height + bevel_height) / T(2))));
  const T core_share = sphere_offset / joint_offset;
  return {.major_radius = T(joint_radius * core_share),
          .minor_radius = T(sphere_radius / joint_offset * (bevel_height / T(2))),  // so, b is any normal number
          .core_sphere_radius = T(sphere_radius * core_share),
          .joint_radius = joint_radius,
          .joint_cosine = T(joint_radius / sphere_radius),
          .joint_sine = T(joint_offset / sphere_radius)};
}

/// Sphere offset d of the lens whose *finished* stone, bevelled with height b, is w wide and h thick   [m].
///
///     d = (w − h) [A + √(A² + 8 b (h − b))] / (8 (h − b)),   A = w + h − 2b = (w − b) + (h − b)
///
/// Domain  0 <= b < h <= w.   Limits  b = 0: (w² − h²)/(4h), the sharp lens.   h = w: 0 (the ball).
/// Error   all terms positive; claim SHAPE-3.   Proof  derivations/bevel.cpp.
template <Elementary T>
[[nodiscard]] T measured_sphere_offset(const T& outer_width, const T& height, const T& bevel_height) {
  const T shrink = height - bevel_height;
  const T sum = (outer_width - bevel_height) + shrink;
  const T root = scalar::sqrt(T(scalar::sq(sum) + T(8) * bevel_height * shrink));
  return T((outer_width - height) * (sum + root) / (T(8) * shrink));
}

/// Width w of the lens of height h and sphere offset d   [m].
///
///     w = √(h (h + 4 d))
///
/// Domain  0 < h, 0 <= d.   Proof  derivations/bevel.cpp.
template <Elementary T>
[[nodiscard]] T generating_width(const T& height, const T& sphere_offset) {
  return scalar::sqrt(T(height * (height + T(4) * sphere_offset)));
}

}  // namespace formula
}  // namespace goishi
