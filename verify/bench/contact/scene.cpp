#include "verify/bench/contact/scene.hpp"

#include <cmath>
#include <stdexcept>

#include "verify/oracles/contact/brute_contact.hpp"
#include "verify/samples/flight_path.hpp"

namespace goishi::verify::bench::contact {

namespace {

using Real = Digits50;
using Real3 = Vec3<Real>;

constexpr double agreement = 1e-20;     // [m] of lower and upper bound
constexpr double longest_fall = 1;      // [s]
constexpr double greatest_spin = 100;   // [rad/s]
constexpr double greatest_drop = 0.05;  // [m]
constexpr double depth_of_cores = 0.4;  // greatest overlap beyond the bevels, in heights
constexpr double near_contact = 0.05;   // greatest gap, in heights
constexpr int search_density = 32;

class Random {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Quat<double> attitude() { return draw_attitude(generator_); }
  Vec3<double> unit() { return attitude() * Vec3<double>::UnitZ(); }

 private:
  std::mt19937_64 generator_{1};
};

Real3 wide(const Vec3<double>& v) {
  return v.cast<Real>();
}

/// The axis as the pose says, its quaternion made unit in 50 digits.
Real3 axis_of(const Quat<double>& attitude) {
  const Quat<Real> q = attitude.cast<Real>().normalized();
  return q * Real3::UnitZ();
}

/// The stone's point that is farthest in the unit direction n, and its core's, both from the stone's centre.
struct Farthest {
  Real3 point;
  Real3 core;
};

Farthest farthest_point(const Hull<Real>& hull, const Quat<double>& attitude, const Real3& n) {
  const Real3 u = axis_of(attitude);
  const Real axial = u.dot(n);
  const Real3 across = n - axial * u;
  const Real radial = across.norm();
  const auto [rho, z] = farthest(hull, radial, axial);
  // The core lies in the stone with a ball of the tube's radius about each of its points.
  const Real core_rho = rho - hull.tube_radius * radial, core_z = z - hull.tube_radius * axial;
  if (outside(hull, core_rho, core_z) > -hull.tube_radius + agreement) {
    throw std::runtime_error("the ball about a point of the core leaves the stone");
  }
  const Real3 point = z * u + rho / radial * across;
  return {point, point - hull.tube_radius * n};
}

struct Touching {
  Pose<double> pose;
  Real lower, upper;  // bounds of the separation
};

/// A stone that touches `other` with the normal n, then moved out by `gap`.
Touching touching(const Hull<Real>& hull, const Quat<double>& attitude, const Farthest& other, const Real3& n,
                  const Real& other_bevel, double gap) {
  const Farthest below = farthest_point(hull, attitude, Real3(-n));
  const Real3 centre = other.point + Real(gap) * n - below.point;
  Touching result;
  result.pose = {.p_WB = centre.cast<double>(), .q_WB = attitude};
  const Real3 placed = wide(result.pose.p_WB);  // rounded
  result.lower = n.dot(Real3(placed + below.point - other.point));
  result.upper = (placed + below.core - other.core).norm() - hull.tube_radius - other_bevel;
  return result;
}

/// A random normal of the board's: at the edge x, or at the corner.
Real3 draw_board_normal(Random& random, bool at_corner) {
  Vec3<double> n = random.unit().cwiseAbs();
  if (!at_corner) {
    n.y() = 0;
  }
  return wide(n).normalized();
}

void add_at_board(Random& random, Scene& scene) {
  const bool plane = scene.query == Query::plane, corner = scene.query == Query::corner;
  const double X = scene.board.half_width, Y = scene.board.half_length;
  const double bevel = static_cast<double>(scene.hull.tube_radius);
  const double near = near_contact * scene.shape.height;
  const Real3 n = plane ? Real3(Real3::UnitZ()) : draw_board_normal(random, corner);
  const double inside = 0.9;
  const Vec3<double> x(plane ? inside * X * random.uniform(-1, 1) : X, corner ? Y : inside * Y * random.uniform(-1, 1),
                       0);
  const double gap = random.uniform(-std::fmin(near, bevel), near);
  const Touching at = touching(scene.hull, random.attitude(), {wide(x), wide(x)}, n, Real(0), gap);
  // Along a plane's only normal there is nothing to maximise.
  if (!plane && !(at.upper - at.lower <= agreement)) {
    throw std::runtime_error("the bounds of a separation do not meet");
  }
  scene.poses.push_back(at.pose);
  scene.right.push_back(static_cast<double>(at.lower));
}

double draw_pair_gap(Random& random, const Scene& scene) {
  const double height = scene.shape.height;
  const double bevels = 2 * static_cast<double>(scene.hull.tube_radius);
  switch (scene.query) {
    case Query::apart:
      return random.uniform(0, near_contact * height);
    case Query::bevels:
      return random.uniform(-bevels, 0);
    default:
      return -bevels - random.uniform(0, depth_of_cores * height);
  }
}

void add_pair(Random& random, Scene& scene) {
  const Hull<Real>& hull = scene.hull;
  const Pose<double> other{.p_WB = 0.01 * random.unit(), .q_WB = random.attitude()};
  const Real3 n = wide(random.unit()).normalized();
  Farthest on_other = farthest_point(hull, other.q_WB, n);
  on_other.point += wide(other.p_WB);
  on_other.core += wide(other.p_WB);
  const Touching at = touching(hull, random.attitude(), on_other, n, hull.tube_radius, draw_pair_gap(random, scene));
  scene.poses.push_back(at.pose);
  scene.others.push_back(other);
  if (scene.query != Query::cores) {
    if (!(at.upper - at.lower <= agreement)) {
      throw std::runtime_error("the bounds of a separation do not meet");
    }
    scene.right.push_back(static_cast<double>(at.lower));
    return;
  }
  const Hull<long double> narrowed = narrow(hull);
  const Best best = search_pair(standing(narrowed, at.pose), standing(narrowed, other), search_density);
  scene.right.push_back(static_cast<double>(std::fmax(best.value, static_cast<long double>(at.lower))));
}

/// Falls or rises at first, turns about any direction; comes down on the board.
FlightPath<double> draw_path(Random& random, const Scene& scene) {
  FlightPath<double> path{.p_W = Vec3<double>::Zero(),
                          .v_W = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-1, 1)},
                          .a_W = {0, 0, -earth_gravity},
                          .u_W = random.unit(),
                          .k_W = random.unit(),
                          .rate = random.uniform(0, greatest_spin)};
  const long double lowest = nearest_along(standing(narrow(scene.hull), path, 0), {0, 0, 1});
  path.p_W.z() = random.uniform(0, greatest_drop) - static_cast<double>(lowest);
  return path;
}

