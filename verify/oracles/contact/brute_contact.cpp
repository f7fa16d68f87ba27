#include "verify/oracles/contact/brute_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "verify/oracles/numbers/golden.hpp"

namespace goishi::verify {

namespace {

using Real = long double;
using Triple_d = Triple<double>;

template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Triple<T> unit(const Triple<T>& a) {
  const T size = std::sqrt(dot(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}

/// S(n): the torus lies in the stone everywhere, a cap's plane beyond its joint is the joint's.
template <class T>
T support_of_hull(const Hull<T>& hull, const T& n_r, const T& n_z) {
  const T torus = hull.torus_radius * n_r + hull.tube_radius;
  const bool on_cap = n_r * (hull.sphere_offset + hull.band) <= n_z * hull.joint_radius;
  return on_cap ? std::max(torus, hull.sphere_radius - hull.sphere_offset * n_z) : torus;
}

template <class T>
struct Seen {
  Hull<T> hull;
  Triple<T> p, u;
  /// inf n · x over the stone.
  T operator()(const Triple<T>& n) const {
    const T axial = dot(u, n);
    const T square = dot(n, n) - axial * axial;
    return dot(p, n) - support_of_hull(hull, square > 0 ? std::sqrt(square) : T(0), std::fabs(axial));
  }
};

template <class T>
Triple<T> cast(const Triple<Real>& a) {
  return {static_cast<T>(a[0]), static_cast<T>(a[1]), static_cast<T>(a[2])};
}

Seen<double> in_double(const Standing& stone) {
  const auto field = [](Real x) { return static_cast<double>(x); };
  const Hull<Real>& hull = stone.hull;
  return {{field(hull.height), field(hull.band), field(hull.sphere_radius), field(hull.sphere_offset),
           field(hull.torus_radius), field(hull.tube_radius), field(hull.joint_radius)},
          cast<double>(stone.p),
          cast<double>(stone.u)};
}

double joint_angle(const Seen<double>& stone) {
  return std::atan2(stone.hull.joint_radius, stone.hull.sphere_offset + stone.hull.band);
}

struct Sample {
  double value;
  Triple_d n;
};

/// Two directions across n.
std::array<Triple_d, 2> across(const Triple_d& n) {
  const Triple_d e =
      std::fabs(n[0]) < std::fabs(n[2]) ? unit<double>({0.0, n[2], -n[1]}) : unit<double>({n[1], -n[0], 0.0});
  return {e, {n[1] * e[2] - n[2] * e[1], n[2] * e[0] - n[0] * e[2], n[0] * e[1] - n[1] * e[0]}};
}

Triple_d off(const Triple_d& n, const std::array<Triple_d, 2>& e, double s, double t) {
  return unit<double>(
      {n[0] + s * e[0][0] + t * e[1][0], n[1] + s * e[0][1] + t * e[1][1], n[2] + s * e[0][2] + t * e[1][2]});
}

/// The simplex of Nelder and Mead in the plane across the normal, climbing from it; started again from what it found.
template <class F>
Sample climb(F&& f, Sample start, double size) {
  struct Corner {
    double value, s, t;
  };
  for (int restart = 0; restart < 3; ++restart) {
    const auto e = across(start.n);
    const auto corner = [&](double s, double t) { return Corner{f(off(start.n, e, s, t)), s, t}; };
    std::array<Corner, 3> simplex = {Corner{start.value, 0.0, 0.0}, corner(size, 0.0), corner(0.0, size)};
    const auto higher = [](const Corner& a, const Corner& b) { return a.value > b.value; };
    for (int i = 0; i < 60; ++i) {
      std::sort(simplex.begin(), simplex.end(), higher);
      const auto& [best, good, worst] = simplex;
      if (std::fabs(best.s - worst.s) + std::fabs(best.t - worst.t) < 1e-9) {
        break;
      }
      const double s = (best.s + good.s) / 2.0, t = (best.t + good.t) / 2.0;
      const auto along = [&](double x) { return corner(s + x * (s - worst.s), t + x * (t - worst.t)); };
      const Corner reflected = along(1.0);
      if (reflected.value > best.value) {
        const Corner expanded = along(2.0);
        simplex[2] = expanded.value > reflected.value ? expanded : reflected;
      } else if (reflected.value > good.value) {
        simplex[2] = reflected;
      } else {
        const Corner contracted = along(reflected.value > worst.value ? 0.5 : -0.5);
        if (contracted.value > std::max(reflected.value, worst.value)) {
          simplex[2] = contracted;
        } else {
          simplex[1] = corner((best.s + good.s) / 2.0, (best.t + good.t) / 2.0);
          simplex[2] = corner((best.s + worst.s) / 2.0, (best.t + worst.t) / 2.0);
        }
      }
    }
    const Corner& best = *std::max_element(simplex.begin(), simplex.end(),
                                           [](const Corner& a, const Corner& b) { return a.value < b.value; });
    const bool moved = best.s != 0.0 || best.t != 0.0;
    start = {best.value, off(start.n, e, best.s, best.t)};
    if (!moved) {
      break;
    }
    size /= 50.0;
  }
  return start;
}

/// Directions evenly over the sphere, on the axes of the stones, and in rings about them as wide as their caps.
template <class See>
void over_sphere(int count, const std::vector<Seen<double>>& stones, See&& see) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    see(Triple_d{r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
  }
  for (const Seen<double>& stone : stones) {
    const auto e = across(stone.u);
    for (const double side : {1.0, -1.0}) {
      const Triple_d pole = {side * stone.u[0], side * stone.u[1], side * stone.u[2]};
      see(pole);
      for (const double width : {0.4, 0.8, 1.2}) {
        const double tangent = std::tan(std::min(width * joint_angle(stone), 1.4));
        for (int k = 0; k < 6; ++k) {
          const double angle = std::numbers::pi / 3.0 * k;
          see(off(pole, e, tangent * std::cos(angle), tangent * std::sin(angle)));
        }
      }
    }
  }
}

/// Between samples there may be better by this much; what is worse is not searched. Were it not enough, the claims
/// would see a search that falls short.
bool is_promising(double value, const Sample& known, const Seen<double>& stone) {
  return value > known.value - 0.4 * (stone.hull.torus_radius + stone.hull.tube_radius);
}

/// The best of samples over the sphere, the best few of them climbed from.
template <class F>
Sample search_sphere(F&& f, int count, const std::vector<Seen<double>>& stones, Sample known) {
  constexpr std::size_t climbed = 6;
  std::array<Sample, climbed> top;
  top.fill({-std::numeric_limits<double>::infinity(), {0.0, 0.0, 1.0}});
  const double apart = 1.0 - 4.0 / count;  // cosine: others are the same hill
  over_sphere(count, stones, [&](const Triple_d& n) {
    Sample sample{f(n), n};
    for (Sample& place : top) {
      const bool same = dot(place.n, sample.n) > apart;
      if (sample.value > place.value) {
        std::swap(place, sample);
      }
      if (same) {
        break;
      }
    }
  });
  for (const Sample& sample : top) {
    if (!is_promising(sample.value, known, stones.front())) {
      continue;
    }
    const Sample found = climb(f, sample, 2.0 / std::sqrt(count));
    if (found.value > known.value) {
      known = found;
    }
  }
  return known;
}

/// The best along n = a cos t + b sin t, a and b axes of the world.
template <class F>
Sample search_arc(F&& f, const Triple_d& a, const Triple_d& b, const Seen<double>& stone, int density, Sample known) {
  const double quarter = std::numbers::pi / 2.0;
  std::vector<double> angles;
  for (int i = 0; i <= density; ++i) {
    angles.push_back(quarter * i / density);
  }
  // Where the arc passes the stone's axis, as densely as its cap is wide.
  for (const double turn : {-2.0, 0.0, 2.0}) {
    const double nearest = std::atan2(dot(stone.u, b), dot(stone.u, a)) + turn * quarter;
    for (const double width : {-1.5, -1.0, -0.7, -0.4, 0.0, 0.4, 0.7, 1.0, 1.5}) {
      const double angle = nearest + width * joint_angle(stone);
      if (0.0 < angle && angle < quarter) {
        angles.push_back(angle);
      }
    }
  }
  std::sort(angles.begin(), angles.end());
  // Of two that are as good as one, round-off decides; a dip must have room.
  angles.erase(std::unique(angles.begin(), angles.end(), [](double one, double next) { return next - one < 1e-4; }),
               angles.end());
  const auto at = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Triple_d{c * a[0] + s * b[0], c * a[1] + s * b[1], c * a[2] + s * b[2]};
  };
  const auto depth = [&](double angle) { return -f(at(angle)); };
  std::vector<double> depths(angles.size());
  std::transform(angles.begin(), angles.end(), depths.begin(), depth);
  const auto see = [&](double angle, double value) {
    if (value > known.value) {
      known = {value, at(angle)};
    }
  };
  for (std::size_t i = 0; i < angles.size(); ++i) {
    see(angles[i], -depths[i]);
  }
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, angles.size() - 1);
    if (depths[i] <= depths[before] && depths[i] <= depths[after] && is_promising(-depths[i], known, stone)) {
      const double angle = golden<double>(depth, angles[before], angles[after], 1e-9);
      see(angle, f(at(angle)));
    }
  }
  return known;
}

/// The value in more digits, at the unit normal.
template <class F>
Best in_full(F&& f, const Triple_d& n) {
  const Triple<Real> normal = unit<Real>({n[0], n[1], n[2]});
  return {f(normal), normal};
}

}  // namespace

