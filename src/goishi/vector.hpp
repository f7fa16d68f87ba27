#pragma once
/// \file
/// Sums and products of vectors, component by component: Eigen's own expressions load as a pair what was just stored
/// one by one, which stalls.

#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>

namespace goishi::formula {

/// a · b.   Proof  derivations/impact.cpp, as of all below.
template <Field T>
[[nodiscard]] T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// a × b.
template <Field T>
[[nodiscard]] Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a.y() * b.z() - a.z() * b.y()), T(a.z() * b.x() - a.x() * b.z()), T(a.x() * b.y() - a.y() * b.x())};
}

/// a + b.
template <Field T>
[[nodiscard]] Vec3<T> plus(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a.x() + b.x()), T(a.y() + b.y()), T(a.z() + b.z())};
}

/// a + s b.
template <Field T>
[[nodiscard]] Vec3<T> plus(const Vec3<T>& a, const T& s, const Vec3<T>& b) {
  return {T(a.x() + s * b.x()), T(a.y() + s * b.y()), T(a.z() + s * b.z())};
}

/// a − b.
template <Field T>
[[nodiscard]] Vec3<T> minus(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(a.x() - b.x()), T(a.y() - b.y()), T(a.z() - b.z())};
}

/// α a + β b.
template <Field T>
[[nodiscard]] Vec3<T> combination(const T& alpha, const Vec3<T>& a, const T& beta, const Vec3<T>& b) {
  return {T(alpha * a.x() + beta * b.x()), T(alpha * a.y() + beta * b.y()), T(alpha * a.z() + beta * b.z())};
}

/// α a + β b + γ c.
template <Field T>
[[nodiscard]] Vec3<T> combination(const T& alpha, const Vec3<T>& a, const T& beta, const Vec3<T>& b, const T& gamma,
                                  const Vec3<T>& c) {
  return {T(alpha * a.x() + beta * b.x() + gamma * c.x()), T(alpha * a.y() + beta * b.y() + gamma * c.y()),
          T(alpha * a.z() + beta * b.z() + gamma * c.z())};
}

/// s a.
template <Field T>
[[nodiscard]] Vec3<T> scaled(const T& s, const Vec3<T>& a) {
  return {T(s * a.x()), T(s * a.y()), T(s * a.z())};
}

}  // namespace goishi::formula

namespace goishi::detail {

/// |v|, of a square that is a number.
template <Ordered T>
[[nodiscard]] T length(const Vec3<T>& v) {
  return scalar::sqrt(formula::dot(v, v));
}

/// v/|v|.
template <Ordered T>
[[nodiscard]] Vec3<T> unit(const Vec3<T>& v) {
  const T norm = detail::length(v);
  return {T(v.x() / norm), T(v.y() / norm), T(v.z() / norm)};
}

}  // namespace goishi::detail
