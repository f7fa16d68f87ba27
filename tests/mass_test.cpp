#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/inertia_row.hpp>
#include <goishi/mass/inertia_table.hpp>
#include <goishi/mass/tensor.hpp>
#include <limits>
#include <numbers>

#include "tests/expectations.hpp"

namespace {

using namespace goishi;

using std::numbers::pi;
using test::nan;

TEST(Mass, IsNanUntilComputed) {
  const MassProperties<double> body;
  EXPECT_TRUE(std::isnan(body.mass));
  EXPECT_TRUE(std::isnan(body.moments.axial));
}

TEST(Mass, OfThePublishedExample) {
  // Size 33, in cm, per unit mass: 1.850540491831, 0.415606897126197, 0.244624139941691.
  const MassProperties<double> body = mass_properties(make_stone(2.2, 0.92), Mass{1.0});
  EXPECT_NEAR(body.volume, 1.850540491831, 5e-13);
  EXPECT_NEAR(body.moments.axial, 0.415606897126197, 5e-16);
  EXPECT_NEAR(body.moments.transverse, 0.244624139941691, 5e-16);
}

TEST(Mass, OfThePublishedExampleBevelled) {
  const MassProperties<double> body = mass_properties(make_stone(2.2, 0.92, 0.1), Mass{1.0});
  EXPECT_NEAR(body.volume, 1.84302, 5e-6);
  EXPECT_NEAR(body.moments.axial, 0.412568, 5e-7);
  EXPECT_NEAR(body.moments.transverse, 0.243254, 5e-7);
}

TEST(Mass, OfABall) {
  for (const double bevel : {0.0, 1e-9, 0.5, 1.999}) {
    const MassProperties<double> ball = mass_properties(make_stone(2.0, 2.0, bevel), Density{3.0});
    EXPECT_DOUBLE_EQ(ball.volume, 4.0 * pi / 3.0);
    EXPECT_DOUBLE_EQ(ball.mass, 4.0 * pi);
    EXPECT_DOUBLE_EQ(ball.surface_area, 4.0 * pi);
    EXPECT_DOUBLE_EQ(ball.moments.axial, 0.4 * 4.0 * pi);
    EXPECT_DOUBLE_EQ(ball.moments.transverse, 0.4 * 4.0 * pi);
  }
}

TEST(Mass, FromDensityAndFromMassAgree) {
  const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  const MassProperties<double> dense = mass_properties(stone, Density{2800.0});
  const MassProperties<double> heavy = mass_properties(stone, Mass{dense.mass});
  EXPECT_DOUBLE_EQ(heavy.density, 2800.0);
  EXPECT_DOUBLE_EQ(heavy.moments.axial, dense.moments.axial);
  EXPECT_DOUBLE_EQ(heavy.moments.transverse, dense.moments.transverse);
  EXPECT_NEAR(dense.mass, 0.005, 0.0005);  // a stone weighs about 5 g
}

TEST(Mass, RefusesBadDensityAndMass) {
  const Stone<double> stone = make_stone(0.022, 0.0092);
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)mass_properties(stone, Density{bad}), InvalidArgument);
    EXPECT_THROW((void)mass_properties(stone, Mass{bad}), InvalidArgument);
  }
}

TEST(Mass, WholeNumbersAreDoubles) {
  const Stone<double> stone = make_stone(0.022, 0.0092);
  EXPECT_EQ(mass_properties(stone, Density{2800}).mass, mass_properties(stone, Density{2800.0}).mass);
  EXPECT_EQ(mass_properties(stone, Mass{1}).mass, 1.0);
}

TEST(Mass, FormulasAreConstantExpressionsWhereTheyNeedNoRoot) {
  constexpr double radius = formula::sphere_radius(22.0, 9.2);
  constexpr double volume = formula::lens_volume(2.0, 2.0);
  static_assert(radius > 15.0 && radius < 16.0);
  static_assert(volume > 4.18 && volume < 4.19);
}

RC_GTEST_PROP(Mass, MoreBevelIsLighter, ()) {
  const double w = *rc::gen::inRange(1, 100001) * 1e-5;
  const double h = w * *rc::gen::inRange(1, 100001) * 1e-5;
  const double b = h * *rc::gen::inRange(1, 100000) * 1e-5;
  const double half = mass_properties(make_stone(w, h, b / 2), Density{1.0}).volume;
  RC_ASSERT(mass_properties(make_stone(w, h, b), Density{1.0}).volume <= half * (1 + 2e-15));
}

TEST(Table, RowsAreConstantExpressions) {
  static_assert(inertia_table.size() == 96);
  static_assert(inertia_table.front().number == 22);
  static_assert(inertia_table.back().number == 50);
  static_assert(inertia_row(33, StoneColor::white).axial_per_mass > 4.15e-5);
}

TEST(Table, RowsAreFoundByNumberColourAndBevel) {
  for (const InertiaRow& row : inertia_table) {
    EXPECT_EQ(&inertia_row(row.number, row.color, row.bevel), &row);
  }
  EXPECT_EQ(inertia_row(33, StoneColor::black).bevel, 0.0);
  EXPECT_THROW((void)inertia_row(29, StoneColor::white), InvalidArgument);
  EXPECT_THROW((void)inertia_row(33, StoneColor::white, 0.002), InvalidArgument);
  EXPECT_THROW((void)inertia_row(33, StoneColor::white, nan), InvalidArgument);
}

