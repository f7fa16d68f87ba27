/// Separation of a stone from a plane, the board and another stone, by hand.

#include <gtest/gtest.h>

#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <numbers>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

/// What a separation must be.
template <class T>
struct Expected {
  T gap;
  Vec3<T> n_W;
  Vec3<T> p_stone;
  Feature feature;
  OtherFeature other;
};

template <class T>
class Contact : public testing::Test {
 protected:
  // Documented in double as 1e-15, 1e-13 and 1e-12 of the width; as multiples of ε.
  static constexpr T plane_error = T(4.5) * std::numeric_limits<T>::epsilon() * T(8);
  static constexpr T board_error = T(450) * std::numeric_limits<T>::epsilon() * T(8);
  static constexpr T stone_error = T(4500) * std::numeric_limits<T>::epsilon() * T(8);

  static void expect(const Separation<T>& found, const Expected<T>& expected, const T& gap_error,
                     const T& point_error) {
    expect_near(found.gap, expected.gap, gap_error);
    expect_near(found.n_W, expected.n_W, point_error);
    expect_near(found.p_stone, expected.p_stone, point_error);
    expect_near(found.p_other, Vec3<T>(expected.p_stone - expected.gap * expected.n_W), point_error);
    EXPECT_EQ(found.feature, expected.feature) << to_string(found.feature);
    EXPECT_EQ(found.other_feature, expected.other) << to_string(found.other_feature);
    EXPECT_EQ(found.status, found.gap < T(0) ? SeparationStatus::overlapping : SeparationStatus::separated);
  }
};
TYPED_TEST_SUITE(Contact, Scalars);

// --- a plane

TYPED_TEST(Contact, OverThePlane) {
  using T = TypeParam;
  const Stone<T> stone = sharp<T>();
  const Plane<T> ground;
  const auto expect = [&](const Pose<T>& pose, const Expected<T>& expected) {
    // Twice the width away at most.
    this->expect(separation(stone, pose, ground), expected, T(2) * this->plane_error, T(16) * this->plane_error);
    this->expect(surface_separation(stone, pose), expected, T(2) * this->plane_error, T(16) * this->plane_error);
    expect_near(surface_gap(stone, pose), expected.gap, T(2) * this->plane_error);
    expect_near(surface_gap(stone, pose, ground), expected.gap, T(2) * this->plane_error);
    // A surface elsewhere.
    Expected<T> lower = expected;
    lower.gap = expected.gap + T(1);
    this->expect(surface_separation(stone, pose, T(-1)), lower, T(2) * this->plane_error, T(16) * this->plane_error);
  };
  const Vec3<T> up = vec<T>(0, 0, 1);
  const auto surface = OtherFeature::surface;
  expect(lying<T>(1, 2, 5), {T(3), up, vec<T>(1, 2, 3), Feature::lower_cap, surface});
  expect(lying<T>(1, 2, 2), {T(0), up, vec<T>(1, 2, 0), Feature::lower_cap, surface});
  expect(lying<T>(1, 2, 1.5L), {T(-0.5), up, vec<T>(1, 2, -0.5L), Feature::lower_cap, surface});
  expect(lying<T>(1, 2, -9), {T(-11), up, vec<T>(1, 2, -11), Feature::lower_cap, surface});
  // Upside down; on its rim; leaning on its cap, r − d μ over it, its sphere's centre at d u; leaning on its rim.
  expect({.p_WB = vec<T>(1, 2, 5), .q_WB = Quat<T>(T(0), T(1), T(0), T(0))},
         {T(3), up, vec<T>(1, 2, 3), Feature::upper_cap, surface});
  expect(standing<T>(1, 2, 5), {T(1), up, vec<T>(1, 2, 1), Feature::rim, surface});
  expect(leaning(T(0.8L), 0, 0, 3), {T(0.4L), up, vec<T>(1.8L, 0, 0.4L), Feature::lower_cap, surface});
  expect(leaning(T(0.28L), 0, 0, 4), {T(0.16L), up, vec<T>(1.12L, 0, 0.16L), Feature::rim, surface});
}

TYPED_TEST(Contact, BevelledOverThePlane) {
  using T = TypeParam;
  const Separation<T> found = separation(bevelled<T>(), leaning(T(0.28L), 0, 0, 4), Plane<T>{});
  // r₁ n_r + r₂ = 2.25 · 0.96 + 1.25.
  expect_near(found.gap, T(0.59L), this->plane_error);
  expect_near(found.p_stone, vec<T>(2.25L * 0.28L, 0, 0.59L), T(16) * this->plane_error);
  expect_near(surface_gap(bevelled<T>(), standing<T>(0, 0, 3)), T(-0.5L), this->plane_error);
}

