#pragma once
/// \file
/// A stone on each of the 361 points of a board, all let go at once: what the library's scene is measured on.

#include <cmath>
#include <goishi/board/board.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/scene/settings.hpp>
#include <random>
#include <vector>

namespace goishi::verify::bench::rivals {

/// Sharp stones of 22 × 9.2 mm, 22 × 23.7 mm apart, so that those of a row touch where they lie.
struct FullBoard {
  static constexpr int lines = 19;
  static constexpr double from = 0.02;          // [m] height of the centres
  static constexpr double greatest_tilt = 0.3;  // [rad]
  static constexpr double greatest_spin = 5.0;  // [rad/s] about each axis of B

  Stone<double> stone = make_stone(0.022, 0.0092);
  RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
  Board<double> board;
  std::vector<State<double>> starts;
};

[[nodiscard]] inline Board<double> wide_board() {
  BoardDimensions<double> dimensions;
  dimensions.lines = FullBoard::lines;
  dimensions.border_x = dimensions.border_y = 0.15;  // what rolls away stays on it
  return make_board(dimensions);
}

/// The numbers drawn are the same on every machine.
[[nodiscard]] inline FullBoard make_full_board(unsigned seed = 1) {
  FullBoard full{.board = wide_board(), .starts = {}};
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  constexpr double middle = (FullBoard::lines - 1) / 2.0, most = FullBoard::greatest_spin;
  for (int i = 0; i < FullBoard::lines; ++i) {
    for (int j = 0; j < FullBoard::lines; ++j) {
      const double towards = uniform(0, 2 * 3.14159265358979323846), half = uniform(0, FullBoard::greatest_tilt) / 2;
      const Quat<double> q(std::cos(half), std::sin(half) * std::cos(towards), std::sin(half) * std::sin(towards), 0);
      const double x = uniform(-most, most), y = uniform(-most, most), z = uniform(-most, most);
      full.starts.push_back(
          {.p_WB = {(i - middle) * full.board.spacing_x, (j - middle) * full.board.spacing_y, FullBoard::from},
           .q_WB = q.normalized(),
           .v_WB = {0, 0, 0},
           .L_W = formula::angular_momentum_W<double>(q.normalized(), full.body, {x, y, z})});
    }
  }
  return full;
}

/// Under which it falls: e = μ = 0.3, rolling and pivot resistance 1e-4 m and 5e-5 m, tolerance 1e-4 where a stone is
/// alone.
[[nodiscard]] inline SceneSettings<double> full_board_settings(double step) {
  SceneSettings<double> settings;
  settings.restitution = settings.drop.restitution = 0.3;
  settings.friction = settings.drop.friction = 0.3;
  settings.drop.rolling_resistance = 1e-4;
  settings.drop.pivot_radius = 5e-5;
  settings.drop.tolerance = 1e-4;
  settings.step = step;
  return settings;
}

}  // namespace goishi::verify::bench::rivals
