/// The board: dimensions, lines, star points, regions, rays.

#include <gtest/gtest.h>

#include <algorithm>
#include <goishi/board/board.hpp>
#include <goishi/board/ray.hpp>
#include <set>
#include <utility>

#include "tests/contact_test.hpp"

namespace goishi::contact_test {

namespace {

// --- dimensions

TEST(Board, TheRealOneHas19Lines) {
  // 424.2 × 454.5 × 151.5 mm.
  const Board<double> real = make_board<double>();
  EXPECT_EQ(real.lines, 19);
  EXPECT_DOUBLE_EQ(2 * real.half_width, 0.4242);
  EXPECT_DOUBLE_EQ(2 * real.half_length, 0.4545);
  EXPECT_DOUBLE_EQ(real.thickness, 0.1515);
  EXPECT_DOUBLE_EQ(real.floor, -0.1515);
  EXPECT_DOUBLE_EQ(static_cast<double>(2 * make_board<long double>().half_width), 0.4242);
}

TEST(Board, OfOtherSizes) {
  const Board<double> nine = make_board<double>({.lines = 9, .legs = 0.1});
  EXPECT_DOUBLE_EQ(2 * nine.half_width, 8 * 0.022 + 2 * 0.0141);
  EXPECT_DOUBLE_EQ(2 * nine.half_length, 8 * 0.0237 + 2 * 0.01395);
  EXPECT_DOUBLE_EQ(nine.floor, -0.2515);
  const Board<double> one = make_board<double>({.lines = 1});
  EXPECT_DOUBLE_EQ(one.half_width, 0.0141);
  EXPECT_DOUBLE_EQ(make_board<double>({.lines = 2, .border_x = 0.0}).half_width, 0.011);
}

TEST(Board, TheTalksIsTheDefault) {
  const BoardDimensions<double> none, talk = board_dimensions<double>(Standard::talk);
  for (double BoardDimensions<double>::*length :
       {&BoardDimensions<double>::spacing_x, &BoardDimensions<double>::spacing_y, &BoardDimensions<double>::border_x,
        &BoardDimensions<double>::border_y, &BoardDimensions<double>::thickness, &BoardDimensions<double>::legs}) {
    EXPECT_EQ(none.*length, talk.*length);
  }
  EXPECT_EQ(none.lines, talk.lines);
  // As they were typed, to the bit.
  EXPECT_EQ(none.spacing_x, 22.0 / 1000.0);
  EXPECT_EQ(none.spacing_y, 237.0 / 10000.0);
  EXPECT_EQ(none.border_x, 141.0 / 10000.0);
  EXPECT_EQ(none.border_y, 1395.0 / 100000.0);
  EXPECT_EQ(none.thickness, 1515.0 / 10000.0);
  EXPECT_EQ(none.legs, 0.0);
  EXPECT_EQ(BoardDimensions<float>{}.spacing_y, 237.0F / 10000.0F);
  // With other numbers of lines only the number changes.
  const BoardDimensions<double> thirteen = board_dimensions<double>(Standard::talk, 13);
  EXPECT_EQ(thirteen.lines, 13);
  EXPECT_EQ(thirteen.border_x, talk.border_x);
  EXPECT_EQ(thirteen.border_y, talk.border_y);
}

TEST(Board, TheNihonKiinsHasRoomForTwoBlackStones) {
  const BoardDimensions<double> nihon_kiin = board_dimensions<double>(Standard::nihon_kiin);
  EXPECT_EQ(nihon_kiin.spacing_x, 0.02233);
  EXPECT_EQ(nihon_kiin.spacing_y, 0.02392);
  EXPECT_EQ(nihon_kiin.border_x, 0.0112);
  EXPECT_EQ(nihon_kiin.border_y, 0.012);
  EXPECT_EQ(nihon_kiin.thickness, 0.1515);
  const Board<double> board = make_board(nihon_kiin);
  EXPECT_DOUBLE_EQ(2 * board.half_width, 0.42434);
  EXPECT_DOUBLE_EQ(2 * board.half_length, 0.45456);
  EXPECT_DOUBLE_EQ(make_board(board_dimensions<double>(Standard::nihon_kiin, 9)).half_width, 4 * 0.02233 + 0.0112);
}

TEST(Board, TheNihonKiinsWith13LinesKeepsItsSpacing) {
  const BoardDimensions<double> thirteen = board_dimensions<double>(Standard::nihon_kiin, 13);
  EXPECT_EQ(thirteen.spacing_x, 0.02233);
  EXPECT_EQ(thirteen.border_x, 0.01102);
  EXPECT_EQ(thirteen.border_y, 0.01398);
  const Board<double> board = make_board(thirteen);
  EXPECT_EQ(board.lines, 13);
  EXPECT_DOUBLE_EQ(2 * board.half_width, 0.29);
  EXPECT_DOUBLE_EQ(2 * board.half_length, 0.315);
}

TEST(Board, OneForTheFloorIsThickerAndHasLegs) {
  for (const Standard standard : standards) {
    const BoardDimensions<double> dimensions = board_dimensions<double>(standard);
    const Board<double> lower = make_board(floor_board(dimensions));
    EXPECT_EQ(lower.thickness, 0.182);
    EXPECT_DOUBLE_EQ(lower.floor, -0.297);
    EXPECT_DOUBLE_EQ(make_board(floor_board(dimensions, boards::long_legs)).floor, -0.302);
    EXPECT_EQ(lower.half_width, make_board(dimensions).half_width);
  }
}

TEST(Board, IntersectionsAreCentred) {
  const Board<double> real = make_board<double>();
  expect_near(intersection(real, 0, 0), {-0.198, -0.2133, 0.0}, 1e-16);
  expect_near(intersection(real, 18, 0), {0.198, -0.2133, 0.0}, 1e-16);
  EXPECT_EQ(intersection(real, 9, 9), Vec3<double>(0.0, 0.0, 0.0));
  expect_near(intersection(real, 3, 15), {-0.132, 0.1422, 0.0}, 1e-16);
  expect_near(intersection(make_board<double>({.lines = 2}), 1, 0), {0.011, -0.01185, 0.0}, 1e-17);
}

TEST(Board, StarPoints) {
  using Points = std::set<std::pair<int, int>>;
  const auto stars = [](int lines) {
    const auto points = star_points(make_board<double>({.lines = lines}));
    EXPECT_EQ(Points(points.begin(), points.end()).size(), points.size());
    return Points(points.begin(), points.end());
  };
  EXPECT_EQ(stars(9), (Points{{2, 2}, {2, 6}, {6, 2}, {6, 6}, {4, 4}}));
  EXPECT_EQ(stars(13), (Points{{3, 3}, {3, 9}, {9, 3}, {9, 9}, {6, 6}}));
  EXPECT_EQ(stars(19), (Points{{3, 3}, {3, 9}, {3, 15}, {9, 3}, {9, 9}, {9, 15}, {15, 3}, {15, 9}, {15, 15}}));
  EXPECT_EQ(stars(5), (Points{{2, 2}}));
  EXPECT_EQ(stars(10), Points{});
}

// --- regions

TEST(Region, TheNineOfTheTalk) {
  const Board<double> wood = board();
  const auto at = [&](double x, double y) { return region_of(wood, {x, y, 0.0}, 4.0); };
  EXPECT_EQ(at(0, 0), Region::primary);
  EXPECT_EQ(at(-48, 0), Region::left);
  EXPECT_EQ(at(48, 0), Region::right);
  EXPECT_EQ(at(0, -58), Region::bottom);
  EXPECT_EQ(at(0, 58), Region::top);
  EXPECT_EQ(at(-48, -58), Region::bottom_left);
  EXPECT_EQ(at(48, -58), Region::bottom_right);
  EXPECT_EQ(at(-48, 58), Region::top_left);
  EXPECT_EQ(at(48, 58), Region::top_right);
}

TEST(Region, BordersAreAReachAway) {
  const Board<double> wood = board();
  const auto at = [&](double x, double y, double z) { return region_of(wood, {x, y, z}, 4.0); };
  EXPECT_EQ(at(46, 0, 0), Region::primary);
  EXPECT_EQ(at(46.001, 0, 0), Region::right);
  EXPECT_EQ(at(54, 0, 0), Region::right);
  EXPECT_EQ(at(54.001, 0, 0), Region::out_of_reach);
  EXPECT_EQ(at(-54.001, 0, 0), Region::out_of_reach);
  EXPECT_EQ(at(0, 56.001, 0), Region::top);
  EXPECT_EQ(at(0, 64.001, 0), Region::out_of_reach);
  EXPECT_EQ(at(0, -64.001, 0), Region::out_of_reach);
  EXPECT_EQ(at(0, 0, 4), Region::primary);
  EXPECT_EQ(at(0, 0, 4.001), Region::out_of_reach);
  EXPECT_EQ(at(0, 0, -1000), Region::primary);  // without a bottom
}

TEST(Region, EachHasAName) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Region::out_of_reach); ++i) {
    names.insert(to_string(static_cast<Region>(i)));
  }
  EXPECT_EQ(names.size(), 10U);
  EXPECT_EQ(to_string(Region::top_left), "top-left corner");
}