void add_flight(Random& random, Scene& scene) {
  const FlightPath<double> path = draw_path(random, scene);
  const Hull<long double> hull = narrow(scene.hull);
  const auto gap_at = [&](long double t) { return nearest_along(standing(hull, path, t), {0, 0, 1}); };
  const long double g = earth_gravity, v = static_cast<long double>(path.v_W.z());
  const long double swing = static_cast<long double>(scene.shape.width) / 2 * path.rate;
  constexpr int most_steps = 1'000'000;
  constexpr long double touched = 1e-18L;
  long double t = 0, gap = gap_at(t);
  for (int i = 0; touched < gap; ++i) {
    if (i == most_steps || longest_fall < t) {
      throw std::runtime_error("a falling stone does not come down");
    }
    t += earliest_contact<long double>(gap, v - g * t, swing, g);
    gap = gap_at(t);
  }
  constexpr long double step = 1e-7L;  // [s] backwards, for the speed of approach
  scene.paths.push_back(path);
  scene.right.push_back(static_cast<double>(t));
  scene.rate.push_back(static_cast<double>((gap_at(t - step) - gap) / step));
}

std::string witness_of(Query query) {
  switch (query) {
    case Query::cores:
      return "search over all normals, long double";
    case Query::impact:
      return "steps no longer than the stone needs to come down, long double";
    case Query::plane:
      return "stone constructed by ruler and compass, 50 digits";
    default:
      return "constructed contact, 50 digits; a lower and an upper bound of the separation agree within 1e-20 m";
  }
}

}  // namespace

Scene with_poses(Scene scene, std::size_t poses) {
  const auto& [width, height, bevel] = scene.shape;
  scene.hull = construct_hull(width, height, bevel);
  scene.board = make_board<double>();
  scene.witness = witness_of(scene.query);
  Random random;
  for (std::size_t i = 0; i < poses; ++i) {
    if (scene.query == Query::impact) {
      add_flight(random, scene);
    } else if (scene.is_pair()) {
      add_pair(random, scene);
    } else {
      add_at_board(random, scene);
    }
  }
  scene.rate.resize(poses, 1);
  return scene;
}

}  // namespace goishi::verify::bench::contact