TYPED_TEST(Contact, BesideAnyPlane) {
  using T = TypeParam;
  const Plane<T> wall{.n_W = {T(0.6L), T(0), T(0.8L)}, .offset = T(2)};
  // n · p = 10; S(n) = r − d μ = 2.6.
  this->expect(separation(sharp<T>(), lying<T>(6, 0, 8), wall),
               {T(5.4L), wall.n_W, vec<T>(3, 0, 7), Feature::lower_cap, OtherFeature::surface},
               T(2) * this->plane_error, T(16) * this->plane_error);
  expect_near(surface_gap(sharp<T>(), lying<T>(6, 0, 8), wall), T(5.4L), T(2) * this->plane_error);
}

// --- the board

TYPED_TEST(Contact, WithTheBoard) {
  using T = TypeParam;
  const auto expect = [this](const Pose<T>& pose, const Expected<T>& expected, const Stone<T>& stone = sharp<T>()) {
    // Some seven widths from the origin.
    this->expect(separation(stone, pose, board<T>()), expected, this->board_error, T(100) * this->board_error);
  };
  const Vec3<T> up = vec<T>(0, 0, 1), right = vec<T>(1, 0, 0);
  expect(lying<T>(1, 2, 5), {T(3), up, vec<T>(1, 2, 3), Feature::lower_cap, OtherFeature::surface});
  expect(standing<T>(1, 2, 4.5L), {T(0.5L), up, vec<T>(1, 2, 0.5L), Feature::rim, OtherFeature::surface});
  // The lower cap's sphere has its centre 3 over the stone's: (3, 0, 4) k from the edge's nearest point.
  const Vec3<T> slope = vec<T>(0.6L, 0, 0.8L);
  expect(lying<T>(56, 7, 5), {T(5), slope, vec<T>(53, 7, 4), Feature::lower_cap, OtherFeature::top_edge});
  expect(lying<T>(53, 7, 1), {T(0), slope, vec<T>(50, 7, 0), Feature::lower_cap, OtherFeature::top_edge});
  expect(lying<T>(52.25L, 7, 0), {T(-1.25L), slope, vec<T>(49.25L, 7, -1), Feature::lower_cap, OtherFeature::top_edge});
  expect(lying<T>(-52.25L, 7, 0),
         {T(-1.25L), vec<T>(-0.6L, 0, 0.8L), vec<T>(-49.25L, 7, -1), Feature::lower_cap, OtherFeature::top_edge});
  expect(lying<T>(7, -66, 5),
         {T(5), vec<T>(0, -0.6L, 0.8L), vec<T>(7, -63, 4), Feature::lower_cap, OtherFeature::top_edge});
  // (2, 1, 2)/3 from the corner.
  const Vec3<T> diagonal = Vec3<T>(T(2), T(1), T(2)) / T(3);
  expect(lying<T>(54, 62, 1),
         {T(1), diagonal, Vec3<T>(vec<T>(50, 60, 0) + diagonal), Feature::lower_cap, OtherFeature::corner});
  // Far below the surface: a side, and the edge between two.
  expect(lying<T>(56, 7, -20), {T(2), right, vec<T>(52, 7, -20), Feature::rim, OtherFeature::side});
  expect(lying<T>(56, 68, -20),
         {T(6), vec<T>(0.6L, 0.8L, 0), vec<T>(53.6L, 64.8L, -20), Feature::rim, OtherFeature::vertical_edge});
  expect(lying<T>(56, 7, -20), {T(2.5L), right, vec<T>(52.5L, 7, -20), Feature::rim, OtherFeature::side},
         bevelled<T>());
}

TYPED_TEST(Contact, InsideTheBoardTheShortestWayOut) {
  using T = TypeParam;
  const auto out = [](long double x, long double y, long double z) {
    return separation(sharp<T>(), lying<T>(x, y, z), board<T>());
  };
  const auto expect = [this](const Separation<T>& found, long double depth, const Vec3<T>& n) {
    expect_near(found.gap, T(-depth), T(10) * this->board_error);
    expect_near(found.n_W, n, T(10) * this->board_error);
    EXPECT_EQ(found.status, SeparationStatus::overlapping);
  };
  expect(out(10, 0, -5), 7, vec<T>(0, 0, 1));
  expect(out(45, 0, -20), 9, vec<T>(1, 0, 0));
  expect(out(-45, 0, -20), 9, vec<T>(-1, 0, 0));
  expect(out(10, -55, -20), 9, vec<T>(0, -1, 0));
  expect(out(10, 0, -1000), 44, vec<T>(1, 0, 0));
  // The middle of the board, as far from both sides: one of them.
  expect_near(out(0, 0, -1000).gap, T(-54), T(10) * this->board_error);
}

