#pragma once
/// \file
/// Vectors, matrices, unit quaternions and poses on Eigen. `q_WB` is the attitude of B in W: v_W = q_WB v_B.

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

/// Where a body is, and how it stands. NaN until set.
template <class T>
struct Pose {
  Vec3<T> p_WB = Vec3<T>::Constant(scalar::unset<T>());
  Quat<T> q_WB = Quat<T>(scalar::unset<T>(), scalar::unset<T>(), scalar::unset<T>(), scalar::unset<T>());
};

namespace scalar {

/// Each component is, whatever their sum is.
template <Ordered T>
[[nodiscard]] bool is_finite(const Vec3<T>& v) {
  return scalar::is_finite(T(v.x() + v.y() + v.z())) ||
         (scalar::is_finite(v.x()) && scalar::is_finite(v.y()) && scalar::is_finite(v.z()));
}

}  // namespace scalar

/// How far |q|² of a given attitude may be from 1: 64 ε. Four squared components, each with a few roundings behind it,
/// stay well below; a quaternion typed with fewer digits does not, and must be normalised by who knows what was meant.
/// Of |q|² as T has it, which is itself off by up to 4 ε: four squares and three sums, none above 1 but the last. What is
/// off by 60 ε is taken in every rounding mode, what is off by 68 ε in none; of a direction, |n|² likewise.
template <Ordered T>
[[nodiscard]] constexpr T unit_tolerance() {
  return T(64) * std::numeric_limits<T>::epsilon();
}

namespace formula {

/// The rotation by the vector θ: axis θ/|θ|, angle |θ|, as a unit quaternion.
///
///     exp(θ) = (cos |θ|/2, θ sin(|θ|/2) / |θ|)
///
/// Limits  θ = 0: the identity, without a branch (`scalar::tiny`).
/// Error   the rotation is off by <= 2 ε |θ| rad (claim FLIGHT-6).   Proof  derivations/rotation.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> rotation_exp(const Vec3<T>& theta) {
  const T angle =
      scalar::sqrt(T(scalar::sq(theta.x()) + scalar::sq(theta.y()) + scalar::sq(theta.z()) + scalar::tiny<T>()));
  const T half = angle / T(2);
  const auto [sine, cosine] = scalar::sincos(half);
  const T over = sine / angle;
  return Quat<T>(cosine, T(over * theta.x()), T(over * theta.y()), T(over * theta.z()));
}

/// The product p q, first q and then p. Component by component: Eigen's own loads as a pair what was just stored one by
/// one, which stalls.
template <Field T>
[[nodiscard]] Quat<T> product(const Quat<T>& p, const Quat<T>& q) {
  const T pw = p.w(), px = p.x(), py = p.y(), pz = p.z();
  const T qw = q.w(), qx = q.x(), qy = q.y(), qz = q.z();
  return Quat<T>(T(pw * qw - px * qx - py * qy - pz * qz), T(pw * qx + px * qw + py * qz - pz * qy),
                 T(pw * qy - px * qz + py * qw + pz * qx), T(pw * qz + px * qy - py * qx + pz * qw));
}

/// The rate of the attitude, q̇ = ½ (0, ω_W) q.
/// Proof  derivations/rotation.cpp.
template <Field T>
[[nodiscard]] Quat<T> attitude_rate(const Vec3<T>& w_WB, const Quat<T>& q_WB) {
  const T half = T(1) / T(2);
  return formula::product(Quat<T>(T(0), T(half * w_WB.x()), T(half * w_WB.y()), T(half * w_WB.z())), q_WB);
}

/// A quaternion that round-off has taken off the unit sphere by a relative δ, back to O(δ²): q (3 − |q|²)/2.
/// Proof  derivations/rotation.cpp.
template <Field T>
[[nodiscard]] Quat<T> reunited(const Quat<T>& q) {
  const T square = scalar::sq(q.w()) + scalar::sq(q.x()) + (scalar::sq(q.y()) + scalar::sq(q.z()));
  const T scale = (T(3) - square) / T(2);
  return Quat<T>(T(scale * q.w()), T(scale * q.x()), T(scale * q.y()), T(scale * q.z()));
}