// --- rays

template <class T>
class BoardRay : public testing::Test {};
TYPED_TEST_SUITE(BoardRay, Scalars);

TYPED_TEST(BoardRay, HitsEachOfTheSixFaces) {
  using T = TypeParam;
  // From 7 before the face at (1, 2, −3), or wherever it is on it; the board is `length` thick there.
  struct Case {
    Vec3<T> from, along, hit;
    BoardFace face;
    T length;
  };
  const Case cases[] = {
      {vec<T>(1, 2, 7), vec<T>(0, 0, -1), vec<T>(1, 2, 0), BoardFace::surface, T(30)},
      {vec<T>(1, 2, -37), vec<T>(0, 0, 1), vec<T>(1, 2, -30), BoardFace::underside, T(30)},
      {vec<T>(-57, 2, -3), vec<T>(1, 0, 0), vec<T>(-50, 2, -3), BoardFace::left, T(100)},
      {vec<T>(57, 2, -3), vec<T>(-1, 0, 0), vec<T>(50, 2, -3), BoardFace::right, T(100)},
      {vec<T>(1, -67, -3), vec<T>(0, 1, 0), vec<T>(1, -60, -3), BoardFace::bottom, T(120)},
      {vec<T>(1, 67, -3), vec<T>(0, -1, 0), vec<T>(1, 60, -3), BoardFace::top, T(120)},
  };
  for (const Case& one : cases) {
    const BoardRayHit<T> ray = cast_ray(board<T>(), one.from, one.along);
    EXPECT_TRUE(ray.hit && ray.forward);
    EXPECT_EQ(ray.entry, T(7));
    EXPECT_EQ(ray.exit, T(7) + one.length);
    EXPECT_EQ(ray.first, ray.entry);
    EXPECT_EQ(ray.p_W, one.hit);
    EXPECT_EQ(ray.n_W, Vec3<T>(-one.along));
    EXPECT_EQ(ray.face, one.face) << to_string(ray.face);
    // From inside, backwards: it leaves through the same face.
    const BoardRayHit<T> out = cast_ray(board<T>(), Vec3<T>(one.hit + one.along), Vec3<T>(-one.along));
    EXPECT_TRUE(out.hit && out.forward);
    EXPECT_EQ(out.first, out.exit);
    EXPECT_EQ(out.exit, T(1));
    EXPECT_EQ(out.entry, T(1) - one.length);
    EXPECT_EQ(out.p_W, one.hit);
    EXPECT_EQ(out.n_W, Vec3<T>(-one.along));
    EXPECT_EQ(out.face, one.face);
    // Away from it: the board lies behind.
    const BoardRayHit<T> away = cast_ray(board<T>(), one.from, Vec3<T>(-one.along));
    EXPECT_TRUE(away.hit);
    EXPECT_FALSE(away.forward);
    EXPECT_EQ(away.exit, T(-7));
    EXPECT_TRUE(std::isnan(away.first));
  }
}

