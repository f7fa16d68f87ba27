/// What begins at a contact, judged by the laws themselves: momentum, friction's cone, the bounds of resistance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <goishi/drop/drop.hpp>
#include <limits>
#include <random>

#include "tests/expectations.hpp"

namespace goishi::detail {

namespace {

using test::infinity;

/// A stone that touches, moves or not, and has rest, slip, turning and jamming all within reach.
struct Contact {
  Stone<double> stone;
  ContactBody<double> body;
  Kinetics<double> now;
  double s_x = 0.0, s_y = 0.0, h = 0.0;
};

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  int of(int sides) { return std::uniform_int_distribution<int>(0, sides - 1)(random_); }
  Vec3<double> vector() {
    const double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0);
    return {x, y, uniform(-1.0, 1.0)};
  }

 private:
  std::mt19937_64 random_;
};

/// Turning and slip are `further` decades smaller and greater than usual, at most.
Contact draw(Dice& dice, double friction, FrictionModel model, double further = 0.0) {
  const double w = 0.022, h = w * (dice.of(2) == 0 ? dice.decades(-3.0, -0.5) : dice.uniform(0.2, 1.0));
  Contact contact;
  contact.stone = make_stone(w, h, h * dice.uniform(0.05, 0.9));
  DropSettings<double> settings;
  settings.friction = friction;
  settings.friction_model = model;
  settings.damping = dice.of(2) == 0 ? 0.0 : dice.decades(0.0, 6.0);
  settings.rolling_resistance = w * dice.decades(-4.0, -0.31);
  settings.pivot_radius = w * dice.decades(-4.0, -0.31);
  settings.gravity = Vec3<double>(dice.uniform(-2.0, 2.0), dice.uniform(-2.0, 2.0), -9.81);
  settings = filled(settings, contact.stone);
  const MassProperties<double> mass = mass_properties(contact.stone, Density{2800.0});
  const Moments<double> per_mass{.axial = mass.moments.axial / mass.mass,
                                 .transverse = mass.moments.transverse / mass.mass};
  contact.body = contact_body(contact.stone, per_mass, settings, settings.gravity.norm());
  Variables<double> y = {};
  const Vec3<double> u = dice.vector().normalized();
  const double turning = dice.of(3) == 0 ? 0.0 : dice.decades(-12.0 - further, 1.0 + further) * contact.body.frequency;
  const Vec3<double> L = turning / contact.body.mobility.transverse * dice.vector();
  for (std::size_t i = 0; i < 3; ++i) {
    y[at::u + i] = u[static_cast<Eigen::Index>(i)];
    y[at::L + i] = L[static_cast<Eigen::Index>(i)];
  }
  const double axial = std::fabs(u.z()) * contact.stone.joint_cosine;
  const bool on_rim = axial < std::hypot(u.x(), u.y()) * contact.stone.joint_sine;
  contact.now = kinetics(contact.body,
                         on_rim        ? Feature::rim
                         : 0.0 < u.z() ? Feature::lower_cap
                                       : Feature::upper_cap,
                         y);
  if (dice.of(3) != 0) {
    const double slip = dice.decades(-12.0 - further, further), direction = dice.uniform(-3.2, 3.2);
    contact.s_x = slip * std::cos(direction);
    contact.s_y = slip * std::sin(direction);
  }
  contact.h = onset_time(contact.body, contact.now, contact.s_x, contact.s_y);
  return contact;
}

/// Kinetic energy per unit of mass, from the velocity of the contact point and L.
double energy(const Contact& contact, const Vec3<double>& point, const Vec3<double>& L) {
  const Vec3<double> w = formula::turning(contact.body.mobility, contact.now.u, L);
  return (L.dot(w) + (point - w.cross(contact.now.r)).squaredNorm()) / 2.0;
}

