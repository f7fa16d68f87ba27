/// When a flying stone first touches a plane, the board, another stone: flights whose answer is known.

#include <gtest/gtest.h>

#include <goishi/contact/time_of_impact.hpp>
#include <numbers>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

template <class T>
class Impact : public testing::Test {
 protected:
  /// Gravity 10, lying, not turning.
  static FlightPath<T> falling(const Vec3<T>& p, const Vec3<T>& v = vec<T>(0, 0, 0)) {
    return {.p_W = p, .v_W = v, .a_W = vec<T>(0, 0, -10), .u_W = vec<T>(0, 0, 1)};
  }
  static FlightPath<T> drifting(const Vec3<T>& p, const Vec3<T>& v) {
    return {.p_W = p, .v_W = v, .a_W = vec<T>(0, 0, 0), .u_W = vec<T>(0, 0, 1)};
  }

  /// The gap's error at the hit over the speed there; the gap's own is 8, 64 and 512 ε of the width at most.
  static void expect_hit(const TimeOfImpact<T>& found, const T& time, const T& gap_error, const T& speed) {
    EXPECT_EQ(found.status, ImpactStatus::hit) << to_string(found.status);
    expect_near(found.time, time, T(gap_error / speed));
    expect_near(found.contact.gap, T(0), T(T(2) * gap_error));
    EXPECT_LT(found.steps, 200);
  }
  static void expect_status(const TimeOfImpact<T>& found, ImpactStatus status, const T& time) {
    EXPECT_EQ(found.status, status) << to_string(found.status);
    EXPECT_EQ(found.time, time);
  }
  static constexpr T plane_error = T(16) * std::numeric_limits<T>::epsilon() * T(8);
  static constexpr T board_error = T(1024) * std::numeric_limits<T>::epsilon() * T(8);
  static constexpr T stone_error = T(8192) * std::numeric_limits<T>::epsilon() * T(8);
  static constexpr T infinite = std::numeric_limits<T>::infinity();
};
TYPED_TEST_SUITE(Impact, Scalars);

// --- a plane

TYPED_TEST(Impact, AFlatDrop) {
  using T = TypeParam;
  const Plane<T> ground;
  // From 5 over the ground at g = 10: after 1 s, at 10 m/s.
  const FlightPath<T> path = this->falling(vec<T>(1, 2, 7));
  const TimeOfImpact<T> found = time_of_impact(sharp<T>(), path, ground, T(2));
  this->expect_hit(found, T(1), this->plane_error, T(10));
  expect_near(found.contact.p_other, vec<T>(1, 2, 0), T(4) * this->plane_error);
  this->expect_hit(time_of_impact(sharp<T>(), path, ground, this->infinite), T(1), this->plane_error, T(10));
  this->expect_status(time_of_impact(sharp<T>(), path, ground, T(0.5)), ImpactStatus::none, T(0.5));
}

TYPED_TEST(Impact, OfAStateAsItIs) {
  using T = TypeParam;
  const Moments<T> moments{.axial = T(0.5), .transverse = T(0.3)};
  const Vec3<T> gravity = vec<T>(0, 0, -10);
  const State<T> start{.p_WB = vec<T>(1, 2, 12),
                       .q_WB = Quat<T>(T(0.8L), T(0.6L), T(0), T(0)),
                       .v_WB = vec<T>(1, 0, 0.5L),
                       .L_W = vec<T>(0.5L, 1, -1)};
  State<T> lower = start;
  lower.p_WB.z() = T(1.5L);
  lower.v_WB = vec<T>(1, 0, 30);
  const Mobility<T> mobility = make_mobility(moments);
  const FlightPath<T> path = path_of(start, mobility, gravity), lower_path = path_of(lower, mobility, gravity);
  const auto expect_same = [](const TimeOfImpact<T>& found, const TimeOfImpact<T>& expected) {
    EXPECT_EQ(expected.status, ImpactStatus::hit);
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.time, expected.time);
  };
  const Plane<T> ground;
  expect_same(time_of_impact(sharp<T>(), start, moments, gravity, ground, T(3)),
              time_of_impact(sharp<T>(), path, ground, T(3)));
  expect_same(time_of_impact(sharp<T>(), start, mobility, gravity, board<T>(), T(3)),
              time_of_impact(sharp<T>(), path, board<T>(), T(3)));
  expect_same(time_of_impact(sharp<T>(), start, moments, sharp<T>(), lower, moments, gravity, T(3)),
              time_of_impact(sharp<T>(), path, sharp<T>(), lower_path, T(3)));
}

