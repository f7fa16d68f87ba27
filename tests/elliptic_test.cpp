/// The flight of a body without a symmetry axis: exactly along an axis of the body, and beside it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <goishi/motion/elliptic_flight.hpp>

#include "tests/expectations.hpp"
#include "tests/motion_test.hpp"

namespace goishi::motion_test {

namespace {

template <class T>
State<T> flown(const Vec3<T>& moments, const Quat<T>& q_WB, const Vec3<T>& L_B, const T& t) {
  const Vec3<T> none = vec_zero<T>();
  return elliptic_flight(turning<T>(q_WB, q_WB * L_B), make_rigid_body(T(1), moments), none, t);
}

/// Turned about an axis of the body.
template <class T>
Quat<T> turned(const Quat<T>& q_WB, int axis, long double angle) {
  Quat<T> turn(static_cast<T>(std::cos(angle / 2)), T(0), T(0), T(0));
  turn.vec()[axis] = static_cast<T>(std::sin(angle / 2));
  return q_WB * turn;
}

template <class T>
class EllipticFlight : public testing::Test {};
using EllipticScalars = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(EllipticFlight, EllipticScalars);

/// Six orders, three axes, both senses, any time, at attitudes whose products are exact.
TYPED_TEST(EllipticFlight, TurnsOnAboutAnAxis) {
  using T = TypeParam;
  std::array<T, 3> order = {T(1), T(2), T(3)};
  do {
    const Vec3<T> moments(order[0], order[1], order[2]);
    for (const Quat<T>& q :
         {Quat<T>(T(1), T(0), T(0), T(0)), Quat<T>(T(0), T(0), T(1), T(0)), Quat<T>(T(0.5), T(0.5), T(0.5), T(0.5))}) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const T sense : {T(1), T(-1)}) {
          for (const T t : {T(0), T(1), T(-1), T(0.001), T(60), T(-1000)}) {
            Vec3<T> L_B = vec_zero<T>();
            L_B[axis] = sense;
            const long double angle = static_cast<long double>(sense * t) / static_cast<long double>(moments[axis]);
            const Quat<T> q_end = flown<T>(moments, q, L_B, t).q_WB;
            EXPECT_LE(angle_between(q_end, turned<T>(q, axis, angle)),
                      T(4) * std::numeric_limits<T>::epsilon() * (T(1) + std::fabs(t)))
                << "I = " << moments.transpose() << ", axis " << axis << ", L = " << sense << ", t = " << t;
          }
        }
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(EllipticFlightOfDouble, AboutTheMiddleAxisByHand) {
  const State<double> end = flown<double>({1.0, 2.0, 3.0}, Quat<double>(1.0, 0.0, 0.0, 0.0), {0.0, 1.0, 0.0}, 1.0);
  EXPECT_NEAR(end.q_WB.w(), 0.96891242171064478, 1e-15);  // cos ¼
  EXPECT_NEAR(end.q_WB.y(), 0.24740395925452293, 1e-15);  // sin ¼
  EXPECT_EQ(end.q_WB.x(), 0.0);
  EXPECT_EQ(end.q_WB.z(), 0.0);
}

/// As far beside the middle axis as numbers go: it stays there for as long as what it is off by has grown to nothing,
/// off exp(λ|t|), λ = 1/√12.
TEST(EllipticFlightOfDouble, BesideTheMiddleAxis) {
  std::array<double, 3> order = {1.0, 2.0, 3.0};
  do {
    const Vec3<double> moments(order[0], order[1], order[2]);
    for (const double off : {1e-300, 1e-200, 1e-100, 1e-40, 1e-20, 1e-16, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
      for (int which = 0; which < 3; ++which) {
        for (const double t : {0.5, 1.0, -3.0, 5.0, -20.0}) {
          Vec3<double> L_B = vec_zero<double>();
          const int axis = static_cast<int>(std::find(order.begin(), order.end(), 2.0) - order.begin());
          L_B[axis] = 1.0;
          L_B[(axis + 1) % 3] = which == 1 ? 0.0 : off;
          L_B[(axis + 2) % 3] = which == 2 ? 0.0 : off;
          const Quat<double> one = Quat<double>::Identity();
          const double allowed = 4e-15 * (1.0 + std::fabs(t)) + 10.0 * off * std::exp(std::fabs(t) / std::sqrt(12.0));
          EXPECT_LE(angle_between(flown<double>(moments, one, L_B, t).q_WB,
                                  turned<double>(one, axis, static_cast<long double>(t) / 2)),
                    allowed)
              << "I = " << moments.transpose() << ", L = " << L_B.transpose() << ", t = " << t;
        }
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

/// Twice as far in time is there and on: a body that flips about its middle axis meets itself.
TEST(EllipticFlightOfDouble, JoinsAcrossFlips) {
  for (const double off : {1e-12, 1e-6, 1e-2}) {
    const Vec3<double> moments(2.0, 3.0, 4.0), L_B(off, 1.0, off);
    const State<double> there = flown<double>(moments, Quat<double>::Identity(), L_B, 150.0);
    const State<double> on = elliptic_flight(there, make_rigid_body(1.0, moments), weightless, -150.0);
    // The middle of the way knows the momentum in the body to ε, which grows as it did on the way.
    EXPECT_LE(angle_between(on.q_WB, Quat<double>::Identity()), 1e-13 / off) << off;
  }
}

TYPED_TEST(EllipticFlight, RestsAndIsRound) {
  using T = TypeParam;
  const Quat<T> q(T(0.5), T(-0.5), T(0.5), T(0.5));
  const State<T> rest = flown<T>({T(1), T(2), T(3)}, q, vec_zero<T>(), T(7));
  EXPECT_LE(angle_between(rest.q_WB, q), std::numeric_limits<T>::epsilon());
  const State<T> round = flown<T>({T(2), T(2), T(2)}, q, {T(0), T(0), T(3)}, T(1));
  EXPECT_LE(angle_between(round.q_WB, turned<T>(q, 2, 1.5L)), T(8) * std::numeric_limits<T>::epsilon());
}

}  // namespace
}  // namespace goishi::motion_test
