/// Free flight: exact answers first, then what must hold for every flight.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <goishi/motion/batch.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <vector>

#include "tests/motion_test.hpp"

namespace goishi::motion_test {

namespace {

using Digits = boost::multiprecision::cpp_bin_float_50;

/// Attitudes without round-off.
const std::vector<Quat<double>> exact_attitudes = {
    {1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, -1.0, 0.0}, {0.5, 0.5, 0.5, 0.5}, {-0.5, 0.5, -0.5, 0.5}};

TEST(State, IsNanUntilSet) {
  const State<double> state;
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isnan(state.p_WB[i]) && std::isnan(state.v_WB[i]) && std::isnan(state.L_W[i]));
  }
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(std::isnan(state.q_WB.coeffs()[i]));
  }
  const RigidBody<double> body;
  EXPECT_TRUE(std::isnan(body.mass) && body.moments.array().isNaN().all());
  EXPECT_TRUE(std::isnan(Mobility<double>().transverse) && std::isnan(Mobility<double>().axial));
}

TEST(State, OfAStone) {
  const MassProperties<double> stone = mass_properties(make_stone(0.022, 0.0092), Density{2800.0});
  const RigidBody<double> body = make_rigid_body(stone);
  EXPECT_EQ(body.mass, stone.mass);
  EXPECT_EQ(body.moments, Vec3<double>(stone.moments.transverse, stone.moments.transverse, stone.moments.axial));
}

// --- elementary spins: the answer is known without the formula

template <class T>
class ElementarySpin : public testing::Test {
 protected:
  using Moments = goishi::Moments<T>;

  /// Flies for a time of 1 and expects this attitude.
  static void expect(const Quat<T>& from, const Moments& moments, const Vec3<T>& L_W, const Quat<T>& to) {
    const State<T> start = turning(from, L_W);
    const State<T> end = free_flight(start, moments, Vec3<T>(T(0), T(0), T(0)), T(1));
    EXPECT_LE(angle_between(end.q_WB, to), flight_bound(start, moments, T(1))) << end.q_WB.coeffs().transpose();
  }

  static Quat<T> unturned() { return Quat<T>(T(1), T(0), T(0), T(0)); }
  static Vec3<T> along(int axis, const T& length) {
    Vec3<T> vector(T(0), T(0), T(0));
    vector[axis] = length;
    return vector;
  }
  /// A turn about one of the axes, by its half angle.
  static Quat<T> about(int axis, const T& cosine, const T& sine) {
    Quat<T> q(cosine, T(0), T(0), T(0));
    q.coeffs()[axis] = sine;
    return q;
  }
  static constexpr int x = 0, z = 2;
  const T pi = scalar::pi<T>();
  const T root = scalar::sqrt(T(T(1) / T(2)));
  const Moments flat{.axial = T(2), .transverse = T(5) / T(4)};
  const Moments needle{.axial = T(1) / T(8), .transverse = T(3)};
  const Moments ball{.axial = T(2), .transverse = T(2)};
};

using MotionScalars = testing::Types<float, double, long double, Digits>;
TYPED_TEST_SUITE(ElementarySpin, MotionScalars);

TYPED_TEST(ElementarySpin, AboutTheSymmetryAxis) {
  using T = TypeParam;
  for (const auto& body : {this->flat, this->needle, this->ball}) {
    const T quarter = body.axial * this->pi / T(2);
    this->expect(this->unturned(), body, this->along(2, quarter), this->about(2, this->root, this->root));
    this->expect(this->unturned(), body, this->along(2, T(-quarter)), this->about(2, this->root, T(-this->root)));
    this->expect(this->unturned(), body, this->along(2, T(2 * quarter)), this->about(2, T(0), T(1)));
    this->expect(this->unturned(), body, this->along(2, T(40 * quarter)), this->unturned());
  }
}

