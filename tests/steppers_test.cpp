/// Time steppers: their table, steps whose result is known, and what happens when a step is too large.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <goishi/motion/steppers.hpp>
#include <set>
#include <string>

#include "tests/motion_test.hpp"

namespace goishi::motion_test {

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
const RigidBody<double> thrown_stone = make_rigid_body(0.005, stone_moments);

// --- the table

TEST(Schemes, TableIsConsistent) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    const SchemeInfo& one = schemes[i];
    EXPECT_EQ(static_cast<std::size_t>(one.scheme), i);
    EXPECT_EQ(&info(one.scheme), &one);
    EXPECT_EQ(scheme_named(one.name), one.scheme) << one.name;
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(one.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-0123456789"), std::string_view::npos) << one.name;
    EXPECT_FALSE(one.what.empty());
    EXPECT_LE(0, one.attitude_order);
    EXPECT_LE(1, one.position_order);
    EXPECT_EQ(one.attitude_order == exact_order, one.scheme == Scheme::exact);
  }
  static_assert(schemes.back().scheme == Scheme::exact);  // the last of the enumeration
  static_assert(scheme_named("splitting-4") == Scheme::splitting_4);
  for (const std::string_view none : {"", "Exact", "exact ", "splitting", "splitting-44"}) {
    EXPECT_FALSE(scheme_named(none).has_value()) << none;
  }
}

TEST(Schemes, StatusesHaveWords) {
  EXPECT_EQ(to_string(StepStatus::completed), "completed");
  EXPECT_EQ(to_string(StepStatus::diverged), "diverged");
  EXPECT_EQ(to_string(StepStatus::not_converged), "not converged");
}

TEST(Schemes, KeepWhatTheyWereMadeOf) {
  const Stepper<double> stepper(Scheme::splitting_2, thrown_stone);
  EXPECT_EQ(stepper.scheme(), Scheme::splitting_2);
  EXPECT_EQ(stepper.body().moments, thrown_stone.moments);
  EXPECT_EQ(stepper.gravity(), gravity_W<double>());
}

// --- steps whose result is known

/// The angle of a step of a body that spins about a principal axis, ω Δt = turn; NaN for the Runge-Kutta method, which
/// has a polynomial there.
double known_turn(Scheme scheme, double turn) {
  switch (scheme) {
    case Scheme::published:
    case Scheme::explicit_euler:
    case Scheme::implicit_midpoint:
      return 2 * std::atan(turn / 2);
    case Scheme::runge_kutta_4:
      return nan;
    default:
      return turn;
  }
}

TEST(Step, AboutAPrincipalAxisTurnsByTheKnownAngle) {
  for (const SchemeInfo& one : schemes) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double turn : {1e-3, 0.5, -2.0}) {
        if (one.scheme == Scheme::runge_kutta_4) {
          continue;
        }
        constexpr double dt = 0.125;
        Vec3<double> L_W = weightless;
        L_W[axis] = thrown_stone.moments[axis] * turn / dt;
        const auto [state, status, steps] = Stepper<double>(one.scheme, thrown_stone, weightless)
                                                .advance(turning(Quat<double>::Identity(), L_W), dt, 3);
        ASSERT_EQ(status, StepStatus::completed);
        ASSERT_EQ(steps, 3);
        const double half = 3 * known_turn(one.scheme, turn) / 2;
        Quat<double> expected(std::cos(half), 0.0, 0.0, 0.0);
        expected.coeffs()[axis] = std::sin(half);
        // Three steps, each with a few roundings of numbers up to 1 and of an angle up to |turn|.
        EXPECT_LE(angle_between(state.q_WB, expected), 3 * 8 * ulp * (1 + std::fabs(turn))) << one.name << turn;
        EXPECT_LE((state.L_W - L_W).norm(), 3 * 8 * ulp * L_W.norm()) << one.name;
      }
    }
  }
}

TEST(Step, WithoutMomentumDoesNotTurn) {
  for (const SchemeInfo& one : schemes) {
    const State<double> start = turning(Quat<double>(0.5, -0.5, 0.5, 0.5), weightless);
    const Stepped<double> end = Stepper<double>(one.scheme, thrown_stone, weightless).advance(start, 0.1, 10);
    EXPECT_EQ(end.status, StepStatus::completed);
    EXPECT_TRUE(same(end.state, start)) << one.name;
  }
}

TEST(Step, NoneIsTheStart) {
  for (const SchemeInfo& one : schemes) {
    const Stepped<double> end = Stepper<double>(one.scheme, thrown_stone).advance(moving(), 0.1, 0);
    EXPECT_EQ(end.status, StepStatus::completed);
    EXPECT_EQ(end.steps, 0);
    EXPECT_TRUE(same(end.state, moving())) << one.name;
  }
}

