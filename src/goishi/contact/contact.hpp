#pragma once
/// \file
/// What every contact query answers, and a stone as contact sees it.
///
/// One rule for every pair: the separation is the greatest value, over all unit normals n, of what lies between the two
/// bodies in the direction n. The n that gives it is the contact normal *and* the direction to push out along; its value
/// is the gap, or minus the depth; the two support points are the contact points.

#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <string_view>

namespace goishi {

enum class SeparationStatus {
  separated,
  overlapping,   // gap < 0: the bodies share points, −gap deep
  not_converged  // the certificate was not reached: `gap` is a lower bound of the separation
};

[[nodiscard]] constexpr std::string_view to_string(SeparationStatus status) {
  switch (status) {
    case SeparationStatus::separated:
      return "separated";
    case SeparationStatus::overlapping:
      return "overlapping";
    case SeparationStatus::not_converged:
      break;
  }
  return "not converged";
}

/// What the stone touches, or would.
enum class OtherFeature { surface, side, top_edge, vertical_edge, corner, stone };

[[nodiscard]] constexpr std::string_view to_string(OtherFeature feature) {
  constexpr std::string_view names[] = {"surface", "side", "top edge", "vertical edge", "corner", "stone"};
  return names[static_cast<std::size_t>(feature)];
}

template <class T>
struct Separation {
  SeparationStatus status = SeparationStatus::not_converged;
  T gap = scalar::unset<T>();                               // [m], < 0: depth
  Vec3<T> n_W = Vec3<T>::Constant(scalar::unset<T>());      // unit, out of the other body towards the stone
  Vec3<T> p_stone = Vec3<T>::Constant(scalar::unset<T>());  // contact point on the stone, in W
  Vec3<T> p_other = Vec3<T>::Constant(scalar::unset<T>());  // on the other body: p_stone − gap n
  Feature feature = Feature::rim;
  OtherFeature other_feature = OtherFeature::surface;
  bool certified = true;  // no normal separates more: proved by the method, or by equal primal and dual values
};

/// A point seen from the nearest point of a circle about an axis: put together along the radial direction and the
/// axis, so that what is left of a point that all but is on the circle are the digits of two lengths.
template <class T>
struct FromRim {
  T height;  // [m] of the point, along the axis
  T beyond;  // [m] how far outside the circle's cylinder
  Vec3<T> away;
};

namespace formula {

/// Of a point v, both it and the circle of the radius r₁ about u seen from the circle's middle.
/// Domain  v not on the axis.   Proof  derivations/edges.cpp.
template <Elementary T>
[[nodiscard]] inline FromRim<T> from_rim(const Vec3<T>& v, const Vec3<T>& u, const T& major_radius) {
  const T height = formula::dot(u, v);
  const Vec3<T> radial = formula::plus(v, T(-height), u);
  const T rho = scalar::sqrt(formula::dot(radial, radial));
  const T beyond = rho - major_radius;
  return {.height = height, .beyond = beyond, .away = formula::combination(T(beyond / rho), radial, height, u)};
}

}  // namespace formula

namespace detail {

/// A stone in the world: all that contact needs of its attitude is the axis.
template <class T>
struct Placed {
  const Stone<T>& stone;
  Vec3<T> p_W;
  Vec3<T> u_W;  // symmetry axis
};

template <Ordered T>
void require_stone(const Stone<T>& stone) {
  require(T(0) < stone.height, "stone", stone.height, "must be one of make_stone (its height is shown)");
}

template <Ordered T>
[[nodiscard]] Placed<T> place(const Stone<T>& stone, const Pose<T>& pose) {
  require_stone(stone);
  require_point(pose.p_WB, "position");
  return {.stone = stone, .p_W = pose.p_WB, .u_W = symmetry_axis(pose.q_WB)};
}

/// 2^e.
template <class T>
[[nodiscard]] constexpr T two_to(int e) {
  T result(1), factor = e < 0 ? T(T(1) / T(2)) : T(2);
  for (int left = e < 0 ? -e : e; left > 0; left /= 2) {
    result = left % 2 == 0 ? result : T(result * factor);
    factor = left == 1 ? factor : T(factor * factor);  // or it would overflow
  }
  return result;
}

/// The lengths that searches of normals may be made of: their squares neither overflow nor lose what round-off leaves of
/// them. Others are scaled by a power of two before.
template <class T>
struct Squares {
  static constexpr int high = std::numeric_limits<T>::max_exponent, low = std::numeric_limits<T>::min_exponent;
  static inline const T most = two_to<T>(high / 2 - 4), least = two_to<T>(low / 2 + std::numeric_limits<T>::digits);
  static inline const T vanished = two_to<T>(low + 2 * std::numeric_limits<T>::digits);
  static inline const T smaller = two_to<T>(-(high / 4 * 3)), larger = two_to<T>(high / 4 * 3);

