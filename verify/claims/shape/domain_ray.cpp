/// DOMAIN: rays at stones of any size, from any distance. The witness walks along the exact line: 50 digits for where it
/// is, long double for the distance there.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/shape/ray.hpp>
#include <string>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/domain.hpp"

namespace goishi::verify {

namespace {

using Digits3 = Vec3<Digits50>;

template <class T>
struct Ray {
  Vec3<T> p, u;
  bool exact;  // along an axis to the bit: the line itself has no round-off
};

/// Through the centre, the axis, the rim, its plane, a cap, to the bit, or past the stone; from there or from afar.
template <class T>
Ray<T> draw_ray(Context& context, const Stone<T>& stone, int i) {
  const T zero(0), half = stone.width / T(2), h = stone.height / T(2);
  const auto share = [&] { return static_cast<T>(context.uniform(-1.1, 1.1)); };
  const std::array<Vec3<T>, 7> targets = {Vec3<T>(zero, zero, zero),
                                          Vec3<T>(zero, zero, h * share()),
                                          Vec3<T>(half, zero, zero),
                                          Vec3<T>(zero, -stone.bevel_major_radius, stone.bevel_minor_radius),
                                          Vec3<T>(half * share(), zero, -h),
                                          Vec3<T>(half * share(), half * share(), h * share()),
                                          Vec3<T>(half * share(), half * share(), half * share())};
  const Vec3<T> u = draw_defective_direction<T>(context, i / 3);
  const T away = i % 4 == 0   ? T(0)
                 : i % 4 == 1 ? any_size<T>(context.random(), size_reach<T>)
                              : half * any_size<T>(context.random(), i % 4 == 2 ? 1.0 : 12.0);
  const Vec3<T> p = targets[static_cast<std::size_t>(i) % targets.size()] - (i % 5 == 0 ? T(-away) : away) * u;
  return {p, u, (u.array() == T(0)).count() == 2 && std::fabs(u.sum()) == T(1)};
}

/// The least signed distance on the line from the point nearest to the centre.
Long least_distance(const Stone<Long>& stone, const Long3& middle, const Long3& u) {
  const auto at = [&](Long t) { return signed_distance(stone, Long3(middle + t * u)); };
  Long low = -outer_width(stone), high = -low;
  for (int k = 0; k < 90; ++k) {
    const Long one = low + (high - low) * 0.4L, other = low + (high - low) * 0.6L;
    (at(one) < at(other) ? high : low) = at(one) < at(other) ? other : one;
  }
  return at((low + high) / 2);
}

template <class T>
void see_ray(const Context& context, Checks& checks, const Stone<T>& stone, const Ray<T>& ray,
             const std::optional<RayHit<T>>& answer, const std::string& of) {
  const auto describe_it = [&](const char* what) {
    return fmt::format("{}: {}, p = ({:a}, {:a}, {:a}), u = ({:a}, {:a}, {:a})", what, of, ray.p.x(), ray.p.y(),
                       ray.p.z(), ray.u.x(), ray.u.y(), ray.u.z());
  };
  const Digits3 p = ray.p.template cast<Digits50>(), u = ray.u.template cast<Digits50>();
  const Digits50 square = 4 * p.squaredNorm() / Digits50(std::numeric_limits<T>::max());
  if (!answer || square > 1) {
    see_choice(checks["refusals"], answer ? square <= Digits50(1.01) : square >= Digits50(0.99),
               [&] { return describe_it(answer ? "taken" : "refused"); });
    return;
  }
  const Stone<Long> wide = stone_cast<Long>(stone);
  const Digits3 middle = p - Digits3(Digits50(p.dot(u) / u.squaredNorm()) * u);
  const Long width = outer_width(wide), far = width + static_cast<Long>(ray.p.template cast<Long>().norm());
  const Long off_line = static_cast<Long>(epsilon_of<T>) * (ray.exact ? width : far),
             off = static_cast<Long>(epsilon_of<T>) * far;
  const Digits50 length = middle.norm();
  const Long least = length > Digits50(2 * width) ? static_cast<Long>(length) - width
                                                  : least_distance(wide, Long3(middle.cast<Long>()),
                                                                   Long3(ray.u.template cast<Long>().normalized()));
  const auto see = [&](const char* check, Long error, Long unit, const char* what) {
    checks[check].see(static_cast<double>(error / unit), [&] { return describe_it(what); });
  };
  const auto choose = [&](bool right, const char* what) {
    see_choice(checks["choices"], right, [&] { return describe_it(what); });
  };
  if (!answer->hit) {
    see("hit or miss", std::max(-least, Long(0)), off_line, "passes");
    return;
  }
  see("hit or miss", std::max(least, Long(0)), off_line, "meets");
  const auto place = [&](const T& t) { return Digits3(p + Digits3(Digits50(context.produced(t)) * u)); };
  const auto distance = [&](const Digits3& x) {
    return x.norm() > Digits50(4 * width) ? static_cast<Long>(Digits50(x.norm()))
                                          : std::fabs(signed_distance(wide, Long3(x.cast<Long>())));
  };
  see("ends", distance(place(answer->entry)), off, "entry");
  see("ends", distance(place(answer->exit)), off, "exit");
  const Long chord = static_cast<Long>(answer->exit) - static_cast<Long>(answer->entry);
  choose(chord >= -8 * off, "exit before entry");
  // In at the entry, out at the exit, or what is between is nothing but round-off.
  const auto slope = [&](const T& t) {
    return closest_point(wide, Long3(place(t).template cast<Long>())).normal_B.dot(ray.u.template cast<Long>());
  };
  choose(off >= width / 64 || (slope(answer->entry) <= 0 && slope(answer->exit) >= 0) || -least <= 8 * off,
         "not the entry or the exit");
  const T first = answer->entry < T(0) ? answer->exit : answer->entry;
  choose(answer->forward == !(answer->exit < T(0)) &&
             (!answer->forward || (answer->first <= first && first <= answer->first)),
         "not the first");
  if (!answer->forward) {
    return;
  }
  // Looked at from the centre: a change of its size is one of a place.
  const Digits3 there = answer->surface.p_B.template cast<Digits50>() * Digits50(context.produced(1.0));
  see("hit point", distance(there), off_line, "off the surface");
  const Digits3 from = there - middle;
  see("hit point", static_cast<Long>(Digits50((from - Digits3(Digits50(from.dot(u) / u.squaredNorm()) * u)).norm())),
      off_line, "off the line");
  see("hit point", static_cast<Long>(Digits50((there - place(answer->first)).norm())), off, "off the first");
  see("normal", std::fabs(static_cast<Long>(context.produced(answer->surface.normal_B.norm())) - 1),
      static_cast<Long>(epsilon_of<T>), "normal");
}

template <class T>
void see_stone_rays(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const ShapeSample<T> shape = draw_any_shape<T>(context, i);
    const auto stone = answer_of(FE_TONEAREST, [&] { return make_stone(shape.width, shape.height, shape.bevel); });
    if (!stone) {
      continue;
    }
    Ray<T> ray = draw_ray(context, *stone, i);
    if (i % 60 == 1) {
      ray.p *= std::sqrt(std::numeric_limits<T>::max()) / ray.p.norm() * static_cast<T>(context.uniform(0.1, 10.0));
    }
    const int mode = rounding_modes[static_cast<std::size_t>(i / 7) % rounding_modes.size()];
    const auto answer = answer_of(mode, [&] { return cast_ray(*stone, ray.p, ray.u); });
    see_ray(context, checks, *stone, ray, answer, fmt::format("{}, mode {}", describe(shape), mode));
  }
}

}  // namespace