// --- another stone

/// The gap changes by no more than the stone is moved.
TEST(ContactOfThinStones, IsContinuousWhereASideComesWithinReach) {
  const Stone<double> stone = make_stone(0.022, 0.002);
  const Quat<double> q(-0.72231494183095801, 0.289656432538211, -0.60150208040025743, -0.18043149162809377);
  const auto gap = [&](double x) {
    return separation(stone, {.p_WB = {x, 0.22385994432252881, -0.00096926243295152547}, .q_WB = q},
                      make_board<double>())
        .gap;
  };
  // Half a width inside the side: 0.2121 − 0.011. Out over both sides is the shortest way on either side of that.
  for (const double x : {0.2010999, 0.201099999, 0.2011, 0.2011001}) {
    EXPECT_NEAR(gap(x), -0.0114698, 1e-6) << x;
  }
  EXPECT_NEAR(gap(0.2010999), gap(0.2011001), 2e-7);
  EXPECT_NEAR(gap(0.201099999), gap(0.2011), 1e-9);
}

/// A bevel of next to nothing that touches an edge: the normal is in the digits that are left of two lengths.
TEST(ContactOfThinStones, AnEdgeThatTouchesTheRim) {
  const Stone<double> stone = make_stone(0.022, 3.55e-6, 8e-13);
  const Board<double> wood = make_board<double>();
  const double reach = outer_width(stone) / 2.0;
  for (const double deeper : {0.0, 1e-16, 1e-15, 1e-14}) {
    const Pose<double> pose{.p_WB = {0.1, -(wood.half_length + reach - deeper), 0.0}, .q_WB = Quat<double>(1, 0, 0, 0)};
    EXPECT_NEAR(separation(stone, pose, wood).gap, -deeper, 5e-17);
  }
}

TYPED_TEST(Contact, WithAnotherStone) {
  using T = TypeParam;
  const Stone<T> small_ball = make_stone(T(2), T(2));
  const auto expect = [this](const Stone<T>& stone, const Pose<T>& pose, const Stone<T>& other,
                             const Pose<T>& other_pose, const Expected<T>& expected) {
    const Separation<T> found = separation(stone, pose, other, other_pose);
    this->expect(found, expected, this->stone_error, T(16) * this->stone_error);
    EXPECT_TRUE(found.certified);
    // The other way round: the same gap, the opposite normal.
    const Separation<T> swapped = separation(other, other_pose, stone, pose);
    expect_near(swapped.gap, expected.gap, this->stone_error);
    expect_near(swapped.n_W, Vec3<T>(-expected.n_W), T(16) * this->stone_error);
    expect_near(swapped.p_stone, Vec3<T>(expected.p_stone - expected.gap * expected.n_W), T(16) * this->stone_error);
  };
  const Vec3<T> up = vec<T>(0, 0, 1), right = vec<T>(1, 0, 0);
  const auto other = OtherFeature::stone;
  const Pose<T> origin = lying<T>(0, 0, 0);
  // Coaxial: apart, touching, overlapping. Side by side. On edge over a lying one.
  expect(sharp<T>(), lying<T>(0, 0, 7), sharp<T>(), origin, {T(3), up, vec<T>(0, 0, 5), Feature::lower_cap, other});
  expect(sharp<T>(), lying<T>(0, 0, 3), sharp<T>(), origin, {T(-1), up, vec<T>(0, 0, 1), Feature::lower_cap, other});
  expect(sharp<T>(), lying<T>(10, 0, 0), sharp<T>(), origin, {T(2), right, vec<T>(6, 0, 0), Feature::rim, other});
  expect(sharp<T>(), standing<T>(0, 0, 7), sharp<T>(), origin, {T(1), up, vec<T>(0, 0, 3), Feature::rim, other});
  // Bevelled, overlapping by less than the bevels: certified.
  expect(bevelled<T>(), lying<T>(6, 0, 0), bevelled<T>(), origin,
         {T(-1), right, vec<T>(2.5L, 0, 0), Feature::rim, other});
  // A ball beside the cap: (3, 0, 4) · 2 from the centre (0, 0, −3) of the upper cap's sphere; r + 1 of it are inside.
  expect(small_ball, lying<T>(6, 0, 5), sharp<T>(), origin,
         {T(4), vec<T>(0.6L, 0, 0.8L), vec<T>(5.4L, 0, 4.2L), Feature::lower_cap, other});
}