TYPED_TEST(ElementarySpin, EndOverEnd) {
  using T = TypeParam;
  for (const auto& body : {this->flat, this->needle, this->ball}) {
    const T quarter = body.transverse * this->pi / T(2);
    for (const int axis : {0, 1}) {
      this->expect(this->unturned(), body, this->along(axis, quarter), this->about(axis, this->root, this->root));
      this->expect(this->unturned(), body, this->along(axis, T(3 * quarter)),
                   this->about(axis, this->root, T(-this->root)));
    }
  }
}

TYPED_TEST(ElementarySpin, OnItsEdge) {
  // A quarter turn about x puts the symmetry axis along −y; spinning about it is then a turn about y in W.
  using T = TypeParam;
  const Quat<T> edge = this->about(0, this->root, this->root);
  const T quarter = this->flat.axial * this->pi / T(2);
  this->expect(edge, this->flat, this->along(1, quarter), this->about(1, this->root, this->root) * edge);
  // Like a coin on a table top: L along z, across the symmetry axis.
  const T turn = this->flat.transverse * this->pi / T(2);
  this->expect(edge, this->flat, this->along(2, turn), this->about(2, this->root, this->root) * edge);
}

TYPED_TEST(ElementarySpin, ABallAboutADiagonal) {
  // A third of a turn about (1, 1, 1) takes x to y, y to z, z to x.
  using T = TypeParam;
  const T half = T(1) / T(2);
  const T each = this->ball.axial * T(2) * this->pi / T(3) / scalar::sqrt(T(3));
  const Quat<T> third(half, half, half, half);
  this->expect(this->unturned(), this->ball, {each, each, each}, third);
  this->expect(third, this->ball, {each, each, each}, Quat<T>(-half, half, half, half));
}

TYPED_TEST(ElementarySpin, TheAxisCirclesTheMomentum) {
  // After half a period of precession the symmetry axis is its mirror image in L, after a whole one it is back.
  using T = TypeParam;
  const Vec3<T> l(T(2) / T(3), T(-1) / T(3), T(2) / T(3));
  for (const auto& body : {this->flat, this->needle, this->ball}) {
    const Vec3<T> L_W = T(body.transverse * this->pi) * l;
    const State<T> start = turning(this->unturned(), L_W);
    const Vec3<T> none(T(0), T(0), T(0));
    const Vec3<T> u = formula::symmetry_axis(start.q_WB);
    const Vec3<T> mirrored = T(2) * u.dot(l) * l - u;
    const T bound = flight_bound(start, body, T(2));
    const auto axis_after = [&](const T& t) { return formula::symmetry_axis(free_flight(start, body, none, t).q_WB); };
    EXPECT_LE((axis_after(T(1)) - mirrored).norm(), bound);
    EXPECT_LE((axis_after(T(2)) - u).norm(), bound);
  }
}

// --- flights

TEST(FreeFlight, KeptIsTheSameAtEveryTime) {
  const State<double> start{
      .p_WB = {1.0, 2.0, 3.0}, .q_WB = {0.5, 0.5, 0.5, 0.5}, .v_WB = {1.0, 0.0, -2.0}, .L_W = {0.1, 0.2, 0.3}};
  const Vec3<double> down = gravity_W<double>();
  // As it is, next to nothing, and not turning.
  for (const double size : {1.0, 1e-200, 0.0}) {
    State<double> turning = start;
    turning.L_W *= size;
    const double unit = size > 0.0 ? size : 1.0;
    const auto mobility = make_mobility(Moments<double>{.axial = 0.2 * unit, .transverse = 0.3 * unit});
    const Flight<double> flight(turning, mobility, down);
    for (int i = -100; i < 100; ++i) {
      const double t = 0.37 * i;
      const State<double> kept = flight.at(t), asked = free_flight(turning, mobility, down, t);
      EXPECT_EQ(kept.p_WB, asked.p_WB);
      EXPECT_EQ(kept.v_WB, asked.v_WB);
      EXPECT_EQ(kept.L_W, asked.L_W);
      // The angles are rounded differently.
      EXPECT_LE((kept.q_WB.coeffs() - asked.q_WB.coeffs()).norm(), 1e-15 * (1.0 + 2.0 * std::abs(t))) << t;
    }
  }
}

