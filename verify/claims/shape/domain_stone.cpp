/// DOMAIN: the shape, the mass and the surface of stones of any size, to the ends of what is said to be taken: a right
/// answer, or a refusal where the exact values leave the type. The witness is the same formula in 50 digits: what is judged
/// is range, not the formula.

#include <fmt/format.h>

#include <goishi/mass/tensor.hpp>
#include <goishi/shape/surface.hpp>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/domain.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

template <class T>
std::vector<std::pair<const char*, T>> lengths(const Stone<T>& stone) {
  return {{"w", stone.width},
          {"r", stone.sphere_radius},
          {"d", stone.sphere_offset},
          {"r₁", stone.bevel_major_radius},
          {"r₂", stone.bevel_minor_radius},
          {"r − r₂", stone.core_sphere_radius},
          {"P_x", stone.joint_radius},
          {"cos α", stone.joint_cosine},
          {"sin α", stone.joint_sine}};
}

template <class T>
std::vector<std::pair<const char*, T>> numbers(const MassProperties<T>& body) {
  return {{"V", body.volume},
          {"area", body.surface_area},
          {"ρ", body.density},
          {"m", body.mass},
          {"I_a", body.moments.axial},
          {"I_t", body.moments.transverse},
          {"I_a/m", body.moments_per_mass.axial},
          {"I_t/m", body.moments_per_mass.transverse}};
}

/// Ulps of each number; and whether there is an answer where there can be one.
template <class T, class Answer, class Exact, class Numbers, class Describe>
void see_numbers(Checks& checks, Context& context, const Answer& answer, bool right_to_refuse, const Exact& exact,
                 Numbers&& all, Describe&& describe) {
  see_choice(checks["refusals"], answer ? !right_to_refuse : right_to_refuse,
             [&] { return (answer ? "taken: " : "refused: ") + describe(); });
  if (!answer || right_to_refuse) {
    return;
  }
  const auto computed = all(*answer);
  const auto expected = all(exact);
  for (std::size_t k = 0; k < computed.size(); ++k) {
    checks["numbers"].see(ulps<T>(context.produced(computed[k].second), expected[k].second),
                          [&] { return std::string(computed[k].first) + ": " + describe(); });
  }
}

/// As `require_length` has it, in exact numbers; its ends themselves to round-off.
template <class T>
bool is_length(const Digits50& value) {
  const Digits50 epsilon(std::numeric_limits<T>::epsilon());
  return holds<T>(Digits50(value * value * epsilon)) && holds<T>(Digits50(256 * value * value));
}

template <class T>
void see_stones(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const ShapeSample<T> shape = draw_any_shape<T>(context, i);
    const bool measured = i % 3 == 1;
    const Digits50 w(shape.width), h(shape.height), b(shape.bevel);
    const auto make = [&](const auto& width, const auto& height, const auto& bevel) {
      return measured ? make_measured_stone(width, height, bevel) : make_stone(width, height, bevel);
    };
    std::optional<Stone<Digits50>> exact;
    if (T(0) < shape.height && shape.bevel < shape.height) {
      exact = make(w, h, b);
    }
    const bool refusable = !exact || !is_length<T>(w) || !is_length<T>(h) || (b > 0 && !holds<T>(b)) ||
                           !is_length<T>(exact->sphere_radius);
    const int mode = rounding_modes[static_cast<std::size_t>(i / 5) % rounding_modes.size()];
    const auto answer = answer_of(mode, [&] { return make(shape.width, shape.height, shape.bevel); });
    see_numbers<T>(
        checks, context, answer, refusable, exact ? *exact : Stone<Digits50>{},
        [](const auto& s) { return lengths(s); },
        [&] { return describe(shape) + fmt::format(", mode {}{}", mode, measured ? ", measured" : ""); });
  }
}

