/// BOARD: its nine regions, rays, and the boards by standard.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <goishi/board/ray.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/shape/catalogue.hpp>
#include <string>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

// --- regions

/// −1, 0 or 1: the side of the board that a region is at.
struct Side {
  int x, y;
};

Side side_of(Region region) {
  const std::string_view name = to_string(region);
  const auto has = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
  return {has("left") ? -1 : has("right") ? 1 : 0, has("bottom") ? -1 : has("top") ? 1 : 0};
}

/// Whether a region lets a stone touch along a normal out of the board.
bool allows(Region region, const Vec3<double>& n) {
  const Side side = side_of(region);
  const auto fits = [](double component, int at) { return component == 0.0 || component * at > 0.0; };
  return fits(n.x(), side.x) && fits(n.y(), side.y);
}

/// Dots where the centre of a stone on the surface is, by the kind of its region; the board's outline.
Plot picture() {
  const Board<double> board = make_board<double>({.lines = 5});
  const double reach = outer_width(make_stone(0.022, 0.0092, 0.001)) / 2.0;
  const auto mm = [](double x, double y) { return std::pair(1e3 * x, 1e3 * y); };
  const double X = board.half_width, Y = board.half_length;
  std::array<Series, 4> kinds;
  kinds[0] = {.name = "primary: the surface", .points = {}, .line = false};
  kinds[1] = {.name = "four sides: surface, a side, the edge between", .points = {}, .line = false};
  kinds[2] = {.name = "four corners: surface, two sides, three edges, a corner", .points = {}, .line = false};
  kinds[3] = {.name = "out of reach", .points = {}, .line = false, .look = Look::foreign};
  constexpr int count = 56;
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; j <= count; ++j) {
      const double x = (X + 1.3 * reach) * (2.0 * i / count - 1.0), y = (Y + 1.3 * reach) * (2.0 * j / count - 1.0);
      const Region region = region_of(board, Vec3<double>(x, y, 0.0), reach);
      const Side side = side_of(region);
      const std::size_t kind =
          region == Region::out_of_reach ? 3 : static_cast<std::size_t>(std::abs(side.x) + std::abs(side.y));
      kinds[kind].points.push_back(mm(x, y));
    }
  }
  Series outline{.name = "the board's outline", .points = {mm(-X, -Y), mm(X, -Y), mm(X, Y), mm(-X, Y), mm(-X, -Y)}};
  return {.title = "The nine regions of a board with five lines, from above, for the centre of a stone of size 33",
          .x_label = "x [mm]",
          .y_label = "y [mm]",
          .equal_scale = true,
          .series = {kinds[0], kinds[1], kinds[2], kinds[3], outline}};
}

Measurement measure_regions(Context& context) {
  Measurement result;
  Measured& seen = result.checks.emplace_back(Measured{.error = 0.0});
  std::array<int, 10> regions{};
  Specimen specimen;
  for (int i = 0; i < context.samples(40000, 400000); ++i) {
    if (i % 8 == 0) {
      specimen = draw_stone(context, i / 8);
    }
    const Stone<double>& stone = specimen.stone;
    const double reach = outer_width(stone) / 2.0;
    const Board<double> board = draw_board(context, i / 48);
    if (board.half_width < reach || board.half_length < reach) {
      continue;  // two sides at once are within reach: no board of nine regions
    }
    const Pose<double> pose = draw_board_pose(context, stone, board, i);
    const Separation<double> at = separation(stone, pose, board);
    const double depth = std::fmax(0.0, -at.gap);
    if (board.half_width < reach + depth || board.half_length < reach + depth) {
      continue;  // likewise
    }
    // One that overlaps may be pushed out over whatever is within its reach and depth.
    const Region region = region_of(board, pose.p_WB, context.produced(reach) + depth);
    ++regions[static_cast<std::size_t>(region)];
    // What touches, or is no deeper than it takes for the shortest way out to be another.
    const bool touches = std::fabs(at.gap) < 1e-3 * reach || (at.gap < 0.0 && pose.p_WB.z() > -stone.height / 2.0);
    const bool wrong = region == Region::out_of_reach ? at.gap < -4.0 * epsilon * board.half_length
                                                      : touches && !allows(region, at.n_W);
    ++seen.cases;
    if (wrong) {
      seen.error += 1.0;
      seen.worst_case =
          fmt::format("{}: {}, board {:a} × {:a}, n = {}, gap {:.6g}", to_string(region), describe(specimen, pose),
                      board.half_width, board.half_length, describe(at.n_W), at.gap);
    }
  }
  for (std::size_t k = 0; k < regions.size(); ++k) {
    result.figures.push_back({std::string(to_string(static_cast<Region>(k))), fmt::format("{} poses", regions[k])});
  }
  result.plots = {picture()};
  return result;
}

// --- rays