TEST(Step, OfTheCentreOfMass) {
  // Whole numbers and halves: no round-off. Semi-implicit Euler is off the parabola by g t Δt/2.
  State<double> start = turning(Quat<double>::Identity(), weightless);
  start.v_WB = {1.0, 0.0, 4.0};
  for (const SchemeInfo& one : schemes) {
    const Stepper<double> stepper(one.scheme, thrown_stone, Vec3<double>(0.0, 0.0, -8.0));
    const State<double> end = stepper.advance(start, 0.5, 4).state;
    const double below = one.position_order == exact_order ? 0.0 : 8.0 * 2.0 * 0.5 / 2.0;
    if (one.position_order == exact_order || one.scheme == Scheme::published || one.scheme == Scheme::explicit_euler) {
      EXPECT_EQ(end.p_WB, Vec3<double>(2.0, 0.0, -8.0 - below)) << one.name;
    }
    EXPECT_EQ(end.v_WB, Vec3<double>(1.0, 0.0, -12.0)) << one.name;
  }
}

TEST(Step, OfOneFreedom) {
  for (const SchemeInfo& one : schemes) {
    const auto after = [&](Freedom freedom) {
      return Stepper<double>(one.scheme, thrown_stone, gravity_W<double>(), freedom).advance(moving(), 0.01, 5).state;
    };
    const State<double> both = after(Freedom::both), linear = after(Freedom::linear), angular = after(Freedom::angular);
    EXPECT_TRUE(linear.p_WB == both.p_WB && linear.v_WB == both.v_WB) << one.name;
    EXPECT_TRUE(linear.q_WB.coeffs() == moving().q_WB.coeffs() && linear.L_W == moving().L_W) << one.name;
    EXPECT_TRUE(angular.p_WB == moving().p_WB && angular.v_WB == moving().v_WB) << one.name;
    EXPECT_TRUE(angular.q_WB.coeffs() == both.q_WB.coeffs() && angular.L_W == both.L_W) << one.name;
    EXPECT_GT(angle_between(both.q_WB, moving().q_WB), 0.1) << one.name;
  }
}

TEST(Step, ManyAreOneAfterTheOther) {
  for (const SchemeInfo& one : schemes) {
    const Stepper<double> stepper(one.scheme, thrown_stone);
    State<double> state = moving();
    for (int i = 0; i < 7; ++i) {
      state = stepper.step(state, 0.01).state;
    }
    const State<double> at_once = stepper.advance(moving(), 0.01, 7).state;
    if (one.scheme == Scheme::runge_kutta_4) {  // carries its own momentum in B, which it knows to order 4 only
      EXPECT_LT((at_once.q_WB.coeffs() - state.q_WB.coeffs()).norm(), 1e-4);
    } else {
      EXPECT_TRUE(same(at_once, state)) << one.name;
    }
  }
}

TEST(Step, ThePublishedLoopKeepsTheWrongThing) {
  // The angular velocity instead of the momentum: the talk's loop.
  const State<double> start = moving();
  const State<double> end =
      Stepper<double>(Scheme::published, thrown_stone, weightless).advance(start, 1e-3, 100).state;
  const Vec3<double> w = formula::angular_velocity_W(start, thrown_stone);
  EXPECT_LE((formula::angular_velocity_W(end, thrown_stone) - w).norm(), 100 * 16 * ulp * w.norm());
  EXPECT_GT((end.L_W - start.L_W).norm(), 0.1 * start.L_W.norm());
  for (const SchemeInfo& one : schemes) {
    if (one.scheme != Scheme::published) {
      EXPECT_EQ(Stepper<double>(one.scheme, thrown_stone).advance(start, 1e-3, 100).state.L_W, start.L_W) << one.name;
    }
  }
}

TEST(Step, TheExactSchemeIsTheExactFlight) {
  const Stepper<double> stepper(Scheme::exact, thrown_stone);
  EXPECT_TRUE(same(stepper.step(moving(), 0.7).state, free_flight(moving(), stone_moments, gravity_W<double>(), 0.7)));
}

template <class T>
class StepIn : public testing::Test {};
using StepperScalars = testing::Types<float, long double, boost::multiprecision::cpp_bin_float_50>;
TYPED_TEST_SUITE(StepIn, StepperScalars);

TYPED_TEST(StepIn, OtherScalars) {
  // A quarter turn about the symmetry axis, in a single step of those that are exact there.
  using T = TypeParam;
  const Moments<T> moments{.axial = T(2), .transverse = T(5) / T(4)};
  const State<T> start = turning(Quat<T>(T(1), T(0), T(0), T(0)), Vec3<T>(T(0), T(0), scalar::pi<T>()));
  const T root = scalar::sqrt(T(T(1) / T(2)));
  for (const SchemeInfo& one : schemes) {
    const Stepped<T> end = Stepper<T>(one.scheme, make_rigid_body(T(1), moments)).step(start, T(1));
    EXPECT_EQ(end.status, StepStatus::completed) << one.name;
    EXPECT_NO_THROW(require_state(end.state)) << one.name;
    if (known_turn(one.scheme, 1.0) == 1.0) {
      EXPECT_LE(angle_between(end.state.q_WB, Quat<T>(root, T(0), T(0), root)), flight_bound(start, moments, T(1)))
          << one.name;
    }
  }
}