TYPED_TEST(BoardRay, SlantingThroughTwoFaces) {
  using T = TypeParam;
  // Down by 4 for 3 to the right: to the surface at (43, 0, 0), out of the right side at (50, 0, −28/3).
  const BoardRayHit<T> ray = cast_ray(board<T>(), vec<T>(40, 0, 4), Vec3<T>(T(3) / T(5), T(0), T(-4) / T(5)));
  const T close = T(8) * std::numeric_limits<T>::epsilon();
  EXPECT_TRUE(ray.hit && ray.forward);
  expect_near(ray.entry, T(5), T(5) * close);
  expect_near(ray.exit, T(50) / T(3), T(17) * close);
  expect_near(ray.p_W, vec<T>(43, 0, 0), T(43) * close);
  EXPECT_EQ(ray.p_W.z(), T(0));
  EXPECT_EQ(ray.face, BoardFace::surface);
}

TYPED_TEST(BoardRay, WhatMissesAndWhatTouches) {
  using T = TypeParam;
  const auto hits = [](const Vec3<T>& p, const Vec3<T>& u) { return cast_ray(board<T>(), p, u).hit; };
  EXPECT_FALSE(hits(vec<T>(0, 0, 0.001), vec<T>(1, 0, 0)));
  EXPECT_FALSE(hits(vec<T>(0, 0, -30.001), vec<T>(0, 1, 0)));
  EXPECT_FALSE(hits(vec<T>(50.001, 0, 9), vec<T>(0, 0, -1)));
  EXPECT_FALSE(hits(vec<T>(0, -60.001, 9), vec<T>(0, 0, -1)));
  // At the surface's height 0.1 beside it, or on it.
  EXPECT_FALSE(hits(vec<T>(47.1L, 0, 4), Vec3<T>(T(3) / T(5), T(0), T(-4) / T(5))));
  EXPECT_TRUE(hits(vec<T>(46.9L, 0, 4), Vec3<T>(T(3) / T(5), T(0), T(-4) / T(5))));
  EXPECT_TRUE(hits(vec<T>(0, 0, 0), vec<T>(1, 0, 0)));  // within the surface
  EXPECT_TRUE(hits(vec<T>(50, 60, 9), vec<T>(0, 0, -1)));
}