  [[nodiscard]] static bool hold(const T& length) { return least < length && length < most; }
  /// What brings a length that they do not hold among those that they do.
  [[nodiscard]] static T factor(const T& length) { return length < T(1) ? larger : smaller; }
};

/// Along v, of a length whose square holds its digits: v itself, or, of one next to nothing, a multiple.
template <Ordered T>
[[nodiscard]] Vec3<T> held_along(const Vec3<T>& v) {
  const bool lost = formula::dot(v, v) < least_square<T>;
  return lost ? formula::scaled(Squares<T>::larger, v) : v;
}

/// The unit vector along v, which may be round-off of the least lengths that there are; false, and n as it was, if v is 0.
template <Ordered T>
[[nodiscard]] bool find_unit(const Vec3<T>& v, Vec3<T>& n) {
  const Vec3<T> held = held_along(v);
  const T size2 = formula::dot(held, held);
  if (!(T(0) < size2)) {
    return false;
  }
  n = formula::scaled(T(T(1) / scalar::sqrt(size2)), held);
  return true;
}

/// A stone `factor` times as large.
template <Ordered T>
[[nodiscard]] Stone<T> scaled(const T& factor, Stone<T> stone) {
  for (T* length :
       {&stone.width, &stone.height, &stone.bevel, &stone.sphere_radius, &stone.sphere_offset,
        &stone.bevel_major_radius, &stone.bevel_minor_radius, &stone.core_sphere_radius, &stone.joint_radius}) {
    *length = factor * *length;
  }
  return stone;
}

/// A separation found in a world `factor` times as large, its points seen from `origin`.
template <Ordered T>
[[nodiscard]] Separation<T> scaled_back(const T& factor, const Vec3<T>& origin, Separation<T> result) {
  result.gap = result.gap / factor;
  if (result.status != SeparationStatus::not_converged) {  // a depth may vanish here
    result.status = result.gap < T(0) ? SeparationStatus::overlapping : SeparationStatus::separated;
  }
  result.p_stone = origin + result.p_stone / factor;
  result.p_other = origin + result.p_other / factor;
  return result;
}

/// A unit normal as a placed stone sees it.
template <class T>
struct SeenNormal {
  T signed_axial;       // u · n
  Vec3<T> radial_part;  // n − (u · n) u
  Direction<T> direction;
};

template <Ordered T>
[[nodiscard]] SeenNormal<T> see(const Vec3<T>& u_W, const Vec3<T>& n_W) {
  const T axial = formula::dot(u_W, n_W);
  SeenNormal<T> seen{.signed_axial = axial, .radial_part = formula::plus(n_W, T(-axial), u_W), .direction = {}};
  const T square = formula::dot(seen.radial_part, seen.radial_part);
  seen.direction = {.axial = scalar::abs(axial), .radial = scalar::sqrt(square), .radial_square = square};
  return seen;
}

template <Ordered T>
[[nodiscard]] T support_value(const Stone<T>& stone, const Direction<T>& n) {
  return meets_cap(stone, n) ? formula::cap_support(stone, n.axial, n.radial_square)
                             : formula::rim_support(stone, n.radial);
}

/// The support point relative to the centre, in W, and its feature.
template <class T>
struct SupportPoint {
  Vec3<T> x_W;
  Feature feature;
};

/// Both are formed and one is taken: which of them it is, is as good as random, and a branch would be guessed wrong.
template <Ordered T>
[[nodiscard]] SupportPoint<T> support_point(const Stone<T>& stone, const Vec3<T>& u_W, const SeenNormal<T>& seen) {
  const Direction<T>& n = seen.direction;
  const bool cap = meets_cap(stone, n);
  const bool upper = !(seen.signed_axial < T(0));
  const T height = formula::cap_support_height(stone, n.axial, n.radial_square);
  const T ring = formula::rim_support_reach(stone, n.radial);
  const T across = cap ? stone.sphere_radius : ring;
  const T along = cap ? scalar::signed_as(height, seen.signed_axial) : T(stone.bevel_minor_radius * seen.signed_axial);
  const Feature on_cap = upper ? Feature::upper_cap : Feature::lower_cap;
  return {.x_W = formula::combination(across, seen.radial_part, along, u_W), .feature = cap ? on_cap : Feature::rim};
}

/// The feature that a stone meets a normal with whose direction from its centre is the opposite one.
[[nodiscard]] inline Feature feature_below(bool cap, bool upwards) {
  return !cap ? Feature::rim : upwards ? Feature::lower_cap : Feature::upper_cap;
}

/// The separation along a unit normal, complete but for `other_feature` and `certified`. `offset` is how far the other body
/// reaches in its direction: the greatest n · x over it. In scalars and in line: vectors would go through memory, where
/// what was stored one by one is loaded as a pair, which stalls.
template <Ordered T>
[[nodiscard, gnu::always_inline]] inline Separation<T> separation_along(const Placed<T>& placed, const Vec3<T>& n_W,
                                                                        const T& offset) {
  const Stone<T>& stone = placed.stone;
  const T nx = n_W.x(), ny = n_W.y(), nz = n_W.z();
  const T ux = placed.u_W.x(), uy = placed.u_W.y(), uz = placed.u_W.z();
  const T px = placed.p_W.x(), py = placed.p_W.y(), pz = placed.p_W.z();
  const T axial = ux * nx + uy * ny + uz * nz;
  const T rx = nx - axial * ux, ry = ny - axial * uy, rz = nz - axial * uz;
  const T square = rx * rx + ry * ry + rz * rz;
  // The stone is its own mirror image: its support point in −n is minus that in n.
  const bool upwards = !(axial < T(0));
  const Direction<T> n{.axial = scalar::abs(axial), .radial = scalar::sqrt(square), .radial_square = square};
  const bool cap = meets_cap(stone, n);
  T across, along, support;
  if (cap) {
    const T height = formula::cap_support_height(stone, n.axial, square);
    across = stone.sphere_radius;
    along = scalar::signed_as(height, axial);
    support = formula::cap_support(stone, n.axial, square);
  } else {
    across = formula::rim_support_reach(stone, n.radial);
    along = stone.bevel_minor_radius * axial;
    support = formula::rim_support(stone, n.radial);
  }
  const T gap = (nx * px + ny * py + nz * pz) - offset - support;
  const T x = px - (across * rx + along * ux), y = py - (across * ry + along * uy), z = pz - (across * rz + along * uz);
  return {.status = gap < T(0) ? SeparationStatus::overlapping : SeparationStatus::separated,
          .gap = gap,
          .n_W = {nx, ny, nz},
          .p_stone = {x, y, z},
          .p_other = {T(x - gap * nx), T(y - gap * ny), T(z - gap * nz)},
          .feature = feature_below(cap, upwards)};
}

}  // namespace detail

}  // namespace goishi