long double nearest_along(const Standing& stone, const Triple<Real>& n) {
  return Seen<Real>{stone.hull, stone.p, stone.u}(n);
}

Best search_board(const Standing& stone, Real X, Real Y, int density) {
  const Seen<double> seen = in_double(stone);
  const double x = static_cast<double>(X), y = static_cast<double>(Y);
  const auto f = [&](const Triple_d& n) {
    return n[2] < 0.0 ? -std::numeric_limits<double>::infinity() : seen(n) - x * std::fabs(n[0]) - y * std::fabs(n[1]);
  };
  const Triple_d up = {0.0, 0.0, 1.0};
  Sample best{f(up), up};
  for (const double side_x : {1.0, -1.0}) {
    const Triple_d out_x = {side_x, 0.0, 0.0};
    best = search_arc(f, up, out_x, seen, density, best);
    best = search_arc(f, up, Triple_d{0.0, side_x, 0.0}, seen, density, best);
    for (const double side_y : {1.0, -1.0}) {
      best = search_arc(f, out_x, Triple_d{0.0, side_y, 0.0}, seen, density, best);
    }
  }
  best = search_sphere(f, density * density / 2, {seen}, best);
  return in_full(
      [&](const Triple<Real>& n) { return nearest_along(stone, n) - X * std::fabs(n[0]) - Y * std::fabs(n[1]); },
      best.n);
}

Best search_pair(const Standing& stone, const Standing& other, int density) {
  const Seen<double> one = in_double(stone), two = in_double(other);
  const auto minus = [](const Triple_d& n) { return Triple_d{-n[0], -n[1], -n[2]}; };
  const auto f = [&](const Triple_d& n) { return one(n) + two(minus(n)); };
  const Sample best =
      search_sphere(f, density * density, {one, two}, {-std::numeric_limits<double>::infinity(), {0.0, 0.0, 1.0}});
  return in_full(
      [&](const Triple<Real>& n) {
        return nearest_along(stone, n) + nearest_along(other, {-n[0], -n[1], -n[2]});
      },
      best.n);
}

}  // namespace goishi::verify