TYPED_TEST(Contact, CoincidentStonesPartAlongTheirAxis) {
  using T = TypeParam;
  for (const Stone<T>& stone : {sharp<T>(), bevelled<T>()}) {
    const Separation<T> found = separation(stone, lying<T>(1, 2, 3), stone, lying<T>(1, 2, 3));
    EXPECT_EQ(found.status, SeparationStatus::overlapping);
    expect_near(found.gap, T(-4), this->stone_error);
    expect_near(std::abs(found.n_W.z()), T(1), this->stone_error);
  }
  // Centres alone, one lying and one standing: halfway between their axes each needs r − d √½.
  const T least = T(10) - T(3) * std::numbers::sqrt2_v<T>;
  expect_near(separation(sharp<T>(), lying<T>(1, 2, 3), sharp<T>(), standing<T>(1, 2, 3)).gap, -least,
              this->stone_error);
}

// Two thin discs, each at right angles to the other, that cut into each other's rims by less than into their caps: pushed
// apart along the line of their centres, rim from rim.
TYPED_TEST(Contact, RimsThatCross) {
  using T = TypeParam;
  const Stone<T> disc = make_stone(T(12), T(1) / T(2));
  const Quat<T> edgewise(std::sqrt(T(0.5)), std::sqrt(T(0.5)), T(0), T(0));
  const Separation<T> found = separation(disc, Pose<T>{vec<T>(11.9L, 0, 0), edgewise}, disc, lying<T>(0, 0, 0));
  EXPECT_EQ(found.status, SeparationStatus::overlapping);
  EXPECT_TRUE(found.certified);
  EXPECT_EQ(found.feature, Feature::rim);
  expect_near(found.gap, T(T(11.9L) - T(12)), T(10) * this->stone_error);
  expect_near(found.n_W, vec<T>(1, 0, 0), T(100) * this->stone_error);
}

// --- magnitudes

TYPED_TEST(Contact, SquaresThatOverflowOrVanish) {
  using T = TypeParam;
  const int e = std::numeric_limits<T>::max_exponent;
  const T huge = std::ldexp(T(1), e * 3 / 4);
  // Far apart: the stones are nothing beside the distance.
  const Separation<T> far = separation(sharp<T>(), lying<T>(0, 0, 0), sharp<T>(),
                                       {.p_WB = {T(0), huge, T(0)}, .q_WB = Quat<T>(T(1), T(0), T(0), T(0))});
  EXPECT_EQ(far.status, SeparationStatus::separated);
  EXPECT_TRUE(far.certified);
  EXPECT_EQ(far.gap, huge);
  EXPECT_EQ(far.n_W, vec<T>(0, -1, 0));
  if (std::same_as<T, long double>) {
    return;  // makes its stones in no wider type
  }
  // All of it larger or smaller, as far as stones may be.
  const T large = std::ldexp(T(1), e / 2 - 12), small = std::ldexp(T(1), -e / 4);
  for (const T& f : {large, small}) {
    const Stone<T> stone = make_stone(T(f * T(8)), T(f * T(4)));
    const auto at = [&](long double x, long double y, long double z) {
      return Pose<T>{.p_WB = f * vec<T>(x, y, z), .q_WB = Quat<T>(T(1), T(0), T(0), T(0))};
    };
    const auto expect = [&](const Separation<T>& found, const T& gap) {
      expect_near(T(found.gap / f), gap, T(4) * this->stone_error);
      EXPECT_EQ(found.status, gap < T(0) ? SeparationStatus::overlapping : SeparationStatus::separated);
      EXPECT_TRUE(found.certified);
      expect_near(Vec3<T>((found.p_stone - found.p_other) / f), Vec3<T>(gap * found.n_W), T(16) * this->stone_error);
    };
    expect(separation(stone, at(1, 2, 9), stone, at(1, 2, 0)), T(5));
    expect(separation(stone, at(1, 2, 3), stone, at(1, 2, 0)), T(-1));
    Board<T> wood = board<T>();
    wood.half_width *= f;
    wood.half_length *= f;
    // 5 from the edge is 0 from the cap, and 3 further out along (3, 4)/5.
    expect(separation(stone, at(53 + 1.8L, 7, 1 + 2.4L), wood), T(3));
    expect(separation(stone, at(1, 2, 1), wood), T(-1));
    expect(separation(stone, at(1, 2, 9), Plane<T>{}), T(7));
  }
}

