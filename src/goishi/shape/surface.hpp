#pragma once
/// \file
/// The surface of a stone, in its own frame B: support, signed distance, closest point, inside. Each is asked of the core
/// lens and then moved out by r₂, so that sharp and bevelled stones go one path.

#include <cmath>
#include <cstdint>
#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <string_view>

namespace goishi {

/// Which part of the surface a point belongs to. The rim is the sharp edge, or the bevel's torus.
enum class Feature { upper_cap, lower_cap, rim };

[[nodiscard]] constexpr std::string_view to_string(Feature feature) {
  switch (feature) {
    case Feature::upper_cap:
      return "upper cap";
    case Feature::lower_cap:
      return "lower cap";
    case Feature::rim:
      break;
  }
  return "rim";
}

namespace formula {

/// Support of the stone in a unit direction n that meets a cap   [m]: μ = |n_z| its axial part, n_r² = 1 − μ² the square of
/// its radial part.
///
///     S = r − d μ = h/2 + d n_r² / (1 + μ)
///
/// Domain  n_r sin α <= μ cos α (the joint's angle).   Limits  n = Bz: h/2.   Thin stones keep their digits.
/// Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] T cap_support(const Stone<T>& stone, const T& axial, const T& radial_square) {
  return stone.height / T(2) + stone.sphere_offset * radial_square / (T(1) + axial);
}

/// Support in a unit direction that meets the rim   [m]: S = r₁ n_r + r₂.
/// Domain  n_r sin α >= μ cos α.   Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] T rim_support(const Stone<T>& stone, const T& radial) {
  return stone.bevel_major_radius * radial + stone.bevel_minor_radius;
}

/// −S' on the rim, by μ   [m]: r₁ μ/n_r.   Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] inline T rim_slope(const Stone<T>& stone, const T& axial, const T& radial) {
  return stone.bevel_major_radius * axial / radial;
}

/// Distance of the rim's support point from the axis, over n_r   [m]: r₁/n_r + r₂. Its height over the middle is r₂ μ.
/// Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] inline T rim_support_reach(const Stone<T>& stone, const T& radial) {
  return stone.bevel_major_radius / radial + stone.bevel_minor_radius;
}

/// Height over the middle of the cap's support point   [m]: h/2 − r n_r² / (1 + μ). Its distance from the axis is r n_r.
/// Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] T cap_support_height(const Stone<T>& stone, const T& axial, const T& radial_square) {
  return stone.height / T(2) - stone.sphere_radius * radial_square / (T(1) + axial);
}

/// The support point in a unit direction n, on the cap or on the rim: n_h times what its distance from the axis is
/// over n_r, r on the cap, and its height.
/// Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> support_point(const T& reach, const Vec3<T>& n_B, const T& height) {
  return {T(reach * n_B.x()), T(reach * n_B.y()), height};
}

/// Signed distance of a point from the core lens's sphere   [m], from its distance ρ from the axis and height ζ over the
/// middle, ζ >= 0; `reach` is its distance √(ρ² + (ζ + d)²) from the sphere's centre.
///
///     reach − R = ((ρ − r₁)(ρ + r₁) + ζ (ζ + 2d)) / (reach + R)
///
/// Domain  reach + R > 0.   Proof  derivations/support.cpp.
template <Field T>
[[nodiscard]] T core_sphere_distance(const Stone<T>& stone, const T& rho, const T& zeta, const T& reach) {
  const T& rim = stone.bevel_major_radius;
  return ((rho - rim) * (rho + rim) + zeta * (zeta + T(2) * stone.sphere_offset)) / (reach + stone.core_sphere_radius);
}

}  // namespace formula

/// The farthest point of a stone in a direction.
template <class T>
struct Support {
  T value = scalar::unset<T>();                         // S(n) = max n · x [m]
  Vec3<T> p_B = Vec3<T>::Constant(scalar::unset<T>());  // where it is reached
  Feature feature = Feature::rim;
};

