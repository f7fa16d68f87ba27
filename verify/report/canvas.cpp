#include "verify/report/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/escape.hpp"

namespace goishi::verify::picture {

namespace {

constexpr double usual_height = 300;
constexpr double least_height = 120;
constexpr double greatest_height = 460;
constexpr double labelled_height = 460;

std::string line(double x1, double y1, double x2, double y2, std::string_view opacity) {
  return fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"currentColor\" stroke-opacity=\"{}\"/>\n", number(x1),
                     number(y1), number(x2), number(y2), opacity);
}

/// To the right of the frame.
double margin_of(const Plot& plot) {
  double widest = 0;
  for (const Series& series : plot.series) {
    widest = std::max(widest, text_width(series.name));
  }
  return plot.labelled ? leader_room + widest : 2 * edge;
}

struct Reason {
  std::string_view text;
  std::size_t count = 0;
};

std::string left_out_sentence(const std::vector<Reason>& reasons) {
  std::size_t total = 0;
  std::vector<std::string> parts;
  for (const Reason& reason : reasons) {
    total += reason.count;
    if (reason.count > 0) {
      parts.push_back(fmt::format("{} {}", reason.count, reason.text));
    }
  }
  return total == 0 ? "" : fmt::format("left out: {}", fmt::join(parts, ", "));
}

}  // namespace

double width_of(const Plot& plot) {
  return plot.labelled ? 960 : 640;
}

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

double text_width(std::string_view text) {
  return letter * static_cast<double>(columns(text));
}

std::string shortened_to(std::string_view text, double room) {
  return shortened(text, static_cast<std::size_t>(std::max(1.0, room / letter)));
}

std::string text_at(double x, double y, std::string_view text, std::string_view attributes) {
  return fmt::format("<text x=\"{}\" y=\"{}\"{}{}>{}</text>\n", number(x), number(y), attributes.empty() ? "" : " ",
                     attributes, xml(text));
}

Place place_of(const Plot& plot, const std::pair<double, double>& point) {
  const auto place = [](double value, bool logarithmic) {
    if (!std::isfinite(value)) {
      return Place::not_finite;
    }
    if (logarithmic) {
      return value > 0 ? Place::drawn : Place::not_positive;
    }
    return std::abs(value) <= greatest_coordinate ? Place::drawn : Place::too_large;
  };
  const Place on_x = place(point.first, plot.log_x);
  return on_x == Place::drawn ? place(point.second, plot.log_y) : on_x;
}

Canvas::Canvas(const Plot& plot, double top)
    : top_(top),
      height_(plot.labelled ? labelled_height : usual_height),
      left_(edge),
      right_(width_of(plot) - margin_of(plot)) {
  std::vector<double> xs;
  std::vector<double> ys;
  std::vector<Reason> reasons = {{"not finite"}, {"beyond ±10³⁰⁰"}, {"not positive on a logarithmic axis"}};
  for (const Series& series : plot.series) {
    for (const auto& point : series.points) {
      const Place place = place_of(plot, point);
      if (place == Place::drawn) {
        xs.push_back(point.first);
        ys.push_back(point.second);
      } else {
        ++reasons[static_cast<std::size_t>(place) - 1].count;
      }
    }
  }
  empty_ = xs.empty();
  left_out_ = left_out_sentence(reasons);
  x_ = axis_around(xs, plot.log_x);
  y_ = axis_around(ys, plot.log_y);
  place_y_ticks();
  if (plot.equal_scale && plot.log_x == plot.log_y) {
    equalize();
    place_y_ticks();  // the frame's height has changed, and with the labels its left side
    equalize();
  }
  place_x_ticks();
}

std::string Canvas::draw() const {
  std::string out = "<g class=\"axes\">\n";
  for (const Tick& tick : x_ticks_) {
    const double at = left() + tick.at * across();
    const double length = tick.label.empty() ? 3 : 5;
    if (!tick.label.empty()) {
      out += line(at, top(), at, bottom(), "0.13");
      out += text_at(at, bottom() + line_height, tick.label, "text-anchor=\"middle\"");
    }
    out += line(at, bottom(), at, bottom() + length, "0.6");
  }
  for (const Tick& tick : y_ticks_) {
    const double at = bottom() - tick.at * height_;
    const double length = tick.label.empty() ? 3 : 5;
    if (!tick.label.empty()) {
      out += line(left(), at, right(), at, "0.13");
      out += text_at(left() - 8, at + 4, tick.label, "text-anchor=\"end\"");
    }
    out += line(left() - length, at, left(), at, "0.6");
  }
  out += line(left(), top(), left(), bottom(), "0.6");
  out += line(left(), bottom(), right(), bottom(), "0.6");
  return out + "</g>\n";
}

/// Makes one unit equally long on both axes: first by the frame's height, then by a wider range.
void Canvas::equalize() {
  const double x_span = x_.high - x_.low;
  const double y_span = y_.high - y_.low;
  height_ = std::clamp(across() * (y_span / x_span), least_height, greatest_height);
  const auto widen = [](Axis& axis, double span) {
    const double more = std::max(0.0, span - (axis.high - axis.low)) / 2;
    axis.low -= more;
    axis.high += more;
  };
  widen(x_, y_span * (across() / height_));
  widen(y_, x_span * (height_ / across()));
}

void Canvas::place_y_ticks() {
  y_ticks_ = ticks(y_, [&](const std::vector<Tick>& some) {
    const auto count = std::count_if(some.begin(), some.end(), [](const Tick& tick) { return !tick.label.empty(); });
    return static_cast<double>(count) * 1.5 * line_height <= height_ + line_height;
  });
  double widest = 0;
  for (const Tick& tick : y_ticks_) {
    widest = std::max(widest, text_width(tick.label));
  }
  left_ = edge + std::min(widest, 120.0) + 10;
}

void Canvas::place_x_ticks() {
  x_ticks_ = ticks(x_, [&](const std::vector<Tick>& some) {
    double end = -edge;  // of the label before
    for (const Tick& tick : some) {
      if (!tick.label.empty()) {
        const double half = text_width(tick.label) / 2;
        const double at = left() + tick.at * across();
        if (at - half < end + letter || at + half > right_ + 2 * edge) {
          return false;
        }
        end = at + half;
      }
    }
    return true;
  });
}

}  // namespace goishi::verify::picture