template <class T>
void see_masses(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const ShapeSample<T> shape = draw_any_shape<T>(context, i);
    const auto stone = answer_of(FE_TONEAREST, [&] { return make_stone(shape.width, shape.height, shape.bevel); });
    if (!stone) {
      continue;
    }
    const T given = any_size<T>(context.random(), i % 2 == 0 ? 4.0 : size_reach<T>);
    const int mode = rounding_modes[static_cast<std::size_t>(i / 5) % rounding_modes.size()];
    const bool by_mass = i % 2 == 1;
    const auto weigh = [&](const auto& of, const auto& value) {
      return by_mass ? mass_properties(of, Mass{value}) : mass_properties(of, Density{value});
    };
    const Stone<Digits50> right = make_stone(Digits50(shape.width), Digits50(shape.height), Digits50(shape.bevel));
    const MassProperties<Digits50> exact = weigh(right, Digits50(given));
    bool refusable = false;
    for (const auto& [name, value] : numbers(exact)) {
      refusable = refusable || !holds<T>(value);
    }
    const auto answer = answer_of(mode, [&] { return weigh(*stone, given); });
    see_numbers<T>(
        checks, context, answer, refusable, exact, [](const auto& body) { return numbers(body); },
        [&] { return describe(shape) + fmt::format(", mode {}, given {}", mode, given); });
  }
}

