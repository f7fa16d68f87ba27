/// CONTACT: where bodies touch, and along which normal.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

Measurement measure_plane_points(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const PlaneCase drawn = draw_plane_case(context, i);
    const Stone<double>& stone = drawn.specimen.stone;
    const auto see = [&](const Separation<double>& at, const char* name) {
      // The axis is rounded; the point moves by the sphere's radius for each radian of it.
      const Digits50 off = sqrt((exact(context.produced(at.p_stone)) - drawn.lowest).squaredNorm());
      worst.see(static_cast<double>(off) / (drawn.scale + stone.sphere_radius),
                [&] { return fmt::format("{}: {}", name, describe(drawn)); });
    };
    see(separation(stone, drawn.pose, drawn.plane), "separation");
    if (i % 2 == 0) {
      see(surface_separation(stone, drawn.pose, drawn.plane.offset), "surface_separation");
    }
  }
  return worst.measurement();
}

// --- bodies of several normals

Long3 vector(const Triple<Long>& v) {
  return {v[0], v[1], v[2]};
}

/// The point of the stone that is farthest against n.
Long3 lowest_point(const Standing& stone, const Long3& n) {
  const Long3 u = vector(stone.u);
  const Long axial = u.dot(n);
  const Long3 across = n - axial * u;
  const Long radial = across.norm();
  const auto [rho, height] = farthest(stone.hull, radial, axial);
  return vector(stone.p) - (radial > 0 ? Long3(rho / radial * across) : Long3(Long3::Zero())) - height * u;
}

/// What lies between two bodies along a normal: from the other body's support point to the stone's, its part along the
/// normal the separation, the rest the separation's gradient.
struct Between {
  std::function<Long3(const Long3&)> stone, other;
  Long3 operator()(const Long3& n) const { return stone(n) - other(n); }
};

/// Newton's step to the stationary normal, in the space of one or two directions across n.
struct Correction {
  Long3 step;
  Long stiffness;  // the least eigenvalue: what a normal that is off by one radian costs in slope [m]
};

/// Curvatures by differences to the side of these signs: at the joint of cap and rim they jump.
Correction correction(const Between& between, const Long3& n, const std::vector<Long3>& directions,
                      const std::array<Long, 2>& signs) {
  constexpr Long h = 1e-7L;
  const Long3 w = between(n);
  const auto change = [&](const Long3& e, Long sign) {
    return Long3((between((n + sign * h * e).normalized()) - w) / (sign * h));
  };
  const Long gap = w.dot(n);
  const Long3& e = directions.front();
  const Long3 by_e = change(e, signs[0]);
  const Long a = gap - by_e.dot(e);
  if (directions.size() == 1) {
    return {w.dot(e) / a * e, a};
  }
  const Long3& f = directions.back();
  const Long3 by_f = change(f, signs[1]);
  const Long b = (-by_e.dot(f) - by_f.dot(e)) / 2, c = gap - by_f.dot(f);
  const Long determinant = a * c - b * b;
  const Long s = (c * w.dot(e) - b * w.dot(f)) / determinant, t = (a * w.dot(f) - b * w.dot(e)) / determinant;
  return {s * e + t * f, (a + c) / 2 - std::hypot((a - c) / 2, b)};
}

