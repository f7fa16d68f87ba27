#include "verify/report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/canvas.hpp"
#include "verify/report/escape.hpp"
#include "verify/report/labels.hpp"
#include "verify/report/look.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify {

namespace {

using picture::Appearance;
using picture::Canvas;
using picture::edge;
using picture::line_height;
using picture::number;
using picture::Place;
using picture::text_at;

constexpr std::size_t title_columns = 78;
constexpr std::string_view dot_stroke =
    "fill=\"none\" stroke=\"currentColor\" stroke-width=\"3\" stroke-linecap=\"round\"";

bool has_markers(const Series& series) {
  return series.points.size() <= greatest_marked && !series.segments;
}

std::string draw_series(const Plot& plot, const Canvas& canvas, std::size_t i) {
  const Series& series = plot.series[i];
  const Appearance look = picture::appearance(plot, i);
  const std::string fill = series.look == Look::foreign ? " " + look.marker_fill : "";
  std::string curve;
  std::string dots;
  std::string marked;
  std::size_t count = 0;
  bool pen_down = false;
  for (const auto& point : series.points) {
    if (picture::place_of(plot, point) != Place::drawn) {
      pen_down = false;
      continue;
    }
    pen_down = pen_down && !(series.segments && count % 2 == 0);
    const std::string at = fmt::format("{} {}", number(canvas.x(point.first)), number(canvas.y(point.second)));
    curve += fmt::format("{}{}{}", pen_down ? 'L' : 'M', at, pen_down ? "" : "h0");
    dots += fmt::format("M{}h0", at);
    marked += fmt::format("<path class=\"point\" d=\"M{}{}\"{}><title>{}: {}, {}</title></path>\n", at, look.marker,
                          fill, xml(series.name), plain_number(point.first, 6), plain_number(point.second, 6));
    pen_down = true;
    ++count;
  }
  std::string out = fmt::format("<g data-series=\"{}\" data-points=\"{}\" {}>\n", xml(series.name), count, look.group);
  if (series.line && count > 1) {
    out += fmt::format("<path d=\"{}\" {}/>\n", curve, look.stroke);
  }
  if (has_markers(series)) {
    out += marked;
  } else if (!series.line && count > 0) {
    out += fmt::format("<path d=\"{}\" {}/>\n", dots, dot_stroke);
  }
  return out + "</g>\n";
}

/// The sample of the i-th curve with its name.
std::string legend_entry(const Plot& plot, std::size_t i, double x, double y, double room) {
  const Series& series = plot.series[i];
  const Appearance look = picture::appearance(plot, i);
  std::string out = fmt::format("<g {}>", look.group);
  if (series.line) {
    out += fmt::format("<path d=\"M{} {}h24\" {}/>", number(x), number(y - 4), look.stroke);
  }
  if (has_markers(series)) {
    out += fmt::format("<path {} d=\"M{} {}{}\"/>", look.marker_fill, number(x + 12), number(y - 4), look.marker);
  } else if (!series.line) {
    out += fmt::format("<path d=\"M{} {}h0\" {}/>", number(x + 12), number(y - 4), dot_stroke);
  }
  return out + "</g>" + text_at(x + 30, y, picture::shortened_to(series.name, room - 30));
}

/// In rows of equal columns, as many as the longest name leaves room for. Moves `y` below it.
std::string legend(const Plot& plot, double left, double& y) {
  double widest = 0;
  for (const Series& series : plot.series) {
    widest = std::max(widest, picture::text_width(series.name));
  }
  const double room = picture::width_of(plot) - edge - left;
  const auto fitting = static_cast<std::size_t>(std::max(1.0, room / (widest + 46)));
  const std::size_t across = std::min({fitting, plot.series.size(), std::size_t{4}});
  std::string out = "<g class=\"legend\">\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    if (i % across == 0) {
      y += line_height;
    }
    const double column = room / static_cast<double>(across);
    const double x = left + column * static_cast<double>(i % across);
    out += legend_entry(plot, i, x, y, column);
  }
  return out + "</g>\n";
}

}  // namespace

std::string svg_plot(const Plot& plot) {
  std::string head;
  double y = edge;
  for (const std::string& title_line : wrapped(plot.title, title_columns)) {
    if (!title_line.empty()) {
      y += line_height;
      head += text_at(edge, y, shortened(title_line, title_columns), "font-size=\"14\" font-weight=\"600\"");
    }
  }
  if (!plot.y_label.empty()) {
    y += line_height + 2;
    head += text_at(edge, y, picture::shortened_to(plot.y_label, picture::width_of(plot) - 2 * edge));
  }

  const Canvas canvas(plot, y + 12);
  std::string out = head + canvas.draw();
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    out += draw_series(plot, canvas, i);
  }
  if (canvas.empty()) {
    out += text_at((canvas.left() + canvas.right()) / 2, (canvas.top() + canvas.bottom()) / 2, "no point to draw",
                   "text-anchor=\"middle\" font-style=\"italic\"");
  }

  y = canvas.bottom() + line_height;
  if (!plot.x_label.empty()) {
    y += line_height;
    out +=
        text_at(canvas.right(), y, picture::shortened_to(plot.x_label, canvas.right() - edge), "text-anchor=\"end\"");
  }
  if (plot.labelled) {
    out += picture::end_labels(plot, canvas);
  } else if (std::any_of(plot.series.begin(), plot.series.end(),
                         [](const Series& series) { return !series.name.empty(); })) {
    y += 4;
    out += legend(plot, canvas.left(), y);
  }
  if (!canvas.left_out().empty()) {
    y += line_height + 2;
    out += text_at(canvas.left(), y, canvas.left_out(), "class=\"left-out\" font-style=\"italic\"");
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" viewBox=\"0 0 {0} "
      "{1}\" "
      "width=\"{0}\" height=\"{1}\">\n<title>{2}</title>\n<g font-family=\"system-ui, sans-serif\" "
      "font-size=\"12\" fill=\"currentColor\">\n{3}</g>\n</svg>\n",
      number(picture::width_of(plot)), number(std::ceil(y + edge)), xml(plot.title), out);
}

std::string_view svg_dark_colours() {
  return picture::dark_colours();
}

}  // namespace goishi::verify
