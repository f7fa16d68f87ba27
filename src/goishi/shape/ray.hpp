#pragma once
/// \file
/// Where a ray meets a stone. The signed distance is convex along a line, so Newton's method from outside cannot jump
/// over the surface: no torus quartic, one path for sharp and bevelled.

#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// Where the line p + t u, u a unit vector, is in the stone: entry <= t <= exit.
template <class T>
struct RayHit {
  bool hit = false;              // the line meets the stone
  T entry = scalar::unset<T>();  // [m], may be negative: behind the start
  T exit = scalar::unset<T>();
  bool forward = false;          // something of it lies ahead
  T first = scalar::unset<T>();  // the first surface point ahead: the entry, or the exit if the start is inside
  SurfacePoint<T> surface;       // there
};

namespace detail {

/// Newton's method for the signed distance along the line, from `t`, outside, in the direction of `sign`. Returns false
/// when the line passes.
template <Ordered T>
[[nodiscard]] bool approach_surface(const Stone<T>& stone, const Vec3<T>& p_B, const Vec3<T>& u_B, const T& sign,
                                    T& t) {
  // Quadratic where the line cuts the surface, halving where it only touches it.
  constexpr int most_steps = 120;
  const T small = T(2) * std::numeric_limits<T>::epsilon() * outer_width(stone);
  for (int i = 0; i < most_steps; ++i) {
    const SurfacePoint<T> at = closest_point(stone, Vec3<T>(p_B + t * u_B));
    if (at.distance <= small) {
      return true;
    }
    const T slope = sign * formula::dot(at.normal_B, u_B);
    if (!(slope < T(0))) {
      return false;
    }
    const T next = t - sign * at.distance / slope;
    if (!(T(0) < sign * (next - t))) {
      return true;
    }
    t = next;
  }
  return true;
}

}  // namespace detail

/// Entry, exit and the first hit ahead of a ray.
///
/// Domain  a start whose square is finite, a unit direction within `unit_tolerance`, else InvalidArgument.
/// Error   entry and exit within 1e-14 of the greater of width and distance where the ray is not grazing (SURFACE-3);
///         they and the answer "passes" are those of a line nearer than 8 ε of that (DOMAIN-11).
template <Ordered T>
[[nodiscard]] RayHit<T> cast_ray(const Stone<T>& stone, const Vec3<T>& p_B, const Vec3<T>& u_B) {
  if (!(formula::dot(p_B, p_B) < std::numeric_limits<T>::max() / T(4))) [[unlikely]] {
    detail::require_point(p_B, "start");
    throw_invalid("start", p_B.transpose(), "must have a square that is finite");
  }
  detail::require_direction(u_B, "direction");
  RayHit<T> result;
  // From the point of the line that is nearest to the centre, so that a far start costs no digits but its own. Twice:
  // the first is off by as much of the way as |u|² is off 1.
  const T far = -formula::dot(p_B, u_B);
  const Vec3<T> near = p_B + far * u_B;
  const T rest = -formula::dot(near, u_B);
  const T nearest = far + rest;
  const Vec3<T> middle = near + rest * u_B;
  // A little more than the stone reaches, so that both ends are outside.
  const T bound = (T(1) + unit_tolerance<T>()) * outer_width(stone) / T(2);
  const T half_square = scalar::sq(bound) - formula::dot(middle, middle);
  if (half_square < T(0)) {
    return result;
  }
  const T half = scalar::sqrt(half_square);
  T entry = -half, exit = half;
  if (!detail::approach_surface(stone, middle, u_B, T(1), entry) ||
      !detail::approach_surface(stone, middle, u_B, T(-1), exit) || exit < entry) {
    return result;
  }
  result.hit = true;
  result.entry = nearest + entry;
  result.exit = nearest + exit;
  result.forward = !(result.exit < T(0));
  if (result.forward) {
    const bool inside = result.entry < T(0);
    result.first = inside ? result.exit : result.entry;
    result.surface = closest_point(stone, Vec3<T>(middle + (inside ? exit : entry) * u_B));
  }
  return result;
}

}  // namespace goishi
