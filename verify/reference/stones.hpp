#pragma once
/// \file
/// The stones of the set, and what its sections say of stones, places and directions.

#include <array>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/rotation.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <vector>

#include "verify/reference/enclosure.hpp"
#include "verify/reference/problem.hpp"

namespace goishi::verify::reference {

/// A shape, as it is given.
struct Shape {
  double width;
  double height;
  double bevel;
  bool measured = false;  // the width is that of the finished stone
  std::string about;
};

/// Exact singular shapes first, then the catalogue, then others.
[[nodiscard]] std::vector<Shape> all_shapes();

/// A few of them, for sections that place them: sharp, bevelled, measured, thin, a ball, a needle's eps.
[[nodiscard]] std::vector<Shape> some_shapes();

[[nodiscard]] std::vector<InputKind> shape_inputs();
[[nodiscard]] std::vector<Input> inputs_of(const Shape& shape);

/// "mass", 7: "mass-007".
[[nodiscard]] std::string numbered(const std::string& section, std::size_t number);

template <class T>
[[nodiscard]] Stone<T> stone_of(const Shape& shape) {
  const T w(shape.width), h(shape.height), b(shape.bevel);
  return shape.measured ? make_measured_stone(w, h, b) : make_stone(w, h, b);
}

/// The numbers as they are.
template <class T>
[[nodiscard]] Vec3<T> vector_of(const std::array<double, 3>& v) {
  return {T(v[0]), T(v[1]), T(v[2])};
}

/// Of any length, made a unit one.
template <class T>
[[nodiscard]] Vec3<T> direction_of(const std::array<double, 3>& v) {
  const Vec3<T> n = vector_of<T>(v);
  const T length = scalar::sqrt(T(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()));
  return {T(n.x() / length), T(n.y() / length), T(n.z() / length)};
}

/// w, x, y, z of any length, made a unit quaternion.
template <class T>
[[nodiscard]] Quat<T> attitude_of(const std::array<double, 4>& q) {
  const T w(q[0]), x(q[1]), y(q[2]), z(q[3]);
  const T length = scalar::sqrt(T(w * w + x * x + y * y + z * z));
  return Quat<T>(T(w / length), T(x / length), T(y / length), T(z / length));
}

template <std::size_t count>
[[nodiscard]] Input input(const std::string& name, const std::array<double, count>& numbers) {
  return {.name = name, .numbers = {numbers.begin(), numbers.end()}};
}
[[nodiscard]] inline Input input(const std::string& name, double number) {
  return {.name = name, .numbers = {number}};
}
[[nodiscard]] inline Input input(const std::string& name, const std::string& word) {
  return {.name = name, .word = word};
}

template <class T>
[[nodiscard]] Answer<T> answer(const std::string& quantity, const T& value, double scale = 0.0) {
  return {.quantity = quantity, .values = {value}, .scale = scale};
}
template <class T>
[[nodiscard]] Answer<T> answer(const std::string& quantity, const Vec3<T>& value, double scale) {
  return {.quantity = quantity, .values = {value.x(), value.y(), value.z()}, .scale = scale};
}
template <class T>
[[nodiscard]] Answer<T> answer(const std::string& quantity, const Quat<T>& value, double scale) {
  return {.quantity = quantity, .values = {value.w(), value.x(), value.y(), value.z()}, .scale = scale};
}
template <class T>
[[nodiscard]] Answer<T> word(const std::string& quantity, std::string_view text) {
  return {.quantity = quantity, .word = std::string(text)};
}

/// |v|, for scales.
template <std::size_t count>
[[nodiscard]] double length_of(const std::array<double, count>& v) {
  double square = 0.0;
  for (const double x : v) {
    square += x * x;
  }
  return std::sqrt(square);
}

}  // namespace goishi::verify::reference