// --- steps that are too large

/// What holds however stepping ended: a state that can be given back, and a count.
void expect_sound(const Stepped<double>& end, std::int64_t asked, const std::string& what) {
  EXPECT_NO_THROW(require_state(end.state)) << what;
  EXPECT_EQ(end.steps == asked, end.status == StepStatus::completed) << what;
  EXPECT_LE(0, end.steps) << what;
  EXPECT_LE(end.steps, asked) << what;
}

TEST(LargeStep, NeverGivesNanOrABrokenAttitude) {
  for (const SchemeInfo& one : schemes) {
    for (int order = -300; order <= 308; ++order) {
      const double dt = std::pow(10.0, order);
      const std::string what = std::string(one.name) + ", step 1e" + std::to_string(order);
      for (const Freedom freedom : {Freedom::linear, Freedom::angular, Freedom::both}) {
        const Stepper<double> stepper(one.scheme, thrown_stone, gravity_W<double>(), freedom);
        expect_sound(stepper.advance(moving(), dt, 3), 3, what);
      }
      ASSERT_FALSE(HasFailure());  // one is enough
    }
  }
}

TEST(LargeStep, OverflowsAreSeen) {
  for (const SchemeInfo& one : schemes) {
    const Stepped<double> end = Stepper<double>(one.scheme, thrown_stone).step(moving(), 1e308);
    EXPECT_NE(end.status, StepStatus::completed) << one.name;
    EXPECT_EQ(end.steps, 0) << one.name;
    EXPECT_TRUE(same(end.state, moving())) << one.name;
  }
}

TEST(LargeStep, TheRungeKuttaMethodDiverges) {
  const Stepper<double> stepper(Scheme::runge_kutta_4, thrown_stone, weightless);
  const double slow = stone_moments.transverse / moving().L_W.norm();  // [s] for a precession of 1 rad
  EXPECT_EQ(stepper.advance(moving(), 0.1 * slow, 100).status, StepStatus::completed);
  const Stepped<double> end = stepper.advance(moving(), 100.0 * slow, 10);
  EXPECT_EQ(end.status, StepStatus::diverged);
  expect_sound(end, 10, "100 rad");
}

TEST(LargeStep, KeepsTheLastGoodState) {
  // The centre of mass leaves the range of a double in the third step: 1.3e308 m, 1.6e308 m, overflow.
  State<double> start = turning(Quat<double>::Identity(), weightless);
  start.p_WB = {1e308, 0.0, 0.0};
  start.v_WB = {3.0, 0.0, 0.0};
  const Stepper<double> stepper(Scheme::exact, thrown_stone, weightless, Freedom::linear);
  const Stepped<double> end = stepper.advance(start, 1e307, 10);
  EXPECT_EQ(end.status, StepStatus::diverged);
  EXPECT_EQ(end.steps, 2);
  EXPECT_DOUBLE_EQ(end.state.p_WB.x(), 1.6e308);
}

RC_GTEST_PROP(LargeStep, AnyBodyAnyStep, ()) {
  const auto some = [](int most) { return *rc::gen::inRange(-1000 * most, 1000 * most + 1) * 1e-3; };
  // Moments that a body can have: sums of the other two axes' squares.
  const Vec3<double> squares(1.001 + some(1), 1.001 + some(1), 1.001 + some(1));
  const Vec3<double> moments = Vec3<double>::Constant(squares.sum()) - squares;
  const Scheme scheme = schemes[*rc::gen::inRange<std::size_t>(0, schemes.size() - 1)].scheme;  // not the exact one
  const Stepper<double> stepper(scheme, make_rigid_body(1.0, moments));
  State<double> start = moving();
  start.L_W = {some(100), some(100), some(100)};
  const double dt = std::pow(10.0, some(6));
  const Stepped<double> end = stepper.advance(start, dt, 20);
  RC_ASSERT((end.status == StepStatus::completed) == (end.steps == 20));
  RC_ASSERT(std::fabs(end.state.q_WB.squaredNorm() - 1.0) < unit_tolerance<double>());
  RC_ASSERT(end.state.p_WB.allFinite() && end.state.v_WB.allFinite() && end.state.L_W.allFinite());
  RC_TAG(std::string(to_string(end.status)));
}

}  // namespace
}  // namespace goishi::motion_test