namespace detail {

/// A unit direction in B by what a body of revolution sees of it.
template <class T>
struct Direction {
  T axial;   // |n_z|
  T radial;  // √(n_x² + n_y²)
  T radial_square;
};

template <Ordered T>
[[nodiscard]] Direction<T> direction(const Vec3<T>& n_B) {
  const T square = scalar::sq(n_B.x()) + scalar::sq(n_B.y());
  return {.axial = scalar::abs(T(n_B.z())), .radial = scalar::sqrt(square), .radial_square = square};
}

/// n_r sin α <= μ cos α. By squares, so that the answer need not wait for a root.
template <Ordered T>
[[nodiscard]] bool meets_cap(const Stone<T>& stone, const Direction<T>& n) {
  return n.radial_square * scalar::sq(stone.joint_sine) <= scalar::sq(T(n.axial * stone.joint_cosine));
}

/// Support of a direction known to be a unit vector.
template <Ordered T>
[[nodiscard]] Support<T> support_of_unit(const Stone<T>& stone, const Vec3<T>& n_B) {
  const Direction<T> n = direction(n_B);
  Support<T> result;
  if (meets_cap(stone, n)) {
    const bool upper = !(n_B.z() < T(0));
    const T height = formula::cap_support_height(stone, n.axial, n.radial_square);
    result.value = formula::cap_support(stone, n.axial, n.radial_square);
    result.p_B = formula::support_point(stone.sphere_radius, n_B, upper ? height : T(-height));
    result.feature = upper ? Feature::upper_cap : Feature::lower_cap;
  } else {
    result.value = formula::rim_support(stone, n.radial);
    result.p_B =
        formula::support_point(formula::rim_support_reach(stone, n.radial), n_B, T(stone.bevel_minor_radius * n_B.z()));
  }
  return result;
}

/// Only the value.
template <Ordered T>
[[nodiscard]] T support_value_of_unit(const Stone<T>& stone, const Vec3<T>& n_B) {
  const Direction<T> n = direction(n_B);
  return meets_cap(stone, n) ? formula::cap_support(stone, n.axial, n.radial_square)
                             : formula::rim_support(stone, n.radial);
}

/// A sum of squares below this has lost digits.
template <class T>
inline const T least_square = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

/// √(a² + b²), of lengths too whose squares vanish beside those of a stone: next to its rim, its axis, a ball's centre.
template <Ordered T>
[[nodiscard]] T hypotenuse(const T& a, const T& b) {
  const T square = scalar::sq(a) + scalar::sq(b);
  if (square < least_square<T>) [[unlikely]] {
    const T unit = scalar::sq(std::numeric_limits<T>::epsilon());
    return unit * scalar::sqrt(T(scalar::sq(T(a / unit)) + scalar::sq(T(b / unit))));
  }
  return scalar::sqrt(square);
}

template <Ordered T>
[[nodiscard]] inline bool is_unit(const Vec3<T>& n) {
  return is_unit_defect(T(formula::dot(n, n) - T(1)));
}

template <Ordered T>
void require_direction(const Vec3<T>& n, const char* argument = "normal") {
  if (!is_unit(n)) [[unlikely]] {
    throw_invalid(argument, scalar::sqrt(formula::dot(n, n)), "must be a unit vector (its length is shown)");
  }
}

template <Ordered T>
void require_point(const Vec3<T>& p, const char* argument = "point") {
  require(scalar::is_finite(T(p.x() + p.y() + p.z())), argument, p.transpose(), "must be finite");
}

}  // namespace detail

/// The support of a stone in the unit direction n_B.
///
/// Domain  |n| = 1 within `unit_tolerance`, else InvalidArgument.
/// Error   value and point within 1e-15 of the width (claim SURFACE-1), and as much more as n is off a unit vector; stones of
///         any size (DOMAIN-4).
/// Proof   derivations/support.cpp: the maximiser on cap and rim, C¹ at the switch.
template <Ordered T>
[[nodiscard]] Support<T> support(const Stone<T>& stone, const Vec3<T>& n_B) {
  detail::require_direction(n_B);
  return detail::support_of_unit(stone, n_B);
}