void expect_laws(const Contact& c, const Onset<double>& next) {
  const Vec3<double>& need = c.now.need;
  const double kept = 1.0 - c.h * c.body.damping;
  const Vec3<double> free(kept * c.s_x - c.h * need.x(), kept * c.s_y - c.h * need.y(), -c.h * need.z());
  const Vec3<double> L_free = kept * c.now.L;
  if (!next.closed) {
    EXPECT_LE(0.0, free.z());
    return;
  }
  // Momentum, the contact point staying on the plane.
  const Vec3<double> L = L_free + c.now.r.cross(next.impulse) + next.resistance;
  const Vec3<double> w_free = formula::turning(c.body.mobility, c.now.u, L_free);
  const Vec3<double> w = formula::turning(c.body.mobility, c.now.u, L);
  const Vec3<double> point = free + next.impulse + (w - w_free).cross(c.now.r);
  const double largest = free.norm() + (w.norm() + w_free.norm()) * c.now.r.norm() +
                         (c.body.mobility.transverse * c.now.r.squaredNorm() + 1.0) * next.impulse.norm() +
                         c.body.mobility.transverse * c.now.r.norm() * next.resistance.norm();
  const double round_off = 1e-11 * largest;
  EXPECT_NEAR(point.z(), 0.0, round_off);
  EXPECT_NEAR(point.x(), next.slip_x, round_off);
  EXPECT_NEAR(point.y(), next.slip_y, round_off);
  EXPECT_LE((L - next.L).norm(), 1e-12 * (c.now.L.norm() + c.stone.width * next.impulse.norm()));
  // Friction.
  const double slip = std::hypot(next.slip_x, next.slip_y), mu = c.body.friction;
  const double N = next.impulse.z(), T = std::hypot(next.impulse.x(), next.impulse.y());
  if (c.body.model != FrictionModel::dry) {
    EXPECT_LE(0.0, N);
    // As much friction for each slip as there is at the end.
    const double per_slip = smooth_friction(c.body, slip * slip, w.z());
    EXPECT_NEAR(next.impulse.x(), -per_slip * N * next.slip_x, 1e-8 * per_slip * N * slip);
    EXPECT_NEAR(next.impulse.y(), -per_slip * N * next.slip_y, 1e-8 * per_slip * N * slip);
  } else if (std::isfinite(mu)) {
    EXPECT_LE(0.0, N);
    EXPECT_LE(T, mu * N * (1.0 + 1e-12));
    EXPECT_EQ(next.slips, 0.0 < slip);
    if (next.slips) {
      EXPECT_NEAR(next.impulse.x() * next.slip_x + next.impulse.y() * next.slip_y, -mu * N * slip,
                  1e-10 * mu * N * slip);
    }
  } else {
    EXPECT_EQ(slip, 0.0);
  }
  // Resistance.
  const double delta = c.body.rolling_resistance, kappa = c.body.pivot_radius, size = std::fabs(N);
  const Vec3<double>& m = next.resistance;
  const double share = std::hypot(std::hypot(m.x(), m.y()) / delta, m.z() / kappa);
  EXPECT_LE(share, size * (1.0 + 1e-12));
  EXPECT_EQ(next.turns, 0.0 < next.L.norm());
  if (next.turns) {
    const double power = std::sqrt(delta * delta * (w.x() * w.x() + w.y() * w.y()) + kappa * kappa * w.z() * w.z());
    EXPECT_NEAR(m.dot(w), -size * power, 1e-9 * size * power);
  }
  // Of all motions with that N none has less energy; less than without any force it has at any rate.
  EXPECT_LE(energy(c, point, L), energy(c, free, L_free) * (1.0 + 1e-12));
}

TEST(DropOnset, ObeysTheSmoothLaws) {
  for (const FrictionModel model : {FrictionModel::slip_proportional, FrictionModel::coulomb_contensou}) {
    Dice dice(2);
    int turns = 0, jams = 0;
    const int samples = 4000;
    for (int i = 0; i < samples; ++i) {
      const Contact contact = draw(dice, dice.decades(-3.0, 2.0), model);
      const Onset<double> next = OnsetSolver<double>(contact.body, contact.now, contact.s_x, contact.s_y, contact.h)();
      SCOPED_TRACE(i);
      expect_laws(contact, next);
      if (testing::Test::HasFailure()) {
        return;
      }
      turns += next.closed && next.turns ? 1 : 0;
      jams += 1e3 * contact.h * contact.body.strength < next.impulse.norm() ? 1 : 0;
    }
    EXPECT_LT(samples / 10, turns);
    EXPECT_GT(samples * 19 / 20, turns);
    EXPECT_LT(0, jams);
  }
}

TEST(DropOnset, ObeysTheLaws) {
  Dice dice(1);
  int slips = 0, turns = 0, opens = 0, jams = 0;
  const int samples = 20000;
  for (int i = 0; i < samples; ++i) {
    const Contact contact = draw(dice, dice.of(10) == 0 ? infinity : dice.decades(-3.0, 2.0), FrictionModel::dry);
    const Onset<double> next = OnsetSolver<double>(contact.body, contact.now, contact.s_x, contact.s_y, contact.h)();
    SCOPED_TRACE(i);
    expect_laws(contact, next);
    if (testing::Test::HasFailure()) {
      return;
    }
    slips += next.closed && next.slips ? 1 : 0;
    turns += next.closed && next.turns ? 1 : 0;
    opens += next.closed ? 0 : 1;
    jams += 1e3 * contact.h * contact.body.strength < next.impulse.norm() ? 1 : 0;
  }
  // Everything that can happen did.
  EXPECT_LT(samples / 10, slips);
  EXPECT_GT(samples * 9 / 10, slips);
  EXPECT_LT(samples / 10, turns);
  EXPECT_GT(samples * 19 / 20, turns);
  EXPECT_LT(10, opens);
  EXPECT_LT(samples / 100, jams);
}

/// What begins is looked for on the motion's own scale, however great or small that is.
TEST(DropOnset, IsFoundInFewEvaluationsAtAnyScale) {
  Dice dice(3);
  int most = 0, closed = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto model = static_cast<FrictionModel>(dice.of(3));
    const double friction = dice.of(10) == 0 ? infinity : dice.decades(-60.0, 60.0);
    const Contact contact = draw(dice, friction, model, 60.0);
    OnsetSolver<double> solver(contact.body, contact.now, contact.s_x, contact.s_y, contact.h);
    const Onset<double> next = solver();
    SCOPED_TRACE(i);
    most = std::max(most, solver.evaluations());
    closed += next.closed ? 1 : 0;
    EXPECT_TRUE(next.closed || contact.now.need.z() <= 0.0);
    if (model == FrictionModel::dry) {
      expect_laws(contact, next);
    }
    if (testing::Test::HasFailure()) {
      return;
    }
  }
  EXPECT_LT(most, 4000);
  EXPECT_LT(1000, closed);
}

}  // namespace
}  // namespace goishi::detail
