/// Impacts by hand: balls, a body that is hit off its centre, two bodies; each law.

#include <gtest/gtest.h>

#include <goishi/mass/inertia.hpp>
#include <goishi/published/linear_response.hpp>
#include <random>
#include <vector>

#include "tests/allocations.hpp"
#include "tests/impact_test.hpp"

namespace goishi::impact_test {

namespace {

template <class T>
class ImpactOf : public testing::Test {
 protected:
  static constexpr T error = T(256) * std::numeric_limits<T>::epsilon();

  static void expect(const Impulse<T>& found, ImpactOutcome outcome, const Vec3<T>& impulse, const Vec3<T>& after) {
    EXPECT_EQ(found.outcome, outcome) << to_string(found.outcome);
    expect_near(found.impulse_W, impulse, T(8) * error);
    expect_near(found.velocity_after, after, T(8) * error);
    expect_near(found.normal, impulse.z(), T(8) * error);
    expect_near(found.energy_change, T(impulse.dot(Vec3<T>(found.velocity_before + after)) / T(2)), T(64) * error);
  }
};
TYPED_TEST_SUITE(ImpactOf, Scalars);

// --- a ball: all laws agree

TYPED_TEST(ImpactOf, BallThatFallsStraight) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    for (const long double mu : {0.0L, 0.3L, 5.0L, std::numeric_limits<long double>::infinity()}) {
      SCOPED_TRACE(std::string(to_string(law)) + ", friction " + std::to_string(static_cast<double>(mu)));
      const auto outcome = mu > 0 ? ImpactOutcome::stuck : ImpactOutcome::slid;
      for (const long double e : {0.0L, 0.5L, 1.0L}) {
        const Impact<T> found = on_plane(law, e, mu, ball<T>(vec<T>(0, 0, -3)));
        this->expect(found.impulse, outcome, vec<T>(0, 0, 6 * (1 + e)), vec<T>(0, 0, 3 * e));
        expect_near(found.body.v_WB, vec<T>(0, 0, 3 * e), this->error);
        expect_near(found.body.L_W, vec<T>(0, 0, 0), this->error);
        expect_near(found.impulse.energy_change, T(-9 * (1 - e * e)), T(8) * this->error);
      }
    }
  }
}

TYPED_TEST(ImpactOf, BallThatSlides) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    SCOPED_TRACE(to_string(law));
    const Impact<T> found = on_plane(law, 0.5L, 0.1L, ball<T>(vec<T>(7, 0, -3)));
    // Friction 0.9 against the slip; at (0, 0, −1) from the centre.
    this->expect(found.impulse, ImpactOutcome::slid, vec<T>(-0.9L, 0, 9), vec<T>(7 - 0.9L * 1.75L, 0, 1.5L));
    expect_near(found.body.v_WB, vec<T>(6.55L, 0, 1.5L), T(8) * this->error);
    expect_near(found.body.L_W, vec<T>(0, 0.9L, 0), T(8) * this->error);
  }
}

TYPED_TEST(ImpactOf, BallThatRollsOn) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    for (const long double mu : {0.5L, 100.0L, std::numeric_limits<long double>::infinity()}) {
      SCOPED_TRACE(std::string(to_string(law)) + ", friction " + std::to_string(static_cast<double>(mu)));
      const Impact<T> found = on_plane(law, 0.5L, mu, ball<T>(vec<T>(0, 7, -3)));
      this->expect(found.impulse, ImpactOutcome::stuck, vec<T>(0, -4, 9), vec<T>(0, 0, 1.5L));
      expect_near(found.body.v_WB, vec<T>(0, 5, 1.5L), T(8) * this->error);  // 5/7
      expect_near(found.body.L_W, vec<T>(-4, 0, 0), T(8) * this->error);     // ω = 5
    }
  }
}

TYPED_TEST(ImpactOf, BallThatRollsAlready) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    SCOPED_TRACE(to_string(law));
    const Impact<T> found = on_plane(law, 1, 0.3L, ball<T>(vec<T>(5, 0, -2), vec<T>(0, 4, 0)));
    this->expect(found.impulse, ImpactOutcome::stuck, vec<T>(0, 0, 8), vec<T>(0, 0, 2));
    expect_near(found.impulse.energy_change, T(0), T(64) * this->error);
  }
}