Measurement measure_masses(Context& context) {
  Checks checks;
  see_masses<double>(context, checks, context.samples(2000, 20'000));
  see_masses<float>(context, checks, context.samples(4000, 20'000));
  return checks.measurement();
}

template <class T>
void see_tensors(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    MassProperties<T> body;
    body.mass = any_size<T>(context.random(), size_reach<T>);
    body.moments.transverse = any_size<T>(context.random(), size_reach<T>);
    body.moments.axial = body.moments.transverse * static_cast<T>(context.uniform(0.01, 2.0));
    const Quat<T> q = draw_defective<T>(context, i);
    const T away = i % 5 == 0 ? T(0) : any_size<T>(context.random(), size_reach<T>);
    const Vec3<T> p(away, i % 3 == 0 ? T(0) : -away, static_cast<T>(context.uniform(-1.0, 1.0)) * away);
    MassProperties<Digits50> wide;
    wide.mass = Digits50(body.mass);
    wide.moments = {.axial = Digits50(body.moments.axial), .transverse = Digits50(body.moments.transverse)};
    const Mat3<Digits50> exact = inertia_tensor<Digits50>(wide, q.template cast<Digits50>().normalized(),
                                                          Vec3<Digits50>(p.template cast<Digits50>()));
    const int mode = rounding_modes[static_cast<std::size_t>(i / 3) % rounding_modes.size()];
    const auto answer = answer_of(mode, [&] { return inertia_tensor(body, q, p); });
    const auto describe = [&] {
      return fmt::format("m = {}, I_t = {}, p = {}, q = ({}, {}, {}, {}), mode {}", body.mass, body.moments.transverse,
                         away, q.w(), q.x(), q.y(), q.z(), mode);
    };
    const Digits50 trace = exact.trace();
    const Digits50 most(std::numeric_limits<T>::max());
    see_choice(checks["refusals"], answer ? trace <= most : 4 * trace > most, describe);
    if (!answer) {
      continue;
    }
    const Mat3<Digits50> computed = answer->template cast<Digits50>() * Digits50(context.produced(1.0));
    const Digits50 off = (computed - exact).cwiseAbs().maxCoeff() / (trace + Digits50(std::numeric_limits<T>::min()));
    checks["tensor"].see(static_cast<double>(off), epsilon_of<T>, describe);
  }
}

template <class T>
void see_surfaces(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const ShapeSample<T> shape = draw_any_shape<T>(context, i);
    const auto stone = answer_of(FE_TONEAREST, [&] { return make_stone(shape.width, shape.height, shape.bevel); });
    if (!stone) {
      continue;
    }
    const Stone<Digits50> wide = stone_cast<Digits50>(*stone);
    const auto draw = [&] { return static_cast<T>(context.uniform(-1.0, 1.0)); };
    const T zero(0), half = stone->width / T(2);
    // The centre, the axis, the rim, its plane, the cap, to the bit, and next to the rim; anywhere, from far in it to far out.
    const T far = half * any_size<T>(context.random(), i % 2 == 0 ? 1.0 : i % 5 == 0 ? 1.2 * size_reach<T> : 10.0);
    const T next = stone->width * any_size<T>(context.random(), 1.0) * std::numeric_limits<T>::epsilon();
    const std::array<Vec3<T>, 9> points = {Vec3<T>(zero, zero, zero),
                                           Vec3<T>(zero, zero, far),
                                           Vec3<T>(stone->bevel_major_radius, zero, zero),
                                           Vec3<T>(zero, -half, zero),
                                           Vec3<T>(far, zero, zero),
                                           Vec3<T>(zero, zero, -stone->height / T(2)),
                                           Vec3<T>(far * draw(), far * draw(), far * draw()),
                                           Vec3<T>(far, far * draw(), std::numeric_limits<T>::denorm_min()),
                                           Vec3<T>(T(0), stone->bevel_major_radius + next, next)};
    const int mode = rounding_modes[static_cast<std::size_t>(i / 8) % rounding_modes.size()];
    const Vec3<T>& p = points[static_cast<std::size_t>(i) % points.size()];
    const auto describe_point = [&] {
      return fmt::format("{}, p = ({:a}, {:a}, {:a}), mode {}", describe(shape), p.x(), p.y(), p.z(), mode);
    };
    const Vec3<Digits50> wide_p = p.template cast<Digits50>();
    const Digits50 size = std::max(Digits50(wide.width), Digits50(wide_p.norm()));
    const auto answer = answer_of(mode, [&] { return closest_point(*stone, p); });
    see_choice(checks["refusals"], answer ? holds<T>(Digits50(size * size)) : !holds<T>(Digits50(8 * size * size)),
               describe_point);
    const auto see = [&](const char* check, const Digits50& off, double allowed, auto&& describe_it) {
      checks[check].see(static_cast<double>(off), allowed, describe_it);
    };
    const Digits50 factor(context.produced(1.0));
    if (answer && holds<T>(Digits50(size * size))) {
      const SurfacePoint<Digits50> exact = closest_point(wide, wide_p);
      const Digits50 distance = factor * Digits50(answer->distance);
      see("distance", Digits50(abs(distance - exact.distance) / size), epsilon_of<T>, describe_point);
      const Vec3<Digits50> normal = factor * answer->normal_B.template cast<Digits50>();
      if (answer->unique && exact.unique && abs(exact.distance) < wide.width) {
        // Where it is, if the distance alone does not say: on its normal, and as far.
        const Vec3<Digits50> back = answer->p_B.template cast<Digits50>() + distance * normal;
        see("closest point", Digits50((back - wide_p).norm() / size), epsilon_of<T>, describe_point);
      }
      see("normal", Digits50(abs(normal.squaredNorm() - 1)), 2.0 * epsilon_of<T>, describe_point);
    }
    // Directions: along axes to the bit, any, off the unit sphere.
    const std::array<Vec3<T>, 4> directions = {Vec3<T>(zero, zero, T(1)), Vec3<T>(T(-1), zero, zero),
                                               Vec3<T>(stone->joint_cosine, zero, stone->joint_sine).normalized(),
                                               Vec3<T>(draw(), draw(), draw()).normalized()};
    const int defect = unit_defects[static_cast<std::size_t>(i / 4) % unit_defects.size()];
    const Vec3<T> n = defective<T, 3>(directions[static_cast<std::size_t>(i) % directions.size()], defect);
    const auto describe_direction = [&] {
      return fmt::format("{}, n = ({:a}, {:a}, {:a}), mode {}", describe(shape), n.x(), n.y(), n.z(), mode);
    };
    const Vec3<Digits50> wide_n = n.template cast<Digits50>().normalized();
    const auto found = answer_of(mode, [&] { return support(*stone, n); });
    see_choice(checks["refusals"], found.has_value(), [&] { return "refused: " + describe_direction(); });
    if (!found) {
      continue;
    }
    const Digits50 value = support(wide, wide_n).value;
    const Digits50 there = wide_n.dot(Vec3<Digits50>(factor * found->p_B.template cast<Digits50>()));
    const double allowed = epsilon_of<T> * (1.0 + std::abs(defect));
    see("support", Digits50(abs(factor * Digits50(found->value) - value) / wide.width), allowed, describe_direction);
    see("support", Digits50(abs(there - value) / wide.width), allowed, describe_direction);
  }
}

}  // namespace

std::vector<Claim> domain_stone_claims() {
  const Check refusals = none("refusals", "what is taken or refused and should not be");
  return {
      {.id = "DOMAIN-1",
       .statement =
           "Stones of any size, 1e±150 m (float: 1e±18), as thin as may be, to the ball, in each rounding mode: right "
           "to 2 ulp, or refused where a length is not one that formulas take.",
       .function = "make_stone, make_measured_stone",
       .family = OracleFamily::rounding,
       .oracle = "the same in 50 digits, without a limit of size (judges range and rounding)",
       .checks = {within("numbers", 2.0, "ulp",
                         "evaluated in the next wider type and rounded, upwards or downwards by up to one ulp", 1.0),
                  refusals},
       .measure = measure_both(see_stones<double>, see_stones<float>, 2000, 20'000)},
      {.id = "DOMAIN-2",
       .statement = "Their mass, volume, area and moments are right, or refused where one of them is no normal number.",
       .function = "mass_properties",
       .family = OracleFamily::rounding,
       .oracle = "the same in 50 digits, without a limit of size (judges range and rounding)",
       .checks = {within("numbers", 16.0, "ulp",
                         "MASS-2's 8; rounding that is not to the nearest errs by twice as much; measured 2026-11-30 "
                         "with 60 seeds: up to 12.2",
                         1.0),
                  refusals},
       .measure = measure_masses},
      {.id = "DOMAIN-3",
       .statement = "The inertia tensor is right for bodies of any size and mass, at any distance, for attitudes with "
                    "|q|² off by "
                    "± 60 ε, in each rounding mode; or refused where it overflows.",
       .function = "inertia_tensor",
       .family = OracleFamily::rounding,
       .oracle = "the same in 50 digits at q/|q|",
       .checks = {within("tensor", 12.0, "ε trace",
                         "some twelve roundings, twice as large where they are not to the nearest", 1.0),
                  refusals},
       .measure = measure_both(see_tensors<double>, see_tensors<float>, 1000, 10'000)},
      {.id = "DOMAIN-4",
       .statement =
           "Distance, closest point and support of stones of any size: at the centre, on the axis, on the rim and in "
           "its "
           "plane to the bit, far away, in each rounding mode; or refused where the square of the point overflows.",
       .function = "closest_point, support",
       .family = OracleFamily::rounding,
       .oracle = "the same in 50 digits on the same stone; the point against its own distance and normal",
       .checks = {within("distance", 10.0, "ε of the greater of width and |p|",
                         "SURFACE-2 has 5; rounding that is not to the nearest errs by twice as much", 1.0),
                  within("closest point", 4.0, "ε of the greater of width and |p|",
                         "it is made of the same foot as the distance and the normal, so that their errors cancel: "
                         "two sums and a product are left",
                         1.0),
                  within("normal", 6.0, "2 ε, of its square", "as SURFACE-2", 1.0),
                  within("support", 10.0, "ε of the width, as much more as |n|² is off",
                         "SURFACE-1 has 5; rounding that is not to the nearest errs by twice as much", 1.0),
                  refusals},
       .measure = measure_both(see_surfaces<double>, see_surfaces<float>, 2000, 20'000)},
  };
}

}  // namespace goishi::verify
