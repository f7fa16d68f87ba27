#pragma once
/// \file
/// Vectors, matrices and unit quaternions on Eigen. `q_WB` is the attitude of B in W: v_W = q_WB v_B.

#include <Eigen/Geometry>
#include <goishi/error.hpp>
#include <goishi/scalar.hpp>

namespace goishi {

template <class T>
using Vec3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Mat3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Quat = Eigen::Quaternion<T>;

/// How far |q|² of a given attitude may be from 1: 64 ε. Four squared components, each with a few roundings behind it,
/// stay well below; a quaternion typed with fewer digits does not, and must be normalised by who knows what was meant.
template <Ordered T>
inline constexpr T unit_tolerance = T(64) * std::numeric_limits<T>::epsilon();

/// Rotation matrix of a unit quaternion: R_WB v_B = v_W.
///
/// Domain  |q| = 1 within `unit_tolerance`, else InvalidArgument.
template <Ordered T>
[[nodiscard]] Mat3<T> rotation_matrix(const Quat<T>& q_WB) {
  const T defect = q_WB.squaredNorm() - T(1);
  require(defect < unit_tolerance<T> && -unit_tolerance<T> < defect, "attitude", q_WB.norm(),
          "must be a unit quaternion; |q|² is off by ", defect, ", more than round-off: normalise it first");
  return q_WB.toRotationMatrix();
}

}  // namespace goishi
