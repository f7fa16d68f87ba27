#include "verify/reference/encounters.hpp"

#include <algorithm>
#include <string>

#include "verify/reference/draw.hpp"

namespace goishi::verify::reference {

namespace {

constexpr std::array<double, 3> falling = {0.0, 0.0, -9.80665};
constexpr std::array<double, 4> flat = {1.0, 0.0, 0.0, 0.0};
constexpr std::array<double, 4> on_edge = {1.0, 1.0, 1.0, 1.0};  // the axis along x

Encounter against_plane(const Shape& shape, const std::array<double, 3>& position,
                        const std::array<double, 4>& attitude, const std::string& about) {
  Encounter one;
  one.first = {.shape = shape, .position = position, .attitude = attitude};
  one.about = "plane, " + about;
  return one;
}

std::vector<Encounter> plane_gaps(Draw& draw) {
  std::vector<Encounter> all;
  for (const Shape& shape : some_shapes()) {
    const double half = shape.height / 2.0;
    all.push_back(against_plane(shape, {0.0, 0.0, half}, flat, shape.about + ", flat, touches to the bit"));
    all.push_back(against_plane(shape, {0.0, 0.0, -half}, {0.0, 1.0, 0.0, 0.0}, shape.about + ", upside down, inside"));
    all.push_back(against_plane(shape, {0.0, 0.0, shape.width}, on_edge, shape.about + ", on edge"));
    for (int i = 0; i < 3; ++i) {
      Encounter one = against_plane(shape, {}, draw.wholes<4>(9), shape.about);
      for (double& x : one.first.position) {
        x = shape.width * draw.part(-200, 200, 100);
      }
      one.normal = draw.wholes<3>(9);
      one.offset = shape.width * draw.part(-100, 100, 100);
      all.push_back(one);
    }
  }
  return all;
}

Encounter at_board(const Shape& shape, const std::array<double, 3>& position, const std::array<double, 4>& attitude,
                   const std::string& about) {
  Encounter one;
  one.against = Against::board;
  one.first = {.shape = shape, .position = position, .attitude = attitude};
  one.about = "board, " + shape.about + about;
  return one;
}

/// The shapes of real stones.
std::vector<Shape> real_shapes() {
  std::vector<Shape> shapes = some_shapes();
  std::erase_if(shapes, [](const Shape& shape) { return shape.width > 0.1; });
  return shapes;
}

std::vector<Encounter> board_gaps(Draw& draw) {
  const double X = board_half_width, Y = board_half_length;
  std::vector<Encounter> all;
  for (const Shape& shape : real_shapes()) {
    const double w = shape.width, h = shape.height;
    all.push_back(at_board(shape, {0.0, 0.0, h / 2.0}, flat, ", flat in the middle, touches to the bit"));
    all.push_back(at_board(shape, {X + w / 4.0, 0.0, h}, flat, ", flat, beyond an edge"));
    all.push_back(at_board(shape, {X + w, 0.0, -w}, flat, ", flat beside a side"));
    all.push_back(at_board(shape, {X, 0.0, w}, on_edge, ", on edge over an edge"));
    all.push_back(at_board(shape, {-X - w / 2.0, -Y - w / 2.0, w / 2.0}, flat, ", flat beyond a corner"));
    all.push_back(at_board(shape, {X + w, -Y - w, -w}, on_edge, ", on edge beside a vertical edge"));
    for (int i = 0; i < 9;) {
      Encounter one = at_board(shape, {X, Y, 0.0}, draw.wholes<4>(9), "");
      std::array<double, 3>& p = one.first.position;
      p[0] = (i % 3 == 0 ? 0.0 : X) + w * draw.part(-100, 100, 100);
      p[1] = (i % 3 == 1 ? 0.0 : -Y) + w * draw.part(-100, 100, 100);
      p[2] = w * draw.part(-100, 100, 100);
      if (1e-4 < separation_of(one).gap) {  // cores that are apart
        all.push_back(one);
        ++i;
      }
    }
  }
  return all;
}

Encounter of_two(const Shape& shape, const Shape& other, const std::array<double, 3>& position,
                 const std::array<double, 4>& attitude, const std::string& about) {
  Encounter one;
  one.against = Against::stone;
  one.first = {.shape = shape, .position = position, .attitude = attitude};
  one.other = {.shape = other};
  one.about = "two, " + shape.about + about;
  return one;
}

std::vector<Encounter> pair_gaps(Draw& draw) {
  std::vector<Encounter> all;
  const std::vector<Shape> shapes = real_shapes();
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Shape& shape = shapes[k];
    const double w = shape.width, h = shape.height;
    all.push_back(of_two(shape, shape, {0.0, 0.0, h}, flat, ", one upon the other, touching to the bit"));
    all.push_back(of_two(shape, shape, {0.0, 0.0, 2.0 * w}, flat, ", one above the other"));
    all.push_back(of_two(shape, shape, {w * 1.25, 0.0, 0.0}, flat, ", side by side"));
    all.push_back(of_two(shape, shape, {w * 1.25, 0.0, 0.0}, on_edge, ", a face beside a rim"));
    all.push_back(of_two(shape, shape, {0.0, w * 1.25, 0.0}, on_edge, ", crossed, rim beside rim"));
    for (int i = 0; i < 9;) {
      Encounter one =
          of_two(shape, shapes[(k + static_cast<std::size_t>(i)) % shapes.size()], {}, draw.wholes<4>(9), " and other");
      one.other.attitude = draw.wholes<4>(9);
      for (double& x : one.first.position) {
        x = w * draw.part(-125, 125, 100);
      }
      if (1e-4 < separation_of(one).gap) {
        all.push_back(one);
        ++i;
      }
    }
  }
  return all;
}

Mover moving(const Mover& at, const std::array<double, 3>& velocity, const std::array<double, 3>& spin) {
  Mover mover = at;
  mover.velocity = velocity;
  mover.spin = spin;
  return mover;
}

std::vector<Encounter> plane_touches(Draw& draw) {
  std::vector<Encounter> all;
  for (const Shape& shape : real_shapes()) {
    const double w = shape.width;
    const auto add = [&](const Mover& mover, const std::string& about) {
      Encounter one = against_plane(shape, {}, flat, shape.about + about);
      one.first = mover;
      one.gravity = falling;
      all.push_back(one);
    };
    add({.shape = shape, .position = {0.0, 0.0, 0.05}}, ", flat, falls");
    add({.shape = shape, .position = {0.0, 0.0, 0.05}, .attitude = on_edge}, ", on edge, falls");
    add({.shape = shape,
         .position = {0.0, 0.0, 0.05},
         .attitude = {4.0, 1.0, 0.0, 0.0},
         .velocity = {},
         .spin = {0.0, 0.0, 20.0}},
        ", tilted, spins about its axis");
    for (int i = 0; i < 6; ++i) {
      add(moving({.shape = shape, .position = {0.0, 0.0, w + draw.part(0, 100, 1000)}, .attitude = draw.wholes<4>(9)},
                 {draw.part(-10, 10, 10), draw.part(-10, 10, 10), draw.part(-10, 10, 10)},
                 draw.wholes<3>(i < 3 ? 20 : 100)),
          "");
    }
    Encounter one = against_plane(shape, {0.0, 0.0, 0.05}, {4.0, 1.0, 0.0, 0.0}, shape.about + ", flies over it");
    one.first = moving(one.first, {1.0, 0.0, 0.0}, {10.0, 0.0, 3.0});
    all.push_back(one);
  }
  return all;
}

/// Stones with bevels that can be touched at edges.
std::vector<Shape> bevelled_shapes() {
  std::vector<Shape> shapes = real_shapes();
  std::erase_if(shapes, [](const Shape& shape) { return !(0.0 < shape.bevel); });
  return shapes;
}

std::vector<Encounter> board_touches(Draw& draw) {
  const double X = board_half_width, Y = board_half_length;
  std::vector<Encounter> all;
  for (const Shape& shape : bevelled_shapes()) {
    const auto add = [&](const Mover& mover, const std::string& about) {
      Encounter one = at_board(shape, {}, flat, about);
      one.first = mover;
      one.gravity = falling;
      one.horizon = 0.5;
      all.push_back(one);
    };
    add({.shape = shape, .position = {0.0, 0.0, 0.05}}, ", flat, falls on the middle");
    add({.shape = shape, .position = {X + 0.005, 0.0, 0.05}}, ", flat, falls on an edge");
    add({.shape = shape, .position = {X + 0.005, Y + 0.005, 0.05}}, ", flat, falls on a corner");
    add({.shape = shape, .position = {X + 0.05, 0.0, -0.05}, .attitude = flat, .velocity = {-1.0, 0.0, 0.0}},
        ", against a side");
    add({.shape = shape, .position = {X + 0.05, 0.0, 0.05}}, ", falls beside it");
    for (int i = 0; i < 6; ++i) {
      const double x = i % 3 == 0 ? 0.0 : X, y = i % 3 == 1 ? 0.0 : Y;
      add(moving({.shape = shape,
                  .position = {x + draw.part(-10, 10, 1000), y + draw.part(-10, 10, 1000), draw.part(25, 80, 1000)},
                  .attitude = draw.wholes<4>(9)},
                 {draw.part(-2, 2, 10), draw.part(-2, 2, 10), draw.part(-10, 0, 10)}, draw.wholes<3>(30)),
          "");
    }
  }
  return all;
}

std::vector<Encounter> pair_touches(Draw& draw) {
  std::vector<Encounter> all;
  for (const Shape& shape : bevelled_shapes()) {
    Encounter one = of_two(shape, shape, {0.0, 0.0, 0.05}, flat, ", one falls flat upon the other");
    one.first.velocity = {0.0, 0.0, -1.0};
    all.push_back(one);
    one.first.position = {0.005, 0.0, 0.05};
    one.about = "two, " + shape.about + ", beside its middle";
    all.push_back(one);
    one.first.position = {0.05, 0.0, 0.0};
    one.first.velocity = {-1.0, 0.0, 0.0};
    one.about = "two, " + shape.about + ", rim against rim";
    all.push_back(one);
    one.first.velocity = {1.0, 0.0, 0.0};
    one.about = "two, " + shape.about + ", they part";
    all.push_back(one);
    for (int i = 0; i < 5; ++i) {
      Encounter any = of_two(shape, shape, {}, flat, "");
      any.first = moving({.shape = shape,
                          .position = {draw.part(-10, 10, 1000), draw.part(-10, 10, 1000), draw.part(30, 80, 1000)},
                          .attitude = draw.wholes<4>(9)},
                         {draw.part(-2, 2, 10), draw.part(-2, 2, 10), draw.part(-10, -5, 10)}, draw.wholes<3>(30));
      any.other = moving({.shape = shape, .position = {}, .attitude = draw.wholes<4>(9)},
                         {draw.part(-2, 2, 10), draw.part(-2, 2, 10), draw.part(0, 5, 10)}, draw.wholes<3>(30));
      any.horizon = 0.5;
      all.push_back(any);
    }
  }
  return all;
}

template <class... Lists>
std::vector<Encounter> joined(const Lists&... lists) {
  std::vector<Encounter> all;
  (all.insert(all.end(), lists.begin(), lists.end()), ...);
  return all;
}

}  // namespace

/// The placed stones themselves, as a caller of the library would ask.
Separation<double> separation_of(const Encounter& of) {
  const auto pose = [](const Mover& mover) {
    return Pose<double>{.p_WB = vector_of<double>(mover.position), .q_WB = attitude_of<double>(mover.attitude)};
  };
  const World<double> world(of);
  switch (of.against) {
    case Against::plane:
      return separation(world.first.stone, pose(of.first), world.plane);
    case Against::board:
      return separation(world.first.stone, pose(of.first), world.board);
    case Against::stone:
      break;
  }
  return separation(world.first.stone, pose(of.first), world.other.stone, pose(of.other));
}

std::vector<Encounter> gap_encounters() {
  Draw of_planes(7), of_boards(8), of_pairs(9);
  return joined(plane_gaps(of_planes), board_gaps(of_boards), pair_gaps(of_pairs));
}

std::vector<Encounter> touch_encounters() {
  Draw of_planes(10), of_boards(11), of_pairs(12);
  return joined(plane_touches(of_planes), board_touches(of_boards), pair_touches(of_pairs));
}

}  // namespace goishi::verify::reference