// --- off the centre

TYPED_TEST(ImpactOf, OffCentreWithoutFriction) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    SCOPED_TRACE(to_string(law));
    const Impact<T> found = on_plane(law, 0.5L, 0, off_centre<T>(vec<T>(0, 0, -3)));
    this->expect(found.impulse, ImpactOutcome::slid, vec<T>(0, 0, 3), vec<T>(1.5L, 0, 1.5L));
    expect_near(found.impulse.energy_change, T(-0.75L * 9 / 3), T(8) * this->error);
    expect_near(found.body.L_W, vec<T>(0, -3, 0), this->error);
  }
}

TYPED_TEST(ImpactOf, OffCentreDefaultLaw) {
  using T = TypeParam;
  const auto law = ImpactLaw::chatterjee_ruina;
  // p_I = (0, 0, 2), p_II = (−3/4, 0, 9/4). Within the cone: what is left of the slip is e W p_I.
  this->expect(on_plane(law, 0.5L, 0.24L, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::stuck,
               vec<T>(-0.75L, 0, 3.25L), vec<T>(0.5L, 0, 1.5L));
  // On it, κ = 12/29.
  this->expect(on_plane(law, 0.5L, 0.1L, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::slid,
               vec<T>(-9.0L / 29, 0, 90.0L / 29), vec<T>(63.0L / 58, 0, 1.5L));
  // Infinite friction: sticking, until that would have to pull: then the impulse lies across the normal.
  this->expect(on_plane(law, 0, infinity, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::stuck,
               vec<T>(-0.75L, 0, 2.25L), vec<T>(0, 0, 0));
  this->expect(on_plane(law, 0, infinity, off_centre<T>(vec<T>(-15, 0, -3))).impulse, ImpactOutcome::slid,
               vec<T>(6, 0, 0), vec<T>(-6, 0, 0));
}

TYPED_TEST(ImpactOf, OffCentrePublishedLaw) {
  using T = TypeParam;
  const auto law = ImpactLaw::published;
  this->expect(on_plane(law, 0.5L, 0.1L, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::slid,
               vec<T>(-0.3L, 0, 3), vec<T>(1.05L, 0, 1.35L));
  this->expect(on_plane(law, 0.5L, 1, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::stuck, vec<T>(-1, 0, 3),
               vec<T>(0, 0, 1));
}

TEST(PublishedLaw, IsResolvedAgainWhileTheContactApproaches) {
  // Each round leaves a sixth of the approach that the one before left, the first 1/2 of 3: twelve bring it below 1e-9.
  const Impulse<double> found = on_plane(ImpactLaw::published, 0, 0.5L, off_centre<double>(vec(10, 0, -3))).impulse;
  EXPECT_EQ(found.rounds, 12);
  EXPECT_EQ(found.outcome, ImpactOutcome::slid);
  expect_near(found.impulse_W, vec(-1.2L, 0, 2.4L), 4e-9);
  EXPECT_LE(found.velocity_after.z(), 0.0);
  EXPECT_GE(found.velocity_after.z(), -3e-9);
}

TYPED_TEST(ImpactOf, OffCentreStronge) {
  using T = TypeParam;
  const auto law = ImpactLaw::stronge;
  // Slips all the way: the normal velocity grows by 5/4 for each unit of normal impulse.
  this->expect(on_plane(law, 0.5L, 0.5L, off_centre<T>(vec<T>(10, 0, -3))).impulse, ImpactOutcome::slid,
               vec<T>(-1.8L, 0, 3.6L), vec<T>(9.1L, 0, 1.5L));
  // Sticks all the way: by 4/3.
  this->expect(on_plane(law, 0.5L, 1, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::stuck,
               vec<T>(-1.125L, 0, 3.375L), vec<T>(0, 0, 1.5L));
  // Friction cannot hold it: slips away from the start, by 29/20, and 7/20 along x.
  this->expect(on_plane(law, 0.5L, 0.1L, off_centre<T>(vec<T>(0, 0, -3))).impulse, ImpactOutcome::slid,
               vec<T>(-9.0L / 29, 0, 90.0L / 29), vec<T>(31.5L / 29, 0, 1.5L));
  // Slips towards −x, with 2 along x and z for each unit of normal impulse; stops after 0.8 with −1.4 along z, then
  // sticks, by 4/3. Compression takes 2.2 · 0.8 + 1.4²/(8/3) = 2.495, a quarter comes back.
  const long double last = std::sqrt(2.495L * 2 / 3), normal = 1.85L + 0.75L * last;
  this->expect(on_plane(law, 0.5L, 1, off_centre<T>(vec<T>(-1.6L, 0, -3))).impulse, ImpactOutcome::stuck,
               vec<T>((1.6L - normal / 2) / 1.5L, 0, normal), vec<T>(0, 0, last));
}

TYPED_TEST(ImpactOf, OffCentreStrongeOutOfThePlane) {
  using T = TypeParam;
  // Infinite friction stops the slip at once, by (−2, −2.5, 0), which lets it approach with 4; that sticks.
  const Impact<T> found = on_plane(ImpactLaw::stronge, 1, infinity, off_centre<T>(vec<T>(3, 5, -3)));
  this->expect(found.impulse, ImpactOutcome::stuck, vec<T>(-2 - 2, -2.5L, 6), vec<T>(0, 0, 4));
}

// --- what leaves

TYPED_TEST(ImpactOf, NothingHappensToAContactThatLeaves) {
  using T = TypeParam;
  for (const ImpactLaw law : all_laws) {
    for (const long double speed : {0.0L, 2.0L}) {
      const ImpactBody<T> body = ball<T>(vec<T>(7, 0, speed), vec<T>(1, 2, 3));
      const Impact<T> found = on_plane(law, 0.5L, 0.3L, body);
      EXPECT_EQ(found.impulse.outcome, ImpactOutcome::separating);
      EXPECT_EQ(found.impulse.impulse_W, vec<T>(0, 0, 0));
      EXPECT_EQ(found.impulse.velocity_after, found.impulse.velocity_before);
      EXPECT_EQ(found.impulse.energy_change, T(0));
      EXPECT_EQ(found.body.v_WB, body.v_WB);
      EXPECT_EQ(found.body.L_W, body.L_W);
    }
  }
}

// --- two bodies

TEST(TwoBodies, EqualBallsExchangeTheirVelocities) {
  for (const ImpactLaw law : all_laws) {
    ImpactBody<double> left = ball(vec(0, 0, 0)), right = ball(vec(0, 0, 0));
    left.p_WB = vec(-1, 0, 0);
    right.p_WB = vec(1, 0, 0);
    left.v_WB = vec(4, 0, 0);
    const auto found = resolve(law, make_material(1.0, 0.3), vec(0, 0, 0), vec(-1, 0, 0), left, right);
    expect_near(found.first.v_WB, vec(0, 0, 0), 1e-14);
    expect_near(found.second.v_WB, vec(4, 0, 0), 1e-14);
    expect_near(found.impulse.impulse_W, vec(-8, 0, 0), 1e-13);
  }
}

/// Bodies that meet at the origin in no special way.
struct Meeting {
  ImpactBody<double> first, second;
  Vec3<double> n_W;
};

std::vector<Meeting> meetings() {
  std::mt19937 bits(20261122);
  const auto some = [&bits](double size) { return size * (static_cast<double>(bits()) / 0x1p31 - 1.0); };
  const auto any = [&](double size) { return Vec3<double>(some(size), some(size), some(size)); };
  const auto body = [&] {
    const Mobility<double> mobility =
        make_mobility(2.0 + some(1.0), Moments<double>{.axial = 2.0 + some(0.5), .transverse = 1.5 + some(0.2)});
    return ImpactBody<double>{mobility, any(1.0), any(1.0).normalized(), any(3.0), any(5.0)};
  };
  std::vector<Meeting> result;
  for (int i = 0; i < 200; ++i) {
    result.push_back({body(), body(), any(1.0).normalized()});
  }
  return result;
}

constexpr std::array frictions = {0.0, 0.3, 2.0, infinity};

TEST(TwoBodies, ExchangedBodiesExchangeTheResult) {
  for (const Meeting& met : meetings()) {
    for (const ImpactLaw law : all_laws) {
      for (const double mu : frictions) {
        const Material<double> material = make_material(0.4, mu);
        const auto one = resolve(law, material, vec(0, 0, 0), met.n_W, met.first, met.second);
        const auto other = resolve(law, material, vec(0, 0, 0), Vec3<double>(-met.n_W), met.second, met.first);
        EXPECT_EQ(one.impulse.impulse_W, Vec3<double>(-other.impulse.impulse_W)) << to_string(law);
        EXPECT_EQ(one.impulse.outcome, other.impulse.outcome);
        EXPECT_EQ(one.impulse.energy_change, other.impulse.energy_change);
        EXPECT_EQ(one.first.v_WB, other.second.v_WB);
        EXPECT_EQ(one.first.L_W, other.second.L_W);
        EXPECT_EQ(one.second.L_W, other.first.L_W);
      }
    }
  }
}

TEST(TwoBodies, AFixedSecondBodyIsABoard) {
  for (const Meeting& met : meetings()) {
    ImpactBody<double> board = met.second;
    board.mobility = fixed_mobility<double>();
    board.v_WB = board.L_W = vec(0, 0, 0);
    for (const ImpactLaw law : all_laws) {
      for (const double mu : frictions) {
        const Material<double> material = make_material(0.4, mu);
        const auto two = resolve(law, material, vec(0, 0, 0), met.n_W, met.first, board);
        const auto one = resolve(law, material, vec(0, 0, 0), met.n_W, met.first);
        EXPECT_EQ(two.impulse.impulse_W, one.impulse.impulse_W) << to_string(law);
        EXPECT_EQ(two.first.v_WB, one.body.v_WB);
        EXPECT_EQ(two.first.L_W, one.body.L_W);
        EXPECT_EQ(two.second.v_WB, board.v_WB);
      }
    }
  }
}

// --- the linear response

TEST(LinearResponse, TurnsTheMomentumRound) {
  EXPECT_EQ(linear_response(vec(1, 2, -3), vec(0, 0, 1), 0.5), 4.5);
  EXPECT_EQ(linear_response(vec(1, 2, -3), vec(0, 0, 1), 0.0), 3.0);
  EXPECT_EQ(linear_response(vec(1, 2, 3), vec(0, 0, 1), 0.5), 0.0);
  ImpactBody<double> sliding = off_centre(vec(0.5L, 1, -1.5L));
  sliding.mobility = make_linear_mobility(2.0);
  const Impulse<double> found = on_plane(ImpactLaw::chatterjee_ruina, 0.5L, 0, sliding).impulse;
  expect_near(found.impulse_W, vec(0, 0, 4.5L), 1e-14);
}

// --- names, and the heap

TEST(ImpactNames, AreThoseOfTheCommandLine) {
  EXPECT_EQ(to_string(ImpactLaw::chatterjee_ruina), "chatterjee_ruina");
  EXPECT_EQ(to_string(ImpactLaw::published), "published");
  EXPECT_EQ(to_string(ImpactLaw::stronge), "stronge");
  EXPECT_EQ(to_string(ImpactOutcome::separating), "separating");
  EXPECT_EQ(to_string(ImpactOutcome::stuck), "stuck");
  EXPECT_EQ(to_string(ImpactOutcome::slid), "slid");
  EXPECT_EQ(to_string(ImpactOutcome::not_converged), "not converged");
}

TEST(ImpactMemory, NoLawAllocates) {
  const std::vector<Meeting> all = meetings();
  double sum = 0.0;
  const long before = test::allocations();
  for (const Meeting& met : all) {
    for (const ImpactLaw law : all_laws) {
      for (const double mu : frictions) {
        const Material<double> material = make_material(0.4, mu);
        sum += resolve(law, material, vec(0, 0, 0), met.n_W, met.first, met.second).impulse.energy_change;
        sum += resolve(law, material, vec(0, 0, 0), met.n_W, met.first).impulse.energy_change;
      }
    }
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_LT(sum, 0.0);
}

/// A stone of 0.1 µm or of 22 km, in every scalar, and the speeds of nothing and of everything: the impact of a stone of 22 mm
/// at 1 m/s, in its own units.
TYPED_TEST(ImpactOf, AnySizeAndSpeed) {
  using T = TypeParam;
  const auto of = [](ImpactLaw law, T friction, T width, T speed) {
    const MassProperties<T> body = mass_properties(make_stone<T>(width, T(0.4L) * width), Density<T>{T(2800)});
    const ImpactBody<T> stone{.mobility = make_mobility(body),
                              .p_WB = vec<T>(0.3L * width, 0, 0.3L * width),
                              .u_W = vec<T>(0.6L, 0, 0.8L),
                              .v_WB = vec<T>(0.1L * speed, 0, -speed),
                              .L_W = vec<T>(0, 0, 0)};
    const Impulse<T> found = resolve(law, make_material(T(0.5), friction), vec<T>(0, 0, 0), up<T>(), stone).impulse;
    const T unit = body.mass * speed;
    return std::pair<Vec3<T>, ImpactOutcome>(found.impulse_W / unit, found.outcome);
  };
  for (const ImpactLaw law : all_laws) {
    for (const T friction : {T(0), T(0.3L), T(2), std::numeric_limits<T>::infinity()}) {
      const auto [right, outcome] = of(law, friction, T(0.022L), T(1));
      for (const T width : {T(1e-7L), T(1e-5L), T(22e3L), T(1e6L)}) {
        for (const T speed : {T(1e-12L), T(1), T(1e6L)}) {
          const auto [found, how] = of(law, friction, width, speed);
          EXPECT_EQ(how, outcome) << to_string(law) << ", " << width << " m, " << speed << " m/s";
          expect_near<T>(found, right,
                         T(200) * std::numeric_limits<T>::epsilon() * (law == ImpactLaw::stronge ? T(1000) : T(1)));
        }
      }
    }
  }
}

TYPED_TEST(ImpactOf, WhatOverflowsIsRefused) {
  using T = TypeParam;
  const T huge = std::numeric_limits<T>::max() / T(4);
  for (const ImpactLaw law : all_laws) {
    for (const long double friction : {0.0L, 0.3L}) {
      EXPECT_THROW((void)on_plane<T>(law, 0.5L, friction, ball<T>(Vec3<T>(huge, T(0), -huge))), InvalidArgument);
    }
  }
}

/// |q|² off by 50 ε, as `require_unit` lets through.
TEST(ImpactAxis, OfAnAttitudeThatIsAccepted) {
  const double k = std::sqrt((1.0 + 50.0 * std::numeric_limits<double>::epsilon()) / 2.0);
  ImpactBody<double> body = ball(vec(0, 0, -3));
  body.u_W = symmetry_axis(Quat<double>(k, 0.0, k, 0.0));
  EXPECT_NEAR(body.u_W.norm(), 1.0, 4e-16);
  EXPECT_NO_THROW((void)on_plane(ImpactLaw::chatterjee_ruina, 0.5, 0.3, body));
}

/// Formerly run as Stronge's.
TEST(BadLaw, OutsideTheEnumeration) {
  for (const int law : {-1, 3, 1000}) {
    for (const double friction : {0.0, 0.3}) {
      expect_invalid("law", [&] { (void)on_plane(static_cast<ImpactLaw>(law), 0.5, friction, ball(vec(0, 0, -3))); });
      expect_invalid("law", [&] {
        (void)resolve(static_cast<ImpactLaw>(law), make_material(0.5, friction), vec(0, 0, 0), vec(0, 0, 1),
                      ball(vec(0, 0, -3)), ball(vec(0, 0, 3)));
      });
    }
  }
}

TEST(Material, OfWholeNumbers) {
  static_assert(std::is_same_v<decltype(make_material(0, 1)), Material<double>>);
  static_assert(std::is_same_v<decltype(make_material(1, 0.5F)), Material<float>>);
  static_assert(std::is_same_v<decltype(make_linear_mobility(2)), Mobility<double>>);
  EXPECT_EQ(make_material(1, 0.25).friction, 0.25);
  EXPECT_EQ(make_mobility(2, Moments<double>{.axial = 1.0, .transverse = 1.0}).linear, 0.5);
}

TEST(BadMobility, WhatHasNoInverse) {
  EXPECT_THROW((void)make_mobility(1e-310, Moments<double>{.axial = 1.0, .transverse = 1.0}), InvalidArgument);
  EXPECT_THROW((void)make_mobility(1.0, Moments<double>{.axial = 1e-310, .transverse = 1e-310}), InvalidArgument);
  EXPECT_THROW((void)make_linear_mobility(1.5e308), InvalidArgument);
  EXPECT_THROW((void)make_linear_mobility(1e-40F), InvalidArgument);
}

}  // namespace
}  // namespace goishi::impact_test
