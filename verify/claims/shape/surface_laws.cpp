/// SURFACE: what must hold for any convex solid of revolution.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/shape/surface.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/contact.hpp"

namespace goishi::verify {

namespace {

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
  Checks checks;
  for (int i = 0; i < context.samples(10000, 100000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Stone<double>& stone = specimen.stone;
    const double width = outer_width(stone);
    const auto describe_it = [&](const Vec3<double>& one, const Vec3<double>& other) {
      return fmt::format("{}, at {} and {}", describe(specimen), describe(one), describe(other));
    };
    const auto see = [&](double error, const char* check, const Vec3<double>& one, const Vec3<double>& other) {
      checks[check].see(error, width, [&] { return describe_it(one, other); });
    };
    const auto choose = [&](bool right, const char* check, const Vec3<double>& at) {
      see_choice(checks[check], right, [&] { return describe_it(at, at); });
    };
    const Vec3<double> p = width * context.uniform(0.0, 1.0) * draw_unit(context);
    const SurfacePoint<double> at_p = closest_point(stone, p);
    const Vec3<double> q = p + width * draw_small(context, 12.0) * (i % 2 == 0 ? at_p.normal_B : draw_unit(context));
    see(std::fabs(context.produced(at_p.distance) - signed_distance(stone, q)) - (p - q).norm(), "Lipschitz", p, q);
    choose(is_inside(stone, p) == (at_p.distance <= 0.0), "inside", p);

    const Vec3<double> n = draw_normal(context, stone, i / 2),
                       m = i % 2 == 0 ? draw_normal(context, stone, i / 14)
                                      : Vec3<double>((n + draw_small(context, 17.0) * draw_unit(context)).normalized());
    const Support<double> at_n = support(stone, n);
    const Vec3<double> sum = n + m;
    if (sum.norm() > 1e-3) {
      const double between = sum.norm() * support(stone, Vec3<double>(sum.normalized())).value;
      see(context.produced(between) - at_n.value - support(stone, m).value, "convexity", n, m);
    }
    choose(at_n.value > 0.0, "inside", n);
    // S(n) n is the plane, the point lies in it: another direction's point does not lie beyond.
    see(context.produced(support(stone, m).p_B).dot(n) - at_n.value, "farthest point", n, m);

    for (int k = 0; k < 3; ++k) {
      const auto mirrored = [&](Vec3<double> v) {
        v[k] = -v[k];
        return v;
      };
      const Support<double> seen = support(stone, mirrored(n));
      choose(seen.value == at_n.value && seen.p_B == mirrored(at_n.p_B), "mirror", n);
      const SurfacePoint<double> other = closest_point(stone, mirrored(p));
      choose(other.distance == at_p.distance && other.p_B == mirrored(at_p.p_B), "mirror", p);
    }
  }
  return checks.measurement();
}

/// Gradients by differences in long double: of the distance the normal, of the support the support point.
Measurement measure_gradients(Context& context) {
  Checks checks;
  constexpr Long h = 1e-8L;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-3);
    const Stone<Long> stone = make_stone<Long>(specimen.shape.width, specimen.shape.height, specimen.shape.bevel);
    const Long width = outer_width(stone);
    const auto see = [&](Long error, const std::string& check, const Long3& at) {
      checks[check].see(static_cast<double>(error), [&] {
        return fmt::format("{}, at {}", describe(specimen), describe(Vec3<double>(at.cast<double>())));
      });
    };
    // At the switch of cap and rim to 1e-17, and everywhere.
    const Long3 n = draw_normal(context, specimen.stone, i / 2).cast<Long>().normalized();
    const Long radial = std::hypot(n.x(), n.y());
    if (stone.sphere_radius < 100 * width && radial > 1e-3L) {
      const Long from_switch = std::fabs(radial * stone.joint_sine - std::fabs(n.z()) * stone.joint_cosine);
      const Long3 slope = gradient([&](const Long3& v) { return homogeneous_support(stone, v); }, n, h);
      see((slope - context.produced(support(stone, n).p_B)).norm() / stone.sphere_radius,
          from_switch < 2 * h ? "support point, at the switch" : "support point", n);
    }
    // On the surface's normal, a tenth of the width outside, where the distance is smooth; every second one where the
    // nearest point is the joint of cap and rim, on any meridian.
    const bool at_joint = i % 2 == 0 && stone.joint_cosine > 0;
    const Long3 azimuth = Long3(draw_unit(context).cast<Long>().cwiseProduct(Long3(1, 1, 0))).normalized();
    const Long3 joint = Long3(stone.joint_cosine * azimuth + stone.joint_sine * Long3(0, 0, 1));
    const SurfacePoint<Long> start = closest_point(stone, Long3(width * static_cast<Long>(context.uniform(0.1, 1.0)) *
                                                                draw_unit(context).cast<Long>().normalized()));
    const Long3 p = at_joint ? Long3(support(stone, joint).p_B + (width / 10) * joint)
                             : Long3(start.p_B + (width / 10) * start.normal_B);
    const SurfacePoint<Long> at = closest_point(stone, p);
    const Long3 slope = gradient([&](const Long3& x) { return signed_distance(stone, x); }, p, h * width);
    see((slope - context.produced(at.normal_B)).norm(), at_joint ? "normal, at the switch" : "normal", p);
  }
  return checks.measurement();
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
       .checks =
           {within("Lipschitz", 2e-15, "of the width", "two distances of 1e-15 each (SURFACE-2)", epsilon / 4.0),
            within("convexity", 2e-15, "of the width",
                   "two supports, and twice that of the sum, each right to 2.5e-16 (SURFACE-1); n and m are unit to ε",
                   epsilon / 4.0),
            within("farthest point", 2e-15, "of the width", "a support and a support point of 1e-15 each",
                   epsilon / 4.0),
            none("mirror", "digits that differ in a mirror"),
            none("inside", "insides that are none, and supports that are not positive")},
       .measure = measure_laws},
      {.id = "SURFACE-5",
       .statement = "The gradient of the distance is the normal; that of the support is the support point, across the "
                    "switch of cap and rim too.",
       .function = "closest_point, support",
       .family = OracleFamily::invariant,
       .oracle = "central differences in long double",
       .checks = {within("normal", 5e-11, "absolute",
                         "two distances, each rounded to 4 ε of long double of up to two widths, over twice the step "
                         "of 1e-8"),
                  within(
                      "normal, at the switch", 2.6e-8, "absolute",
                      "a quarter of the step times the jump of the curvature, up to 10 a tenth of the width outside, "
                      "and what is rounded"),
                  within("support point", 5e-11, "of the sphere's radius", "as the normal"),
                  within("support point, at the switch", 2.6e-9, "of the sphere's radius",
                         "a quarter of the step times the jump of the curvature, up to 1, and what is rounded")},
       .measure = measure_gradients},
  };
}

}  // namespace goishi::verify
