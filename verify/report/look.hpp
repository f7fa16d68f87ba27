#pragma once
/// \file
/// How the curves of a plot look: colour, dashes, marker.

#include <string>
#include <string_view>

#include "verify/suite/claim.hpp"

namespace goishi::verify::picture {

/// Of the i-th series.
struct Appearance {
  std::string group;        // attributes of the group: colour
  std::string stroke;       // attributes of the line
  std::string marker;       // a path around (0, 0), to follow a move
  std::string marker_fill;  // attributes of a marker
};

/// No two of the first 21 usual curves are alike, no two of the first 8 foreign ones.
[[nodiscard]] Appearance appearance(const Plot& plot, std::size_t i);

[[nodiscard]] std::string_view dark_colours();

}  // namespace goishi::verify::picture