TEST(Tensor, OfAStoneAtTheOriginIsDiagonal) {
  const MassProperties<double> body = mass_properties(make_stone(0.022, 0.0092), Density{2800.0});
  const Mat3<double> tensor = inertia_tensor(body, Quat<double>::Identity(), Vec3<double>(Vec3<double>::Zero()));
  EXPECT_EQ(tensor(0, 0), body.moments.transverse);
  EXPECT_EQ(tensor(1, 1), body.moments.transverse);
  EXPECT_EQ(tensor(2, 2), body.moments.axial);
  EXPECT_EQ(tensor(0, 1), 0.0);
}

TEST(Tensor, OfAStoneOnItsEdge) {
  // A quarter turn about x takes the symmetry axis from z to −y.
  const MassProperties<double> body = mass_properties(make_stone(0.022, 0.0092), Density{2800.0});
  const Quat<double> quarter(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
  const Mat3<double> tensor = inertia_tensor(body, quarter, Vec3<double>(1.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(tensor(0, 0), body.moments.transverse);
  EXPECT_DOUBLE_EQ(tensor(1, 1), body.moments.axial + body.mass);
  EXPECT_DOUBLE_EQ(tensor(2, 2), body.moments.transverse + body.mass);
}

/// |q|² off by 50 ε, as `require_unit` lets through: a rotation all the same.
TEST(Tensor, OfAnAttitudeThatIsAccepted) {
  const double k = std::sqrt((1.0 + 50.0 * std::numeric_limits<double>::epsilon()) / 2.0);
  const auto body = mass_properties(make_stone(0.022, 0.0092), Density{2800});
  const Mat3<double> tensor = inertia_tensor(body, Quat<double>(k, 0.0, k, 0.0), {0.0, 0.0, 0.0});
  EXPECT_NEAR(tensor(0, 0) / body.moments.axial, 1.0, 1e-15);
  EXPECT_NEAR(tensor(2, 2) / body.moments.transverse, 1.0, 1e-15);
}

TEST(Mass, OfAnySizeOrRefused) {
  for (const double size : {1e-60, 1e-20, 1e20, 1e60}) {
    const auto body = mass_properties(make_stone(22.0 * size, 9.0 * size, size), Density{1.0});
    const auto one = mass_properties(make_stone(22.0, 9.0, 1.0), Density{1.0});
    EXPECT_NEAR(body.volume / one.volume / size / size / size, 1.0, 1e-14);
    EXPECT_NEAR(body.moments_per_mass.axial / one.moments_per_mass.axial / size / size, 1.0, 1e-14);
  }
  for (const double size : {1e-63, 1e-130, 1e63, 1e130}) {  // w⁵ is no number
    EXPECT_THROW((void)mass_properties(make_stone(size, size), Density{1.0}), InvalidArgument);
  }
  EXPECT_THROW((void)mass_properties(make_stone(1e-9F, 4e-10F), Density{2800.0F}), InvalidArgument);
  EXPECT_NO_THROW((void)mass_properties(make_stone(1e-7F, 4e-8F), Density{2800.0F}));
}

TEST(Tensor, RefusesAnAttitudeThatIsNone) {
  const MassProperties<double> body = mass_properties(make_stone(0.022, 0.0092), Density{2800.0});
  const Vec3<double> origin = Vec3<double>::Zero();
  for (const Quat<double>& bad :
       {Quat<double>(0.0, 0.0, 0.0, 0.0), Quat<double>(1.0, 1.0, 0.0, 0.0), Quat<double>(nan, 0.0, 0.0, 0.0)}) {
    EXPECT_THROW((void)inertia_tensor(body, bad, origin), InvalidArgument);
  }
  EXPECT_THROW((void)inertia_tensor(body, Quat<double>::Identity(), Vec3<double>(nan, 0.0, 0.0)), InvalidArgument);
}

TEST(Tensor, PrincipalAxesRefuseWhatNoBodyHas) {
  const auto diagonal = [](double x, double y, double z) { return Mat3<double>(Vec3<double>(x, y, z).asDiagonal()); };
  EXPECT_NO_THROW((void)principal_axes(diagonal(1.0, 2.0, 3.0)));  // a lamina: the equality is allowed
  EXPECT_THROW((void)principal_axes(diagonal(1.0, 1.0, 2.1)), InvalidArgument);
  EXPECT_THROW((void)principal_axes(diagonal(-1.0, 2.0, 2.0)), InvalidArgument);
  EXPECT_THROW((void)principal_axes(diagonal(0.0, 1.0, 1.0)), InvalidArgument);
  EXPECT_THROW((void)principal_axes(diagonal(nan, 1.0, 1.0)), InvalidArgument);
  Mat3<double> skew = diagonal(2.0, 2.0, 2.0);
  skew(0, 1) = 0.1;
  EXPECT_THROW((void)principal_axes(skew), InvalidArgument);
}

TEST(Tensor, MomentsOfASymmetricBodyAreChecked) {
  EXPECT_NO_THROW(require_physical(Moments<double>{.axial = 2.0, .transverse = 1.0}));
  EXPECT_THROW(require_physical(Moments<double>{.axial = 2.1, .transverse = 1.0}), InvalidArgument);
  EXPECT_THROW(require_physical(Moments<double>{.axial = 0.0, .transverse = 1.0}), InvalidArgument);
  EXPECT_THROW(require_physical(Moments<double>{.axial = 1.0, .transverse = nan}), InvalidArgument);
}

TEST(Tensor, TinyAndHugeBodiesHavePrincipalAxes) {
  for (const double scale : {1e-200, 1e-20, 1e20, 1e200}) {
    const PrincipalAxes<double> axes =
        principal_axes(Mat3<double>(Vec3<double>(1.0 * scale, 2.0 * scale, 2.5 * scale).asDiagonal()));
    EXPECT_DOUBLE_EQ(axes.moments[0], scale);
    EXPECT_DOUBLE_EQ(axes.moments[2], 2.5 * scale);
  }
}

}  // namespace
