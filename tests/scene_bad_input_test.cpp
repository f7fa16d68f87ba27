/// What a scene refuses, and that it is then as it was.

#include "tests/expectations.hpp"
#include "tests/scene_test.hpp"

namespace goishi::scene_test {

namespace {

using test::infinity, test::nan;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(SceneBadInput, OverlapsAreRefusedByNumberAndDepth) {
  const Kind kind;
  Scene<double> scene(make_board<double>());
  scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  const std::string stones = refusal([&] { scene.add(kind.stone, kind.body, lying(0.0217, 0, 0.0046)); });
  EXPECT_TRUE(test::contains(stones, "overlaps stone 0")) << stones;
  const Pose<double> one{{0, 0, 0.0046}, {1, 0, 0, 0}}, two{{0.0217, 0, 0.0046}, {1, 0, 0, 0}};
  const double depth = -separation(kind.stone, one, kind.stone, two).gap;
  EXPECT_TRUE(test::contains(stones, detail::written(depth, 6) + " m deep")) << stones;
  const std::string board = refusal([&] { scene.add(kind.stone, kind.body, lying(0.1, 0, 0.004)); });
  EXPECT_TRUE(test::contains(board, "overlaps the board")) << board;
  EXPECT_TRUE(test::contains(board, "0.0006 m deep")) << board;
  EXPECT_EQ(scene.stones().size(), 1U);
  scene.add(kind.stone, kind.body, lying(0.022, 0, 0.0046));  // touching is in order
}

TEST(SceneBadInput, WhatIsNoNumberOrOutOfRange) {
  const Kind kind;
  Scene<double> scene(make_board<double>());
  const StoneId id = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  EXPECT_THROW(scene.add(kind.stone, kind.body, lying(nan, 0, 1)), InvalidArgument);
  EXPECT_THROW(scene.add(kind.stone, kind.body, lying(0, 0, infinity)), InvalidArgument);
  for (const double dt : {0.0, -1.0, nan, infinity}) {
    EXPECT_THROW(scene.advance(dt), InvalidArgument) << dt;
    EXPECT_THROW(static_cast<void>(scene.run_until_rest(dt)), InvalidArgument) << dt;
    EXPECT_THROW(scene.hold(id, {0, 0, 1}, {0, 0, 0}, dt), InvalidArgument) << dt;
  }
  EXPECT_THROW(scene.advance_to(nan), InvalidArgument);
  EXPECT_THROW(scene.apply_impulse(id, {0, 0, 0}, {nan, 0, 0}), InvalidArgument);
  EXPECT_THROW(scene.hold(id, {nan, 0, 0}, {0, 0, 0}, 1), InvalidArgument);
  EXPECT_THROW(scene.hold(id, {0, 0, 0}, {0, infinity, 0}, 1), InvalidArgument);
  SceneSettings<double> settings;
  settings.restitution = 1.5;
  EXPECT_THROW(scene.change(settings), InvalidArgument);
  EXPECT_THROW(Scene<double>(make_board<double>(), settings), InvalidArgument);
  for (const double value : {0.0, -1.0, nan}) {
    settings = {};
    settings.step = value;
    EXPECT_THROW(scene.change(settings), InvalidArgument) << value;
    settings = {};
    settings.solver_tolerance = value;
    EXPECT_THROW(scene.change(settings), InvalidArgument) << value;
    settings = {};
    settings.clearance = value;
    EXPECT_THROW(scene.change(settings), InvalidArgument) << value;
  }
  EXPECT_EQ(scene.time(), 0.0);
  EXPECT_TRUE(same(scene.state(id), lying(0, 0, 0.0046)));
}

TEST(SceneBadInput, UnknownStones) {
  const Kind kind;
  Scene<double> scene(make_board<double>());
  const StoneId gone = scene.add(kind.stone, kind.body, lying(0, 0, 0.0046));
  scene.add(kind.stone, kind.body, lying(0.1, 0, 0.0046));
  scene.remove(gone);
  for (const StoneId id : {gone, StoneId(2)}) {
    EXPECT_FALSE(scene.has(id));
    EXPECT_THROW(static_cast<void>(scene.state(id)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(scene.mode(id)), InvalidArgument);
    EXPECT_THROW(scene.remove(id), InvalidArgument);
    EXPECT_THROW(scene.apply_impulse(id, {0, 0, 0}, {0, 0, 0}), InvalidArgument);
    EXPECT_THROW(scene.hold(id, {0, 0, 0}, {0, 0, 0}, 1), InvalidArgument);
  }
  EXPECT_EQ(scene.stones().size(), 1U);
  EXPECT_THROW(scene.release(StoneId(1)), InvalidArgument);  // nobody holds it
}

TEST(SceneBadInput, AHandStaysOutOfTheBoard) {
  const Kind kind;
  Scene<double> scene(make_board<double>());
  const StoneId id = scene.add(kind.stone, kind.body, lying(0, 0, 0.0096));
  EXPECT_THROW(scene.hold(id, {0, 0, -0.1}, {0, 0, 0}, 0.06), InvalidArgument);
  EXPECT_EQ(scene.mode(id), StoneMode::flight);
  scene.hold(id, {0, 0, -0.1}, {0, 0, 0}, 0.04);
  EXPECT_EQ(scene.mode(id), StoneMode::held);
  EXPECT_THROW(scene.apply_impulse(id, {0, 0, 0}, {0, 0, 0}), InvalidArgument);
}

}  // namespace

}  // namespace goishi::scene_test
