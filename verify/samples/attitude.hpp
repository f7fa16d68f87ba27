#pragma once
/// \file
/// Attitudes by where they take an axis, and the angle between two.

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

/// The angle of the rotation between two attitudes, as 2 sin(angle/2); neither needs to be of length 1.
template <class Real>
[[nodiscard]] double angle_between(const Quat<Real>& one, const Quat<Real>& other) {
  const Real w = one.w(), x = one.x(), y = one.y(), z = one.z();
  const Real w_ = other.w(), x_ = other.x(), y_ = other.y(), z_ = other.z();
  const Vec3<Real> turn(Real(w * x_ - x * w_ - y * z_ + z * y_), Real(w * y_ - y * w_ - z * x_ + x * z_),
                        Real(w * z_ - z * w_ - x * y_ + y * x_));
  return static_cast<double>(Real(Real(2) * turn.norm() / (one.norm() * other.norm())));
}

}  // namespace goishi::verify