/// High over a board so narrow that its edge is all but under the stone's lowest point: in float, where the last step of
/// the search left the arc between the surface and the side, too.
TEST(ContactFloat, HighOverANarrowBoard) {
  const Quat<double> q(0x1.530a7e79c61b6p-1, -0x1.7a737100cb5d3p-1, 0x1.4fa6c95079bdfp-4, -0x1.781043106f063p-4);
  const auto gap = [&]<class T>(T half_length) {
    const Stone<T> stone = make_stone(T(0.02201), T(0.0092), T(0));
    Board<T> narrow = make_board<T>();
    narrow.half_length = half_length;
    const Pose<T> pose{Vec3<T>(T(0), T(0), T(1)), q.cast<T>().normalized()};
    return static_cast<double>(separation(stone, pose, narrow).gap);
  };
  for (int i = 0; i < 2000; ++i) {
    const double half_length = 0.009 + 1e-6 * i;
    EXPECT_NEAR(gap(static_cast<float>(half_length)), gap(half_length), 1e-6) << half_length;
  }
}

// --- a core that is a point

TEST(ContactOfABevelledBall, ItsCentreAtTheRimOfASharpStone) {
  const Stone<double> stone = sharp(), ball = make_stone(8.0, 8.0, 3.0);
  EXPECT_EQ(ball.bevel_major_radius, 0.0);
  const double around = 0.7, joint = std::atan2(3.0, 4.0);
  const Vec3<double> out(std::cos(around), std::sin(around), 0.0);
  const Quat<double> turned(Eigen::AngleAxisd(0.4, Vec3<double>(1.0, 2.0, 2.0) / 3.0));
  for (int power = -18; power <= 0; ++power) {
    for (int i = 0; i < 100; ++i) {
      // Beside the rim, all round its edge, and where rim and cap meet to a few ulps.
      const double angle = i % 2 == 0 ? 0.08 * i : joint * (1.0 + std::pow(10.0, -i / 6.0));
      const Vec3<double> beside =
          std::pow(10.0, power) * (std::cos(angle) * out + std::sin(angle) * Vec3<double>::UnitZ());
      const Vec3<double> centre = 4.0 * out + beside;
      const Pose<double> pose{.p_WB = turned * centre, .q_WB = turned},
          origin{.p_WB = Vec3<double>::Zero(), .q_WB = turned};
      const double gap = closest_point(stone, centre).distance - 4.0;
      for (const Separation<double>& at :
           {separation(ball, pose, stone, origin), separation(stone, origin, ball, pose)}) {
        EXPECT_TRUE(at.certified) << power << ", " << i;
        EXPECT_NEAR(at.gap, gap, 2e-13) << power << ", " << i;
      }
    }
  }
}

// --- errors of the caller

TEST(ContactBadInput, PosesNormalsOffsets) {
  const Pose<double> good = lying<double>(1, 2, 3);
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)separation(sharp(), bad, Plane<double>{}); });
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)surface_gap(sharp(), bad); });
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)surface_gap(sharp(), bad, Plane<double>{}); });
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)surface_separation(sharp(), bad); });
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)separation(sharp(), bad, board()); });
  expect_bad_poses_refused([&](const Pose<double>& bad) { (void)separation(sharp(), bad, sharp(), good); });
  expect_bad_poses_refused([&](const Pose<double>& bad) { (void)separation(sharp(), good, sharp(), bad); });
  with_each_bad_direction([&](const Vec3<double>& bad) {
    expect_invalid("normal", [&] { (void)separation(sharp(), good, Plane<double>{.n_W = bad}); });
    expect_invalid("normal", [&] { (void)surface_gap(sharp(), good, Plane<double>{.n_W = bad}); });
  });
  for (const double bad : {nan, infinity, -infinity}) {
    expect_invalid("offset", [&] { (void)separation(sharp(), good, Plane<double>{.offset = bad}); });
    expect_invalid("offset", [&] { (void)surface_gap(sharp(), good, Plane<double>{.offset = bad}); });
    expect_invalid("offset", [&] { (void)surface_separation(sharp(), good, bad); });
  }
  expect_invalid("stone", [&] { (void)separation(Stone<double>{}, good, Plane<double>{}); });
  expect_invalid("stone", [&] { (void)surface_gap(Stone<double>{}, good, Plane<double>{}); });
  expect_invalid("stone", [&] { (void)surface_separation(Stone<double>{}, good); });
  expect_invalid("board", [&] { (void)separation(sharp(), good, Board<double>{}); });
}

}  // namespace
}  // namespace goishi::contact_test
