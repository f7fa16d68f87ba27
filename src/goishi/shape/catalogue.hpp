#pragma once
/// \file
/// The stone sizes that are sold: 14 numbers (号), white and black.
///
/// Dimensions are decimal data, held as whole micrometres, so that every scalar gets them exactly: T(22000) /
/// T(1000000).

#include <algorithm>
#include <array>
#include <goishi/error.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <string_view>

namespace goishi {

enum class StoneColor { white, black };

[[nodiscard]] constexpr std::string_view to_string(StoneColor color) {
  return color == StoneColor::white ? "white" : "black";
}

namespace catalogue {

/// Diameter of a white stone, whatever its number   [µm]. Source: the talk; the Nihon Ki-in gives 21.9 mm.
inline constexpr int white_width = 22000;

/// What a black stone of the same number is larger by   [µm]. Source: Nihon Ki-in ("about"), 0.3 mm in diameter, 0.6
/// mm in thickness. The original program had 0.3 cm.
inline constexpr int black_wider = 300;
inline constexpr int black_thicker = 600;

/// Assumed densities   [kg/m³]. General values of the materials, measured on no stone: clam shell about 2.8 g/cm³,
/// slate 2.7 … 2.8 g/cm³ (the middle).
inline constexpr int assumed_white_density = 2800;
inline constexpr int assumed_black_density = 2750;

/// The bevel of the inertia table's bevelled rows   [µm]. Source: the talk's demonstration.
inline constexpr int table_bevel = 1000;

struct Size {
  int number;        // 号
  int white_height;  // thickness of the white stone [µm]
};

/// Source: "K" confirmed by the Nihon Ki-in's page; "M" from the maker's list that the original program used.
inline constexpr std::array<Size, 14> sizes = {{
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
}};

}  // namespace catalogue

/// One stone of the catalogue.
struct CatalogueStone {
  int number;
  StoneColor color;
  int width;    // [µm]
  int height;   // [µm]
  int density;  // assumed [kg/m³]
};

/// The stone of a catalogue number and colour; InvalidArgument for a number that is not in the catalogue.
[[nodiscard]] inline CatalogueStone catalogue_stone(int number, StoneColor color) {
  const auto* size = std::find_if(catalogue::sizes.begin(), catalogue::sizes.end(),
                                  [number](const catalogue::Size& candidate) { return candidate.number == number; });
  if (size == catalogue::sizes.end()) {
    std::string known;
    for (const auto& candidate : catalogue::sizes) {
      known += (known.empty() ? "" : " ") + std::to_string(candidate.number);
    }
    throw_invalid("size", number, "must be one of ", known);
  }
  const bool black = color == StoneColor::black;
  return {.number = number,
          .color = color,
          .width = catalogue::white_width + (black ? catalogue::black_wider : 0),
          .height = size->white_height + (black ? catalogue::black_thicker : 0),
          .density = black ? catalogue::assumed_black_density : catalogue::assumed_white_density};
}

/// A length of whole micrometres in metres, rounded once (exact in exact arithmetic).
template <Field T>
[[nodiscard]] constexpr T metres(int micrometres) {
  return T(T(micrometres) / T(1000000));
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