/// Where a point is, seen from a stone's surface.
template <class T>
struct SurfacePoint {
  T distance = scalar::unset<T>();                           // [m], < 0 inside
  Vec3<T> p_B = Vec3<T>::Constant(scalar::unset<T>());       // the closest point of the surface
  Vec3<T> normal_B = Vec3<T>::Constant(scalar::unset<T>());  // unit, out of the stone, there
  Feature feature = Feature::rim;
  bool unique = true;  // false: others are as near, or the normal is one of many
};

/// Signed distance, closest point, normal and feature.
///
/// Domain  a point whose square is finite, else InvalidArgument. Where the closest point or the normal is not unique (the middle plane
///         inside, a sharp edge, a ball's centre), one of them is given and the result says so.
/// Error   distance and point within 1e-15 of the greater of width and |p| (claim SURFACE-2); stones of any size, points from
///         0 on (DOMAIN-4).
template <Ordered T>
[[nodiscard]] SurfacePoint<T> closest_point(const Stone<T>& stone, const Vec3<T>& p_B) {
  const T across = scalar::sq(p_B.x()) + scalar::sq(p_B.y());
  if (!(across + scalar::sq(p_B.z()) < std::numeric_limits<T>::max() / T(4))) [[unlikely]] {
    detail::require_point(p_B);
    throw_invalid("point", p_B.transpose(), "must have a square that is finite");
  }
  const T rho = detail::hypotenuse(p_B.x(), p_B.y());
  const bool upper = !(p_B.z() < T(0));
  const T zeta = upper ? p_B.z() : T(-p_B.z());
  const T& rim = stone.bevel_major_radius;
  const T& d = stone.sphere_offset;
  const T over = zeta + d;
  // Radial and axial part of the normal, and the distance from the core.
  T radial, axial, distance;
  SurfacePoint<T> result;
  if (rho * d <= rim * over) {
    const T reach = detail::hypotenuse(rho, over);
    const bool at_centre = !(T(0) < reach);  // of a ball
    radial = at_centre ? T(0) : T(rho / reach);
    axial = at_centre ? T(1) : T(over / reach);
    // A sum so small that its square vanishes beside a stone's is round-off of the width.
    const bool vanishes = scalar::sq(T(reach + stone.core_sphere_radius)) < detail::least_square<T>;
    distance = vanishes ? T(reach - stone.core_sphere_radius) : formula::core_sphere_distance(stone, rho, zeta, reach);
    result.feature = upper ? Feature::upper_cap : Feature::lower_cap;
    result.unique = !at_centre && (T(0) < zeta || !(T(0) < d));
  } else {
    const T outward = rho - rim;
    distance = detail::hypotenuse(outward, zeta);
    const bool on_edge = !(T(0) < distance);
    radial = on_edge ? T(1) : T(outward / distance);
    axial = on_edge ? T(0) : T(zeta / distance);
    result.unique = !on_edge;
  }
  const bool on_axis = !(T(0) < rho);
  const Vec3<T> outward(on_axis ? T(1) : T(p_B.x() / rho), on_axis ? T(0) : T(p_B.y() / rho), T(0));
  result.unique = result.unique && (!on_axis || !(T(0) < radial));
  result.normal_B = {T(radial * outward.x()), T(radial * outward.y()), upper ? axial : T(-axial)};
  result.distance = distance - stone.bevel_minor_radius;
  result.p_B = p_B - result.distance * result.normal_B;
  return result;
}

/// Only the signed distance   [m].
template <Ordered T>
[[nodiscard]] T signed_distance(const Stone<T>& stone, const Vec3<T>& p_B) {
  return closest_point(stone, p_B).distance;
}

/// Whether a point is in the stone or on its surface.
template <Ordered T>
[[nodiscard]] bool is_inside(const Stone<T>& stone, const Vec3<T>& p_B) {
  return signed_distance(stone, p_B) <= T(0);
}

}  // namespace goishi
