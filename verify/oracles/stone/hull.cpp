#include "verify/oracles/stone/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verify/oracles/numbers/golden.hpp"

namespace goishi::verify {

namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

/// The least of f over [0, 1], piece by piece: cap, bevel, bevel, cap. Every dip of the samples is searched.
template <class F>
Real least_over_outline(F&& f) {
  constexpr std::size_t count = 24;
  std::array<Real, count + 1> value;
  Real least = std::numeric_limits<Real>::infinity();
  for (int piece = 0; piece < 4; ++piece) {
    const auto place = [&](std::size_t i) { return (piece + Real(i) / count) / 4; };
    for (std::size_t i = 0; i <= count; ++i) {
      value[i] = f(place(i));
      least = std::min(least, value[i]);
    }
    for (std::size_t i = 0; i <= count; ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, count);
      if (value[i] <= value[before] && value[i] <= value[after]) {
        least = std::min(least, f(golden<Real>(f, place(before), place(after), 1e-18L)));
      }
    }
  }
  return least;
}

}  // namespace

Hull<Digits50> construct_hull(double width, double height, double bevel) {
  const Digits50 w(width), h(height), b(bevel);
  // The sphere's centre is as far from the rim as from the pole: (w/2)² + d² = (h/2 + d)².
  const Digits50 d = (w * w - h * h) / (4 * h);
  const Digits50 r = d + h / 2;
  if (bevel == 0.0) {
    return {h, Digits50(0), r, d, w / 2, Digits50(0), w / 2};
  }
  // From the centre of the cap's sphere through the joint: where that line crosses the middle plane, the torus has its
  // circle.
  const Digits50 joint = sqrt(r * r - (d + b / 2) * (d + b / 2));
  const Digits50 torus = joint - (b / 2) * joint / (d + b / 2);
  const Digits50 tube = sqrt((joint - torus) * (joint - torus) + b * b / 4);
  return {h, b / 2, r, d, torus, tube, joint};
}

Hull<long double> narrow(const Hull<Digits50>& hull) {
  const auto field = [](const Digits50& x) { return static_cast<Real>(x); };
  return {field(hull.height),       field(hull.band),        field(hull.sphere_radius), field(hull.sphere_offset),
          field(hull.torus_radius), field(hull.tube_radius), field(hull.joint_radius)};
}

template <class T>
T outside(const Hull<T>& hull, const T& rho, const T& z) {
  const auto length = [](const T& x, const T& y) { return T(sqrt(x * x + y * y)); };
  const T height = z < 0 ? T(-z) : z;
  const T beyond = rho - hull.torus_radius;
  if (beyond > 0 && height * hull.torus_radius < hull.sphere_offset * beyond) {
    return length(beyond, height) - hull.tube_radius;
  }
  return length(rho, height + hull.sphere_offset) - hull.sphere_radius;  // the farther of the two balls' centres
}
template Real outside(const Hull<Real>&, const Real&, const Real&);
template Digits50 outside(const Hull<Digits50>&, const Digits50&, const Digits50&);

std::array<long double, 2> outline(const Hull<Real>& hull, Real s) {
  const Real joint = std::atan2(hull.joint_radius, hull.sphere_offset + hull.band);  // the cap's half angle
  const Real side = s < 0.5L ? 1.0L : -1.0L;
  const Real along = s < 0.5L ? 2 * s : 2 * (1 - s);  // 0 at the pole, 1 on the rim
  const Real on_cap = hull.tube_radius > 0 ? 0.5L : 1.0L;
  if (along <= on_cap) {
    const Real half = std::sin(joint * along / on_cap / 2);
    return {hull.sphere_radius * std::sin(joint * along / on_cap),
            side * (hull.height / 2 - 2 * hull.sphere_radius * half * half)};
  }
  const Real angle = joint + (pi / 2 - joint) * (along - on_cap) / (1 - on_cap);
  return {hull.torus_radius + hull.tube_radius * std::sin(angle), side * hull.tube_radius * std::cos(angle)};
}

long double searched_support(const Hull<Real>& hull, Real n_r, Real n_z) {
  return -least_over_outline([&](Real s) {
    const auto [rho, z] = outline(hull, s);
    return -(n_r * rho + n_z * z);
  });
}

long double searched_distance(const Hull<Real>& hull, Real rho, Real z) {
  return least_over_outline([&](Real s) {
    const auto [x, y] = outline(hull, s);
    return std::hypot(rho - x, z - y);
  });
}

template <class T>
std::array<T, 2> farthest(const Hull<T>& hull, const T& n_r, const T& n_z) {
  const T side = n_z < 0 ? T(-1) : T(1);
  // The caps' normals are those that are nearer to the axis than the joint's.
  if (n_r * (hull.sphere_offset + hull.band) <= side * n_z * hull.joint_radius) {
    return {hull.sphere_radius * n_r, hull.sphere_radius * n_z - side * hull.sphere_offset};
  }
  return {hull.torus_radius + hull.tube_radius * n_r, hull.tube_radius * n_z};
}
template std::array<Real, 2> farthest(const Hull<Real>&, const Real&, const Real&);
template std::array<Digits50, 2> farthest(const Hull<Digits50>&, const Digits50&, const Digits50&);

Foot closest_foot(const Hull<Digits50>& hull, const Digits50& rho, const Digits50& z) {
  const Digits50 zero(0);
  Foot best{zero, zero, zero, zero, Digits50(-1), 0.0, 0.0};
  // The foot of the circle of this radius about (x, y), if it is on the outline.
  const auto see = [&](const Digits50& x, const Digits50& y, const Digits50& radius, auto&& is_on_outline) {
    const Digits50 reach = sqrt((rho - x) * (rho - x) + (z - y) * (z - y));
    const Digits50 n_r = reach > 0 ? Digits50((rho - x) / reach) : zero;
    const Digits50 n_z = reach > 0 ? Digits50((z - y) / reach) : Digits50(1);
    const Digits50 foot_rho = x + radius * n_r, foot_z = y + radius * n_z;
    const Digits50 distance = abs(reach - radius);
    if (is_on_outline(foot_rho, foot_z) && (best.distance < 0 || distance < best.distance)) {
      best = {foot_rho, foot_z, n_r, n_z, distance, static_cast<double>(reach), static_cast<double>(radius)};
    }
  };
  for (const int side : {1, -1}) {
    see(zero, -side * hull.sphere_offset, hull.sphere_radius,
        [&](const Digits50&, const Digits50& y) { return side * y >= hull.band; });
  }
  see(hull.torus_radius, zero, hull.tube_radius,
      [&](const Digits50& x, const Digits50&) { return hull.tube_radius == 0 || x >= hull.joint_radius; });
  return best;
}

}  // namespace goishi::verify
