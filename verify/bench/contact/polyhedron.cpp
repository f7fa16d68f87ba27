#include "verify/bench/contact/polyhedron.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace goishi::verify::bench::contact {

namespace {

using std::numbers::pi;

/// The point (ρ, z) of the outline at `part` of the way from pole to pole, the way measured in angles of the normal
/// times √(radius of curvature): a chord of the angle θ leaves a gap of about radius θ²/8.
std::array<double, 2> outline_point(const Hull<long double>& hull, double part) {
  const auto number = [](long double x) { return static_cast<double>(x); };
  const double sphere = number(hull.sphere_radius), tube = number(hull.tube_radius);
  const double joint = number(std::atan2(hull.joint_radius, hull.sphere_offset + hull.band));
  const double on_cap = std::sqrt(sphere) * joint, on_bevel = std::sqrt(tube) * (pi / 2 - joint);
  const bool lower = part > 0.5;
  const double way = 2 * (lower ? 1 - part : part) * (on_cap + on_bevel);
  const double side = lower ? -1 : 1;
  if (way < on_cap) {
    const double angle = way / std::sqrt(sphere);
    return {sphere * std::sin(angle), side * (sphere * std::cos(angle) - number(hull.sphere_offset))};
  }
  const double angle = joint + (way - on_cap) / std::sqrt(tube);
  return {number(hull.torus_radius) + tube * std::sin(angle), side * tube * std::cos(angle)};
}

}  // namespace

Polyhedron make_polyhedron(const Hull<Digits50>& hull, int rings) {
  const Hull<long double> narrowed = narrow(hull);
  const auto index = [&](int ring, int k) { return ring * rings + k % rings; };
  Polyhedron body;
  body.neighbours.resize(static_cast<std::size_t>(rings * rings));
  std::vector<int> top, bottom;
  for (int i = 0; i < rings; ++i) {
    const auto [rho, z] = outline_point(narrowed, (i + 0.5) / rings);
    for (int k = 0; k < rings; ++k) {
      const double turn = 2 * pi * k / rings;
      body.points.emplace_back(rho * std::cos(turn), rho * std::sin(turn), z);
      std::vector<int>& near = body.neighbours[static_cast<std::size_t>(index(i, k))];
      near = {index(i, k + 1), index(i, k + rings - 1)};
      if (i > 0) {
        near.push_back(index(i - 1, k));
      }
      if (i + 1 < rings) {
        near.push_back(index(i + 1, k));
        body.faces.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1)});
      }
    }
  }
  for (int k = 0; k < rings; ++k) {
    top.push_back(index(0, k));
    bottom.push_back(index(rings - 1, rings - 1 - k));
  }
  body.faces.push_back(top);
  body.faces.push_back(bottom);
  return body;
}

int farthest_point(const Polyhedron& body, const Vec3<double>& direction, int start) {
  const auto along = [&](int i) { return body.points[static_cast<std::size_t>(i)].dot(direction); };
  int at = start;
  double best = along(at);
  for (bool climbs = true; climbs;) {
    climbs = false;
    for (const int next : body.neighbours[static_cast<std::size_t>(at)]) {
      const double value = along(next);
      if (best < value) {
        best = value;
        at = next;
        climbs = true;
      }
    }
  }
  return at;
}

}  // namespace goishi::verify::bench::contact
