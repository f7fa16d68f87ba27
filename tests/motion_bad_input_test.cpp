/// Motion: errors of the caller.

#include <gtest/gtest.h>

#include <functional>
#include <goishi/motion/batch.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/steppers.hpp>
#include <string>
#include <vector>

#include "tests/expectations.hpp"
#include "tests/motion_test.hpp"

namespace goishi::motion_test {

namespace {

using test::expect_invalid;

const Vec3<double> gravity = gravity_W<double>();

/// All that take a state.
void expect_invalid_state(const std::string& argument, const State<double>& state) {
  expect_invalid(argument, [&] { require_state(state); });
  for (const Freedom freedom : {Freedom::linear, Freedom::angular, Freedom::both}) {
    expect_invalid(argument, [&] { (void)free_flight(state, stone_moments, gravity, 1.0, freedom); });
    expect_invalid(argument, [&] { (void)free_flight(state, make_mobility(stone_moments), gravity, 1.0, freedom); });
  }
  expect_invalid(argument, [&] { (void)Flight<double>(state, make_mobility(stone_moments), gravity); });
  for (const SchemeInfo& one : schemes) {
    const Stepper<double> stepper(one.scheme, make_rigid_body(0.005, stone_moments));
    expect_invalid(argument, [&] { (void)stepper.advance(state, 1e-3, 0); });
    expect_invalid(argument, [&] { (void)stepper.step(state, 1e-3); });
  }
  StoneBatch<double> stones(3);
  expect_invalid(argument, [&] { stones.set(1, state, stone_moments); });
  EXPECT_NO_THROW(require_state(stones.get(1)));  // as it was
}

TEST(BadState, EachComponentOfEachVector) {
  using Member = Vec3<double> State<double>::*;
  const std::vector<std::pair<std::string, Member>> members = {{"position", &State<double>::p_WB},
                                                               {"velocity", &State<double>::v_WB},
                                                               {"angular momentum", &State<double>::L_W}};
  for (const auto& [argument, member] : members) {
    for (int i = 0; i < 3; ++i) {
      for (const double bad : {nan, infinity, -infinity}) {
        State<double> state = moving();
        (state.*member)[i] = bad;
        expect_invalid_state(argument, state);
      }
    }
    State<double> opposite = moving();
    opposite.*member = {infinity, -infinity, 0.0};
    expect_invalid_state(argument, opposite);
  }
  expect_invalid_state("position", State<double>());
}

TEST(BadState, EachComponentOfTheAttitude) {
  for (int i = 0; i < 4; ++i) {
    for (const double bad : {nan, infinity, -infinity}) {
      State<double> state = moving();
      state.q_WB.coeffs()[i] = bad;
      expect_invalid_state("attitude", state);
    }
  }
}

TEST(BadState, AttitudeThatIsNotUnit) {
  const auto with_attitude = [](const Quat<double>& q_WB) {
    State<double> state = moving();
    state.q_WB = q_WB;
    return state;
  };
  for (const Quat<double>& bad :
       {Quat<double>(0.0, 0.0, 0.0, 0.0), Quat<double>(1.0, 1.0, 0.0, 0.0), Quat<double>(0.5, 0.0, 0.0, 0.0),
        Quat<double>(1e200, 0.0, 0.0, 0.0), Quat<double>(0.70710678, 0.70710678, 0.0, 0.0)}) {
    expect_invalid_state("attitude", with_attitude(bad));
  }
  // |q|² may be off by 64 ε: from (1 + n ε)² = 1 + 2 n ε.
  const double epsilon = std::numeric_limits<double>::epsilon();
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_NO_THROW(require_state(with_attitude(Quat<double>(1.0 + sign * 31.0 * epsilon, 0.0, 0.0, 0.0))));
    expect_invalid_state("attitude", with_attitude(Quat<double>(1.0 + sign * 33.0 * epsilon, 0.0, 0.0, 0.0)));
  }
}

TEST(BadState, VectorsWhoseSumOverflowsAreGood) {
  State<double> state = moving();
  state.p_WB = {1e308, 1e308, 1e308};
  EXPECT_NO_THROW(require_state(state));
}

TEST(BadBody, Moments) {
  const auto expect = [](const std::string& argument, double axial, double transverse) {
    const Moments<double> moments{.axial = axial, .transverse = transverse};
    expect_invalid(argument, [&] { (void)make_mobility(moments); });
    expect_invalid(argument, [&] { (void)make_rigid_body(1.0, moments); });
    expect_invalid(argument, [&] { (void)free_flight(moving(), moments, gravity, 1.0); });
    expect_invalid(argument, [&] { StoneBatch<double>(1).set(0, moving(), moments); });
  };
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity}) {
    expect("axial", bad, 1.0);
    expect("transverse", 1.0, bad);
  }
  expect("axial", 2.001, 1.0);  // the triangle inequality
  EXPECT_NO_THROW((void)make_mobility(Moments<double>{.axial = 2.0, .transverse = 1.0}));
}

