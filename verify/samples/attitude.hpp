#pragma once
/// \file
/// Attitudes by where they take an axis.

#include <goishi/rotation.hpp>

namespace goishi::verify {

/// An attitude that turns the unit vector `from` into `to`: the shortest turn, or a half turn first where they are more
/// than a right angle apart. (Eigen's `FromTwoVectors` instantiates a singular value decomposition.)
[[nodiscard]] inline Quat<double> turn_between(const Vec3<double>& from, const Vec3<double>& to) {
  const auto shortest = [&to](const Vec3<double>& near) {
    const Vec3<double> axis = near.cross(to);
    return Quat<double>(1.0 + near.dot(to), axis.x(), axis.y(), axis.z()).normalized();
  };
  if (0.0 <= from.dot(to)) {
    return shortest(from);
  }
  const Vec3<double> p = from.unitOrthogonal();
  return (shortest(-from) * Quat<double>(0.0, p.x(), p.y(), p.z())).normalized();
}

}  // namespace goishi::verify
