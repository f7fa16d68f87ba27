/// Pictures of plots, and their axes.

#include "verify/report/svg.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "verify/report/axis.hpp"

namespace goishi::verify {
namespace {

using test::infinity;
using test::nan;
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double huge = std::numeric_limits<double>::max();

using Points = std::vector<std::pair<double, double>>;

using test::contains;

/// What stands between each `before` and the next `after`.
std::vector<std::string> all_between(std::string_view text, std::string_view before, std::string_view after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string_view::npos; at = text.find(before, at)) {
    at += before.size();
    found.emplace_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

std::vector<std::string> points_of(std::string_view svg) {
  return all_between(svg, "<path class=\"point\" d=\"", "\"");
}

Plot plot_of(const Points& points, bool log_x = false, bool log_y = false) {
  return {"Title", "x [m]", "y [m]", log_x, log_y, false, {{"curve", points, true}}};
}

TEST(Svg, DegenerateInputGivesAPicture) {
  const std::vector<Points> inputs = {{},
                                      {{1, 1}},
                                      {{0, 0}},
                                      {{nan, nan}, {nan, 1}, {1, infinity}, {-infinity, 1}},
                                      {{nan, 1}, {2, 3}},
                                      {{0, 1}, {-1, 2}, {1, 0}},
                                      {{1, 1}, {1, 1}, {1, 1}},
                                      {{1, 1}, {1 + 1e-16, 1 + 1e-15}},
                                      {{tiny, -tiny}, {2 * tiny, tiny}, {tiny, tiny}},
                                      {{-huge, huge}, {huge, -huge}, {huge, huge / 2}},
                                      {{-1e300, 1e300}, {1e300, 1e-300}},
                                      {{1e-300, 1e-300}, {1.5e-300, 1.2e-300}},
                                      {{123456789.25, 1}, {123456789.5, 2}}};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (int kind = 0; kind < 8; ++kind) {
      SCOPED_TRACE(testing::Message() << "input " << i << ", kind " << kind);
      Plot plot = plot_of(inputs[i], (kind & 1) != 0, (kind & 2) != 0);
      plot.equal_scale = (kind & 4) != 0;
      const std::string svg = svg_plot(plot);
      for (const char* wrong : {"nan", "inf\"", "inf ", "inf<"}) {
        EXPECT_FALSE(contains(svg, wrong)) << wrong;
      }
      EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
      const std::size_t drawn = points_of(svg).size();
      EXPECT_TRUE(contains(svg, "data-points=\"" + std::to_string(drawn) + "\""));
      EXPECT_EQ(contains(svg, "left out"), drawn < inputs[i].size());
      EXPECT_EQ(contains(svg, "no point to draw"), drawn == 0);
    }
  }
  EXPECT_TRUE(contains(svg_plot({}), "no point to draw"));
}

TEST(Svg, SaysWhatWasLeftOut) {
  const Plot plot = plot_of({{nan, 1}, {1, 0}, {0, 1}, {2, 2}, {1, infinity}}, true, true);
  EXPECT_TRUE(contains(svg_plot(plot), "left out: 2 not finite, 2 not positive on a logarithmic axis"));
  EXPECT_TRUE(contains(svg_plot(plot_of({{huge, 1}, {1, 1}})), "left out: 1 beyond ±10³⁰⁰"));
}

TEST(Svg, PointWithoutAPlaceInterruptsTheLine) {
  const std::string svg = svg_plot(plot_of({{1, 1}, {2, 2}, {nan, 3}, {4, 4}, {5, 5}}));
  const std::string line = all_between(svg, "data-points=\"4\"", "fill=").at(0);
  EXPECT_EQ(all_between(line, "M", "h0").size(), 2U) << line;
  EXPECT_EQ(all_between(line, "L", "\"").size(), 2U) << line;
}

TEST(Svg, CountsThePointsOfEachSeries) {
  Plot plot = plot_of({{1, 1}, {2, 2}, {3, nan}});
  plot.series.push_back({"a & <b>", {{1, 2}}, false});
  plot.series.push_back({"long", {}, true});
  plot.series.push_back({"cloud", {}, false});
  for (int i = 0; i < 1000; ++i) {
    plot.series[2].points.emplace_back(i, std::sin(i));
    plot.series[3].points.emplace_back(i, std::cos(i));
  }
  const std::string svg = svg_plot(plot);
  EXPECT_TRUE(contains(svg, "data-series=\"curve\" data-points=\"2\""));
  EXPECT_TRUE(contains(svg, "data-series=\"a &amp; &lt;b&gt;\" data-points=\"1\""));
  EXPECT_TRUE(contains(svg, "data-series=\"long\" data-points=\"1000\""));
  EXPECT_TRUE(contains(svg, "data-series=\"cloud\" data-points=\"1000\""));
  EXPECT_EQ(points_of(svg).size(), 3U);
  EXPECT_EQ(svg, svg_plot(plot));
}

TEST(Svg, EachCurveLooksDifferent) {
  Plot plot;
  for (int i = 0; i < 21; ++i) {
    plot.series.push_back({"", {{1, 1}, {2, 2}}, true});
  }
  std::set<std::string> looks;
  for (const std::string& look : all_between(svg_plot(plot), "data-points=\"2\" ", "<title>")) {
    looks.insert(look);  // colour, dashes and marker: the place is the same
  }
  EXPECT_EQ(looks.size(), 21U);
}

TEST(Svg, EqualScale) {
  for (const double height : {0.01, 0.4, 1.0, 7.0}) {
    Plot plot = plot_of({{0, 0}, {1, 0}, {1, height}});
    plot.equal_scale = true;
    std::vector<std::pair<double, double>> found;
    for (const std::string& point : points_of(svg_plot(plot))) {
      const std::size_t space = point.find(' ');
      found.emplace_back(std::stod(point.substr(1)), std::stod(point.substr(space)));
    }
    ASSERT_EQ(found.size(), 3U);
    const double across = found[1].first - found[0].first;
    const double up = found[1].second - found[2].second;
    EXPECT_GT(across, 50);
    EXPECT_NEAR(up, height * across, 0.005 * (2 + 2 * height));  // two decimals
  }
}

using Labels = std::vector<std::string>;

Labels labels(const Axis& axis, std::size_t at_most) {
  const auto labelled = [](const std::vector<Tick>& some) {
    Labels result;
    for (const Tick& tick : some) {
      if (!tick.label.empty()) {
        result.push_back(tick.label);
      }
    }
    return result;
  };
  return labelled(ticks(axis, [&](const std::vector<Tick>& some) { return labelled(some).size() <= at_most; }));
}

TEST(Axis, Ticks) {
  EXPECT_EQ(labels({false, 0, 1}, 6), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels({false, -3, 11}, 4), (Labels{"0", "5", "10"}));
  EXPECT_EQ(labels({false, -2e-9, 2.5e-9}, 5), (Labels{"−2·10⁻⁹", "−10⁻⁹", "0", "10⁻⁹", "2·10⁻⁹"}));
  EXPECT_EQ(labels({true, -0.5, 1.5}, 9), (Labels{"0.5", "1", "2", "5", "10", "20"}));
  EXPECT_EQ(labels({true, -16.2, -11.9}, 9), (Labels{"10⁻¹⁶", "10⁻¹⁵", "10⁻¹⁴", "10⁻¹³", "10⁻¹²"}));
  EXPECT_EQ(labels({true, -16.2, 0.1}, 5), (Labels{"10⁻¹⁵", "10⁻¹⁰", "10⁻⁵", "10⁰"}));
  EXPECT_EQ(labels({true, std::log10(2.4), std::log10(3.6)}, 4), (Labels{"2.5", "3.0", "3.5"}));
}

TEST(Axis, HoldsItsValues) {
  for (const bool logarithmic : {false, true}) {
    const Axis axis = axis_around({3, 7, 5}, logarithmic);
    EXPECT_GT(axis.at(3), 0.0);
    EXPECT_LT(axis.at(3), axis.at(5));
    EXPECT_LT(axis.at(7), 1.0);
    EXPECT_NEAR(axis_around({7, 7}, logarithmic).at(7), 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace goishi::verify
