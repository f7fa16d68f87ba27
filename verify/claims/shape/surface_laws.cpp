/// SURFACE: what must hold for any convex solid of revolution.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/shape/surface.hpp>

#include "verify/claims/claims.hpp"
#include "verify/samples/contact.hpp"

namespace goishi::verify {

namespace {

using Long = long double;
using Long3 = Vec3<Long>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// |n| S(n/|n|).
Long homogeneous_support(const Stone<Long>& stone, const Long3& v) {
  const Long size = v.norm();
  return size * support(stone, Long3(v / size)).value;
}

/// Central differences with a step h in each coordinate.
template <class F>
Long3 gradient(F&& f, const Long3& at, Long h) {
  Long3 result;
  for (int k = 0; k < 3; ++k) {
    Long3 step = Long3::Zero();
    step[k] = h;
    result[k] = (f(Long3(at + step)) - f(Long3(at - step))) / (2 * h);
  }
  return result;
}

/// The distance is 1-Lipschitz, the support convex, both the same seen in a mirror.
Measurement measure_laws(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(10000, 100000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Stone<double>& stone = specimen.stone;
    const double width = outer_width(stone);
    const auto see = [&](double error, const char* name, const Vec3<double>& one, const Vec3<double>& other) {
      worst.see(error, width, [&] {
        return fmt::format("{}: {}, at {} and {}", name, describe(specimen), describe(one), describe(other));
      });
    };
    const Vec3<double> p = width * context.uniform(0.0, 1.0) * draw_unit(context);
    const SurfacePoint<double> at_p = closest_point(stone, p);
    const Vec3<double> q = p + width * draw_small(context, 12.0) * (i % 2 == 0 ? at_p.normal_B : draw_unit(context));
    see(std::fabs(context.produced(at_p.distance) - signed_distance(stone, q)) - (p - q).norm(), "1-Lipschitz", p, q);
    see(is_inside(stone, p) == (at_p.distance <= 0.0) ? 0.0 : 1.0, "inside", p, p);

    const Vec3<double> n = draw_normal(context, stone, i / 2),
                       m = i % 2 == 0 ? draw_normal(context, stone, i / 14)
                                      : Vec3<double>((n + draw_small(context, 17.0) * draw_unit(context)).normalized());
    const Support<double> at_n = support(stone, n);
    const Vec3<double> sum = n + m;
    if (sum.norm() > 1e-3) {
      const double between = sum.norm() * support(stone, Vec3<double>(sum.normalized())).value;
      see(context.produced(between) - at_n.value - support(stone, m).value, "convex", n, m);
    }
    see(-at_n.value, "positive", n, n);
    // S(n) n is the plane, the point lies in it: another direction's point does not lie beyond.
    see(support(stone, m).p_B.dot(n) - context.produced(at_n.value), "the farthest point is the farthest", n, m);

    for (int k = 0; k < 3; ++k) {
      const auto mirrored = [&](Vec3<double> v) {
        v[k] = -v[k];
        return v;
      };
      const Support<double> seen = support(stone, mirrored(n));
      see(std::fabs(seen.value - at_n.value) + (seen.p_B - mirrored(at_n.p_B)).norm(), "support in a mirror", n, n);
      const SurfacePoint<double> other = closest_point(stone, mirrored(p));
      see(std::fabs(other.distance - at_p.distance) + (other.p_B - mirrored(at_p.p_B)).norm(), "distance in a mirror",
          p, p);
    }
  }
  return worst.measurement();
}

/// Gradients by differences in long double: of the distance the normal, of the support the support point.
Measurement measure_gradients(Context& context) {
  Worst worst;
  constexpr Long h = 1e-8L;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-3);
    const Stone<Long> stone = make_stone<Long>(specimen.shape.width, specimen.shape.height, specimen.shape.bevel);
    const Long width = outer_width(stone);
    const auto see = [&](Long error, const char* name, const Long3& at) {
      worst.see(static_cast<double>(error), [&] {
        return fmt::format("{}: {}, at {}", name, describe(specimen), describe(Vec3<double>(at.cast<double>())));
      });
    };
    // At the switch of cap and rim to 1e-17, and everywhere.
    const Long3 n = draw_normal(context, specimen.stone, i / 2).cast<Long>().normalized();
    if (stone.sphere_radius < 100 * width && std::hypot(n.x(), n.y()) > 1e-3L) {
      const Long3 slope = gradient([&](const Long3& v) { return homogeneous_support(stone, v); }, n, h);
      see((slope - context.produced(support(stone, n).p_B)).norm() / stone.sphere_radius, "support", n);
    }
    // On the surface's normal, a tenth of the radius of the tube or more outside: the distance is smooth there.
    const SurfacePoint<Long> start = closest_point(stone, Long3(width * static_cast<Long>(context.uniform(0.1, 1.0)) *
                                                                draw_unit(context).cast<Long>().normalized()));
    const Long3 p = start.p_B + (width / 10) * start.normal_B;
    const SurfacePoint<Long> at = closest_point(stone, p);
    const Long3 slope = gradient([&](const Long3& x) { return signed_distance(stone, x); }, p, h * width);
    see((slope - context.produced(at.normal_B)).norm(), "distance", p);
  }
  return worst.measurement();
}

}  // namespace

