/// SURFACE: support, distance, rays.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/shape/ray.hpp>
#include <goishi/shape/surface.hpp>
#include <stdexcept>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/golden.hpp"
#include "verify/samples/contact.hpp"

namespace goishi::verify {

namespace {

double length(const Exact3& v) {
  return static_cast<double>(Digits50(sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z())));
}

Digits50 radius_of(const Exact3& v) {
  return sqrt(v.x() * v.x() + v.y() * v.y());
}

/// The point (ρ, z) in the half plane of v.
Exact3 in_half_plane(const Exact3& v, const Digits50& rho, const Digits50& z) {
  const Digits50 radius = radius_of(v);
  const Digits50 over = radius > 0 ? Digits50(rho / radius) : Digits50(0);
  return {Digits50(over * v.x()), Digits50(over * v.y()), z};
}

void require_agreement(double one, double other, double tolerance, const std::string& of) {
  if (!(std::fabs(one - other) <= tolerance)) {
    throw std::runtime_error(fmt::format("two oracles disagree, {:.17g} and {:.17g}: {}", one, other, of));
  }
}

// --- support

Measurement measure_support(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Vec3<double> n = draw_normal(context, specimen.stone, i / 2);
    const Support<double> computed = support(specimen.stone, n);
    const Hull<Digits50> hull = hull_of(specimen);
    const Exact3 normal = exact(n) / Digits50(sqrt(exact(n).squaredNorm()));
    const Digits50 radial = radius_of(normal);
    const auto [rho, z] = farthest(hull, radial, normal.z());
    const Digits50 value = rho * radial + z * normal.z();
    const double width = outer_width(specimen.stone);
    if (i % 10 == 0) {
      const long double searched =
          searched_support(narrow(hull), static_cast<long double>(radial), static_cast<long double>(normal.z()));
      require_agreement(static_cast<double>(searched), static_cast<double>(value), 4.0 * epsilon * width,
                        "support of " + describe(specimen) + " at " + describe(n));
    }
    const auto see = [&](double error, const char* check) {
      checks[check].see(error, width, [&] { return fmt::format("{}, n = {}", describe(specimen), describe(n)); });
    };
    see(std::fabs(static_cast<double>(Digits50(context.produced(computed.value) - value))), "value");
    if (radial > 0 || computed.feature != Feature::rim) {
      see(length(exact(context.produced(computed.p_B)) - in_half_plane(normal, rho, z)), "point");
    }
  }
  return checks.measurement();
}

// --- distance

/// Points of all places: any, near the surface, far, near the axis, in the middle plane, near the bevel's circle.
Vec3<double> draw_point(Context& context, const Specimen& specimen, int i) {
  const double reach = outer_width(specimen.stone) / 2.0;
  const double azimuth = context.uniform(-3.2, 3.2);
  const auto at = [&](double rho, double z) {
    return Vec3<double>(rho * std::cos(azimuth), rho * std::sin(azimuth), z);
  };
  switch (i % 8) {
    case 0: {
      const auto [rho, z] = outline(narrow(hull_of(specimen)), static_cast<long double>(context.uniform(0.0, 1.0)));
      const Vec3<double> off = draw_small(context, 18.0) * reach * draw_unit(context);
      return at(static_cast<double>(rho), static_cast<double>(z)) + off;
    }
    case 1:
      return reach / draw_small(context, 9.0) * draw_unit(context);
    case 2:
      return at(reach * draw_small(context, 18.0), specimen.shape.height * context.uniform(-1.0, 1.0));
    case 3:
      return at(reach * context.uniform(0.0, 2.0),
                i % 3 == 0 ? 0.0 : specimen.shape.height * draw_small(context, 18.0));
    case 4:
      return at(specimen.stone.bevel_major_radius, 0.0) + draw_small(context, 12.0) * reach * draw_unit(context);
    case 5:
      return Vec3<double>(0.0, 0.0, i % 3 == 0 ? 0.0 : specimen.shape.height * context.uniform(-1.0, 1.0));
    case 6:
      return at(reach * context.uniform(0.0, 1.0), specimen.shape.height * context.uniform(-0.6, 0.6));
    default:
      return reach * 2.0 * context.uniform(0.0, 1.0) * draw_unit(context);
  }
}

