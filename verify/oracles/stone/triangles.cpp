#include "verify/oracles/stone/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace goishi::verify {

namespace {

Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double product(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

double segment_distance(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 along = difference(b, a), to = difference(p, a);
  const double share = std::clamp(product(to, along) / product(along, along), 0.0, 1.0);
  return length({to[0] - share * along[0], to[1] - share * along[1], to[2] - share * along[2]});
}

}  // namespace

double triangle_distance(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  // p = a + s (b − a) + t (c − a) + what is across: the normal equations.
  const Point3 u = difference(b, a), v = difference(c, a), w = difference(p, a);
  const double uu = product(u, u), uv = product(u, v), vv = product(v, v), uw = product(u, w), vw = product(v, w);
  const double determinant = uu * vv - uv * uv;
  const double s = (vv * uw - uv * vw) / determinant, t = (uu * vw - uv * uw) / determinant;
  if (0.0 <= s && 0.0 <= t && s + t <= 1.0) {
    return length({w[0] - s * u[0] - t * v[0], w[1] - s * u[1] - t * v[1], w[2] - s * u[2] - t * v[2]});
  }
  return std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
}

void Triangles::add(const Point3& a, const Point3& b, const Point3& c) {
  Point3 centre{};
  for (std::size_t i = 0; i < 3; ++i) {
    centre[i] = (a[i] + b[i] + c[i]) / 3.0;
  }
  const double reach =
      std::max({length(difference(a, centre)), length(difference(b, centre)), length(difference(c, centre))});
  all_.push_back({a, b, c, centre, reach});
}

double Triangles::distance(const Point3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const One& one : all_) {
    if (length(difference(p, one.centre)) - one.reach < least) {  // else it is farther
      least = std::min(least, triangle_distance(p, one.a, one.b, one.c));
    }
  }
  return least;
}

}  // namespace goishi::verify
