#include "verify/reference/stones.hpp"

#include <fmt/format.h>

#include <goishi/shape/catalogue.hpp>

#include "verify/reference/draw.hpp"

namespace goishi::verify::reference {

namespace {

/// The doubles next to w and to h.
constexpr double half_ulp = 1.0 - 1.0 / 9007199254740992.0;  // 1 − 2⁻⁵³

void add_singular(std::vector<Shape>& shapes) {
  const double w = 0.022, h = 0.0092;
  const auto add = [&](double width, double height, double bevel, const std::string& about) {
    shapes.push_back({width, height, bevel, false, about});
    if (0.0 < bevel) {
      shapes.push_back({width, height, bevel, true, about + ", measured"});
    }
  };
  add(w, w, 0.0, "the ball");
  add(w, w, 0.011, "the ball, bevelled: the same ball");
  add(w, w * half_ulp, 0.0, "the ball but for one ulp of the height");
  add(w, w * half_ulp, 0.001, "the ball but for one ulp of the height, bevelled");
  add(0.024, 0.008, 0.0, "r, d and w/2 as 5 to 4 to 3");
  add(24.0, 8.0, 0.0, "r, d and w/2 are 20, 16 and 12");
  add(w, h, h * half_ulp, "nearly all bevel: one ulp less than the height");
  add(w, h, 1e-12, "nearly no bevel");
  add(w, w * half_ulp, w * (1.0 - 1.0 / 2251799813685248.0), "nearly the ball and nearly all bevel");
  for (const double aspect : {1e-3, 1e-6, 1e-9}) {
    add(1.0, aspect, 0.0, fmt::format("as thin as h/w = {}", aspect));
    add(1.0, aspect, aspect / 2.0, fmt::format("as thin as h/w = {}, half of it bevel", aspect));
    add(1.0, aspect, aspect * 1e-9, fmt::format("as thin as h/w = {}, nearly no bevel", aspect));
    add(1.0, 1.0 - aspect, 0.0, fmt::format("a ball but for 1 - h/w = {}", aspect));
    add(1.0, 1.0 - aspect, 0.25, fmt::format("a ball but for 1 - h/w = {}, bevelled", aspect));
  }
  add(2.2e-8, 9.2e-9, 1e-9, "a million times smaller than a stone");
  add(22000.0, 9200.0, 1000.0, "a million times greater than a stone");
}

void add_catalogue(std::vector<Shape>& shapes) {
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      const CatalogueStone stone = catalogue_stone(size.number, color);
      const double w = stone.width / 1e6, h = stone.height / 1e6;
      const std::string name = fmt::format("size {} {}", size.number, to_string(color));
      shapes.push_back({w, h, 0.0, false, name});
      shapes.push_back({w, h, 0.001, false, name + ", b = 1 mm"});
      if (color == StoneColor::white) {
        shapes.push_back({w, h, 0.001, true, name + ", b = 1 mm, measured"});
      }
    }
  }
}

void add_others(std::vector<Shape>& shapes, int count) {
  Draw draw(1);
  for (int i = 0; i < count; ++i) {
    const double w = draw.part(500, 2000, 1000);
    const double h = w * draw.part(20, 999, 1000);
    const double b = i % 3 == 0 ? 0.0 : h * draw.part(1, 999, 1000);
    shapes.push_back({w, h, b, i % 3 == 2, "any"});
  }
}

}  // namespace

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes;
  add_singular(shapes);
  add_catalogue(shapes);
  add_others(shapes, 60);
  return shapes;
}

std::vector<Shape> some_shapes() {
  return {{0.022, 0.0092, 0.0, false, "size 33, sharp"},
          {0.022, 0.0092, 0.001, false, "size 33, b = 1 mm"},
          {0.022, 0.0092, 0.001, true, "size 33, b = 1 mm, measured"},
          {24.0, 8.0, 0.0, false, "r, d and w/2 are 20, 16 and 12"},
          {0.022, 0.022, 0.0, false, "the ball"},
          {0.022, 0.0001, 0.0, false, "thin"},
          {0.022, 0.0092, 0.009, false, "nearly all bevel"},
          {1.0, 1e-9, 0.0, false, "as thin as h/w = 1e-9"},
          {1.0, 1e-9, 5e-10, false, "as thin as h/w = 1e-9, half of it bevel"}};
}

std::vector<InputKind> shape_inputs() {
  return {{"width", "m", "w, of the lens that generates the stone, or of the finished stone (width_of)"},
          {"height", "m", "h, the thickness"},
          {"bevel", "m", "b, the height of the bevel band; 0: sharp"},
          {"width_of", "", "lens or stone: what width is the width of"}};
}

std::vector<Input> inputs_of(const Shape& shape) {
  return {input("width", shape.width), input("height", shape.height), input("bevel", shape.bevel),
          input("width_of", std::string(shape.measured ? "stone" : "lens"))};
}

std::string numbered(const std::string& section, std::size_t number) {
  return fmt::format("{}-{:03}", section, number);
}

}  // namespace goishi::verify::reference
