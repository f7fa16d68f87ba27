#pragma once
/// \file
/// What an engine asks of a stone that stands somewhere: its box, its support.

#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// A box along the axes of W   [m].
template <class T>
struct Bounds {
  Vec3<T> low = Vec3<T>::Constant(scalar::unset<T>());
  Vec3<T> high = Vec3<T>::Constant(scalar::unset<T>());
};

/// The least box that holds the stone: p_WB ± the support along each axis, which depends on the symmetry axis's component
/// there alone.
///
/// Domain  a finite position, a unit attitude, else InvalidArgument.
/// Error   2 ε of the width and of |p| (MESH-6).
template <Ordered T>
[[nodiscard]] Bounds<T> bounds(const Stone<T>& stone, const Pose<T>& pose) {
  detail::require_point(pose.p_WB, "position");
  const Vec3<T> u = symmetry_axis(pose.q_WB);
  Bounds<T> result;
  for (int i = 0; i < 3; ++i) {
    const T axial = scalar::abs(T(u[i]));
    const T square = scalar::sq(u[(i + 1) % 3]) + scalar::sq(u[(i + 2) % 3]);  // no difference of near equals
    const detail::Direction<T> seen{axial, scalar::sqrt(square), square};
    const T half = detail::meets_cap(stone, seen) ? formula::cap_support(stone, seen.axial, seen.radial_square)
                                                  : formula::rim_support(stone, seen.radial);
    result.low[i] = pose.p_WB[i] - half;
    result.high[i] = pose.p_WB[i] + half;
  }
  return result;
}

/// The farthest point of a stone that stands somewhere, in W.
template <class T>
struct SupportInWorld {
  T value = scalar::unset<T>();                         // max n · x, from the origin of W [m]
  Vec3<T> p_W = Vec3<T>::Constant(scalar::unset<T>());  // where it is reached
  Feature feature = Feature::rim;
};

/// The support in the unit direction n_W, of the stone where it stands.
///
/// Domain  |n| = 1 within `unit_tolerance`, a finite position, a unit attitude, else InvalidArgument.
/// Error   value and point within 4 ε of the width and of |p| (MESH-6).
template <Ordered T>
[[nodiscard]] SupportInWorld<T> support(const Stone<T>& stone, const Pose<T>& pose, const Vec3<T>& n_W) {
  detail::require_point(pose.p_WB, "position");
  detail::require_direction(n_W);
  const Mat3<T> R_WB = rotation_matrix(pose.q_WB);
  const auto seen = [&](int i) { return formula::dot(Vec3<T>(R_WB.col(i)), n_W); };
  const Support<T> own = detail::support_of_unit<T>(stone, {seen(0), seen(1), seen(2)});
  const auto there = [&](int i) { return formula::dot(Vec3<T>(R_WB.row(i)), own.p_B); };
  const Vec3<T> placed(there(0), there(1), there(2));
  return {.value = T(own.value + formula::dot(n_W, pose.p_WB)),
          .p_W = formula::plus(pose.p_WB, placed),
          .feature = own.feature};
}

}  // namespace goishi
