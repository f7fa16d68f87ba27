#pragma once
/// \file
/// A stone and what it meets, in any scalar: a plane, the board, another stone.

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/phases/next_impact.hpp>
#include <goishi/mass/inertia.hpp>
#include <optional>
#include <string>

#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

/// What is searched with before balls prove it: its square root is what is left of a normal.
using Digits100 =
    boost::multiprecision::number<boost::multiprecision::backends::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// A stone of uniform density, and how it moves.
struct Mover {
  Shape shape;
  std::array<double, 3> position = {};
  std::array<double, 4> attitude = {1.0, 0.0, 0.0, 0.0};
  std::array<double, 3> velocity = {};
  std::array<double, 3> spin = {};  // in B
};

enum class Against { plane, board, stone };

/// The board's half sides as they are given; it is infinitely deep.
inline constexpr double board_half_width = 0.2121, board_half_length = 0.22725;

struct Encounter {
  Against against = Against::plane;
  Mover first;
  Mover other;                                     // a stone
  std::array<double, 3> normal = {0.0, 0.0, 1.0};  // of the plane, of any length
  double offset = 0.0;
  std::array<double, 3> gravity = {};
  double horizon = 1.0;
  std::string about;
};

/// Unchecked, as balls do not tell two equal moments apart.
template <class T>
[[nodiscard]] RigidBody<T> body_of(const MassProperties<T>& stone) {
  const Moments<T>& moments = stone.moments;
  return {.mass = stone.mass, .moments = {moments.transverse, moments.transverse, moments.axial}};
}

template <class T>
[[nodiscard]] State<T> state_of(const Mover& mover, const RigidBody<T>& body) {
  const Quat<T> q = attitude_of<T>(mover.attitude);
  return {.p_WB = vector_of<T>(mover.position),
          .q_WB = q,
          .v_WB = vector_of<T>(mover.velocity),
          .L_W = formula::angular_momentum_W<T>(q, body, vector_of<T>(mover.spin))};
}

/// One of the bodies of an encounter: its shape, and how it flies.
template <class T>
struct Flyer {
  Stone<T> stone;
  FlightPath<T> path;

  Flyer(const Mover& mover, const std::array<double, 3>& gravity) : stone(stone_of<T>(mover.shape)) {
    const MassProperties<T> properties = mass_properties(stone, Mass<T>{T(1)});
    path = path_of(state_of(mover, body_of(properties)), formula::mobility(properties.moments), vector_of<T>(gravity));
  }
  [[nodiscard]] detail::Placed<T> at(const T& t) const { return detail::placed_at(stone, path, t); }
};

template <class T>
struct World {
  Against against;
  Flyer<T> first, other;
  Plane<T> plane;
  Board<T> board = make_board<T>();

  explicit World(const Encounter& of)
      : against(of.against),
        first(of.first, of.gravity),
        other(of.against == Against::stone ? of.other : of.first, of.gravity),
        plane{.n_W = direction_of<T>(of.normal), .offset = T(of.offset)} {
    board.half_width = T(board_half_width);
    board.half_length = T(board_half_length);
  }

  [[nodiscard]] Separation<T> separation_at(const T& t) const {
    switch (against) {
      case Against::plane:
        return detail::separation_along(first.at(t), plane.n_W, plane.offset);
      case Against::board:
        return detail::separation(first.at(t), board);
      case Against::stone:
        break;
    }
    return detail::separation(first.at(t), other.at(t));
  }

  [[nodiscard]] TimeOfImpact<T> first_touch(const T& horizon) const {
    switch (against) {
      case Against::plane:
        return time_of_impact(first.stone, first.path, plane, horizon);
      case Against::board:
        return time_of_impact(first.stone, first.path, board, horizon);
      case Against::stone:
        break;
    }
    return time_of_impact(first.stone, first.path, other.stone, other.path, horizon);
  }

  /// The gap along a fixed normal, as a function of time.
  [[nodiscard]] detail::GapAlong<T> gap_along(const Vec3<T>& n) const {
    switch (against) {
      case Against::plane:
        return detail::gap_along(first.stone, first.path, n, plane.offset);
      case Against::board:
        return detail::gap_along(first.stone, first.path, n, detail::reach_of(board, n));
      case Against::stone:
        break;
    }
    const auto along = [&](const Vec3<T>& one, const Vec3<T>& two) {
      return formula::dot(n, formula::minus(one, two));
    };
    detail::GapAlong<T> gap(along(first.path.p_W, other.path.p_W), along(first.path.v_W, other.path.v_W),
                            along(first.path.a_W, other.path.a_W));
    gap.add(formula::wobble(first.stone, first.path, n));
    gap.add(formula::wobble(other.stone, other.path, n));
    return gap;
  }
};

}  // namespace goishi::verify::reference