std::vector<Claim> surface_law_claims() {
  return {
      {.id = "SURFACE-4",
       .statement =
           "The distance is 1-Lipschitz, the support convex and reached at the point that is given; in a mirror "
           "everything is the same to the last bit.",
       .function = "closest_point, support, is_inside",
       .family = OracleFamily::invariant,
       .oracle = "inequalities that hold for every convex body, and three mirrors",
       .checks = {{.unit = "of the width",
                   .bound = 4e-15,
                   .reason = "two distances or three supports of 1e-15 each, and the norm of a difference",
                   .resolution = epsilon / 4.0}},
       .mutants = {{"shape/surface.hpp", "zeta * (zeta + T(2) * stone.sphere_offset)",
                    "T(2) * zeta * (zeta + T(2) * stone.sphere_offset)"},
                   {"shape/surface.hpp", "const bool upper = !(p_B.z() < T(0));",
                    "const bool upper = !(p_B.z() < -stone.height / T(2));"},
                   {"shape/surface.hpp", "return signed_distance(stone, p_B) <= T(0);",
                    "return signed_distance(stone, p_B) <= stone.bevel;"},
                   {"shape/surface.hpp",
                    "n.radial_square * scalar::sq(stone.joint_sine) <= scalar::sq(T(n.axial * stone.joint_cosine))",
                    "n.radial_square * scalar::sq(stone.joint_cosine) <= scalar::sq(T(n.axial * stone.joint_sine))"}},
       .measure = measure_laws},
      {.id = "SURFACE-5",
       .statement = "The gradient of the distance is the normal; that of the support is the support point, across the "
                    "switch of cap and rim too.",
       .function = "closest_point, support",
       .family = OracleFamily::invariant,
       .oracle = "central differences in long double",
       .checks = {{.unit = "absolute; of the sphere's radius",
                   .bound = 2.5e-8,
                   .reason = "step 1e-8: where it straddles the switch, a quarter of the step times the jump of the "
                             "curvature, which "
                             "is 1 for the support, and up to 10 a tenth of the width outside",
                   .resolution = 0.0}},
       .mutants = {{"shape/surface.hpp", "radial = at_centre ? T(0) : T(rho / reach);",
                    "radial = at_centre ? T(0) : T(rho / stone.core_sphere_radius);"},
                   {"shape/surface.hpp", "const T across = stone.bevel_major_radius / n.radial",
                    "const T across = stone.bevel_major_radius"}},
       .measure = measure_gradients},
  };
}

}  // namespace goishi::verify
