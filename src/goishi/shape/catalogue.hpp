#pragma once
/// \file
/// The stone sizes that are sold: 24 numbers (号), white and black, by two standards of their width. Dimensions in whole
/// micrometres.
///
/// A number is a class, and the thickness of a stone here is the lower bound of its class: a white 33 is from 9.2 mm up
/// to the 9.5 mm of the 34.

#include <algorithm>
#include <array>
#include <goishi/error.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/standard.hpp>
#include <string>
#include <string_view>

namespace goishi {

enum class StoneColor { white, black };

[[nodiscard]] constexpr std::string_view to_string(StoneColor color) {
  return color == StoneColor::white ? "white" : "black";
}

namespace catalogue {

/// Diameter of a white stone, whatever its number, and what a black stone of the same number is larger by   [µm].
struct Widths {
  Standard standard;
  int white_width;
  int black_wider;
  int black_thicker;
};

/// Source: the talk's width of white stones; all else the Nihon Ki-in's page on stones, 21.9 and 22.2 mm (7.2 and 7.3
/// bu), black 0.6 mm thicker ("about"). The original program had 0.3 cm for what black is wider by.
inline constexpr std::array<Widths, 2> widths = {{
    {.standard = Standard::talk, .white_width = 22000, .black_wider = 300, .black_thicker = 600},
    {.standard = Standard::nihon_kiin, .white_width = 21900, .black_wider = 300, .black_thicker = 600},
}};

/// Assumed densities   [kg/m³]. General values of the materials, measured on no stone: clam shell about 2.8 g/cm³,
/// slate 2.7 … 2.8 g/cm³ (the middle).
inline constexpr int assumed_white_density = 2800;
inline constexpr int assumed_black_density = 2750;

/// The bevel of the inertia table's bevelled rows   [µm]. Source: the talk's demonstration.
inline constexpr int table_bevel = 1000;

struct Size {
  int number;        // 号
  int white_height;  // thickness of the white stone, by any standard [µm]
};

/// Source: "K" the Nihon Ki-in's page on stones; "M" the maker's list that the original program used; "L" what goes on
/// from it by 0.3 mm a number, up to the thickest that a maker (Tengudo) lists, "T".
inline constexpr std::array<Size, 24> sizes = {{
    {22, 6300},   // M
    {25, 7000},   // K
    {28, 7500},   // M
    {30, 8000},   // M
    {31, 8400},   // K
    {32, 8800},   // K
    {33, 9200},   // K, and the talk's
    {34, 9500},   // K
    {35, 9800},   // M
    {36, 10100},  // M
    {37, 10400},  // M
    {38, 10700},  // M
    {39, 11000},  // M
    {40, 11300},  // K
    {41, 11600},  // L
    {42, 11900},  // L
    {43, 12200},  // L
    {44, 12500},  // L
    {45, 12800},  // L
    {46, 13100},  // L
    {47, 13400},  // L
    {48, 13700},  // L
    {49, 14000},  // L
    {50, 14300},  // T
}};

}  // namespace catalogue

/// One stone of the catalogue.
struct CatalogueStone {
  int number;
  StoneColor color;
  Standard standard;
  int width;    // [µm]
  int height;   // [µm]
  int density;  // assumed [kg/m³]
};

/// The stone of a catalogue number and colour; InvalidArgument for a number that is not in the catalogue, or a value that
/// is no standard.
[[nodiscard]] inline CatalogueStone catalogue_stone(int number, StoneColor color, Standard standard = Standard::talk) {
  const auto* size = std::find_if(catalogue::sizes.begin(), catalogue::sizes.end(),
                                  [number](const catalogue::Size& candidate) { return candidate.number == number; });
  if (size == catalogue::sizes.end()) {
    std::string known;
    for (const auto& candidate : catalogue::sizes) {
      known += (known.empty() ? "" : " ") + std::to_string(candidate.number);
    }
    throw_invalid("size", number, "must be one of ", known);
  }
  const auto* widths = std::find_if(catalogue::widths.begin(), catalogue::widths.end(),
                                    [standard](const catalogue::Widths& one) { return one.standard == standard; });
  require(widths != catalogue::widths.end(), "standard", static_cast<int>(standard), "must be one of `standards`");
  const bool black = color == StoneColor::black;
  return {.number = number,
          .color = color,
          .standard = standard,
          .width = widths->white_width + (black ? widths->black_wider : 0),
          .height = size->white_height + (black ? widths->black_thicker : 0),
          .density = black ? catalogue::assumed_black_density : catalogue::assumed_white_density};
}

/// The catalogue stone's shape in metres, sharp or with a bevel (as published: the bevel shrinks it).
/// Domain  0 <= bevel < height, else InvalidArgument.
template <Ordered T = double>
[[nodiscard]] Stone<T> make_stone(const CatalogueStone& entry, const T& bevel = T(0)) {
  return make_stone(metres<T>(entry.width), metres<T>(entry.height), bevel);
}
[[nodiscard]] inline Stone<double> make_stone(const CatalogueStone& entry, std::integral auto bevel) {
  return make_stone<double>(entry, static_cast<double>(bevel));
}

}  // namespace goishi