TEST(FreeFlight, IsAParabola) {
  const State<double> start{
      .p_WB = {1.0, 2.0, 3.0}, .q_WB = {1.0, 0.0, 0.0, 0.0}, .v_WB = {4.0, 5.0, 6.0}, .L_W = weightless};
  const State<double> end = free_flight(start, stone_moments, Vec3<double>(0.0, 1.0, -10.0), 2.0);
  EXPECT_EQ(end.p_WB, Vec3<double>(9.0, 14.0, -5.0));
  EXPECT_EQ(end.v_WB, Vec3<double>(4.0, 7.0, -14.0));
  EXPECT_EQ(gravity_W<double>(), Vec3<double>(0.0, 0.0, -9.80665));
}

TEST(FreeFlight, OfNoTimeChangesNothing) {
  for (const Quat<double>& q : exact_attitudes) {
    State<double> start = moving();
    start.q_WB = q;
    EXPECT_TRUE(same(free_flight(start, stone_moments, gravity_W<double>(), 0.0), start));
  }
  // An attitude with round-off is brought nearer to unit length by it, and not turned.
  State<double> start = moving();
  start.q_WB.coeffs() *= 1.0 + 2e-15;
  const State<double> end = free_flight(start, stone_moments, gravity_W<double>(), 0.0);
  EXPECT_EQ(angle_between(start.q_WB, end.q_WB), 0.0);
  EXPECT_LE(std::fabs(end.q_WB.squaredNorm() - 1.0), 4 * std::numeric_limits<double>::epsilon());
  EXPECT_TRUE(end.p_WB == start.p_WB && end.v_WB == start.v_WB && end.L_W == start.L_W);
}

TEST(FreeFlight, WithoutMomentumDoesNotTurn) {
  for (const Quat<double>& q : exact_attitudes) {
    for (const double t : {-1.0, 1e-300, 1.0, 1e6}) {
      const State<double> start = turning(q, weightless);
      EXPECT_TRUE(same(free_flight(start, stone_moments, weightless, t), start)) << t;
    }
  }
}

TEST(FreeFlight, OfABallIsOneRotation) {
  // I_a = I_t: no spin about the symmetry axis beside the precession, not even by round-off.
  for (const double moment : {1e-7, 0.3, 7.0}) {
    const Mobility<double> mobility = make_mobility(Moments<double>{.axial = moment, .transverse = moment});
    EXPECT_EQ(mobility.axial, 0.0);
    EXPECT_EQ(mobility.transverse, 1.0 / moment);
  }
}

TEST(FreeFlight, KeepsItsInvariantsForAMillionSeconds) {
  const RigidBody<double> body = make_rigid_body(0.005, stone_moments);
  const State<double> start = moving();
  const double energy = formula::rotational_energy(start, body);
  // Each of its two parts, ½ L_t²/I_t and ½ L_z²/I_a, is positive, so an error of 8 ε of L in the body's axes is one of
  // 16 ε · |L|²/(2 I_t) in the energy.
  const double bound =
      16 * std::numeric_limits<double>::epsilon() * start.L_W.squaredNorm() / (2 * stone_moments.transverse);
  for (const double t : {1e-3, 1.0, 1e3, 1e6, -1e6}) {
    const State<double> end = free_flight(start, stone_moments, gravity_W<double>(), t);
    EXPECT_EQ(end.L_W, start.L_W);
    EXPECT_LE(std::fabs(formula::rotational_energy(end, body) - energy), bound) << t;
    EXPECT_NO_THROW(require_state(end));
  }
}

