#pragma once
/// \file
/// Stones that touch each other and a plane, by Moreau and Jean's time stepping with θ = 1/2: places of the middle of a
/// step, velocities of its ends, no impact law, dry friction and resistance to rolling and turning. Shares no formula and no
/// scheme with src/: gaps by Newton's method on the normal over the hulls' supports, all contacts by projections.

#include <optional>
#include <vector>

#include "verify/oracles/stone/hull.hpp"

namespace goishi::verify {

using Vector = std::array<double, 3>;

/// A stone, where its axis points, and its momenta. SI units.
struct HeavyBody {
  Hull<double> hull;
  double mass, axial, transverse;
  Vector p, u, v, L;
};

/// What all contacts have in common.
struct MoreauLaws {
  Vector gravity = {0.0, 0.0, -9.80665};
  double board_friction = 0.3, friction = 0.3;
  double rolling = 0.0, pivot = 0.0;  // [m] of resistance, everywhere
  double apart = 0.0;                 // [m] two stones touch at this distance, a stone and the plane z = 0 at none
};

/// How far two stones are apart, and along which normal, out of the second; `guess` is one near it. By supports alone.
struct HullGap {
  double gap;
  Vector n, first, second;  // unit; the points that are met along it
};
[[nodiscard]] HullGap gap_between(const HeavyBody& one, const HeavyBody& two, const Vector& guess);

class Moreau {
 public:
  Moreau(std::vector<HeavyBody> bodies, const MoreauLaws& laws);

  /// `steps` steps up to a time from now.
  void advance(double duration, int steps);

  [[nodiscard]] const std::vector<HeavyBody>& bodies() const { return bodies_; }
  /// How much a sweep of projections changed in the end, at most, of g h   (a step that is not solved has more than 1e-7).
  [[nodiscard]] double unsolved() const { return unsolved_; }

 private:
  struct Pair {
    std::size_t one, two;
    Vector n;
  };
  struct Contact {
    std::size_t one = 0;
    std::optional<std::size_t> two = {};
    std::size_t memory = 0;
    Vector n = {}, s = {}, t = {};                // unit
    Vector arm = {}, other_arm = {};              // from the centres
    double mu = 0.0, scale = 0.0, turning = 0.0;  // friction; of projections, 1/(effective masses)
    std::array<double, 3> P = {};                 // along n, s, t
    std::array<double, 3> y = {};                 // the torque along n, s, t, over κ, δ, δ
  };

  void step(double h);
  void find_contacts();
  void add(std::size_t one, std::optional<std::size_t> two, std::size_t memory, const Vector& n, const Vector& p);
  void solve(double h);
  [[nodiscard]] double sweep(Contact& contact);
  void push(const Contact& contact, const std::array<double, 3>& P, const std::array<double, 3>& torque);

  std::vector<HeavyBody> bodies_;
  MoreauLaws laws_;
  std::vector<Pair> pairs_;
  std::vector<Contact> contacts_;
  std::vector<std::array<std::array<double, 3>, 2>> memories_;  // of a contact in its last step: P, y
  std::vector<Vector> w_;
  double unsolved_ = 0.0;
};

}  // namespace goishi::verify
