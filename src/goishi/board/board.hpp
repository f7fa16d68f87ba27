#pragma once
/// \file
/// The board, by standard: lines, star points, sides; its nine regions.

#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/standard.hpp>
#include <string_view>
#include <vector>

namespace goishi {

/// A board in frame W: the playing surface is z = 0, its middle the origin, the lines run along x and y. For contact it
/// is infinitely deep: a stone that falls beside it meets its sides, whatever the height.
template <class T>
struct Board {
  int lines = 0;
  T spacing_x = scalar::unset<T>();  // [m] between neighbouring lines, along x
  T spacing_y = scalar::unset<T>();
  T half_width = scalar::unset<T>();   // [m] along x
  T half_length = scalar::unset<T>();  // [m] along y
  T thickness = scalar::unset<T>();    // [m]
  T floor = scalar::unset<T>();        // [m] z of the floor, at or below −thickness
};

namespace boards {

/// Lengths of a standard   [µm].
struct Grid {
  int spacing_x;
  int spacing_y;
  int border_x;  // from the outermost line to the side
  int border_y;
};

/// 19 lines: 424.2 × 454.5 mm. Source: the talk.
inline constexpr Grid talk = {.spacing_x = 22000, .spacing_y = 23700, .border_x = 14100, .border_y = 13950};

/// 19 lines: 424.34 × 454.56 mm. Source: the board as the Nihon Ki-in has it.
inline constexpr Grid nihon_kiin = {.spacing_x = 22330, .spacing_y = 23920, .border_x = 11200, .border_y = 12000};

/// The Nihon Ki-in's board with 13 lines, from side to side   [µm]. Source: as sold.
inline constexpr int thirteen_width = 290000;
inline constexpr int thirteen_length = 315000;

/// Thickness   [µm]. Source: the talk (5 sun); the maker Tengudo, whose usual board for the floor has 6 sun.
inline constexpr int thickness = 151500;
inline constexpr int floor_board_thickness = 182000;

/// Legs of a board for the floor, the shortest and the longest that are usual   [µm]. Source: as sold.
inline constexpr int short_legs = 115000;
inline constexpr int long_legs = 120000;

}  // namespace boards

/// What a board is made from   [m]. The default is the talk's 19-line board, 424.2 × 454.5 × 151.5 mm, without legs.
template <class T>
struct BoardDimensions {
  int lines = 19;
  T spacing_x = metres<T>(boards::talk.spacing_x);
  T spacing_y = metres<T>(boards::talk.spacing_y);
  T border_x = metres<T>(boards::talk.border_x);  // from the outermost line to the side
  T border_y = metres<T>(boards::talk.border_y);
  T thickness = metres<T>(boards::thickness);
  T legs = T(0);  // height of the board's underside over the floor
};

/// The dimensions of a standard's board, 151.5 mm thick and without legs   [m].
///
/// With any number of lines it has the spacing and the borders of 19. Only the Nihon Ki-in's board with 13 has a size of
/// its own: the stones are the same, so the spacing is, and the borders are what is left of 290 × 315 mm,
///
///     (290 − 12 · 22.33)/2 = 11.02 mm,   (315 − 12 · 23.92)/2 = 13.98 mm
///
/// Domain  one of `standards`, else InvalidArgument; any number of lines: `make_board` judges it.
/// Error   each length is rounded once; claim BOARD-3.
template <Field T>
[[nodiscard]] BoardDimensions<T> board_dimensions(Standard standard, int lines = 19) {
  require(standard == Standard::talk || standard == Standard::nihon_kiin, "standard", static_cast<int>(standard),
          "must be one of `standards`");
  boards::Grid grid = standard == Standard::talk ? boards::talk : boards::nihon_kiin;
  if (standard == Standard::nihon_kiin && lines == 13) {
    grid.border_x = (boards::thirteen_width - 12 * grid.spacing_x) / 2;
    grid.border_y = (boards::thirteen_length - 12 * grid.spacing_y) / 2;
  }
  return {.lines = lines,
          .spacing_x = metres<T>(grid.spacing_x),
          .spacing_y = metres<T>(grid.spacing_y),
          .border_x = metres<T>(grid.border_x),
          .border_y = metres<T>(grid.border_y)};
}

/// The same board as one that stands on the floor: 182 mm thick, on legs of whole micrometres.
template <Field T>
[[nodiscard]] BoardDimensions<T> floor_board(BoardDimensions<T> dimensions, int legs = boards::short_legs) {
  dimensions.thickness = metres<T>(boards::floor_board_thickness);
  dimensions.legs = metres<T>(legs);
  return dimensions;
}

/// Domain  lines >= 1, spacings and thickness > 0, borders and legs >= 0, all finite, and so the whole board; else
///         InvalidArgument.
template <Ordered T>
[[nodiscard]] Board<T> make_board(const BoardDimensions<T>& dimensions = {}) {
  const auto require_not_negative = [](const char* argument, const T& value) {
    require(!(value < T(0)) && scalar::is_finite(value), argument, value, "must be finite and at least 0");
  };
  require(dimensions.lines >= 1, "lines", dimensions.lines, "must be at least 1");
  require_positive("spacing_x", dimensions.spacing_x);
  require_positive("spacing_y", dimensions.spacing_y);
  require_positive("thickness", dimensions.thickness);
  require_not_negative("border_x", dimensions.border_x);
  require_not_negative("border_y", dimensions.border_y);
  require_not_negative("legs", dimensions.legs);
  const T steps = static_cast<T>(dimensions.lines - 1);
  const T half_width = steps * dimensions.spacing_x / T(2) + dimensions.border_x;
  const T half_length = steps * dimensions.spacing_y / T(2) + dimensions.border_y;
  const auto require_half = [](const char* argument, const T& border, const T& half) {
    require(T(0) < half, argument, border, "must be positive on a board with one line");
    require(scalar::is_finite(half), argument, border, "must leave the board a finite size");
  };
  const T height = dimensions.thickness + dimensions.legs;
  require(scalar::is_finite(height), "legs", dimensions.legs, "must leave the board a finite height over the floor");
  require_half("border_x", dimensions.border_x, half_width);
  require_half("border_y", dimensions.border_y, half_length);
  return {.lines = dimensions.lines,
          .spacing_x = dimensions.spacing_x,
          .spacing_y = dimensions.spacing_y,
          .half_width = half_width,
          .half_length = half_length,
          .thickness = dimensions.thickness,
          .floor = -height};
}

namespace detail {

template <Ordered T>
void require_board(const Board<T>& board) {
  require(T(0) < board.half_width && T(0) < board.half_length, "board", board.half_width,
          "must be one of make_board (its half width is shown)");
}

}  // namespace detail

/// The point where line i along x and line j along y cross, counted from 0 at the lower left; in W, on the surface.
/// Domain  0 <= i, j < lines, else InvalidArgument.
/// Error   one rounding; of as many lines as T does not count, two (DOMAIN-9).
template <Ordered T>
[[nodiscard]] Vec3<T> intersection(const Board<T>& board, int i, int j) {
  require(0 <= i && i < board.lines, "i", i, "must be a line of the board (0 … ", board.lines - 1, ")");
  require(0 <= j && j < board.lines, "j", j, "must be a line of the board (0 … ", board.lines - 1, ")");
  const auto place = [&](int line, const T& spacing) {
    return T(static_cast<T>(line - (board.lines - 1 - line)) / T(2) * spacing);  // no sum that an int does not hold
  };
  return {place(i, board.spacing_x), place(j, board.spacing_y), T(0)};
}

/// The star points, as pairs of lines: nine on 19 lines, five on 13 and on 9, the middle alone on other odd boards.
template <Ordered T>
[[nodiscard]] std::vector<std::pair<int, int>> star_points(const Board<T>& board) {
  const int n = board.lines;
  const int middle = (n - 1) / 2;
  std::vector<std::pair<int, int>> points;
  const int corner = n == 9 ? 2 : 3;
  if (n == 9 || n == 13 || n == 19) {
    for (const int i : {corner, n - 1 - corner}) {
      for (const int j : {corner, n - 1 - corner}) {
        points.emplace_back(i, j);
      }
    }
  }
  if (n == 19) {
    points.insert(points.end(),
                  {{corner, middle}, {n - 1 - corner, middle}, {middle, corner}, {middle, n - 1 - corner}});
  }
  if (n % 2 == 1) {
    points.emplace_back(middle, middle);
  }
  return points;
}

/// The talk's nine regions, and beyond: where a stone's centre is, seen from above, by the features that it can touch.
/// `primary`: the surface only; a side: the surface, that side, and the edge between; a corner: two sides, three edges
/// and their corner; `out_of_reach`: nothing.
enum class Region { primary, left, right, bottom, top, bottom_left, bottom_right, top_left, top_right, out_of_reach };

[[nodiscard]] constexpr std::string_view to_string(Region region) {
  constexpr std::string_view names[] = {
      "primary",          "left side",          "right side",          "bottom side",
      "top side",         "bottom-left corner", "bottom-right corner", "top-left corner",
      "top-right corner", "out of reach"};
  return names[static_cast<std::size_t>(region)];
}

/// The region of a body whose centre is at p_W and which lies within `reach` of it. x goes from left to right, y from
/// bottom to top.
///
/// Domain  a board of `make_board`, finite p, a finite reach >= 0; else InvalidArgument.
/// Error   none but where the centre is within round-off of a region's border (DOMAIN-9).
template <Ordered T>
[[nodiscard]] Region region_of(const Board<T>& board, const Vec3<T>& p_W, const T& reach) {
  detail::require_board(board);
  require(scalar::is_finite(T(p_W.x() + p_W.y() + p_W.z())), "position", p_W.transpose(), "must be finite");
  require(T(0) <= reach && scalar::is_finite(reach), "reach", reach, "must be finite and at least 0");
  const T x = scalar::abs(T(p_W.x()));
  const T y = scalar::abs(T(p_W.y()));
  if (board.half_width + reach < x || board.half_length + reach < y || reach < p_W.z()) {
    return Region::out_of_reach;
  }
  const bool beside_x = board.half_width - reach < x;
  const bool beside_y = board.half_length - reach < y;
  const bool left = p_W.x() < T(0);
  const bool bottom = p_W.y() < T(0);
  if (beside_x && beside_y) {
    return bottom ? (left ? Region::bottom_left : Region::bottom_right) : (left ? Region::top_left : Region::top_right);
  }
  if (beside_x) {
    return left ? Region::left : Region::right;
  }
  if (beside_y) {
    return bottom ? Region::bottom : Region::top;
  }
  return Region::primary;
}

}  // namespace goishi
