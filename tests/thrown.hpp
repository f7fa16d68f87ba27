#pragma once
/// \file
/// A stone that is thrown, for the tests of `drop`.

#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <numbers>

#include "compiled/drop.hpp"

namespace goishi::drop_test {

inline constexpr double g_earth = 9.80665;

/// Of size 33 unless told otherwise, 5 cm over the board.
struct Thrown {
  Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
  State<double> start{
      .p_WB = {0.0, 0.0, 0.05}, .q_WB = Quat<double>::Identity(), .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
  DropSettings<double> settings = {};

  void tilt(double degrees) {
    const double half = degrees / 360.0 * std::numbers::pi;
    start.q_WB = Quat<double>(std::cos(half), 0.0, std::sin(half), 0.0);
  }
  void spin(const Vec3<double>& w_B) { start.L_W = formula::angular_momentum_W(start.q_WB, body, w_B); }
  [[nodiscard]] DropResult<double> drop() const { return goishi::drop(stone, body, start, settings); }
  [[nodiscard]] DropResult<double> drop_on_board() const {
    return goishi::drop(stone, body, start, make_board<double>(), settings);
  }
};

/// Turned and spinning, about no axis of its own.
[[nodiscard]] inline Thrown tumbling() {
  Thrown thrown;
  thrown.start.q_WB = Quat<double>(0.5, 0.5, -0.1, 0.7).normalized();
  thrown.start.L_W = {3e-6, -2e-6, 4e-6};
  return thrown;
}

/// Of this shape.
[[nodiscard]] inline Thrown thrown(const Stone<double>& stone) {
  return {.stone = stone, .body = make_rigid_body(mass_properties(stone, Density{2800.0}))};
}

}  // namespace goishi::drop_test
