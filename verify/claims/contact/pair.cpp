/// CONTACT: two stones.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/pose.hpp"

namespace goishi::verify {

namespace {

/// A pair as the oracle sees it.
struct Witness {
  Standing one, two;
  explicit Witness(const Pair& pair)
      : one(standing(narrow(hull_of(pair.first)), pair.pose)),
        two(standing(narrow(hull_of(pair.second)), pair.other_pose)) {}
  [[nodiscard]] long double along(const Vec3<double>& n_W) const {
    const Triple<long double> n = triple(Long3(n_W.cast<long double>().normalized()));
    return nearest_along(one, n) + nearest_along(two, {-n[0], -n[1], -n[2]});
  }
};

/// What must hold for any pair: the gap is that of its normal, the points are on the stones; and if it is certified, the
/// gap is that of the two points, of the swapped pair, and 0 after the push-out.
template <class See>
void see_consistent(const Context& context, const Pair& pair, const Witness& witness, const Separation<double>& at,
                    See&& see) {
  const double gap = context.produced(at.gap);
  // Of a thin stone, support points turn about its sphere's centre, and a normal is known as well as that is.
  const double scale = std::max(2.0 * reach_of(pair), (pair.pose.p_WB - pair.other_pose.p_WB).norm());
  const double thin = 1.0 + (pair.first.stone.sphere_radius + pair.second.stone.sphere_radius) / scale;
  see(std::fabs(static_cast<double>(witness.along(at.n_W) - static_cast<long double>(gap))), "gap");
  const Separation<double> swapped = separation(pair.second.stone, pair.other_pose, pair.first.stone, pair.pose);
  if (at.certified && swapped.certified) {
    see(std::fabs(swapped.gap - gap) / thin, "swapped");
  }
  see(std::fabs(outside_stone(witness.one.hull, pair.pose, context.produced(at.p_stone))) / thin, "points");
  see(std::fabs(outside_stone(witness.two.hull, pair.other_pose, context.produced(at.p_other))) / thin, "points");
  Pair pushed = pair;
  pushed.pose.p_WB -= gap * at.n_W;
  if (at.certified) {
    // Along the normal: a climb ends where the gap is right; how well the normal is, CONTACT-7 says.
    const double off = std::fabs(at.n_W.dot(at.p_stone - at.p_other) - gap);
    see(off / thin, "between the points");
    see(std::fabs(separation(pushed).gap), "push-out");
  }
}

/// `cores_overlap`: of which pairs.
Measurement measure_pairs(Context& context, bool cores_overlap, int count) {
  Checks checks;
  std::array<int, pair_strata.size()> drawn{};
  int seen = 0, uncertified = 0, short_of = 0;
  double worst_uncertified = 0.0;
  for (int i = 0; seen < count; ++i) {
    const Pair pair = draw_pair(context, i);
    const Separation<double> at = separation(pair);
    const double bevels = pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius;
    if ((at.gap + bevels <= 0.0) != cores_overlap) {
      continue;
    }
    ++seen;
    ++drawn[static_cast<std::size_t>(i % pair_strata_count)];
    uncertified += !at.certified;
    const Witness witness(pair);
    const double scale = std::max(2.0 * reach_of(pair), (pair.pose.p_WB - pair.other_pose.p_WB).norm());
    const auto see = [&](double error, const char* name) {
      checks[name].see(error, scale, [&] {
        return fmt::format("{}{}: {}, gap {:.6g}", pair_strata[static_cast<std::size_t>(i % pair_strata_count)],
                           at.certified ? "" : ", not certified", describe(pair), at.gap);
      });
    };
    see(at.certified || (cores_overlap && at.gap < 0.0) ? 0.0 : scale, "faults");
    see_consistent(context, pair, witness, at, see);
    const Best best = search_pair(witness.one, witness.two, 20);
    const double better = static_cast<double>(best.value - static_cast<long double>(context.produced(at.gap)));
    if (at.certified) {
      const double radii = pair.first.stone.sphere_radius + pair.second.stone.sphere_radius;
      see(better / (1.0 + radii / scale), "better normal");
    } else {
      worst_uncertified = std::max(worst_uncertified, better / scale);
    }
    short_of += !(-better <= 1e-9 * scale);
  }
  see_search(checks["faults"], short_of, seen);
  checks["faults"].see(20 * uncertified <= seen ? 0.0 : 1.0, [] { return "more than one in twenty uncertified"; });
  std::string strata;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    strata += fmt::format("{}{} {}", k == 0 ? "" : ", ", pair_strata[k], drawn[k]);
  }
  return checks.measurement(
      {{"pairs", strata},
       {"without a certificate",
        fmt::format("{} of {}, a better normal by up to {:.2g} of the widths", uncertified, seen, worst_uncertified)},
       {"the search was not within 1e-9 of the width", fmt::format("{} of {}", short_of, seen)}});
}

}  // namespace

