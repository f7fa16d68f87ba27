#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <goishi/shape/catalogue.hpp>
#include <goishi/shape/stone.hpp>
#include <limits>
#include <set>
#include <string>
#include <type_traits>

#include "tests/expectations.hpp"

namespace {

using namespace goishi;

using test::infinity;
using test::nan;

/// A bad call throws InvalidArgument that names the argument, and says its value and rule in one line.
template <class Call>
void expect_refused(Call&& call, const std::string& argument, const std::string& what) {
  try {
    call();
    ADD_FAILURE() << "accepted: " << what;
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.argument(), argument);
    EXPECT_EQ(error.what(), what);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Stone, IsNanUntilMade) {
  const Stone<double> stone;
  EXPECT_TRUE(std::isnan(stone.width));
  EXPECT_TRUE(std::isnan(stone.joint_sine));
}

// Integers have another division: they are no field, and count as the scalar that stands beside them.
static_assert(!Field<int> && !Field<long> && !Ordered<unsigned> && Ordered<float> && Ordered<long double>);
static_assert(std::is_same_v<decltype(make_stone(22, 9)), Stone<double>>);
static_assert(std::is_same_v<decltype(make_stone(22, 9, 1)), Stone<double>>);
static_assert(std::is_same_v<decltype(make_stone(0.022, 0, 1)), Stone<double>>);
static_assert(std::is_same_v<decltype(make_stone(1, 0.5F)), Stone<float>>);
static_assert(std::is_same_v<decltype(make_stone(0.5L, 0.5L, 0)), Stone<long double>>);
static_assert(std::is_same_v<decltype(make_measured_stone(22, 9.5, 1L)), Stone<double>>);
static_assert(std::is_same_v<decltype(make_stone(catalogue_stone(33, StoneColor::white), 0)), Stone<double>>);

template <class... Ts>
concept MakesStone = requires(Ts... lengths) {
  make_stone(lengths...);
};
static_assert(MakesStone<double, double> && MakesStone<int, float, long> && !MakesStone<double, float>);
static_assert(!MakesStone<int, double, float>);

TEST(Stone, OfWholeNumbers) {
  EXPECT_DOUBLE_EQ(make_stone(22, 9).sphere_radius, 565.0 / 36.0);
  EXPECT_EQ(make_stone(22, 9, 1).bevel_minor_radius, make_stone(22.0, 9.0, 1.0).bevel_minor_radius);
  EXPECT_EQ(make_measured_stone(22, 9, 1).width, make_measured_stone(22.0, 9.0, 1.0).width);
  EXPECT_EQ(make_stone(2, 1.5F).sphere_radius, make_stone(2.0F, 1.5F).sphere_radius);
  expect_refused([] { (void)make_stone(0.022, 0, 1); }, "height", "height = 0: must be positive and finite");
  expect_refused([] { (void)make_stone(9, 22); }, "height", "height = 22: must not exceed the width (9)");
}

/// From 1e-145 m to 1e152 m (float: 1e-15 to 1e17), and no farther.
TEST(Stone, OfAnySize) {
  for (const double size : {1e-144, 1e-50, 1.0, 1e50, 1e150}) {
    const Stone<double> stone = make_stone(22.0 * size, 9.0 * size, size);
    EXPECT_NEAR(stone.sphere_radius / size, 565.0 / 36.0, 1e-14);
    EXPECT_NEAR(stone.joint_sine, make_stone(22.0, 9.0, 1.0).joint_sine, 1e-15);
  }
  for (const double size : {1e-150, 5e-324, 1e154, 1e308}) {
    EXPECT_THROW((void)make_stone(size, size), InvalidArgument) << size;
    EXPECT_THROW((void)make_measured_stone(size, size, 0.0), InvalidArgument) << size;
  }
  EXPECT_THROW((void)make_stone(1e100, 1e-100), InvalidArgument);  // r = 2.5e299
  EXPECT_THROW((void)make_stone(1e-18F, 1e-18F), InvalidArgument);
  EXPECT_NO_THROW((void)make_stone(1e-7F, 4e-8F));
}

TEST(Stone, OfThePublishedExample) {
  // 22 × 9.2 mm by hand: r = (484 + 84.64)/36.8, d = r − 4.6.
  const Stone<double> stone = make_stone(22.0, 9.2);
  EXPECT_DOUBLE_EQ(stone.sphere_radius, 568.64 / 36.8);
  EXPECT_DOUBLE_EQ(stone.sphere_offset, (568.64 - 169.28) / 36.8);
  EXPECT_EQ(stone.bevel_major_radius, 11.0);
  EXPECT_EQ(stone.bevel_minor_radius, 0.0);
  EXPECT_EQ(outer_width(stone), 22.0);
}

TEST(Stone, BevelShrinksThePublishedAndNotTheMeasuredStone) {
  EXPECT_NEAR(outer_width(make_stone(22.0, 9.2, 1.0)), 21.40, 0.005);
  const Stone<double> measured = make_measured_stone(22.0, 9.2, 1.0);
  EXPECT_DOUBLE_EQ(outer_width(measured), 22.0);
  EXPECT_NEAR(measured.sphere_offset, 11.6102, 0.00005);
  EXPECT_NEAR(measured.sphere_radius, 16.2102, 0.00005);
  EXPECT_GT(measured.width, 22.0);
}

TEST(Stone, SharpIsTheSameBothWays) {
  const Stone<double> published = make_stone(22.0, 9.2);
  const Stone<double> measured = make_measured_stone(22.0, 9.2, 0.0);
  EXPECT_EQ(published.sphere_radius, measured.sphere_radius);
  EXPECT_EQ(published.width, measured.width);
}

TEST(Stone, BallSharpAndBevelled) {
  const Stone<double> sharp = make_stone(2.0, 2.0);
  EXPECT_EQ(sharp.sphere_radius, 1.0);
  EXPECT_EQ(sharp.sphere_offset, 0.0);
  EXPECT_EQ(sharp.bevel_minor_radius, 0.0);
  const Stone<double> bevelled = make_stone(2.0, 2.0, 0.5);
  EXPECT_EQ(bevelled.bevel_major_radius, 0.0);
  EXPECT_EQ(bevelled.bevel_minor_radius, 1.0);
  EXPECT_EQ(bevelled.core_sphere_radius, 0.0);
  EXPECT_EQ(outer_width(bevelled), 2.0);
}

TEST(Stone, RefusesWhatNoStoneHas) {
  const std::string positive = ": must be positive and finite";
  expect_refused([] { (void)make_stone(0.0, 0.01); }, "width", "width = 0" + positive);
  expect_refused([] { (void)make_stone(-0.022, 0.01); }, "width", "width = -0.022" + positive);
  expect_refused([] { (void)make_stone(nan, 0.01); }, "width", "width = nan" + positive);
  expect_refused([] { (void)make_stone(infinity, 0.01); }, "width", "width = inf" + positive);
  expect_refused([] { (void)make_stone(0.022, 0.0); }, "height", "height = 0" + positive);
  expect_refused([] { (void)make_stone(0.022, nan); }, "height", "height = nan" + positive);
  expect_refused([] { (void)make_stone(0.022, 0.03); }, "height", "height = 0.03: must not exceed the width (0.022)");
  const std::string rule = ": must be at least 0 and below the height (0.01)";
  expect_refused([] { (void)make_stone(0.022, 0.01, 0.01); }, "bevel", "bevel = 0.01" + rule);
  expect_refused([] { (void)make_stone(0.022, 0.01, 0.02); }, "bevel", "bevel = 0.02" + rule);
  expect_refused([] { (void)make_stone(0.022, 0.01, -0.001); }, "bevel", "bevel = -0.001" + rule);
  expect_refused([] { (void)make_stone(0.022, 0.01, nan); }, "bevel", "bevel = nan" + rule);
  expect_refused([] { (void)make_measured_stone(0.022, 0.03, 0.001); }, "height",
                 "height = 0.03: must not exceed the outer_width (0.022)");
  expect_refused([] { (void)make_measured_stone(nan, 0.03, 0.001); }, "outer_width", "outer_width = nan" + positive);
}

TEST(Stone, RefusesInFloatToo) {
  EXPECT_THROW((void)make_stone(0.022F, 0.03F), InvalidArgument);
  EXPECT_THROW((void)make_stone(std::numeric_limits<float>::quiet_NaN(), 0.03F), InvalidArgument);
}

/// RapidCheck shrinks whole numbers well: shapes on a grid.
struct Shape {
  double width, height, bevel;
};
Shape draw() {
  const double width = *rc::gen::inRange(1, 100001) * 1e-5;
  const double height = width * *rc::gen::inRange(1, 100001) * 1e-5;
  const double bevel = height * *rc::gen::inRange(0, 100000) * 1e-5;
  return {width, height, bevel};
}

RC_GTEST_PROP(Stone, CoreLensPlusBallTouchesTheSphere, ()) {
  const auto [w, h, b] = draw();
  const Stone<double> stone = make_stone(w, h, b);
  const double core = std::hypot(stone.sphere_offset, stone.bevel_major_radius);
  RC_ASSERT(std::fabs(core - stone.core_sphere_radius) <= 4e-16 * stone.sphere_radius);
  RC_ASSERT(stone.core_sphere_radius + stone.bevel_minor_radius <= stone.sphere_radius * (1 + 4e-16));
  RC_ASSERT(outer_width(stone) <= w * (1 + 4e-16));
}

RC_GTEST_PROP(Stone, MoreBevelIsNarrower, ()) {
  const auto [w, h, b] = draw();
  RC_ASSERT(outer_width(make_stone(w, h, b)) <= outer_width(make_stone(w, h, b / 2)) * (1 + 4e-16));
}

RC_GTEST_PROP(Stone, JointNormalIsAUnitVector, ()) {
  const auto [w, h, b] = draw();
  const Stone<double> stone = make_stone(w, h, b);
  RC_ASSERT(std::fabs(std::hypot(stone.joint_cosine, stone.joint_sine) - 1) <= 4e-16);
  RC_ASSERT(stone.joint_cosine > 0);
  RC_ASSERT(stone.joint_sine >= 0);
}

TEST(Catalogue, Has24SizesThatGrow) {
  ASSERT_EQ(catalogue::sizes.size(), 24U);
  for (std::size_t i = 1; i < catalogue::sizes.size(); ++i) {
    EXPECT_LT(catalogue::sizes[i - 1].number, catalogue::sizes[i].number);
    EXPECT_LT(catalogue::sizes[i - 1].white_height, catalogue::sizes[i].white_height);
  }
}

TEST(Catalogue, BlackIsThreeTenthsWiderAndSixTenthsThicker) {
  const CatalogueStone white = catalogue_stone(33, StoneColor::white);
  const CatalogueStone black = catalogue_stone(33, StoneColor::black);
  EXPECT_EQ(white.width, 22000);
  EXPECT_EQ(white.height, 9200);
  EXPECT_EQ(black.width - white.width, 300);
  EXPECT_EQ(black.height - white.height, 600);
  EXPECT_EQ(metres<double>(white.height), 0.0092);
}

TEST(Catalogue, TheNihonKiinsStonesAreATenthNarrower) {
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      const CatalogueStone talk = catalogue_stone(size.number, color);
      const CatalogueStone nihon_kiin = catalogue_stone(size.number, color, Standard::nihon_kiin);
      EXPECT_EQ(talk.standard, Standard::talk);
      EXPECT_EQ(nihon_kiin.standard, Standard::nihon_kiin);
      EXPECT_EQ(talk.width - nihon_kiin.width, 100);
      EXPECT_EQ(talk.height, nihon_kiin.height);
      EXPECT_EQ(talk.density, nihon_kiin.density);
    }
  }
  EXPECT_EQ(make_stone(catalogue_stone(33, StoneColor::black, Standard::nihon_kiin)).width, 0.0222);
}