Measurement measure_rays(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(20000, 200000); ++i) {
    const Board<double> board = draw_board(context, i / 8);
    const Vec3<double> size(board.half_width, board.half_length, board.thickness / 2.0);
    const auto within = [&](double share) {
      return Vec3<double>(size.x() * context.uniform(-share, share), size.y() * context.uniform(-share, share),
                          -size.z() + size.z() * context.uniform(-share, share));
    };
    Vec3<double> u = draw_unit(context);
    if (i % 5 == 0) {  // in a plane of the axes, or along one
      u[i / 5 % 3] = 0.0;
      u[(i / 5 + 1) % 3] *= i % 10 == 0 ? 0.0 : 1.0;
      u.normalize();
    }
    const double away = i % 3 == 0 ? 0.0 : i % 3 == 1 ? context.uniform(-1.0, 1.0) : 10.0;
    const Vec3<double> p = within(1.5) - away * u;
    const BoardRayHit<double> hit = cast_ray(board, p, u);
    const double scale = size.sum() + p.norm();
    /// < 0 in the board.
    const auto outside = [&](double t) {
      const Vec3<double> x = p + t * u;
      return std::max(
          {std::fabs(x.x()) - board.half_width, std::fabs(x.y()) - board.half_length, x.z(), -board.thickness - x.z()});
    };
    const auto describe_it = [&](const char* what) {
      return fmt::format("{}: board {:a} × {:a} × {:a}, p = {}, u = {}", what, board.half_width, board.half_length,
                         board.thickness, describe(p), describe(u));
    };
    const auto see = [&](const char* check, double error, const char* what) {
      checks[check].see(error, scale, [&] { return describe_it(what); });
    };
    const auto choose = [&](bool right, const char* what) {
      see_choice(checks["choices"], right, [&] { return describe_it(what); });
    };
    const double round_off = 4.0 * epsilon * scale;
    if (!hit.hit) {
      // Convex along the line: nowhere inside, at points that close in on the nearest.
      double low = -p.dot(u) - 2.0, high = -p.dot(u) + 2.0;
      for (int k = 0; k < 80; ++k) {
        const double one = low + (high - low) / 3.0, other = high - (high - low) / 3.0;
        (outside(one) < outside(other) ? high : low) = outside(one) < outside(other) ? other : one;
      }
      choose(outside((low + high) / 2.0) > -round_off, "it passes, and is inside");
      continue;
    }
    const double entry = context.produced(hit.entry), exit = context.produced(hit.exit);
    see("ends", std::fabs(outside(entry)), "entry");
    see("ends", std::fabs(outside(exit)), "exit");
    choose(outside((hit.entry + hit.exit) / 2.0) < round_off, "outside between entry and exit");
    choose(hit.forward == (hit.exit >= 0.0), "forward");
    if (hit.forward) {
      const double first = hit.entry < 0.0 ? hit.exit : hit.entry;
      choose(hit.first >= first && hit.first <= first, "first");
      const Vec3<double> at = context.produced(hit.p_W);
      see("hit point", (at - (p + hit.first * u)).norm(), "from the ray");
      // Out of the board there; against the ray from outside, along it from inside.
      see("hit point",
          std::fabs(std::fabs(hit.n_W.dot(at + size.z() * Vec3<double>::UnitZ())) - size.dot(hit.n_W.cwiseAbs())),
          "from the face");
      choose(hit.n_W.dot(u) * (hit.entry < 0.0 ? 1.0 : -1.0) >= 0.0, "the normal's direction");
    }
  }
  return checks.measurement();
}

// --- standards

/// Two stones of a colour on neighbouring intersections along x (0) or y (1), and what is between them   [mm].
struct Neighbours {
  Standard standard;
  StoneColor color;
  int axis;
  double gap;  // < 0: they overlap
};

constexpr std::array<Neighbours, 8> neighbours = {{{Standard::talk, StoneColor::white, 0, 0.0},
                                                   {Standard::talk, StoneColor::black, 0, -0.3},
                                                   {Standard::talk, StoneColor::white, 1, 1.7},
                                                   {Standard::talk, StoneColor::black, 1, 1.4},
                                                   {Standard::nihon_kiin, StoneColor::white, 0, 0.43},
                                                   {Standard::nihon_kiin, StoneColor::black, 0, 0.13},
                                                   {Standard::nihon_kiin, StoneColor::white, 1, 2.02},
                                                   {Standard::nihon_kiin, StoneColor::black, 1, 1.72}}};

