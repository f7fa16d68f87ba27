/// ENCLOSURE: signs that the library relies on, proved for every stone: the domain is covered with boxes, and the
/// formulas are evaluated on whole boxes at once.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify {

namespace {

/// The numbers from `low` to `high`, both positive.
struct Range {
  double low, high;

  [[nodiscard]] Ball ball() const {
    Ball result;
    const Ball from(low), to(high);
    arb_union(result.get(), from.get(), to.get(), Ball::precision);
    return result;
  }
  [[nodiscard]] double ratio() const { return high / low; }
  [[nodiscard]] std::array<Range, 2> halves() const {
    const double middle = std::sqrt(low * high);
    return {{{low, middle}, {middle, high}}};
  }
};

/// Stones of height 1, so that no difference of the data is one of wide balls: w = 1 + widening, and b, or 1 − b.
struct Box {
  Range widening;
  Range band;
  bool from_above = false;  // band is 1 − b

  [[nodiscard]] Ball width() const { return Ball(1) + widening.ball(); }
  [[nodiscard]] Ball bevel() const { return from_above ? Ball(1) - band.ball() : band.ball(); }
  [[nodiscard]] std::array<Box, 2> halves() const {
    if (band.ratio() < widening.ratio()) {
      const auto [low, high] = widening.halves();
      return {{{low, band, from_above}, {high, band, from_above}}};
    }
    const auto [low, high] = band.halves();
    return {{{widening, low, from_above}, {widening, high, from_above}}};
  }
};

Stone<Ball> stone_of(const Box& box) {
  return formula::bevelled_stone(box.width(), Ball(1), box.bevel(), formula::sphere_offset(box.width(), Ball(1)));
}

/// Every length is positive.
bool has_positive_lengths(const Box& box, const Ball& factor) {
  const Stone<Ball> stone = stone_of(box);
  const Ball measured = formula::measured_sphere_offset(box.width(), Ball(1), box.bevel());
  const std::array<const Ball*, 9> lengths = {
      &stone.sphere_offset,      &stone.bevel_major_radius, &stone.bevel_minor_radius,
      &stone.core_sphere_radius, &stone.joint_radius,       &stone.joint_cosine,
      &stone.joint_sine,         &stone.sphere_radius,      &measured};
  return std::ranges::all_of(lengths, [&](const Ball* length) { return (factor * *length).is_positive(); });
}

/// The joint is inside the rim, the finished stone narrower than its lens; area, volume and moments are positive.
bool is_a_body(const Box& box, const Ball& factor) {
  const Stone<Ball> stone = stone_of(box);
  const Ball half = box.width() / Ball(2);
  if (!(half - factor * stone.joint_radius).is_positive() ||
      !(half - factor * (outer_width(stone) / Ball(2))).is_positive()) {
    return false;
  }
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const Moments<Ball> moments = formula::bevelled_moments(stone, terms);
  return (factor * formula::bevelled_volume(stone, terms)).is_positive() &&
         (factor * formula::bevelled_surface_area(stone, terms)).is_positive() &&
         (factor * moments.axial).is_positive() && (factor * moments.transverse).is_positive();
}

/// No moment exceeds the sum of the others.
bool obeys_triangle(const Box& box, const Ball& factor) {
  const Stone<Ball> stone = stone_of(box);
  const auto terms = formula::bevel_terms(stone, scalar::atan2(stone.joint_sine, stone.joint_cosine));
  const Moments<Ball> moments = formula::bevelled_moments(stone, terms);
  return (Ball(2) * moments.transverse - factor * moments.axial).is_positive();
}

using Property = bool (*)(const Box&, const Ball&);

struct Count {
  std::uint64_t proved = 0, not_proved = 0;
  int depth = 0;      // halvings of one box, at most
  std::string first;  // not proved
};

// Where the search gives up: measured 2026-11-22, no domain below takes more than 38 039 boxes, nor halves one more
// than 9 times.
constexpr int deepest = 24;
constexpr std::uint64_t most_boxes = 200000;

void prove(const Box& box, Property property, const Ball& factor, int depth, Count& count) {
  count.depth = std::max(count.depth, depth);
  if (property(box, factor)) {
    ++count.proved;
  } else if (depth == deepest || most_boxes < count.proved || count.not_proved != 0) {
    if (count.not_proved++ == 0) {
      count.first = fmt::format("w/h − 1 from {:.3g} to {:.3g}, {} from {:.3g} to {:.3g}", box.widening.low,
                                box.widening.high, box.from_above ? "1 − b/h" : "b/h", box.band.low, box.band.high);
    }
  } else {
    for (const Box& half : box.halves()) {
      prove(half, property, factor, depth + 1, count);
    }
  }
}

/// [low, high] in parts of a ratio of at most `ratio`.
std::vector<Range> parts(double low, double high, double ratio) {
  std::vector<Range> result;
  while (low < high) {
    const double next = low * ratio < high ? low * ratio : high;
    result.push_back({low, next});
    low = next;
  }
  return result;
}

/// w/h − 1, and b/h up to 1/2 and 1 − b/h below 1/2.
struct Domain {
  Range widening;
  double least_band, least_rest;
};

Measurement cover(Context& context, Property property, const Domain& domain, double ratio) {
  Count count;
  const Ball factor(context.produced(1.0));
  for (const Range& wide : parts(domain.widening.low, domain.widening.high, ratio)) {
    for (const Range& band : parts(domain.least_band, 0.5, ratio)) {
      prove({wide, band, false}, property, factor, 0, count);
    }
    for (const Range& rest : parts(domain.least_rest, 0.5, ratio)) {
      prove({wide, rest, true}, property, factor, 0, count);
    }
  }
  Measurement result;
  result.checks = {{.error = static_cast<double>(count.not_proved),
                    .cases = count.proved + count.not_proved,
                    .worst_case = count.first}};
  result.figures = {{"boxes proved", fmt::format("{}", count.proved)},
                    {"most halvings of a box", fmt::format("{}", count.depth)}};
  return result;
}

Measurement measure_lengths(Context& context) {
  const double widest = context.tier() == Tier::full ? 1e9 : 1.0;
  return cover(context, has_positive_lengths, {{1e-9, widest}, 1e-12, 1e-9}, 2.0);
}

Measurement measure_bodies(Context& context) {
  return cover(context, is_a_body, {{0.25, context.tier() == Tier::full ? 3.0 : 0.3}, 0.08, 0.125}, 1.1);
}

Measurement measure_triangle(Context& context) {
  return cover(context, obeys_triangle, {{0.25, context.tier() == Tier::full ? 2.5 : 0.3}, 0.08, 0.125}, 1.1);
}

}  // namespace