TEST(FreeFlight, OfOneFreedom) {
  const State<double> start = moving();
  const Vec3<double> g = gravity_W<double>();
  const State<double> both = free_flight(start, stone_moments, g, 0.5);
  const State<double> linear = free_flight(start, stone_moments, g, 0.5, Freedom::linear);
  const State<double> angular = free_flight(start, stone_moments, g, 0.5, Freedom::angular);
  EXPECT_TRUE(same(both, free_flight(start, stone_moments, g, 0.5, Freedom::both)));
  EXPECT_TRUE(linear.p_WB == both.p_WB && linear.v_WB == both.v_WB && linear.L_W == start.L_W);
  EXPECT_TRUE(linear.q_WB.coeffs() == start.q_WB.coeffs());
  EXPECT_TRUE(angular.p_WB == start.p_WB && angular.v_WB == start.v_WB && angular.L_W == start.L_W);
  EXPECT_TRUE(angular.q_WB.coeffs() == both.q_WB.coeffs());
  EXPECT_GT(angle_between(both.q_WB, start.q_WB), 0.1);
}

TEST(FreeFlight, GivesTheSameBitsTwice) {
  const Mobility<double> mobility = make_mobility(stone_moments);
  const State<double> once = free_flight(moving(), mobility, gravity_W<double>(), 0.7);
  EXPECT_TRUE(same(free_flight(moving(), mobility, gravity_W<double>(), 0.7), once));
  EXPECT_TRUE(same(free_flight(moving(), stone_moments, gravity_W<double>(), 0.7), once));
}

/// A whole number of thousandths from −`most` to `most`.
double some(int most) {
  return *rc::gen::inRange(-1000 * most, 1000 * most + 1) * 1e-3;
}

/// Any attitude, but the few grid points near 0.
Quat<double> some_attitude() {
  Quat<double> q(some(1), some(1), some(1), some(1));
  RC_PRE(q.norm() > 0.01);
  return q.normalized();
}

Moments<double> some_moments() {
  const double transverse = 1e-3 * *rc::gen::inRange(1, 1001);
  return {.axial = transverse * 1e-3 * *rc::gen::inRange(1, 2001), .transverse = transverse};
}

/// Of a body with these moments, at up to 10 rad/s about each axis.
State<double> some_state(const Moments<double>& moments) {
  const Quat<double> q = some_attitude();
  const RigidBody<double> body = make_rigid_body(1.0, moments);
  State<double> state = turning(q, formula::angular_momentum_W(q, body, Vec3<double>(some(10), some(10), some(10))));
  state.p_WB = {some(1), some(1), some(1)};
  state.v_WB = {some(10), some(10), some(10)};
  return state;
}

/// What two flights may differ by whose starts differ by round-off: an error ε |L| of L_z turns into a spin of
/// ε |L| (1/I_a − 1/I_t), much for a needle   [rad].
double difference_bound(const State<double>& start, const Moments<double>& moments, double t) {
  const Mobility<double> mobility = make_mobility(moments);
  const double turn = start.L_W.norm() * std::fabs(t) * (mobility.transverse + std::fabs(mobility.axial));
  return 8 * std::numeric_limits<double>::epsilon() * (1 + turn);
}

RC_GTEST_PROP(FreeFlight, BackwardsUndoes, ()) {
  const Moments<double> moments = some_moments();
  const State<double> start = some_state(moments);
  const double t = some(10);
  const State<double> back = free_flight(free_flight(start, moments, weightless, t), moments, weightless, -t);
  RC_ASSERT(angle_between(back.q_WB, start.q_WB) <= 2 * difference_bound(start, moments, t));
}