TEST(Catalogue, GoesTo50InStepsOfThreeTenths) {
  for (int number = 33; number < 50; ++number) {
    EXPECT_EQ(catalogue_stone(number + 1, StoneColor::white).height,
              catalogue_stone(number, StoneColor::white).height + 300);
  }
  EXPECT_EQ(catalogue_stone(50, StoneColor::white).height, 14300);
  const Stone<double> thickest = make_stone(catalogue_stone(50, StoneColor::black, Standard::nihon_kiin));
  EXPECT_EQ(thickest.height, 0.0149);
  EXPECT_LT(thickest.height, thickest.width);
}

TEST(Catalogue, StandardsHaveNames) {
  for (const Standard standard : standards) {
    EXPECT_EQ(standard_named(to_string(standard)), standard);
  }
  EXPECT_EQ(standard_named("talk"), Standard::talk);
  EXPECT_EQ(standard_named("nihon-kiin"), Standard::nihon_kiin);
  for (const char* name : {"", "Talk", "nihon_kiin", "nihon-kiin ", "nihon"}) {
    EXPECT_EQ(standard_named(name), std::nullopt) << name;
  }
}

TEST(Catalogue, RefusesAnUnknownStandard) {
  expect_refused([] { (void)catalogue_stone(33, StoneColor::white, static_cast<Standard>(7)); }, "standard",
                 "standard = 7: must be one of `standards`");
}

TEST(Catalogue, RefusesAnUnknownSize) {
  expect_refused([] { (void)catalogue_stone(23, StoneColor::white); }, "size",
                 "size = 23: must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50");
}

}  // namespace