std::vector<Claim> enclosure_box_claims() {
  const std::string boxes = "boxes that cover the domain, halved until it is proved";
  const std::string reason = "proved on a whole box or not";
  return {
      {.id = "ENCLOSURE-6",
       .statement =
           "For every stone with w/h − 1 from 1e-9 to 1e9 (quick tier: to 1) and b/h from 1e-12 to 1 − 1e-9, the "
           "lengths r, d, r₁, r₂, r − r₂, P_x and the joint's cosine and sine are positive; d of the measured stone, "
           "too.",
       .function = "goishi::formula on boxes of balls",
       .family = OracleFamily::proof,
       .oracle = boxes,
       .checks = {{.unit = "boxes not proved or given up", .bound = 0.0, .reason = reason, .counts = true}},
       .measure = measure_lengths},
      {.id = "ENCLOSURE-7",
       .statement = "For every stone with w/h from 5/4 to 4 (quick tier: to 1.3) and b/h from 0.08 to 7/8, the joint "
                    "lies inside the rim, the finished stone is narrower than its lens, and area, volume and moments "
                    "are positive.",
       .function = "goishi::formula on boxes of balls",
       .family = OracleFamily::proof,
       .oracle = boxes,
       .checks = {within(
           "", 0.0, "boxes not proved or given up",
           reason + "; towards the edges of the whole domain P_x becomes w/2, and boxes would shrink without end")},
       .measure = measure_bodies},
      {.id = "ENCLOSURE-8",
       .statement =
           "For every stone with w/h from 5/4 to 3.5 (quick tier: to 1.3) and b/h from 0.08 to 7/8, I_a < 2 I_t.",
       .function = "formula::bevelled_moments on boxes of balls",
       .family = OracleFamily::proof,
       .oracle = boxes,
       .checks = {{.unit = "boxes not proved or given up",
                   .bound = 0.0,
                   .reason =
                       reason + "; of thinner stones I_a is 2 I_t but for (h/w)², and boxes would have to be as small",
                   .counts = true}},
       .measure = measure_triangle},
  };
}

}  // namespace goishi::verify