RC_GTEST_PROP(FreeFlight, TwoFlightsAreOneLonger, ()) {
  const Moments<double> moments = some_moments();
  const State<double> start = some_state(moments);
  const double first = some(10), second = some(10);
  const State<double> once = free_flight(start, moments, weightless, first + second);
  const State<double> twice = free_flight(free_flight(start, moments, weightless, first), moments, weightless, second);
  RC_ASSERT(angle_between(once.q_WB, twice.q_WB) <= difference_bound(start, moments, first + second) +
                                                        difference_bound(start, moments, first) +
                                                        difference_bound(start, moments, second));
}

RC_GTEST_PROP(FreeFlight, IsTheSameFromEverySide, ()) {
  // The world turned, then the flight: the flight, then the world turned.
  const Moments<double> moments = some_moments();
  const State<double> start = some_state(moments);
  const Quat<double> q_VW = some_attitude();
  const double t = some(10);
  State<double> turned = start;
  turned.q_WB = formula::reunited(formula::product(q_VW, start.q_WB));
  turned.L_W = q_VW * start.L_W;
  const Quat<double> expected = q_VW * free_flight(start, moments, weightless, t).q_WB;
  RC_ASSERT(angle_between(free_flight(turned, moments, weightless, t).q_WB, expected) <=
            2 * difference_bound(start, moments, t));
}

// --- invariants

TEST(Invariants, OfASimpleState) {
  const RigidBody<double> body = make_rigid_body(2.0, Vec3<double>(1.0, 2.0, 2.0));
  State<double> state = turning(Quat<double>(0.5, 0.5, 0.5, 0.5), Vec3<double>(2.0, 3.0, 4.0));  // L_B = (3, 4, 2)
  state.p_WB = {1.0, 0.0, 5.0};
  state.v_WB = {3.0, 0.0, 4.0};
  EXPECT_EQ(formula::in_body(state.q_WB, state.L_W), Vec3<double>(3.0, 4.0, 2.0));
  EXPECT_EQ(formula::angular_velocity_B(state, body), Vec3<double>(3.0, 2.0, 1.0));
  EXPECT_EQ(formula::angular_velocity_W(state, body), Vec3<double>(1.0, 3.0, 2.0));
  EXPECT_EQ(formula::rotational_energy(state, body), 9.5);
  EXPECT_EQ(formula::translational_energy(state, body), 25.0);
  EXPECT_EQ(formula::potential_energy(state, body, Vec3<double>(0.0, 0.0, -10.0)), 100.0);
  EXPECT_EQ(formula::energy(state, body, Vec3<double>(0.0, 0.0, -10.0)), 134.5);
  EXPECT_EQ(formula::linear_momentum(state, body), Vec3<double>(6.0, 0.0, 8.0));
  // (1, 0, 5) × (6, 0, 8) = (0, 22, 0).
  EXPECT_EQ(formula::angular_momentum_about(weightless, state, body), Vec3<double>(2.0, 25.0, 4.0));
  EXPECT_EQ(formula::angular_momentum_about(state.p_WB, state, body), state.L_W);
}

TEST(Invariants, SeenFromAMovingFrame) {
  // From a train that is at (1, 0, 0), turned by a third about the diagonal, and goes at (0, 2, 0).
  const Quat<double> third(0.5, 0.5, 0.5, 0.5);
  State<double> state = turning(third, Vec3<double>(2.0, 3.0, 4.0));
  state.p_WB = {3.0, 5.0, 7.0};
  state.v_WB = {1.0, 2.0, 3.0};
  const State<double> seen = formula::seen_from(Vec3<double>(1.0, 0.0, 0.0), third, Vec3<double>(0.0, 2.0, 0.0), state);
  EXPECT_EQ(seen.p_WB, Vec3<double>(5.0, 7.0, 2.0));
  EXPECT_EQ(seen.v_WB, Vec3<double>(0.0, 3.0, 1.0));
  EXPECT_EQ(seen.L_W, Vec3<double>(3.0, 4.0, 2.0));
  EXPECT_EQ(seen.q_WB.coeffs(), Quat<double>::Identity().coeffs());
}

}  // namespace
}  // namespace goishi::motion_test