/// The same of a vector: u (3 − |u|²)/2.
template <Field T>
[[nodiscard]] inline Vec3<T> reunited(const Vec3<T>& u) {
  const T square = scalar::sq(u.x()) + scalar::sq(u.y()) + scalar::sq(u.z());
  const T scale = (T(3) - square) / T(2);
  return {T(scale * u.x()), T(scale * u.y()), T(scale * u.z())};
}

/// The symmetry axis in W: q_WB Bz, the third column of R_WB.
/// Proof  derivations/rotation.cpp.
template <Field T>
[[nodiscard]] Vec3<T> symmetry_axis(const Quat<T>& q) {
  return {T(T(2) * (q.x() * q.z() + q.w() * q.y())), T(T(2) * (q.y() * q.z() - q.w() * q.x())),
          T(T(1) - T(2) * (scalar::sq(q.x()) + scalar::sq(q.y())))};
}

/// The same of q/|q|, to O(δ²), where round-off has taken |q| off 1 by δ: what `reunited` would do to q, at the end.
///
///     u = (2(q_x q_z + q_w q_y), 2(q_y q_z − q_w q_x), q_w² + q_z² − q_x² − q_y²) ((3 − |q|²)/2)²
///
/// Proof  derivations/rotation.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> unit_axis(const Quat<T>& q) {
  const T w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const T wz = w * w + z * z, xy = x * x + y * y;
  const T scale = scalar::sq(T((T(3) - (wz + xy)) / T(2))), twice = scale + scale;
  return {T(twice * (x * z + w * y)), T(twice * (y * z - w * x)), T(scale * (wz - xy))};
}

}  // namespace formula

namespace detail {

/// |q|². Component by component: what Eigen's sums round to depends on its vector instructions.
template <Field T>
[[nodiscard]] T squared_norm(const Quat<T>& q) {
  const T wz = scalar::sq(q.w()) + scalar::sq(q.z()), xy = scalar::sq(q.x()) + scalar::sq(q.y());
  return T(wz + xy);
}

/// q/|q|; 0 where |q|² overflows, q where it vanishes.
template <Ordered T>
[[nodiscard]] Quat<T> normalized(const Quat<T>& q) {
  const T square = detail::squared_norm(q);
  if (!(T(0) < square)) {
    return q;
  }
  const T norm = scalar::sqrt(square);
  return Quat<T>(T(q.w() / norm), T(q.x() / norm), T(q.y() / norm), T(q.z() / norm));
}

/// |q|² − 1.
template <Ordered T>
[[nodiscard]] inline T unit_defect(const Quat<T>& q) {
  return detail::squared_norm(q) - T(1);
}

/// Of |q|² − 1 or |n|² − 1.
template <Ordered T>
[[nodiscard]] inline bool is_unit_defect(const T& defect) {
  return scalar::abs(defect) < unit_tolerance<T>();
}

template <Ordered T>
[[nodiscard]] inline bool is_unit(const Quat<T>& q) {
  return is_unit_defect(unit_defect(q));
}

}  // namespace detail

/// Throws InvalidArgument unless |q| = 1 within `unit_tolerance`.
template <Ordered T>
void require_unit(const Quat<T>& q_WB) {
  if (const T defect = detail::unit_defect(q_WB); !detail::is_unit_defect(defect)) [[unlikely]] {
    throw_invalid("attitude", scalar::sqrt(T(defect + T(1))), "must be a unit quaternion; |q|² is off by ", defect,
                  ", more than round-off: normalise it first");
  }
}

/// Rotation matrix of a unit quaternion: R_WB v_B = v_W. Of q/|q|, so that it is a rotation to round-off.
///
/// Domain  |q| = 1 within `unit_tolerance`, else InvalidArgument.
template <Ordered T>
[[nodiscard]] Mat3<T> rotation_matrix(const Quat<T>& q_WB) {
  require_unit(q_WB);
  return formula::reunited(q_WB).toRotationMatrix();
}

/// The symmetry axis in W, a unit vector to round-off; `formula::symmetry_axis` alone has twice the quaternion's defect.
///
/// Domain  |q| = 1 within `unit_tolerance`, else InvalidArgument.
template <Ordered T>
[[nodiscard]] Vec3<T> symmetry_axis(const Quat<T>& q_WB) {
  require_unit(q_WB);
  return formula::unit_axis(q_WB);
}

}  // namespace goishi
