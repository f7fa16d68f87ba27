#pragma once
/// \file
/// A plot as SVG.

#include <cstddef>
#include <string>
#include <string_view>

#include "verify/suite/claim.hpp"

namespace goishi::verify {

/// A picture 640 units wide: title, grid, curves with markers, legend below; 960 wide with the names beside the curves if
/// the plot is `labelled`. It stands alone, and it can be put into a page: it inherits the page's text colour, and has
/// no ids.
///
/// Each series is `<g data-series="name" data-points="N">`, N the points that are drawn. In a
/// series of up to `greatest_marked` points each is an element of class `point` with its values as a
/// tooltip; a longer line has no markers, a longer cloud is one path of dots.
///
/// A point that has no place (NaN, infinite, not positive on a logarithmic axis) interrupts its line,
/// and the picture says how many were left out. The same plot gives the same bytes everywhere.
[[nodiscard]] std::string svg_plot(const Plot& plot);

inline constexpr std::size_t greatest_marked = 64;

/// CSS rules with the colours of the curves on a dark page.
[[nodiscard]] std::string_view svg_dark_colours();

}  // namespace goishi::verify