TYPED_TEST(Impact, AtTheStart) {
  using T = TypeParam;
  const Plane<T> ground;
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(0, 0, 1.5L)), ground, T(1)),
                      ImpactStatus::overlapping, T(0));
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(0, 0, 2), vec<T>(0, 0, -1)), ground, T(1)),
                      ImpactStatus::hit, T(0));
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(0, 0, 2)), ground, T(1)), ImpactStatus::hit,
                      T(0));
  // It leaves, and comes back after 2 v/g.
  this->expect_hit(time_of_impact(sharp<T>(), this->falling(vec<T>(0, 0, 2), vec<T>(0, 0, 5)), ground, T(9)), T(1),
                   this->plane_error, T(5));
  // Or not.
  this->expect_status(
      time_of_impact(sharp<T>(), this->drifting(vec<T>(0, 0, 2), vec<T>(0, 0, 1)), ground, this->infinite),
      ImpactStatus::none, this->infinite);
}

TYPED_TEST(Impact, OfATurningStone) {
  using T = TypeParam;
  // Sinking by 1 m/s and turning about Wx, a quarter turn in 3 s: at t = 3 it stands, and its rim comes to 0.
  FlightPath<T> path = this->drifting(vec<T>(0, 0, 7), vec<T>(0, 0, -1));
  path.k_W = vec<T>(1, 0, 0);
  path.rate = std::numbers::pi_v<T> / T(6);
  const TimeOfImpact<T> found = time_of_impact(sharp<T>(), path, Plane<T>{}, T(9));
  this->expect_hit(found, T(3), this->plane_error, T(1));
  EXPECT_EQ(found.contact.feature, Feature::rim);
  // Turning about its own axis changes nothing.
  path.k_W = vec<T>(0, 0, 1);
  path.rate = T(100);
  this->expect_hit(time_of_impact(sharp<T>(), path, Plane<T>{}, T(9)), T(5), this->plane_error, T(1));
}

TYPED_TEST(Impact, GrazingOrNot) {
  using T = TypeParam;
  // Thrown up against a ceiling that it reaches at its highest, 5 higher after 1 s.
  const T little = scalar::sqrt(std::numeric_limits<T>::epsilon());
  const FlightPath<T> path = this->falling(vec<T>(0, 0, 0), vec<T>(0, 0, 10));
  const auto under = [&](const T& ceiling) {
    return time_of_impact(sharp<T>(), path, Plane<T>{.n_W = vec<T>(0, 0, -1), .offset = -ceiling}, T(9));
  };
  // 5 t² − 10 t + 5 = ∓ little.
  const TimeOfImpact<T> hit = under(T(7) - little);
  EXPECT_EQ(hit.status, ImpactStatus::hit);
  const T early = scalar::sqrt(T(little / T(5)));
  expect_near(hit.time, T(T(1) - early), T(this->plane_error / (T(10) * early)));
  this->expect_status(under(T(7) + little), ImpactStatus::none, T(9));
}

TYPED_TEST(Impact, GrazingExactly) {
  using T = TypeParam;
  // Gravity upwards: 5 down in 1 s, to where it touches, and up again.
  FlightPath<T> path = this->falling(vec<T>(1, 2, 7), vec<T>(0, 0, -10));
  path.a_W = vec<T>(0, 0, 10);
  const auto expect_grazes = [this](const TimeOfImpact<T>& found) {
    EXPECT_EQ(found.status, ImpactStatus::hit) << to_string(found.status);
    // The gap is 5 (t − 1)².
    expect_near(found.time, T(1), scalar::sqrt(T(16 * this->stone_error)));
  };
  expect_grazes(time_of_impact(sharp<T>(), path, Plane<T>{}, T(9)));
  expect_grazes(time_of_impact(sharp<T>(), path, board<T>(), T(9)));
  expect_grazes(time_of_impact(sharp<T>(), path, sharp<T>(), this->drifting(vec<T>(1, 2, -2), vec<T>(0, 0, 0)), T(9)));
}

