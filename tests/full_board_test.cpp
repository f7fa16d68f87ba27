#include <gtest/gtest.h>

#include "compiled/scene.hpp"
#include "verify/bench/rivals/full_board.hpp"

namespace goishi::full_board_test {

using verify::bench::rivals::FullBoard;

/// What the figures of the scene are measured on is this, and no other.
TEST(FullBoard, ComesToRestWithTheEnergyThatItsFiguresAreOf) {
  const FullBoard full = verify::bench::rivals::make_full_board();
  ASSERT_EQ(full.starts.size(), 361u);
  Scene<double> scene(full.board, verify::bench::rivals::full_board_settings(1.0 / 480));
  for (const State<double>& start : full.starts) {
    scene.add(full.stone, full.body, start);  // throws where stones overlap
  }
  // Of the numbers drawn, measured 2026-11-30.
  double upright = 0;
  for (const State<double>& start : full.starts) {
    upright += formula::symmetry_axis(start.q_WB).z();
  }
  EXPECT_NEAR(scene.energy(), 0.367582652532692, 1e-14);
  EXPECT_NEAR(upright, 355.6431414280981, 1e-11);
  EXPECT_TRUE(scene.run_until_rest(3.0));
  EXPECT_NEAR(scene.energy(), 0.0848, 5e-5);  // [J]; the finest steps have 0.08480. All flat: 0.08438
  for (const StoneId id : scene.stones()) {
    EXPECT_GT(scene.state(id).p_WB.z(), 0.0);
  }
}

}  // namespace goishi::full_board_test
