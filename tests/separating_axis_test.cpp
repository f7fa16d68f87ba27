/// The talk's test as published: its axes, and where it is wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <goishi/contact/stone_board.hpp>
#include <goishi/published/separating_axis.hpp>
#include <numbers>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

TEST(PublishedTest, HasTheAxesOfEachRegion) {
  const auto axes = [](Region region) { return detail::published_axes<double>(region).count; };
  EXPECT_EQ(axes(Region::primary), 1U);
  for (const Region side : {Region::left, Region::right, Region::bottom, Region::top}) {
    EXPECT_EQ(axes(side), 3U);
  }
  for (const Region corner : {Region::bottom_left, Region::bottom_right, Region::top_left, Region::top_right}) {
    EXPECT_EQ(axes(corner), 7U);
  }
  const Vec3<double> corner = detail::published_axes<double>(Region::bottom_right).axes[6];
  expect_near(corner, Vec3<double>(Vec3<double>(1.0, -1.0, 1.0) / std::numbers::sqrt3), 1e-15);
}

/// The list has the depth along each axis: those that the test goes through, and chooses the least and the most of.
TEST(PublishedTest, ListsItsAxes) {
  const Pose<double> corner = lying<double>(52.5L, -62.25L, 0.5L);
  const auto axes = published_axes(sharp(), corner, board());
  ASSERT_EQ(axes.size(), 7U);
  const auto less = [](const auto& a, const auto& b) { return a.depth < b.depth; };
  const auto [least, most] = std::minmax_element(axes.begin(), axes.end(), less);
  const auto chosen = separating_axis_published(sharp(), corner, board());
  EXPECT_TRUE(chosen.colliding);
  EXPECT_EQ(chosen.axis_W, least->axis_W);
  EXPECT_EQ(chosen.depth, least->depth);
  EXPECT_EQ(separating_axis_published(sharp(), corner, board(), PushOut::most_penetration).depth, most->depth);
  EXPECT_EQ(axes[0].axis_W, Vec3<double>(0.0, 0.0, 1.0));
  EXPECT_NEAR(axes[0].depth, 1.5, 1e-13);
  const auto over = published_axes(sharp(), lying<double>(1, 2, 2.5L), board());
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over[0].depth, -0.5);
  EXPECT_TRUE(published_axes(sharp(), lying<double>(1, 2, 4.5L), board()).empty());
}

TEST(PublishedTest, IsRightOverTheSurface) {
  const auto at = [](double z) { return separating_axis_published(sharp(), lying<double>(1, 2, z), board()); };
  EXPECT_TRUE(at(1.5).colliding);
  EXPECT_EQ(at(1.5).depth, 0.5);
  EXPECT_EQ(at(1.5).axis_W, Vec3<double>(0.0, 0.0, 1.0));
  EXPECT_TRUE(at(2.0).colliding);
  EXPECT_FALSE(at(2.5).colliding);
  EXPECT_EQ(at(2.5).depth, -0.5);
  EXPECT_EQ(at(4.5).region, Region::out_of_reach);
  EXPECT_FALSE(at(4.5).colliding);
  EXPECT_TRUE(std::isnan(at(4.5).depth));
}

TEST(PublishedTest, CallsAGapAtAnEdgeACollision) {
  // 5.02 from the edge to the centre of the cap's sphere: a gap of 0.02 along (3, 0, 4)/5.
  const Pose<double> apart = lying<double>(53.012L, 7, 1.016L);
  EXPECT_NEAR(separation(sharp(), apart, board()).gap, 0.02, 1e-12);
  // Along 45°: r − 5.02 · 7 √½ / 5.
  const double along_45 = 5 - 5.02 * 7 * std::numbers::sqrt2 / 10;
  const auto least = separating_axis_published(sharp(), apart, board());
  EXPECT_TRUE(least.colliding);
  EXPECT_EQ(least.region, Region::right);
  EXPECT_NEAR(least.depth, along_45, 1e-13);
  expect_near(least.axis_W, Vec3<double>(std::numbers::sqrt2 / 2, 0.0, std::numbers::sqrt2 / 2), 1e-15);
  const auto most = separating_axis_published(sharp(), apart, board(), PushOut::most_penetration);
  EXPECT_NEAR(most.depth, 4 - 3.012, 1e-13);
  EXPECT_EQ(most.axis_W, Vec3<double>(1.0, 0.0, 0.0));
  const auto up = separating_axis_published(sharp(), apart, board(), PushOut::preferred);
  EXPECT_NEAR(up.depth, 2 - 1.016, 1e-13);
  EXPECT_EQ(up.axis_W, Vec3<double>(0.0, 0.0, 1.0));
  // Of axes that are equally in line with the preferred direction, the last.
  const auto along =
      separating_axis_published(sharp(), apart, board(), PushOut::preferred, Vec3<double>(0.0, 1.0, 0.0));
  EXPECT_EQ(along.axis_W, least.axis_W);
  // The same at the top side.
  const auto top = separating_axis_published(sharp(), lying<double>(7, 63.012L, 1.016L), board());
  EXPECT_TRUE(top.colliding);
  EXPECT_EQ(top.region, Region::top);
  EXPECT_NEAR(top.depth, along_45, 1e-13);
  // Far enough for the 45° axis to separate.
  EXPECT_FALSE(separating_axis_published(sharp(), lying<double>(53.06L, 7, 1.08L), board()).colliding);
}

TEST(PublishedTest, PushesOutFartherThanTheDepth) {
  const Pose<double> pose = lying<double>(52.97L, 7, 0.96L);  // 4.95 of 5: 0.05 deep
  EXPECT_NEAR(separation(sharp(), pose, board()).gap, -0.05, 1e-12);
  EXPECT_NEAR(separating_axis_published(sharp(), pose, board()).depth, 5 - 4.95 * 7 * std::numbers::sqrt2 / 10, 1e-13);
  EXPECT_NEAR(separating_axis_published(sharp(), pose, board(), PushOut::preferred).depth, 1.04, 1e-13);
}

TEST(PublishedTestBadInput, IsRefused) {
  expect_bad_poses_refused([](const Pose<double>& bad) { (void)separating_axis_published(sharp(), bad, board()); });
  with_each_bad_direction([&](const Vec3<double>& bad) {
    const Pose<double> good = lying<double>(1, 2, 3);
    expect_invalid("preferred",
                   [&] { (void)separating_axis_published(sharp(), good, board(), PushOut::preferred, bad); });
  });
}

}  // namespace
}  // namespace goishi::contact_test