// --- touching at the start: one rule for all

/// What `query` answers for a stone that was pushed out along n: hit at once unless it leaves.
template <class T, class Query>
void expect_hit_unless_it_leaves(FlightPath<T> path, const Vec3<T>& n, Query&& query) {
  const Vec3<T> along = n.unitOrthogonal();
  path.a_W = vec<T>(0, 0, 0);
  for (const Vec3<T>& v : {vec<T>(0, 0, 0), Vec3<T>(-n), Vec3<T>(3 * along), Vec3<T>(along - n)}) {
    path.v_W = v;
    const TimeOfImpact<T> found = query(path);
    EXPECT_EQ(found.status, ImpactStatus::hit) << to_string(found.status) << ", v = " << v.transpose();
    EXPECT_EQ(found.time, T(0)) << "v = " << v.transpose();
  }
  for (const Vec3<T>& v : {n, Vec3<T>(n / T(1000)), Vec3<T>(n + along)}) {
    path.v_W = v;
    const TimeOfImpact<T> found = query(path);
    EXPECT_EQ(found.status, ImpactStatus::none) << to_string(found.status) << ", v = " << v.transpose();
    EXPECT_EQ(found.time, T(1));
  }
  // At rest, and pressed on or pulled off: at rest is not leaving.
  path.v_W = vec<T>(0, 0, 0);
  for (const Vec3<T>& a : {Vec3<T>(-10 * n), Vec3<T>(10 * n)}) {
    path.a_W = a;
    const TimeOfImpact<T> found = query(path);
    EXPECT_EQ(found.status, ImpactStatus::hit) << to_string(found.status) << ", a = " << a.transpose();
    EXPECT_EQ(found.time, T(0)) << "a = " << a.transpose();
  }
}

/// A pose and an axis to start from, `i` of many.
template <class T>
Pose<T> leaning_pose(int i, const Vec3<T>& p) {
  return {.p_WB = p, .q_WB = Quat<T>(T(1), T(i % 7) / T(5), T(i % 11) / T(7) - T(1), T(i % 3) / T(2)).normalized()};
}

template <class T>
FlightPath<T> path_from(const Pose<T>& pose) {
  return {.p_W = pose.p_WB, .v_W = vec<T>(0, 0, 0), .a_W = vec<T>(0, 0, 0), .u_W = formula::symmetry_axis(pose.q_WB)};
}

TYPED_TEST(Impact, TouchingAnObliquePlaneFarAway) {
  using T = TypeParam;
  for (int i = 0; i < 200; ++i) {
    const Vec3<T> n = vec<T>(1 + i % 5, 2 - i % 4, 3 - i % 9).normalized();
    const Plane<T> plane{.n_W = n, .offset = T(i % 13)};
    for (const T& away : {T(0), T(45), T(450), T(45000)}) {  // 45 widths are 1 m
      Pose<T> pose = leaning_pose(i, Vec3<T>(away * vec<T>(1, -1, 1) / T(2)));
      for (int k = 0; k < 2; ++k) {  // again, nearer: the first gap is rounded as it is far
        pose.p_WB -= separation(sharp<T>(), pose, plane).gap * n;
      }
      expect_hit_unless_it_leaves(
          path_from(pose), n, [&](const FlightPath<T>& path) { return time_of_impact(sharp<T>(), path, plane, T(1)); });
    }
  }
}

TYPED_TEST(Impact, TouchingTheBoard) {
  using T = TypeParam;
  for (int i = 0; i < 200; ++i) {
    // On the surface, at an edge, at a corner, beside.
    const Vec3<T> places[] = {vec<T>(1, 2, 3), vec<T>(51, i % 50, 1), vec<T>(52, 61, 2), vec<T>(-53, i % 60, -20)};
    Pose<T> pose = leaning_pose(i, places[i % 4]);
    const Separation<T> at = separation(sharp<T>(), pose, board<T>());
    pose.p_WB -= at.gap * at.n_W;
    expect_hit_unless_it_leaves(path_from(pose), at.n_W, [&](const FlightPath<T>& path) {
      return time_of_impact(sharp<T>(), path, board<T>(), T(1));
    });
  }
}

