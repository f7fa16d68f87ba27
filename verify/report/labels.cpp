#include "verify/report/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/look.hpp"

namespace goishi::verify::picture {

namespace {

constexpr double label_distance = 17;

struct End {
  std::size_t series;
  double x;
  double y;
};

/// Where each curve ends on the picture, from top to bottom. A curve without a point has no end.
std::vector<End> ends_of(const Plot& plot, const Canvas& canvas) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const auto& points = plot.series[i].points;
    const auto last = std::find_if(points.rbegin(), points.rend(),
                                   [&](const auto& point) { return place_of(plot, point) == Place::drawn; });
    if (last != points.rend()) {
      ends.push_back({i, canvas.x(last->first), canvas.y(last->second)});
    }
  }
  // At one height, what ends further right comes first: so the thin lines do not cross.
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    const auto height = [](const End& end) { return std::lround(end.y / label_distance); };
    return height(a) != height(b) ? height(a) < height(b) : a.x > b.x;
  });
  return ends;
}

std::string name_beside(const Plot& plot, const End& end) {
  return fmt::format("<g {}>", appearance(plot, end.series).group) +
         text_at(end.x + 12, end.y + 4, plot.series[end.series].name, "font-weight=\"700\"") + "</g>\n";
}

std::string name_in_column(const Plot& plot, const End& end, double column, double y) {
  const Appearance look = appearance(plot, end.series);
  return fmt::format(
             "<g {}><path d=\"M{} {}L{} {}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.45\" "
             "stroke-width=\"0.8\"/><path {} d=\"M{} {}{}\"/></g>",
             look.group, number(end.x + 5), number(end.y), number(column - 6), number(y), look.marker_fill,
             number(column), number(y), look.marker) +
         text_at(column + 9, y + 4, plot.series[end.series].name);
}

}  // namespace

std::vector<double> spread(std::vector<double> wanted, double distance, double low, double high) {
  // Blocks of places that touch, each at the mean of what its members want.
  struct Block {
    double sum;  // of the wanted place of the first, as seen by each member
    std::size_t count;
    [[nodiscard]] double first() const { return sum / static_cast<double>(count); }
  };
  std::vector<Block> blocks;
  for (const double place : wanted) {
    blocks.push_back({place, 1});
    while (blocks.size() > 1) {
      Block& before = blocks[blocks.size() - 2];
      const Block& last = blocks.back();
      const double shift = static_cast<double>(before.count) * distance;
      if (last.first() >= before.first() + shift) {
        break;
      }
      before = {before.sum + last.sum - shift * static_cast<double>(last.count), before.count + last.count};
      blocks.pop_back();
    }
  }
  std::size_t i = 0;
  for (const Block& block : blocks) {
    for (std::size_t k = 0; k < block.count; ++k) {
      wanted[i++] = block.first() + distance * static_cast<double>(k);
    }
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    wanted[k] = std::max(wanted[k], low + distance * static_cast<double>(k));
  }
  for (std::size_t k = wanted.size(); k-- > 0;) {
    wanted[k] = std::min(wanted[k], high - distance * static_cast<double>(wanted.size() - 1 - k));
  }
  return wanted;
}

std::string end_labels(const Plot& plot, const Canvas& canvas) {
  std::string out = "<g class=\"labels\">\n";
  std::vector<End> ends = ends_of(plot, canvas);
  for (const End& end : ends) {
    if (plot.series[end.series].look == Look::star) {
      out += name_beside(plot, end);
    }
  }
  std::erase_if(ends, [&](const End& end) { return plot.series[end.series].look == Look::star; });
  std::vector<double> wanted;
  for (const End& end : ends) {
    wanted.push_back(end.y);
  }
  std::sort(wanted.begin(), wanted.end());
  const std::vector<double> places = spread(wanted, label_distance, canvas.top(), canvas.bottom());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    out += name_in_column(plot, ends[i], canvas.right() + leader_room - 18, places[i]);
  }
  return out + "</g>\n";
}

}  // namespace goishi::verify::picture
