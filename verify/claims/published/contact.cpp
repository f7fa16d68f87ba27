/// PUBLISHED: the talk's test of a stone against the board, its push-out, its support, and how far they are off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/separating_axis.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/shape/catalogue.hpp>
#include <numbers>

#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

using std::numbers::pi;

/// Collects numbers that the talk or its critique gives with so many digits, and says what was found.
class Figures {
 public:
  void see(double value, double expected, double digit, const std::string& name) {
    worst_.see(std::fabs(value - expected), digit, [&] { return name; });
    figures_.push_back({name, fmt::format("{:.5f} mm", value)});
  }
  void see_over(double value, double least, const std::string& name, const std::string& text) {
    worst_.see(value > least ? 0.0 : 1.0 + least - value, [&] { return name; });
    figures_.push_back({name, text});
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

/// Between the published push-out and the contact normal, for a stone of size 33 that is up to 1 mm deep.
struct Disagreement {
  Pose<double> pose;
  double degrees = 0.0;
  double depth = 0.0;  // [m]
};

Disagreement disagreement(const Board<double>& board, const Pose<double>& pose) {
  const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  const PublishedSeparation<double> published = separating_axis_published(stone, pose, board);
  const Separation<double> at = separation(stone, pose, board);
  const bool counts = published.colliding && at.gap < 0.0 && at.gap > -1e-3;
  const double cosine = counts ? std::clamp(published.axis_W.dot(at.n_W), -1.0, 1.0) : 1.0;
  return {pose, std::acos(cosine) * 180.0 / pi, -at.gap};
}

/// The worst of searches that each begin with random poses at edges and corners, and go on ever nearer to their worst.
Disagreement worst_disagreement(Context& context, const Board<double>& board) {
  Disagreement worst;
  for (int round = 0; round < 8; ++round) {
    Disagreement found;
    const auto see = [&](const Pose<double>& pose) {
      const Disagreement now = disagreement(board, pose);
      if (now.degrees > found.degrees) {
        found = now;
      }
    };
    for (int i = 0; i < 3000; ++i) {
      see(draw_board_pose(context, make_stone(0.022, 0.0092, 0.001), board, 8 * (i / 2) + 1 + i % 2));
    }
    for (int i = 0; i < 3000; ++i) {
      const double size = 0.3 * draw_small(context, 4.0);
      const Eigen::AngleAxisd turn(size * context.uniform(-1.0, 1.0), draw_unit(context));
      see({.p_WB = found.pose.p_WB + 0.01 * size * draw_unit(context), .q_WB = (turn * found.pose.q_WB).normalized()});
    }
    if (found.degrees > worst.degrees) {
      worst = found;
    }
  }
  return worst;
}

Measurement measure_push_out(Context& context) {
  const Board<double> board = make_board<double>();
  Figures figures;
  const Pose<double> shallow = over_corner(context, board, worst_at_edge(), -4e-5);
  const PublishedSeparation<double> pushed = separating_axis_published(published_stone(), shallow, board);
  figures.see(-1e3 * context.produced(separation(published_stone(), shallow, board).gap), 0.04, 1e-3, "a depth of");
  figures.see(1e3 * context.produced(pushed.depth), 1.2, 0.1, "is pushed out by");

  const Disagreement worst = worst_disagreement(context, board);
  figures.see_over(context.produced(worst.degrees), 60.0, "push-out and contact normal differ by up to",
                   fmt::format("{:.1f}°, at a depth of {:.3f} mm", worst.degrees, 1e3 * worst.depth));
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
       .checks = {{.unit = "last digits given",
                   .bound = 0.5,
                   .reason = "half a unit of the last digit that is given",
                   .resolution = 0.5}},
       .mutants = {{"contact/separating_axis.hpp", "result.add(x + up);", "result.add(x + up + up);"},
                   {"contact/separating_axis.hpp", "result.add(x + y + up);", "result.add(x + y + up + up);"}},
       .measure = measure_false_collisions},
      {.id = "PUBLISHED-12",
       .statement =
           "It pushes a stone that is 0.04 mm deep out by 1.2 mm, and elsewhere along an axis that is more than "
           "60° off the contact normal.",
       .function = "separation (board), separating_axis_published",
       .family = OracleFamily::published,
       .oracle = "size 33 over an edge, half way between two of its axes; a search over poses at edges and corners",
       .checks = {{.unit = "last digits given",
                   .bound = 0.5,
                   .reason = "half a unit of the last digit that is given",
                   .resolution = 0.5}},
       .mutants = {{"contact/separating_axis.hpp", ": T(-depth);", ": depth;"}},
       .measure = measure_push_out},
      {.id = "PUBLISHED-13",
       .statement =
           "The published support, with its switch at (w/2)/r in place of d/r, is wrong by 2.116 mm at size 22, "
           "and by no more than 0.0014 mm at size 33, where w/h is near 1 + √2.",
       .function = "support",
       .family = OracleFamily::published,
       .oracle = "the published switch, written anew here, at 90001 angles",
       .checks = {{.unit = "last digits given",
                   .bound = 0.5,
                   .reason = "half a unit of the last digit that is given",
                   .resolution = 0.5}},
       .mutants = {{"shape/surface.hpp",
                    "return stone.height / T(2) + stone.sphere_offset * radial_square / (T(1) + axial);",
                    "return stone.height / T(2) + stone.sphere_offset * radial_square / (T(2) + axial);"}},
       .measure = measure_support},
  };
}

}  // namespace goishi::verify