Measurement measure_distance(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Vec3<double> p = draw_point(context, specimen, i / 2);
    const SurfacePoint<double> computed = closest_point(specimen.stone, p);
    const Hull<Digits50> hull = hull_of(specimen);
    const Exact3 point = exact(p);
    const Digits50 rho = radius_of(point);
    const Foot foot = closest_foot(hull, rho, point.z());
    const double scale = std::max(outer_width(specimen.stone), p.norm());
    if (i % 10 == 0) {
      const long double searched =
          searched_distance(narrow(hull), static_cast<long double>(rho), static_cast<long double>(point.z()));
      require_agreement(static_cast<double>(searched), static_cast<double>(foot.distance), 4.0 * epsilon * scale,
                        "distance of " + describe(p) + " from " + describe(specimen));
    }
    const Digits50 distance = outside(hull, rho, point.z()) < 0 ? Digits50(-foot.distance) : foot.distance;
    const auto see = [&](double error, const char* check) {
      checks[check].see(error, scale, [&] { return fmt::format("{}, p = {}", describe(specimen), describe(p)); });
    };
    see(std::fabs(static_cast<double>(Digits50(context.produced(computed.distance) - distance))), "distance");
    if (computed.unique) {
      // A shift of the point turns the normal by its size over the distance from the centre of curvature, and moves the
      // foot by the radius as many times.
      const double turn = std::max(1.0, foot.from_centre / scale);
      see(length(exact(context.produced(computed.p_B)) - in_half_plane(point, foot.rho, foot.z)) /
              std::max(1.0, foot.radius / foot.from_centre),
          "closest point");
      see(length(exact(context.produced(computed.normal_B)) - in_half_plane(point, foot.n_r, foot.n_z)) *
              foot.from_centre / turn,
          "normal");
    }
  }
  return checks.measurement();
}

// --- rays

struct Line {
  Hull<long double> hull;
  Vec3<long double> p, u;
  long double operator()(long double t) const {
    const Vec3<long double> x = p + t * u;
    return outside<long double>(hull, std::hypot(x.x(), x.y()), x.z());
  }
  /// Where it changes sign between a point inside and one outside.
  [[nodiscard]] long double crossing(long double inside, long double out) const {
    for (int i = 0; i < 80; ++i) {
      const long double middle = (inside + out) / 2;
      ((*this)(middle) < 0 ? inside : out) = middle;
    }
    return (inside + out) / 2;
  }
};