/// To the softest side.
Correction correction(const Between& between, const Long3& n, const std::vector<Long3>& directions) {
  Correction softest{Long3::Zero(), std::numeric_limits<Long>::infinity()};
  if (!directions.empty()) {
    for (const std::array<Long, 2>& signs : {std::array<Long, 2>{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const Correction side = correction(between, n, directions, signs);
      if (!(side.stiffness >= softest.stiffness)) {
        softest = side;
      }
    }
  }
  return softest;
}

/// The stationary normal on the way of a step that the softest side gave: on a stiffer side it is reached sooner.
Long3 stationary_along(const Between& between, const Long3& n, const Long3& step) {
  const auto at = [&](Long part) { return Long3((n + part * step).normalized()); };
  const auto overshoots = [&](Long part) { return between(at(part)).dot(step) < 0; };
  if (!overshoots(1)) {
    return at(1);
  }
  Long low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const Long middle = (low + high) / 2;
    (overshoots(middle) ? high : low) = middle;
  }
  return at(high);
}

/// Directions across n in which the board's normal may turn.
std::vector<Long3> free_directions(const Long3& n, bool on_board) {
  std::vector<Long3> axes;
  for (int k = 0; k < 3; ++k) {
    if (!on_board || n[k] != 0) {
      axes.emplace_back(Long3::Unit(k));
    }
  }
  if (axes.size() == 1) {
    return {};
  }
  if (axes.size() == 2) {
    return {Long3(axes[0].cross(axes[1]).cross(n))};
  }
  const Long3 e = n.unitOrthogonal();
  return {e, n.cross(e)};
}

struct SeenPoints {
  Checks checks;
  int normals = 0, ill_conditioned = 0;

  /// How far normal and points are off, where a radian of the normal costs a hundredth of the width. A support point moves
  /// by the `radius` of its sphere for each radian.
  template <class Describe>
  void see(const Context& context, const Separation<double>& at, const Between& between, bool on_board, double width,
           double radius, Describe&& describe) {
    const Vec3<double> turned(context.produced(at.n_W.x()), at.n_W.y(), at.n_W.z());  // a length would not be seen
    const Long3 n = Long3(turned.template cast<Long>()).normalized();
    const Correction off = correction(between, n, free_directions(n, on_board));
    if (!(off.stiffness > static_cast<Long>(0.01 * width))) {
      ++ill_conditioned;
      return;
    }
    ++normals;
    const Long3 right = stationary_along(between, n, off.step);
    checks["normal"].see(static_cast<double>((right - n).norm()), [&] { return "normal" + describe(); });
    // The points are those of the normal that is given.
    const Long3 given = at.n_W.template cast<Long>().normalized(), on_stone = between.stone(given);
    const Long3 on_other = on_board ? Long3(on_stone - between(given).dot(given) * given) : between.other(given);
    const auto see_point = [&](const Vec3<double>& p, const Long3& expected, const char* name) {
      const double far = static_cast<double>((context.produced(p).cast<Long>() - expected).norm());
      checks["points"].see(far / (width + radius), [&] { return name + describe(); });
    };
    see_point(at.p_stone, on_stone, "p_stone");
    see_point(at.p_other, on_other, "p_other");
  }
};

Measurement measure_points(Context& context) {
  SeenPoints seen;
  for (int i = 0; i < context.samples(4000, 40000); ++i) {
    const Specimen specimen = draw_stone(context, i / 8);
    const Board<double> board = draw_board(context, i / 48);
    const Pose<double> pose = draw_board_pose(context, specimen.stone, board, i);
    const Standing stone = standing(narrow(hull_of(specimen)), pose);
    const Separation<double> at = separation(specimen.stone, pose, board);
    const Between between{[&](const Long3& n) { return lowest_point(stone, n); },
                          [&](const Long3& n) {
                            return Long3(std::copysign(static_cast<Long>(board.half_width), n.x()),
                                         std::copysign(static_cast<Long>(board.half_length), n.y()), 0);
                          }};
    seen.see(context, at, between, true, outer_width(specimen.stone), specimen.stone.sphere_radius, [&] {
      return fmt::format(" ({}, {}): {}, board {:a} × {:a}, gap {:.6g}", board_strata[static_cast<std::size_t>(i % 8)],
                         to_string(at.other_feature), describe(specimen, pose), board.half_width, board.half_length,
                         at.gap);
    });
  }
  const int at_board = seen.normals, hard_at_board = seen.ill_conditioned;
  for (int i = 0; i < context.samples(3000, 30000); ++i) {
    const Pair pair = draw_pair(context, i);
    const Separation<double> at = separation(pair);
    const Standing one = standing(narrow(hull_of(pair.first)), pair.pose),
                   two = standing(narrow(hull_of(pair.second)), pair.other_pose);
    const Between between{[&](const Long3& n) { return lowest_point(one, n); },
                          [&](const Long3& n) { return lowest_point(two, Long3(-n)); }};
    const double width = std::max(2.0 * reach_of(pair), (pair.pose.p_WB - pair.other_pose.p_WB).norm());
    // Where the cores touch, a sharp rim has a fan of normals, and its edge is no better known.
    const double cores = at.gap + pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius;
    if (std::fabs(cores) < 1e-6 * width) {
      ++seen.ill_conditioned;
      continue;
    }
    seen.see(context, at, between, false, width, pair.first.stone.sphere_radius + pair.second.stone.sphere_radius, [&] {
      return fmt::format(" ({}): {}, gap {:.6g}", pair_strata[static_cast<std::size_t>(i % pair_strata_count)],
                         describe(pair), at.gap);
    });
  }
  Measurement result = seen.checks.measurement();
  result.figures = {{"at the board", fmt::format("{}; {} too ill conditioned to judge", at_board, hard_at_board)},
                    {"of two stones", fmt::format("{}; {} too ill conditioned to judge", seen.normals - at_board,
                                                  seen.ill_conditioned - hard_at_board)}};
  return result;
}

}  // namespace

std::vector<Claim> contact_point_claims() {
  return {
      {.id = "CONTACT-6",
       .statement = "The contact point of a stone over a plane is its lowest point.",
       .function = "separation (plane), surface_separation",
       .family = OracleFamily::other_formula,
       .oracle = "the farthest point of caps and torus in 50 digits",
       .checks = {within("", 2e-15, "of the greater of width and distance, plus the sphere's radius",
                         "the axis, 2 ulp, turns the point about the sphere's centre; then as CONTACT-1",
                         epsilon / 4.0)},
       .measure = measure_plane_points},
      {.id = "CONTACT-7",
       .statement =
           "The normal is that at which the separation is stationary, wherever a normal that is off by a radian costs "
           "at least a hundredth of the width in slope; the contact points are those that it meets.",
       .function = "separation (board, stones)",
       .family = OracleFamily::other_formula,
       .oracle = "slope and curvature of the separation in long double, from the farthest points of caps and torus",
       .checks = {within("normal", 2e-10, "radians",
                         "a fifth of the bar, 1e-9; what the last step of a search over the normals leaves: "
                         "measured 2026-11-30 with 14 seeds: up to 6.8e-11. Resolution: a slope is rounded to ε of "
                         "the sphere's radius, 250 widths, and divided by that hundredth",
                         250.0 * epsilon / 0.01),
                  within("points", 2e-14, "of the width and the spheres' radii",
                         "they are those that the given normal meets, to the roundings of its parts; measured "
                         "2026-11-30 with 11 seeds: up to 4.6e-15",
                         epsilon)},
       .measure = measure_points},
  };
}

}  // namespace goishi::verify
