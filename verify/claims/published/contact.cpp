/// PUBLISHED: the talk's test of a stone against the board, its push-out, its support, and how far they are off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/stone_board.hpp>
#include <goishi/published/separating_axis.hpp>
#include <goishi/shape/catalogue.hpp>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

using std::numbers::pi;

/// Collects numbers that the talk or its critique gives with so many digits, and says what was found.
class Figures {
 public:
  void see(double value, double expected, double digit, const std::string& name, const char* unit = " mm") {
    worst_.see(std::fabs(value - expected), digit, [&] { return name; });
    figures_.push_back({name, fmt::format("{:.5f}{}", value, unit)});
  }
  [[nodiscard]] Measurement measurement() const {
    Measurement result = worst_.measurement();
    result.figures = figures_;
    return result;
  }

 private:
  Worst worst_;
  std::vector<Figure> figures_;
};

/// Sharp size 33.
Stone<double> published_stone() {
  return make_stone(0.022, 0.0092);
}

/// The stone over the right edge, or the top right corner where n_y > 0, its axis along n, its lowest point `gap` away.
Pose<double> over_corner(Context& context, const Board<double>& board, const Vec3<double>& n, double gap) {
  const double along = n.y() > 0.0 ? board.half_length : 0.0;
  return {.p_WB = Vec3<double>(board.half_width, along, 0.0) + (published_stone().height / 2.0 + gap) * n,
          .q_WB = attitude_with_axis(context, n)};
}

/// The normals that are farthest from every fixed axis.
Vec3<double> worst_at_edge() {
  return {std::sin(pi / 8.0), 0.0, std::cos(pi / 8.0)};
}
Vec3<double> worst_at_corner() {
  return Vec3<double>(std::sqrt(2.0) - 1.0, std::sqrt(3.0) - std::sqrt(2.0), 1.0).normalized();
}

// --- PUBLISHED-11

Measurement measure_false_collisions(Context& context) {
  const Board<double> board = make_board<double>();
  const auto false_gap = [&](const Vec3<double>& n) {
    double low = 0.0, high = 0.005;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2.0;
      const Pose<double> pose = over_corner(context, board, n, middle);
      (separating_axis_published(published_stone(), pose, board).colliding ? low : high) = middle;
    }
    const Pose<double> pose = over_corner(context, board, n, low);
    return 1e3 * context.produced(separation(published_stone(), pose, board).gap);
  };
  Figures figures;
  figures.see(false_gap(worst_at_edge()), 1.273, 0.001, "called a collision at an edge: a gap up to");
  figures.see(false_gap(worst_at_corner()), 1.979, 0.001, "called a collision at a corner: a gap up to");
  return figures.measurement();
}

// --- PUBLISHED-12

/// Size 33 with a bevel of 1 mm, 0.95 mm deep at a corner of the board: the worst that a search over poses found.
Pose<double> worst_pose() {
  return {.p_WB = {0.215757, -0.234259, 0.005540},
          .q_WB = Quat<double>(-0.103979, -0.383643, 0.865899, -0.303687).normalized()};
}

Measurement measure_push_out(Context& context) {
  const Board<double> board = make_board<double>();
  Figures figures;
  const Pose<double> shallow = over_corner(context, board, worst_at_edge(), -4e-5);
  const PublishedSeparation<double> pushed = separating_axis_published(published_stone(), shallow, board);
  figures.see(-1e3 * context.produced(separation(published_stone(), shallow, board).gap), 0.04, 1e-3, "a depth of");
  figures.see(1e3 * context.produced(pushed.depth), 1.2, 0.1, "is pushed out by");

  const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  const PublishedSeparation<double> elsewhere = separating_axis_published(stone, worst_pose(), board);
  const Separation<double> at = separation(stone, worst_pose(), board);
  const double cosine = elsewhere.colliding ? std::clamp(elsewhere.axis_W.dot(at.n_W), -1.0, 1.0) : NAN;
  const double angle = std::acos(cosine) * 180.0 / pi;
  figures.see(context.produced(angle), 90.0, 0.1, "elsewhere along an axis off the contact normal by", "°");
  figures.see(-1e3 * context.produced(at.gap), 0.954, 1e-3, "there, a depth of");
  return figures.measurement();
}

