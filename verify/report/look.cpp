#include "verify/report/look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace goishi::verify::picture {

namespace {

// Each pair is at least 0.149 apart in Oklab, seen normally and with protanopia, deuteranopia and
// tritanopia (Machado et al. 2009, severity 1), and has contrast 3 with the page.
constexpr std::array<std::string_view, 7> colours = {"#283688", "#bb0809", "#026b71", "#c67cba",
                                                     "#0d6aff", "#83a000", "#3b0c00"};
constexpr std::string_view dark =
    ".curve0{color:#6f8eff}.curve1{color:#b6380e}.curve2{color:#a0cdff}.curve3{color:#e37e7a}"
    ".curve4{color:#635c97}.curve5{color:#efca00}.curve6{color:#feffd7}";

// Around (0, 0); lower case, so that a marker is one move and this path.
constexpr std::array<std::string_view, 8> markers = {
    "m-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",                 // circle
    "m-3.2 -3.2h6.4v6.4h-6.4z",                                      // square
    "m0 -4.4l4.2 7.2h-8.4z",                                         // triangle
    "m0 -4.8l4 4.8l-4 4.8l-4 -4.8z",                                 // diamond
    "m0 4.4l4.2 -7.2h-8.4z",                                         // triangle upside down
    "m-1.3 -4.2h2.6v2.9h2.9v2.6h-2.9v2.9h-2.6v-2.9h-2.9v-2.6h2.9z",  // plus
    "m-4.2 -2.4l1.8 -1.8l2.4 2.4l2.4 -2.4l1.8 1.8l-2.4 2.4l2.4 2.4l-1.8 1.8l-2.4 -2.4l-2.4 "
    "2.4l-1.8 "
    "-1.8l2.4 -2.4z",            // cross
    "m-4.4 -2.2h8.8v4.4h-8.8z",  // bar
};
constexpr std::string_view star = "m0 -9l2.2 6.2l6.6 .2l-5.2 4l1.9 6.3l-5.5 -3.7l-5.5 3.7l1.9 -6.3l-5.2 -4l6.6 -.2z";
constexpr std::array<std::string_view, 3> dashes = {"", "6 3", "2 3"};

std::string stroke(double width, std::string_view dash) {
  return fmt::format(
      "fill=\"none\" stroke=\"currentColor\" stroke-width=\"{}\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\"{}",
      width, dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash));
}

/// How many series before the i-th are foreign, or how many are not.
std::size_t place_among(const std::vector<Series>& series, std::size_t i) {
  const bool foreign = series[i].look == Look::foreign;
  return static_cast<std::size_t>(
      std::count_if(series.begin(), series.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const Series& other) { return (other.look == Look::foreign) == foreign; }));
}

}  // namespace

Appearance appearance(const Plot& plot, std::size_t i) {
  const std::size_t place = place_among(plot.series, i);
  if (plot.series[i].look == Look::foreign) {
    return {.group = "class=\"foreign\" color=\"#767676\"",  // contrast 4 with a white page and with a dark one
            .stroke = stroke(1.3, "5 3"),
            .marker = std::string(markers[place % markers.size()]),
            .marker_fill = "fill=\"none\" stroke=\"currentColor\""};
  }
  return {
      .group = fmt::format("class=\"curve{}\" color=\"{}\"", place % colours.size(), colours[place % colours.size()]),
      .stroke = stroke(1.8, dashes[place / colours.size() % dashes.size()]),
      .marker = std::string(plot.series[i].look == Look::star ? star : markers[place % markers.size()]),
      .marker_fill = "fill=\"currentColor\""};
}

std::string_view dark_colours() {
  return dark;
}

}  // namespace goishi::verify::picture
