#pragma once
/// \file
/// What the arrays of the C interface stand for.

#include <cstddef>
#include <goishi/board/board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/shape/stone.hpp>
#include <variant>

#include "arrays.hpp"

namespace goishi::c {

struct Body {
  Stone<double> stone;
  MassProperties<double> mass;

  [[nodiscard]] RigidBody<double> rigid() const { return make_rigid_body(mass); }
};

[[nodiscard]] inline Body read_stone(const char* name, const double* pointer, std::size_t size) {
  const auto a = read<GOISHI_STONE_SIZE>(name, pointer, size);
  const double width = a[GOISHI_WIDTH], height = a[GOISHI_HEIGHT], bevel = a[GOISHI_BEVEL];
  const double density = a[GOISHI_DENSITY], mass = a[GOISHI_MASS];
  const bool measured = whole("measured", a[GOISHI_MEASURED], 0, 1) == 1;
  const Stone<double> stone = measured ? make_measured_stone(width, height, bevel) : make_stone(width, height, bevel);
  const bool by_density = mass == 0.0;
  require(by_density || density == 0.0, "density", density, "must be 0 where the mass is given (", mass, ")");
  return {stone,
          by_density ? mass_properties(stone, Density<double>{density}) : mass_properties(stone, Mass<double>{mass})};
}

[[nodiscard]] inline Pose<double> read_pose(const char* name, const double* pointer, std::size_t size) {
  const auto a = read<GOISHI_POSE_SIZE>(name, pointer, size);
  return {.p_WB = {a[0], a[1], a[2]}, .q_WB = Quat<double>(a[3], a[4], a[5], a[6])};
}

[[nodiscard]] inline State<double> read_state(const char* name, const double* pointer, std::size_t size) {
  const auto a = read<GOISHI_STATE_SIZE>(name, pointer, size);
  State<double> state{.p_WB = {a[0], a[1], a[2]},
                      .q_WB = Quat<double>(a[3], a[4], a[5], a[6]),
                      .v_WB = {a[7], a[8], a[9]},
                      .L_W = {a[10], a[11], a[12]}};
  require_state(state);
  return state;
}

[[nodiscard]] inline Board<double> read_board(const char* name, const double* pointer, std::size_t size) {
  const auto a = read<GOISHI_BOARD_SIZE>(name, pointer, size);
  return make_board(BoardDimensions<double>{.lines = whole("lines", a[GOISHI_BOARD_LINES], 1, most_whole),
                                            .spacing_x = a[GOISHI_BOARD_SPACING_X],
                                            .spacing_y = a[GOISHI_BOARD_SPACING_Y],
                                            .border_x = a[GOISHI_BOARD_BORDER_X],
                                            .border_y = a[GOISHI_BOARD_BORDER_Y],
                                            .thickness = a[GOISHI_BOARD_THICKNESS],
                                            .legs = a[GOISHI_BOARD_LEGS]});
}

using Obstacle = std::variant<Plane<double>, Board<double>>;

[[nodiscard]] inline Obstacle read_ground(const double* pointer, std::size_t size) {
  constexpr std::size_t of_plane = GOISHI_PLANE_SIZE, of_board = GOISHI_BOARD_SIZE;
  require_pointer("ground", pointer);
  if (size == of_plane) {
    const auto a = read<GOISHI_PLANE_SIZE>("ground", pointer, size);
    return Plane<double>{{a[0], a[1], a[2]}, a[3]};
  }
  require(size == of_board, "ground_size", size, "must be ", of_plane, " of a plane, or ", of_board, " of a board");
  return read_board("ground", pointer, size);
}

inline void put_motion(Row row, const State<double>& state, const RigidBody<double>& body, const Vec& gravity) {
  row << state << formula::angular_velocity_W(state, body) << formula::energy(state, body, gravity);
}

}  // namespace goishi::c