std::vector<Claim> domain_ray_claims() {
  const std::string line = "ε of the sum of width and distance, of the width for a line without round-off";
  return {
      {.id = "DOMAIN-11",
       .statement =
           "Rays at stones of any size, from any distance, along axes to the bit, through centre and rim, with "
           "|u|² off by ± 60 ε, in each rounding mode: entry, exit, the hit and a miss are right; where the square "
           "of the start overflows, it is refused.",
       .function = "cast_ray",
       .family = OracleFamily::other_formula,
       .oracle = "distances along the exact line, in 50 digits and long double; their minimum by search",
       .checks = {within("ends", 8.0, "ε of the sum of width and distance",
                         "some six roundings of a place and its distance, twice as large where they are not to the "
                         "nearest",
                         1.0),
                  within("hit point", 8.0, line, "as the ends, and a foot on the surface", 1.0),
                  within("normal", 6.0, "ε", "a root, a quotient and a product, and the norm's own three", 0.5),
                  {.name = "hit or miss",
                   .unit = line + "; how far a line that is said to meet passes, or one that is said to pass is inside",
                   .bound = 8.0,
                   .reason = "as the ends",
                   .resolution = 1.0,
                   .counts = true},
                  none("choices", "orders of entry, exit and the first that are wrong"),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_both(see_stone_rays<double>, see_stone_rays<float>, 1500, 9000)},
  };
}

}  // namespace goishi::verify