void see_neighbours(const Context& context, Checks& checks, const Neighbours& two) {
  const Stone<double> stone = make_stone<double>(catalogue_stone(33, two.color, two.standard));
  const Board<double> board = make_board(board_dimensions<double>(two.standard));
  const auto lying = [&](int i, int j) {
    const Vec3<double> p_W = context.produced(intersection(board, i, j));
    return Pose<double>{.p_WB = {p_W.x(), p_W.y(), stone.height / 2.0}, .q_WB = {1.0, 0.0, 0.0, 0.0}};
  };
  const Pose<double> one = lying(9, 9);
  Pose<double> other = two.axis == 0 ? lying(10, 9) : lying(9, 10);
  const auto describe_it = [&] {
    return fmt::format("{} {}, along {}", to_string(two.standard), to_string(two.color), two.axis == 0 ? "x" : "y");
  };
  if (two.gap < 0.0 || 0.0 < two.gap) {
    const bool overlap = separation(stone, one, stone, other).status == SeparationStatus::overlapping;
    see_choice(checks["overlaps"], overlap == (two.gap < 0.0), describe_it);
  }
  // Slid together, or apart, by what is between them, they touch.
  other.p_WB[two.axis] -= 1e-3 * two.gap;
  checks["neighbours"].see(std::fabs(separation(stone, one, stone, other).gap), stone.width, describe_it);
}

/// Sides, and the height over the floor, as published   [mm].
struct PublishedBoard {
  std::string_view name;
  BoardDimensions<double> dimensions;
  double width, length, height;
  double half_digit;  // 0: the figures are exact
};

void see_board(const Context& context, Checks& checks, const PublishedBoard& published) {
  const Board<double> board = make_board(published.dimensions);
  const auto see = [&](double metres, double millimetres, double half_digit, const char* what) {
    const double error = std::fabs(1e3 * context.produced(metres) - millimetres);
    checks[half_digit > 0.0 ? "as printed" : "sides"].see(
        error, half_digit > 0.0 ? half_digit : epsilon * millimetres,
        [&] { return fmt::format("{} of {}", what, published.name); });
  };
  see(2.0 * board.half_width, published.width, published.half_digit, "width");
  see(2.0 * board.half_length, published.length, published.half_digit, "length");
  see(-board.floor, published.height, 0.0, "height");
}

Measurement measure_standards(Context& context) {
  Checks checks;
  const auto talk = board_dimensions<double>(Standard::talk);
  const auto nihon_kiin = board_dimensions<double>(Standard::nihon_kiin);
  const PublishedBoard boards[] = {
      {"the talk's board", talk, 424.2, 454.5, 151.5, 0.0},
      {"the Nihon Ki-in's board", nihon_kiin, 424.3, 454.6, 151.5, 0.05},
      {"the Nihon Ki-in's with 13 lines", board_dimensions<double>(Standard::nihon_kiin, 13), 290.0, 315.0, 151.5, 0.0},
      {"the talk's for the floor", floor_board(talk), 424.2, 454.5, 182.0 + 115.0, 0.0},
      {"the Nihon Ki-in's on long legs", floor_board(nihon_kiin, boards::long_legs), 424.3, 454.6, 182.0 + 120.0,
       0.05}};
  for (const PublishedBoard& board : boards) {
    see_board(context, checks, board);
  }
  for (const Neighbours& two : neighbours) {
    see_neighbours(context, checks, two);
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> board_claims() {
  return {
      {.id = "BOARD-1",
       .statement = "A stone touches only what its region names: out of reach nothing, over the primary region the "
                    "surface alone, at a side that side and its edge, at a corner that corner's sides and edges.",
       .function = "region_of",
       .family = OracleFamily::invariant,
       .oracle = "the normal of the separation, which CONTACT-2 judges, at poses of every stratum",
       .checks = {none("", "poses")},
       .measure = measure_regions},
      {.id = "BOARD-2",
       .statement =
           "A ray enters and leaves the board where the box begins and ends, all six faces; a ray that passes is "
           "said to pass.",
       .function = "cast_ray (board)",
       .family = OracleFamily::invariant,
       .oracle = "inside the box or not, along the ray",
       .checks = {within("ends", 4.0 * epsilon, "of the board and the distance",
                         "a difference, a quotient, a product and a sum, each rounded once", epsilon),
                  within("hit point", 4.0 * epsilon, "of the board and the distance",
                         "p + t u is rounded twice in each coordinate, and is set upon the face", epsilon),
                  none("choices", "hits, orders and normals that are wrong")},
       .measure = measure_rays},
      {.id = "BOARD-3",
       .statement =
           "The boards have the published sides; on neighbouring lines two black stones of the talk overlap by "
           "0.3 mm, its white ones touch, and between those of the Nihon Ki-in are 0.13 and 0.43 mm.",
       .function = "board_dimensions, floor_board, catalogue_stone, separation (two stones)",
       .family = OracleFamily::published,
       .oracle = "the published figures, and their differences by hand",
       .checks = {within("sides", 4.0, "ε of the side", "spacing and border rounded once each, twice a sum", 0.5),
                  within("as printed", 1.0, "half last printed digits", "424.34 × 454.56 mm, printed with one decimal",
                         1e-9),
                  within("neighbours", 4.0 * epsilon, "of the width", "spacing, width and figure rounded once each",
                         0.5 * epsilon),
                  none("overlaps", "pairs that overlap and should not, or the reverse")},
       .measure = measure_standards},
  };
}

}  // namespace goishi::verify