std::vector<Claim> contact_pair_claims() {
  return {
      {.id = "CONTACT-4",
       .statement =
           "The gap of two stones that are apart, or overlap by no more than their bevels, is the greatest separation "
           "over all normals, the same with the stones swapped, that of the two contact points, and 0 after the "
           "push-out.",
       .function = "separation (stones)",
       .family = OracleFamily::brute_force,
       .oracle = "a search over the sphere of normals, its best valued in long double; primal against dual",
       .checks = {within("gap", 2e-15, "of the widths or the distance",
                         "roundings of the widths; measured 2026-11-30 with 14 seeds: up to 4.8e-16", epsilon),
                  within("better normal", 2e-15, "of the widths or the distance and the spheres' radii",
                         "a normal is known as well as the centre of a thin stone's sphere, up to 250 widths away; "
                         "measured 2026-11-30 with 10 seeds: up to 4.2e-16",
                         epsilon),
                  within("swapped", 2e-15, "of the widths or the distance and the spheres' radii",
                         "the same; measured 2026-11-30 with 10 seeds: up to 2.4e-16", epsilon),
                  within("points", 5e-15, "of the widths or the distance and the spheres' radii",
                         "the same; measured 2026-11-30 with 10 seeds: up to 1.1e-15", epsilon),
                  within("between the points", 5e-15, "of the widths or the distance and the spheres' radii",
                         "the same, along the normal; measured 2026-11-30 with 5 seeds: up to 1.0e-15", epsilon),
                  within("push-out", 3e-15, "of the widths or the distance",
                         "two gaps, and the place between them; measured 2026-11-30 with 14 seeds: up to 6.7e-16",
                         epsilon),
                  none("faults", "faults")},
       .measure = [](Context& context) { return measure_pairs(context, false, context.samples(1500, 12000)); }},
      {.id = "CONTACT-5",
       .statement =
           "Where the cores of two stones overlap, too, no normal separates more than the one that is given, if it is "
           "certified; of rims that cross near the greatest depth at which they can hold each other, of stones that "
           "are "
           "nearly balls and of stones with one centre, a few are not.",
       .function = "separation (stones)",
       .family = OracleFamily::brute_force,
       .oracle = "a search over the sphere of normals, its best valued in long double",
       .checks = {within("gap", 1e-15, "of the widths",
                         "roundings of the widths; measured 2026-11-30 with 14 seeds: up to 1.9e-16", epsilon),
                  within("better normal", 2e-15, "of the widths and the spheres' radii",
                         "a normal is known as well as the centre of a thin stone's sphere, up to 250 widths away; "
                         "measured 2026-11-30 with 10 seeds: up to 2.9e-16",
                         epsilon),
                  within("swapped", 2e-15, "of the widths and the spheres' radii",
                         "the same; measured 2026-11-30 with 10 seeds: up to 3.0e-16", epsilon),
                  within("points", 5e-15, "of the widths and the spheres' radii",
                         "the same; measured 2026-11-30 with 10 seeds: up to 1.0e-15", epsilon),
                  within("between the points", 5e-15, "of the widths and the spheres' radii",
                         "the same, along the normal; measured 2026-11-30 with 14 seeds: up to 1.1e-15", epsilon),
                  within("push-out", 2e-15, "of the widths",
                         "two gaps, and the place between them; measured 2026-11-30 with 14 seeds: up to 3.2e-16",
                         epsilon),
                  none("faults", "faults")},
       .measure = [](Context& context) { return measure_pairs(context, true, context.samples(1500, 12000)); }},
  };
}

}  // namespace goishi::verify