Measurement measure_ray(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-4);
    const double width = outer_width(specimen.stone);
    if (specimen.stone.sphere_radius > 1000.0 * width) {
      continue;  // the oracle subtracts the sphere's radius in long double
    }
    // Aimed at a point of the box about the stone; from inside, near, far; every eighth nearly along the surface.
    const Vec3<double> aim(width * context.uniform(-0.55, 0.55), width * context.uniform(-0.55, 0.55),
                           specimen.shape.height * context.uniform(-0.55, 0.55));
    Vec3<double> u = draw_unit(context);
    if (i % 8 == 0) {
      u.z() *= draw_small(context, 6.0);
      u.normalize();
    }
    const double away = i % 4 == 0 ? 0.0 : i % 4 == 1 ? 100.0 * width : width * context.uniform(-2.0, 2.0);
    const Vec3<double> p = aim - away * u;
    const RayHit<double> computed = cast_ray(specimen.stone, p, u);
    const Line line{narrow(hull_of(specimen)), p.cast<long double>(), u.cast<long double>().normalized()};
    const long double nearest = -line.p.dot(line.u), reach = static_cast<long double>(width);
    const long double deepest = golden<long double>(line, nearest - reach, nearest + reach, 1e-12L * reach);
    const double scale = std::max(width, p.norm()), depth = static_cast<double>(line(deepest)) / scale;
    const auto describe_it = [&](const char* what) {
      return fmt::format("{}: {}, p = {}, u = {}", what, describe(specimen), describe(p), describe(u));
    };
    const auto choose = [&](bool right, const char* what) {
      see_choice(checks["choices"], right, [&] { return describe_it(what); });
    };
    if (std::fabs(depth) < 1e-13) {
      continue;  // it grazes: whether it hits is beyond round-off
    }
    choose(computed.hit == (depth < 0.0), "hit");
    if (!computed.hit || !(depth < 0.0)) {
      continue;
    }
    const long double entry = line.crossing(deepest, nearest - reach), exit = line.crossing(deepest, nearest + reach);
    const auto see_end = [&](double t, long double expected, const char* what) {
      // How far off the surface; and, where the ray is steeper than 1 : 10, how far along the ray.
      const Long residual = std::fabs(line(static_cast<Long>(t))), off = std::fabs(static_cast<Long>(t) - expected);
      checks["off the surface"].see(static_cast<double>(residual), scale, [&] { return describe_it(what); });
      if (std::fabs(static_cast<double>(line(expected + 1e-6L * reach) - line(expected - 1e-6L * reach))) >
          2e-7 * width) {
        checks["along the ray"].see(static_cast<double>(off), scale, [&] { return describe_it(what); });
      }
    };
    see_end(context.produced(computed.entry), entry, "entry");
    see_end(context.produced(computed.exit), exit, "exit");
    const double first = 0 < entry ? computed.entry : computed.exit;
    const bool ahead = 0 < exit;
    if (std::fabs(static_cast<double>(entry)) > 1e-12 * scale && std::fabs(static_cast<double>(exit)) > 1e-12 * scale) {
      choose(computed.forward == ahead, "whether it is ahead");
      choose(!ahead || computed.first == first, "which is first");
    }
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> surface_claims() {
  return {
      {.id = "SURFACE-1",
       .statement =
           "The support of a stone, value and point, is that of the solid: sharp, bevelled, thin, round, at the "
           "switch of cap and rim.",
       .function = "support",
       .family = OracleFamily::other_formula,
       .oracle = "farthest point of caps and torus in 50 digits; the outline searched by golden section must agree",
       .checks = {within("value", 1e-15, "of the width",
                         "the bar; three roundings of terms up to half the width, the stone's fields have one each",
                         epsilon / 4.0),
                  within("point", 1e-15, "of the width", "the bar; as the value, in each coordinate", epsilon / 4.0)},
       .measure = measure_support},
      {.id = "SURFACE-2",
       .statement = "Signed distance, closest point and normal are those of the solid.",
       .function = "closest_point, signed_distance",
       .family = OracleFamily::other_formula,
       .oracle = "the nearest of the feet on caps, bevel and edge in 50 digits; sign: inside both balls and the torus "
                 "rule; the outline searched by golden section must agree",
       .checks = {within("distance", 1e-15, "of the greater of width and distance from the centre",
                         "the bar; the distance from the axis, from the centre of curvature and the quotient have two "
                         "roundings each",
                         epsilon / 4.0),
                  within(
                      "closest point", 1e-15, "of the greater of width and distance from the centre",
                      "as the distance; near a centre of curvature as many times less as a shift of the point counts",
                      epsilon / 4.0),
                  within("normal", 1e-15, "of the greater of width and distance from the centre",
                         "as the closest point", epsilon / 4.0)},
       .measure = measure_distance},
      {.id = "SURFACE-3",
       .statement = "A ray enters and leaves a stone where the solid begins and ends; the first hit ahead is the right "
                    "one; a line that passes is said to pass.",
       .function = "cast_ray",
       .family = OracleFamily::brute_force,
       .oracle = "inside both balls and the torus rule, bisected along the line in long double",
       .checks = {within("off the surface", 2e-15, "of the greater of width and distance",
                         "two roundings of p + t u, and the distance's 1e-15 (SURFACE-2)", epsilon / 4.0),
                  within("along the ray", 1e-14, "of the greater of width and distance",
                         "of a ray that is steeper than 1 : 10, up to ten times as much; twice a ray's two ends",
                         epsilon / 4.0),
                  none("choices", "hits, misses and orders that are wrong")},
       .measure = measure_ray},
  };
}

}  // namespace goishi::verify