TYPED_TEST(Impact, TouchingAnotherStone) {
  using T = TypeParam;
  for (int i = 0; i < 200; ++i) {
    const Pose<T> other = leaning_pose(i + 5, vec<T>(i % 3 * 40, 0, 0));
    Pose<T> pose = leaning_pose(i, Vec3<T>(other.p_WB + vec<T>(3, i % 5 - 2, 4)));
    const Separation<T> at = separation(bevelled<T>(), pose, bevelled<T>(), other);
    pose.p_WB -= at.gap * at.n_W;
    expect_hit_unless_it_leaves(path_from(pose), at.n_W, [&](const FlightPath<T>& path) {
      return time_of_impact(bevelled<T>(), path, bevelled<T>(), path_from(other), T(1));
    });
  }
}

// --- the board

TYPED_TEST(Impact, WithTheBoard) {
  using T = TypeParam;
  const auto expect = [this](const FlightPath<T>& path, const T& time, const Vec3<T>& n, const T& speed,
                             OtherFeature feature) {
    const TimeOfImpact<T> found = time_of_impact(sharp<T>(), path, board<T>(), T(9));
    this->expect_hit(found, time, this->board_error, speed);
    EXPECT_EQ(found.contact.other_feature, feature) << to_string(found.contact.other_feature);
    EXPECT_GT(static_cast<double>(found.contact.n_W.dot(n)), 1.0 - 1e-4);
  };
  expect(this->falling(vec<T>(1, 2, 7)), T(1), vec<T>(0, 0, 1), T(10), OtherFeature::surface);
  // 5 down to where the cap's sphere, about 3 over the centre, is 5 from the edge, or from the corner.
  expect(this->falling(vec<T>(53, 7, 6)), T(1), vec<T>(0.6L, 0, 0.8L), T(8), OtherFeature::top_edge);
  const T third = T(1) / T(3);
  expect(this->falling({T(50) + T(10) * third, T(60) + T(5) * third, T(16) * third}), T(1),
         {T(2) * third, third, T(2) * third}, T(6), OtherFeature::corner);
  // Sideways against the side, 6 away, while it falls.
  expect(this->falling(vec<T>(60, 7, -20), vec<T>(-2, 0, 0)), T(3), vec<T>(1, 0, 0), T(2), OtherFeature::side);
}

TYPED_TEST(Impact, BesideTheBoard) {
  using T = TypeParam;
  const Board<T> wood = board<T>();
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(54.5L, 7, 6)), wood, T(9)), ImpactStatus::none,
                      T(9));
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(1, 2, 7)), wood, T(0.5)), ImpactStatus::none,
                      T(0.5));
  this->expect_status(time_of_impact(sharp<T>(), this->falling(vec<T>(1, 2, 1)), wood, T(9)), ImpactStatus::overlapping,
                      T(0));
}

// --- another stone

TYPED_TEST(Impact, WithAnotherStone) {
  using T = TypeParam;
  const auto meet = [](const FlightPath<T>& one, const FlightPath<T>& other) {
    return time_of_impact(sharp<T>(), one, sharp<T>(), other, T(9));
  };
  // 3 apart, cap to cap, at 2 + 1; side by side, 6 apart, at 2. Both fall alike.
  this->expect_hit(
      meet(this->falling(vec<T>(0, 0, 7), vec<T>(0, 0, -2)), this->falling(vec<T>(0, 0, 0), vec<T>(0, 0, 1))), T(1),
      this->stone_error, T(3));
  const TimeOfImpact<T> beside =
      meet(this->falling(vec<T>(14, 0, 0), vec<T>(-2, 0, 0)), this->falling(vec<T>(0, 0, 0)));
  this->expect_hit(beside, T(3), this->stone_error, T(2));
  EXPECT_EQ(beside.contact.other_feature, OtherFeature::stone);
  // Past each other; apart; one in the other.
  this->expect_status(
      meet(this->drifting(vec<T>(14, 0, 4.5L), vec<T>(-2, 0, 0)), this->drifting(vec<T>(0, 0, 0), vec<T>(0, 0, 0))),
      ImpactStatus::none, T(9));
  this->expect_status(meet(this->falling(vec<T>(14, 0, 0), vec<T>(2, 0, 0)), this->falling(vec<T>(0, 0, 0))),
                      ImpactStatus::none, T(9));
  this->expect_status(meet(this->falling(vec<T>(1, 0, 1)), this->falling(vec<T>(0, 0, 0))), ImpactStatus::overlapping,
                      T(0));
}

