/// No query asks for memory.

#include <gtest/gtest.h>

#include <goishi/board/ray.hpp>
#include <goishi/contact/batch_plane.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/published/separating_axis.hpp>
#include <goishi/shape/ray.hpp>
#include <random>
#include <vector>

#include "tests/allocations.hpp"
#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

TEST(ContactMemory, NoQueryAllocates) {
  const Stone<double> stones[] = {sharp(), bevelled()};
  const Board<double> wood = board();
  std::vector<Pose<double>> poses;
  std::mt19937 bits(20261121);
  const auto some = [&bits](double size) { return size * (static_cast<double>(bits()) / 0x1p31 - 1.0); };
  for (int i = 0; i < 300; ++i) {
    poses.push_back({.p_WB = {50 + some(6), 60 + some(6), some(6)},
                     .q_WB = Quat<double>(some(1), some(1), some(1), some(1)).normalized()});
  }
  PlaneBatch<double> batch(poses.size());
  std::vector<double> gaps(poses.size());
  double sum = 0.0;
  const long before = test::allocations();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose<double>& pose = poses[i];
    const Pose<double>& other = poses[poses.size() - 1 - i];
    const Vec3<double> u = pose.q_WB * Vec3<double>(0.0, 0.0, 1.0);
    for (const Stone<double>& stone : stones) {
      sum += separation(stone, pose, Plane<double>{}).gap + surface_gap(stone, pose);
      sum += separation(stone, pose, wood).gap + separation(stone, pose, sharp(), other).gap;
      sum += separating_axis_published(stone, pose, wood).colliding ? 1.0 : 0.0;
      sum += support(stone, u).value + closest_point(stone, u).distance;
      sum += cast_ray(stone, pose.p_WB, u).hit ? 1.0 : 0.0;
      sum += cast_ray(wood, pose.p_WB, u).hit ? 1.0 : 0.0;
      const FlightPath<double> path{.p_W = pose.p_WB + Vec3<double>(0.0, 0.0, 12.0),
                                    .v_W = {0.0, 0.0, -1.0},
                                    .a_W = {0.0, 0.0, -10.0},
                                    .u_W = u / u.norm(),
                                    .k_W = {0.6, 0.0, 0.8},
                                    .rate = 20.0};
      FlightPath<double> still = path;
      still.p_W = other.p_WB;
      still.v_W = still.a_W = Vec3<double>::Zero();
      sum += time_of_impact(stone, path, Plane<double>{}, 9.0).time + time_of_impact(stone, path, wood, 9.0).time;
      sum += time_of_impact(stone, path, sharp(), still, 9.0).time;
    }
    batch.set(i, stones[i % 2], pose);
  }
  batch.gaps({}, gaps);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_TRUE(std::isfinite(sum));
  const std::vector<int> something(1);
  EXPECT_EQ(test::allocations(), before + 1) << "the count does not count";
}

}  // namespace
}  // namespace goishi::contact_test