// --- PUBLISHED-13

/// The published support of a sharp stone: cap where μ is over the cosine (w/2)/r of the rim, in place of d/r.
double published_support(const Stone<double>& stone, double axial) {
  const double radial = std::sqrt((1.0 - axial) * (1.0 + axial));
  return axial >= stone.width / 2.0 / stone.sphere_radius ? stone.sphere_radius - stone.sphere_offset * axial
                                                          : stone.width / 2.0 * radial;
}

/// Right and as published, against the angle from the axis; how far they differ at most   [mm].
double compare_supports(const Context& context, const Stone<double>& stone, Plot& plot) {
  Series right{.name = "right", .points = {}}, published{.name = "published", .points = {}, .look = Look::foreign};
  double greatest = 0.0;
  constexpr int count = 90000;
  for (int i = 0; i <= count; ++i) {
    const double angle = pi / 2.0 * i / count;
    const Vec3<double> n(std::sin(angle), 0.0, std::cos(angle));
    const double ours = context.produced(support(stone, n).value), theirs = published_support(stone, n.z());
    greatest = std::max(greatest, std::fabs(theirs - ours));
    if (i % 250 == 0) {
      right.points.emplace_back(90.0 * i / count, 1e3 * ours);
      published.points.emplace_back(90.0 * i / count, 1e3 * theirs);
    }
  }
  plot.series = {right, published};
  return 1e3 * greatest;
}

Measurement measure_support(Context& context) {
  Figures figures;
  std::vector<Plot> plots;
  for (const auto& [number, expected, digit] : {std::tuple(22, 2.116, 0.001), std::tuple(33, 0.0014, 0.0001)}) {
    const CatalogueStone size = catalogue_stone(number, StoneColor::white);
    const Stone<double> stone = make_stone(metres<double>(size.width), metres<double>(size.height));
    Plot plot{.title = fmt::format("Support of size {}, sharp, right and as published", number),
              .x_label = "angle of the direction from the axis [°]",
              .y_label = "support [mm]",
              .series = {}};
    figures.see(compare_supports(context, stone, plot), expected, digit,
                fmt::format("size {}, {:g} mm thick: off by up to", number, 1e3 * stone.height));
    plots.push_back(plot);
  }
  Measurement result = figures.measurement();
  result.plots = plots;
  return result;
}

}  // namespace

std::vector<Claim> published_contact_claims() {
  return {
      {.id = "PUBLISHED-11",
       .statement =
           "The talk's separating-axis test, its axes fixed at 45°, calls a gap of up to 1.273 mm at an edge of "
           "the board and of 1.979 mm at a corner a collision.",
       .function = "separation (board), separating_axis_published",
       .family = OracleFamily::published,
       .oracle = "r (sec 22.5° − 1), and at the corner r (sec 27.57° − 1)",
       .checks = {within("", 0.5, "last digits given", "half a unit of the last digit that is given", 0.5)},
       .measure = measure_false_collisions},
      {.id = "PUBLISHED-12",
       .statement =
           "It pushes a stone that is 0.04 mm deep out by 1.2 mm, and elsewhere along an axis that is more than "
           "60° off the contact normal: across it, at a corner.",
       .function = "separation (board), separating_axis_published",
       .family = OracleFamily::published,
       .oracle =
           "size 33 over an edge, half way between two of its axes; the worst pose of a search at edges and corners",
       .checks = {within("", 0.5, "last digits given", "half a unit of the last digit that is given", 0.5)},
       .measure = measure_push_out},
      {.id = "PUBLISHED-13",
       .statement =
           "The published support, with its switch at (w/2)/r in place of d/r, is wrong by 2.116 mm at size 22, "
           "and by no more than 0.0014 mm at size 33, where w/h is near 1 + √2.",
       .function = "support",
       .family = OracleFamily::published,
       .oracle = "the published switch, written anew here, at 90001 angles",
       .checks = {within("", 0.5, "last digits given", "half a unit of the last digit that is given", 0.5)},
       .measure = measure_support},
  };
}

}  // namespace goishi::verify
