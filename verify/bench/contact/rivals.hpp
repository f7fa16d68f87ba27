#pragma once
/// \file
/// What the rivals have in common: hulls of these sizes, and a flight stepped by what a query for the gap answers.

#include <array>
#include <goishi/motion/free_flight.hpp>

#include "verify/bench/contact/contact.hpp"
#include "verify/bench/contact/polyhedron.hpp"

namespace goishi::verify::bench::contact {

inline constexpr std::array hull_rings = {8, 16, 32, 64};

[[nodiscard]] std::vector<Contestant<Scene>> libccd_contestants();

/// Of every hull in `hull_rings`.
[[nodiscard]] inline std::vector<double> vertex_counts() {
  std::vector<double> counts;
  for (const int rings : hull_rings) {
    counts.push_back(rings * rings);
  }
  return counts;
}

[[nodiscard]] inline int rings_of(double vertices) {
  return static_cast<int>(std::lround(std::sqrt(vertices)));
}

/// The board as a box: centre, and half the lengths of its sides.
struct Box {
  Vec3<double> centre;
  Vec3<double> half;
};
[[nodiscard]] inline Box box_of(const Board<double>& board) {
  const Vec3<double> half(board.half_width, board.half_length, board.thickness / 2);
  return {.centre = {0, 0, -half.z()}, .half = half};
}

/// The stone's pose at a time, all that a collision library has to be told of its flight.
[[nodiscard]] inline Pose<double> pose_at(const FlightPath<double>& path, double t) {
  const Vec3<double> turn = path.rate * t * path.k_W;
  const Vec3<double>& u = path.u_W;
  return {.p_WB = path.p_W + t * (path.v_W + t / 2 * path.a_W),
          .q_WB = formula::rotation_exp(turn) * Quat<double>(1 + u.z(), -u.y(), u.x(), 0).normalized()};
}

/// Conservative advancement: no farther than the stone could come down, until it is as near as `near_enough`. `gap_at`
/// answers with the gap of a pose, or with less; NaN is no answer.
template <class GapAt>
[[nodiscard]] double advanced_to_contact(const FlightPath<double>& path, double reach, GapAt&& gap_at) {
  constexpr double near_enough = 1e-6;  // [m]
  constexpr int most_steps = 1000;
  const double g = -path.a_W.z();
  double t = 0;
  for (int i = 0; i < most_steps; ++i) {
    const double gap = gap_at(pose_at(path, t));
    if (!(near_enough < gap)) {
      return gap == gap ? t : gap;
    }
    t += earliest_contact(gap, path.v_W.z() - g * t, reach * path.rate, g);
  }
  return scalar::unset<double>();
}

/// `make_duel(scene, setting)` has `gap(pose)`, to the board, and `gap(pose, other)`, to another stone; NaN is no answer.
template <class MakeDuel>
[[nodiscard]] Contestant<Scene> make_rival(std::string name, std::string label, Kind kind, std::vector<double> settings,
                                           MakeDuel make_duel) {
  const auto enter = [make_duel](const Scene& scene, double setting) {
    const auto duel = std::make_shared<decltype(make_duel(scene, setting))>(make_duel(scene, setting));
    return make_query(scene, [&scene, duel](std::size_t i) {
      if (scene.query == Query::impact) {
        return advanced_to_contact(scene.paths[i], scene.shape.width / 2,
                                   [&](const Pose<double>& pose) { return duel->gap(pose); });
      }
      return scene.is_pair() ? duel->gap(scene.poses[i], scene.others[i]) : duel->gap(scene.poses[i]);
    });
  };
  return {{std::move(name), std::move(label), "rival", kind, std::move(settings)}, enter, {}};
}

}  // namespace goishi::verify::bench::contact
