#include "verify/oracles/stone/geometry.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <stdexcept>

#include "verify/oracles/numbers/multiprecision.hpp"

namespace goishi::verify {

namespace {

using Real = Digits50;

/// The root of f between low and high, where f changes its sign, to 45 digits.
template <class F>
Real root(F&& f, const Real& low, const Real& high) {
  const auto close = [](const Real& a, const Real& b) { return abs(b - a) <= Real("1e-45") * (abs(a) + abs(b)); };
  std::uintmax_t iterations = 400;
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, close, iterations);
  if (!close(a, b)) {
    throw std::runtime_error("no root found for a stone's geometry");
  }
  return (a + b) / 2;
}

struct Circle {
  Real distance;  // of the torus' centre circle from the axis
  Real radius;
};

/// The circle with its centre on the plane of the rim that touches the sphere of offset d from inside, at height b/2.
Circle touching_circle(const Real& h, const Real& b, const Real& d) {
  const Real r = d + h / 2;
  const Real radius = root([&](const Real& tube) { return -d + r * d / (r - tube) - b / 2; }, Real(0), r - d);
  return {sqrt((r - radius) * (r - radius) - d * d), radius};
}

Geometry geometry(const Real& h, const Real& b, const Real& d, const Circle& circle) {
  const Real r = d + h / 2;
  const Real joint = sqrt(r * r - (d + b / 2) * (d + b / 2));
  return {.height = static_cast<double>(h),
          .bevel = static_cast<double>(b),
          .sphere_radius = static_cast<double>(r),
          .sphere_offset = static_cast<double>(d),
          .torus_radius = static_cast<double>(circle.distance),
          .tube_radius = static_cast<double>(circle.radius),
          .joint_radius = static_cast<double>(joint),
          .outer_radius = static_cast<double>(circle.distance + circle.radius)};
}

/// Offset of the centre that is as far from the rim as from the pole.
Real equidistant_offset(const Real& w, const Real& h) {
  return root(
      [&](const Real& d) {
        const Real to_rim = sqrt(w * w / 4 + d * d);
        const Real to_pole = h / 2 + d;
        return to_rim - to_pole;
      },
      Real(0), w * w / h);
}

}  // namespace

Geometry solve_published(double width, double height, double bevel) {
  const Real w(width), h(height), b(bevel);
  const Real d = equidistant_offset(w, h);
  return geometry(h, b, d, bevel > 0.0 ? touching_circle(h, b, d) : Circle{w / 2, Real(0)});
}

Geometry solve_measured(double outer_width, double height, double bevel) {
  const Real w(outer_width), h(height), b(bevel);
  const auto excess = [&](const Real& d) {
    const Circle circle = touching_circle(h, b, d);
    return circle.distance + circle.radius - w / 2;
  };
  const Real low = equidistant_offset(w, h);
  Real high = 2 * low;
  while (excess(high) < 0) {
    high *= 2;
  }
  const Real d = root(excess, low, high);
  return geometry(h, b, d, touching_circle(h, b, d));
}

}  // namespace goishi::verify