// --- errors of the caller

TEST(BoardBadInput, Dimensions) {
  for (const int lines : {0, -1}) {
    expect_invalid("lines", [&] { (void)make_board<double>({.lines = lines}); });
  }
  using Member = double BoardDimensions<double>::*;
  const std::pair<const char*, Member> positive[] = {{"spacing_x", &BoardDimensions<double>::spacing_x},
                                                     {"spacing_y", &BoardDimensions<double>::spacing_y},
                                                     {"thickness", &BoardDimensions<double>::thickness}};
  const std::pair<const char*, Member> not_negative[] = {{"border_x", &BoardDimensions<double>::border_x},
                                                         {"border_y", &BoardDimensions<double>::border_y},
                                                         {"legs", &BoardDimensions<double>::legs}};
  const auto expect_refused = [](const char* argument, Member member, double value) {
    BoardDimensions<double> dimensions;
    dimensions.*member = value;
    expect_invalid(argument, [&] { (void)make_board(dimensions); });
  };
  for (const auto& [argument, member] : positive) {
    for (const double value : {0.0, -1.0, nan, infinity}) {
      expect_refused(argument, member, value);
    }
  }
  for (const auto& [argument, member] : not_negative) {
    for (const double value : {-1e-9, nan, infinity}) {
      expect_refused(argument, member, value);
    }
  }
  expect_invalid("border_x", [] { (void)make_board<double>({.lines = 1, .border_x = 0.0}); });
  expect_invalid("border_y", [] { (void)make_board<double>({.lines = 1, .border_y = 0.0}); });
}

TEST(BoardBadInput, Standards) {
  expect_invalid("standard", [] { (void)board_dimensions<double>(static_cast<Standard>(2)); });
  expect_invalid("lines", [] { (void)make_board(board_dimensions<double>(Standard::nihon_kiin, 0)); });
  expect_invalid("legs", [] { (void)make_board(floor_board(board_dimensions<double>(Standard::talk), -1)); });
}

TEST(BoardBadInput, Intersections) {
  const Board<double> real = make_board<double>();
  for (const int line : {-1, 19}) {
    expect_invalid("i", [&] { (void)intersection(real, line, 0); });
    expect_invalid("j", [&] { (void)intersection(real, 0, line); });
  }
}

TEST(BoardBadInput, Rays) {
  const Vec3<double> up(0.0, 0.0, 1.0);
  with_each_bad(up,
                [&](const Vec3<double>& bad) { expect_invalid("start", [&] { (void)cast_ray(board(), bad, up); }); });
  with_each_bad_direction(
      [&](const Vec3<double>& bad) { expect_invalid("direction", [&] { (void)cast_ray(board(), up, bad); }); });
}

}  // namespace
}  // namespace goishi::contact_test
