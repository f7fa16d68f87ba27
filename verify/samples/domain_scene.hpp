#pragma once
/// \file
/// What the claims that walk the domain of contact ask: a stone over a plane, at a board and beside another stone, of any
/// size, and all that is asked of them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <goishi/contact/time_of_impact.hpp>
#include <limits>
#include <string>
#include <utility>

#include "verify/samples/pose.hpp"
#include "verify/suite/claim.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify::domain {

/// The greatest magnitudes, as powers of two: 1e±150 and 1e±18.
template <class T>
inline constexpr int span = std::same_as<T, float> ? 59 : 498;

template <class T>
Vec3<T> narrow(const Vec3<double>& v) {
  return v.cast<T>();
}

/// A stone over a plane, at a board and beside another stone, and how they fly. All of it `factor` times as large as drawn;
/// factors are powers of two, so that nothing but overflow and underflow can tell one from another.
template <class T>
struct Scene {
  T factor;
  Stone<T> stone, other;
  Board<T> board;
  Pose<T> pose, other_pose;
  Plane<T> plane;
  FlightPath<T> path, other_path;
};

/// The numbers that a scene is made of, so that one can be made of any size.
struct Drawn {
  Specimen first, second;
  Board<double> board;
  Pose<double> pose, other_pose;
  Vec3<double> n, v, spin;
  double rate;
};

inline Drawn draw(Context& context, int i) {
  const Pair pair = draw_pair(context, i);
  Drawn drawn{pair.first,
              pair.second,
              draw_board(context, i / 6),
              {},
              {},
              draw_unit(context),
              {},
              draw_unit(context),
              i % 5 == 0 ? 0.0 : 300.0 * draw_small(context, 3.0)};
  const bool near_board = i % 2 == 0;
  drawn.pose = near_board ? draw_board_pose(context, pair.first.stone, drawn.board, i / 2) : pair.pose;
  drawn.other_pose = pair.other_pose;
  if (near_board) {
    drawn.other_pose.p_WB = drawn.pose.p_WB + (pair.other_pose.p_WB - pair.pose.p_WB);
  }
  drawn.v = context.uniform(0.0, 2.0) * draw_unit(context);
  return drawn;
}

template <class T>
Scene<T> make_scene(const Drawn& drawn, const T& factor) {
  const auto length = [&](double x) { return T(factor * static_cast<T>(x)); };
  const auto stone = [&](const Specimen& specimen) {
    const ShapeSample<double>& shape = specimen.shape;
    const T h = static_cast<T>(shape.height);
    T b = static_cast<T>(shape.bevel);
    b = b < h ? b : std::nextafter(h, T(0));
    return make_stone(T(factor * std::max(h, static_cast<T>(shape.width))), T(factor * h), T(factor * b));
  };
  const auto pose = [&](const Pose<double>& at) {
    return Pose<T>{.p_WB = factor * narrow<T>(at.p_WB), .q_WB = at.q_WB.cast<T>().normalized()};
  };
  Scene<T> scene{factor, stone(drawn.first), stone(drawn.second), {}, pose(drawn.pose), pose(drawn.other_pose), {}, {},
                 {}};
  scene.board = {.lines = drawn.board.lines,
                 .spacing_x = length(drawn.board.spacing_x),
                 .spacing_y = length(drawn.board.spacing_y),
                 .half_width = length(drawn.board.half_width),
                 .half_length = length(drawn.board.half_length),
                 .thickness = length(drawn.board.thickness),
                 .floor = length(drawn.board.floor)};
  scene.plane = {.n_W = narrow<T>(drawn.n).normalized(), .offset = length(drawn.board.half_width / 3.0)};
  const auto path = [&](const Pose<T>& at, const Vec3<double>& v) {
    return FlightPath<T>{.p_W = at.p_WB,
                         .v_W = factor * narrow<T>(v),
                         .a_W = factor * Vec3<T>(T(0), T(0), T(-9.8)),
                         .u_W = formula::symmetry_axis(at.q_WB).normalized(),
                         .k_W = narrow<T>(drawn.spin).normalized(),
                         .rate = static_cast<T>(drawn.rate)};
  };
  scene.path = path(scene.pose, drawn.v);
  scene.other_path = path(scene.other_pose, Vec3<double>(-0.5 * drawn.v));
  return scene;
}

/// Of what the round-off of a gap is.
template <class T>
Long size_of(const Scene<T>& scene) {
  const auto of = [](const auto& v) { return static_cast<Long>(v.cwiseAbs().maxCoeff()); };
  return static_cast<Long>(outer_width(scene.stone) + outer_width(scene.other)) + of(scene.pose.p_WB) +
         of(scene.other_pose.p_WB) + static_cast<Long>(scene.board.half_width + scene.board.half_length);
}

/// What is wrong with a separation; empty if nothing.
template <class T>
std::string defect(const Separation<T>& at) {
  const auto sum = [](const Vec3<T>& v) { return v.template cast<Long>().sum(); };
  const Long all = static_cast<Long>(at.gap) + sum(at.n_W) + sum(at.p_stone) + sum(at.p_other);
  if (!std::isfinite(all)) {
    return "not finite";
  }
  if (!(std::fabs(at.n_W.norm() - T(1)) < T(16) * std::numeric_limits<T>::epsilon())) {
    return "no unit normal";
  }
  if (at.status != SeparationStatus::not_converged && (at.status == SeparationStatus::overlapping) != (at.gap < T(0))) {
    return "status and gap disagree";
  }
  return "";
}

/// All four gaps of a scene.
template <class T>
std::array<Separation<T>, 3> separations(const Scene<T>& scene) {
  return {separation(scene.stone, scene.pose, scene.plane), separation(scene.stone, scene.pose, scene.board),
          separation(scene.stone, scene.pose, scene.other, scene.other_pose)};
}

template <class T>
Long produced(const Context& context, const Separation<T>& at) {
  return static_cast<Long>(context.produced(static_cast<double>(at.gap)));
}

inline constexpr std::array kinds = {"plane", "board", "pair"};

template <class T>
std::array<TimeOfImpact<T>, 3> impacts(const Scene<T>& scene, const T& horizon) {
  return {time_of_impact(scene.stone, scene.path, scene.plane, horizon),
          time_of_impact(scene.stone, scene.path, scene.board, horizon),
          time_of_impact(scene.stone, scene.path, scene.other, scene.other_path, horizon)};
}

inline constexpr double wrong = 1e9;

/// From where on flights are refused.
template <class T>
inline const Long most_of = std::sqrt(static_cast<Long>(std::numeric_limits<T>::max())) / 16;

/// The greatest number of a flight, of those that are held against that.
template <class T>
Long greatest(const Stone<T>& stone, const FlightPath<T>& path) {
  const auto size = [](const Vec3<T>& v) { return v.template cast<Long>().template lpNorm<1>(); };
  const Long r = static_cast<Long>(stone.sphere_radius), rate = static_cast<Long>(path.rate);
  return std::max({size(path.p_W), size(path.v_W), size(path.a_W), r, r * rate * rate});
}

/// The powers of two that a scene may be larger by, its lengths still being those of stones (`require_length`).
template <class T>
std::pair<int, int> sizes_taken(const Scene<T>& scene) {
  const auto [least, most] = length_range<T>();
  const T thin = std::min(scene.stone.height, scene.other.height);
  const T round = std::max(scene.stone.sphere_radius, scene.other.sphere_radius);
  return {std::max(-span<T>, std::ilogb(least / thin) + 2), std::min(span<T>, std::ilogb(most / round) - 1)};
}

}  // namespace goishi::verify::domain