// --- errors of the caller

/// Expects this path and this horizon to be refused by all three.
void expect_refused(const std::string& argument, const FlightPath<double>& path, double horizon) {
  const FlightPath<double> good{
      .p_W = {0.0, 0.0, 50.0}, .v_W = {0.0, 0.0, 0.0}, .a_W = {0.0, 0.0, -10.0}, .u_W = {0.0, 0.0, 1.0}};
  expect_invalid(argument, [&] { (void)time_of_impact(sharp(), path, Plane<double>{}, horizon); });
  expect_invalid(argument, [&] { (void)time_of_impact(sharp(), path, board(), horizon); });
  expect_invalid(argument, [&] { (void)time_of_impact(sharp(), path, sharp(), good, horizon); });
  expect_invalid(argument, [&] { (void)time_of_impact(sharp(), good, sharp(), path, horizon); });
}

TEST(ImpactBadInput, IsRefused) {
  const FlightPath<double> good{
      .p_W = {0.0, 0.0, 9.0}, .v_W = {1.0, 0.0, 0.0}, .a_W = {0.0, 0.0, -10.0}, .u_W = {0.0, 0.0, 1.0}};
  using Member = Vec3<double> FlightPath<double>::*;
  const std::pair<const char*, Member> vectors[] = {{"position", &FlightPath<double>::p_W},
                                                    {"velocity", &FlightPath<double>::v_W},
                                                    {"acceleration", &FlightPath<double>::a_W}};
  for (const auto& [argument, member] : vectors) {
    with_each_bad({1.0, 2.0, 3.0}, [&](const Vec3<double>& bad) {
      FlightPath<double> path = good;
      path.*member = bad;
      expect_refused(argument, path, 1.0);
    });
  }
  const std::pair<const char*, Member> directions[] = {{"axis", &FlightPath<double>::u_W},
                                                       {"precession axis", &FlightPath<double>::k_W}};
  for (const auto& [argument, member] : directions) {
    with_each_bad_direction([&](const Vec3<double>& bad) {
      FlightPath<double> path = good;
      path.*member = bad;
      expect_refused(argument, path, 1.0);
    });
  }
  for (const double rate : {nan, infinity}) {
    FlightPath<double> path = good;
    path.rate = rate;
    expect_refused("rate", path, 1.0);
  }
  for (const double horizon : {0.0, -1.0, nan, -infinity}) {
    expect_refused("horizon", good, horizon);
  }
  expect_refused("position", {}, 1.0);
  // What no factory has made.
  expect_invalid("stone", [&] { (void)time_of_impact(Stone<double>{}, good, Plane<double>{}, 1.0); });
  expect_invalid("stone", [&] { (void)time_of_impact(Stone<double>{}, good, board(), 1.0); });
  expect_invalid("stone", [&] { (void)time_of_impact(Stone<double>{}, good, sharp(), good, 1.0); });
  Board<double> flat = board();
  flat.half_width = 0.0;
  expect_invalid("board", [&] { (void)time_of_impact(sharp(), good, flat, 1.0); });
  with_each_bad_direction([&](const Vec3<double>& bad) {
    expect_invalid("normal", [&] { (void)time_of_impact(sharp(), good, Plane<double>{.n_W = bad}, 1.0); });
  });
  for (const double offset : {nan, infinity, -infinity}) {
    expect_invalid("offset", [&] { (void)time_of_impact(sharp(), good, Plane<double>{.offset = offset}, 1.0); });
  }
}

}  // namespace
}  // namespace goishi::contact_test