TEST(BadBody, PrincipalMomentsAndMass) {
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {0.0, -1.0, nan, infinity, 2.001}) {
      Vec3<double> moments(1.0, 1.0, 1.0);
      moments[i] = bad;
      expect_invalid("moments", [&] { (void)make_rigid_body(1.0, moments); });
      expect_invalid("moments", [&] {
        (void)Stepper<double>(Scheme::runge_kutta_4, RigidBody<double>{.mass = 1.0, .moments = moments});
      });
    }
  }
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    expect_invalid("mass", [&] { (void)make_rigid_body(bad, stone_moments); });
    expect_invalid("mass", [&] { (void)make_rigid_body(bad, Vec3<double>(1.0, 1.0, 1.0)); });
  }
  expect_invalid("mass", [] { (void)Stepper<double>(Scheme::published, RigidBody<double>()); });
}

TEST(BadFlight, TimeAndGravity) {
  StoneBatch<double> stones(1);
  for (const double bad : {nan, infinity, -infinity}) {
    expect_invalid("time", [&] { (void)free_flight(moving(), stone_moments, gravity, bad); });
    expect_invalid("time", [&] { stones.fly(gravity, bad); });
    for (int i = 0; i < 3; ++i) {
      Vec3<double> pull = gravity;
      pull[i] = bad;
      expect_invalid("gravity", [&] { (void)free_flight(moving(), stone_moments, pull, 1.0); });
      expect_invalid("gravity", [&] { stones.fly(pull, 1.0); });
      expect_invalid("gravity",
                     [&] { (void)Stepper<double>(Scheme::splitting_2, make_rigid_body(1.0, stone_moments), pull); });
    }
  }
}

TEST(BadStep, StepAndCount) {
  for (const SchemeInfo& one : schemes) {
    const Stepper<double> stepper(one.scheme, make_rigid_body(0.005, stone_moments));
    for (const double bad : {0.0, -0.0, -1e-3, nan, infinity, -infinity}) {
      expect_invalid("step", [&] { (void)stepper.advance(moving(), bad, 1); });
      expect_invalid("step", [&] { (void)stepper.step(moving(), bad); });
    }
    expect_invalid("steps", [&] { (void)stepper.advance(moving(), 1e-3, -1); });
  }
}

TEST(BadStep, ASymmetricSchemeForAnAsymmetricBody) {
  const RigidBody<double> brick = make_rigid_body(1.0, Vec3<double>(1.0, 2.0, 2.5));
  for (const SchemeInfo& one : schemes) {
    if (one.needs_symmetry) {
      expect_invalid("moments", [&] { (void)Stepper<double>(one.scheme, brick); });
    } else {
      EXPECT_NO_THROW((void)Stepper<double>(one.scheme, brick)) << one.name;
    }
  }
  EXPECT_TRUE(info(Scheme::exact).needs_symmetry);
}

TEST(BadScheme, OutsideTheEnumeration) {
  const RigidBody<double> body = make_rigid_body(1, Vec3<double>(2.0, 3.0, 4.0));
  for (const int scheme : {-1, 9, 1000}) {
    expect_invalid("scheme", [&] { (void)Stepper<double>(static_cast<Scheme>(scheme), body); });
  }
}

TEST(BadBody, MomentsWithoutInverse) {
  expect_invalid("transverse", [] { (void)make_mobility(Moments<double>{.axial = 1e-310, .transverse = 1e-310}); });
  expect_invalid("axial", [] { (void)make_mobility(Moments<float>{.axial = 1e-40F, .transverse = 1.0F}); });
}

TEST(BadIndex, OfAStone) {
  for (const std::size_t count : {0U, 1U, 8U, 9U}) {
    StoneBatch<double> stones(count);
    for (const std::size_t bad : {count, count + 1, static_cast<std::size_t>(-1)}) {
      expect_invalid("index", [&] { stones.set(bad, moving(), stone_moments); });
      expect_invalid("index", [&] { (void)stones.get(bad); });
    }
  }
}

}  // namespace
}  // namespace goishi::motion_test
