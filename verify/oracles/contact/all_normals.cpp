#include "verify/oracles/contact/all_normals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace goishi::verify {

namespace {

using Vector = Triple<double>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector plus(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// A stone without the ball that rolls along its core: that adds the same along every unit normal.
struct Core {
  Vector p, u;
  double height, sphere, offset, ring, ball;  // half thickness of the core, its caps' sphere, its rim
  double joint_radius, joint_height;          // n meets a cap if its radial part is to its axial as these at most

  explicit Core(const Standing& stone) {
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = static_cast<double>(stone.p[i]);
      u[i] = static_cast<double>(stone.u[i]);
    }
    const Hull<long double>& hull = stone.hull;
    ball = static_cast<double>(hull.tube_radius);
    ring = static_cast<double>(hull.torus_radius);
    sphere = static_cast<double>(hull.sphere_radius - hull.tube_radius);
    offset = static_cast<double>(hull.sphere_offset);
    height = static_cast<double>(hull.sphere_radius - hull.tube_radius - hull.sphere_offset);
    joint_radius = static_cast<double>(hull.joint_radius);
    joint_height = static_cast<double>(hull.sphere_offset + hull.band);
  }

  /// Its point farthest along n.
  [[nodiscard]] Vector support(const Vector& n) const {
    const double axial = dot(n, u), side = axial < 0.0 ? -1.0 : 1.0;
    // Twice, so that what is left along u is nothing beside the radial part: a thin stone's sphere magnifies it.
    const Vector nearly = plus(n, -axial, u);
    const Vector radial = plus(nearly, -dot(nearly, u), u);
    const double length = std::sqrt(dot(radial, radial));
    if (length * joint_height <= side * axial * joint_radius) {
      const Vector chord = plus(n, -side, u);
      return plus(plus(p, side * (height - sphere * dot(chord, chord) / 2.0), u), sphere, radial);
    }
    return plus(p, ring / length, radial);
  }
};

/// A normal, and the difference of the two points that are met along it.
struct Corner {
  Vector n, w;
};

struct Triangle {
  std::array<Corner, 3> corners;
};

/// At least what a bound over a triangle is: the greatest value of a linear function over its normals.
double greatest(const Vector& w, const std::array<Corner, 3>& corners, double over) {
  const double most = std::max({dot(w, corners[0].n), dot(w, corners[1].n), dot(w, corners[2].n)});
  return most > 0.0 ? most * over : most;
}

template <class Between>
AllNormals search(std::vector<std::array<Vector, 3>> cover, Between&& between, double bound) {
  constexpr int most_triangles = 200000;
  AllNormals result;
  std::vector<Triangle> open;
  const auto corner = [&](const Vector& n) {
    const Corner made{n, between(n)};
    if (dot(made.w, n) > bound) {
      result.answer = AllNormals::Answer::better;
      result.n = n;
      result.value = dot(made.w, n);
    }
    return made;
  };
  for (const auto& [a, b, c] : cover) {
    open.push_back({{corner(a), corner(b), corner(c)}});
  }
  while (!open.empty() && result.answer != AllNormals::Answer::better) {
    if (++result.triangles > most_triangles) {
      return result;
    }
    const std::array<Corner, 3> now = open.back().corners;
    open.pop_back();
    // The longest side, from corner k + 1 to corner k + 2.
    std::size_t k = 0;
    double longest = -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector side = plus(now[(i + 1) % 3].n, -1.0, now[(i + 2) % 3].n);
      const double square = dot(side, side);
      if (square > longest) {
        longest = square;
        k = i;
      }
    }
    // A flat triangle of sides up to L lies in a circle of radius L/√3 at most.
    const double over = 1.0 / std::sqrt(1.0 - std::min(longest / 3.0, 2.0 / 3.0));
    if (greatest(now[0].w, now, over) <= bound || greatest(now[1].w, now, over) <= bound ||
        greatest(now[2].w, now, over) <= bound) {
      continue;
    }
    const Corner &one = now[(k + 1) % 3], &two = now[(k + 2) % 3];
    const Vector sum = plus(one.n, 1.0, two.n);
    const double size = std::sqrt(dot(sum, sum));
    const Corner middle = corner({sum[0] / size, sum[1] / size, sum[2] / size});
    open.push_back({{now[k], one, middle}});
    open.push_back({{now[k], middle, two}});
  }
  if (result.answer != AllNormals::Answer::better) {
    result.answer = AllNormals::Answer::none_better;
  }
  return result;
}

}  // namespace

AllNormals ask_all_normals(const Standing& stone, double X, double Y, double bound) {
  const Core core(stone);
  AllNormals all;
  for (const double side_x : {1.0, -1.0}) {
    for (const double side_y : {1.0, -1.0}) {
      Core seen = core;  // from the corner
      seen.p = {core.p[0] - side_x * X, core.p[1] - side_y * Y, core.p[2]};
      const auto between = [&](const Vector& n) {
        const Vector far = seen.support({-n[0], -n[1], -n[2]});
        return far;
      };
      AllNormals found = search({{Vector{side_x, 0.0, 0.0}, Vector{0.0, side_y, 0.0}, Vector{0.0, 0.0, 1.0}}}, between,
                                bound + core.ball);
      found.triangles += all.triangles;
      found.value -= core.ball;
      all = found;
      if (all.answer != AllNormals::Answer::none_better) {
        return all;
      }
    }
  }
  return all;
}

AllNormals ask_all_normals(const Standing& stone, const Standing& other, double bound) {
  Core one(stone), two(other);
  for (std::size_t i = 0; i < 3; ++i) {
    one.p[i] = static_cast<double>(stone.p[i] - other.p[i]);
    two.p[i] = 0.0;
  }
  std::vector<std::array<Vector, 3>> cover;
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {1.0, -1.0}) {
        cover.push_back({Vector{x, 0.0, 0.0}, Vector{0.0, y, 0.0}, Vector{0.0, 0.0, z}});
      }
    }
  }
  AllNormals found = search(
      cover,
      [&](const Vector& n) {
        return plus(one.support({-n[0], -n[1], -n[2]}), -1.0, two.support(n));
      },
      bound + one.ball + two.ball);
  found.value -= one.ball + two.ball;
  return found;
}

}  // namespace goishi::verify
