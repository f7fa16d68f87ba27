/// ENCLOSURE: where a function switches from one formula to another, balls cannot tell which it takes, and both give
/// the same.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/shape/surface.hpp>
#include <string>
#include <utility>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ordered_ball.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

using Number = OrderedBall;
using Numbers = std::vector<std::pair<const char*, Number>>;

Numbers numbers_of(const Support<Number>& at) {
  return {{"S", at.value}, {"support x", at.p_B.x()}, {"support y", at.p_B.y()}, {"support z", at.p_B.z()}};
}

Numbers numbers_of(const SurfacePoint<Number>& at) {
  return {{"distance", at.distance},    {"closest x", at.p_B.x()},     {"closest y", at.p_B.y()},
          {"closest z", at.p_B.z()},    {"normal x", at.normal_B.x()}, {"normal y", at.normal_B.y()},
          {"normal z", at.normal_B.z()}};
}

Numbers numbers_of(const Stone<Number>& stone) {
  return {{"r", stone.sphere_radius},       {"d", stone.sphere_offset},  {"r₁", stone.bevel_major_radius},
          {"r₂", stone.bevel_minor_radius}, {"P_x", stone.joint_radius}, {"R", stone.core_sphere_radius},
          {"cos α", stone.joint_cosine},    {"sin α", stone.joint_sine}, {"w", stone.width}};
}

/// Wide balls meet anything. Lengths are those of stones about 1 wide. The widest measured in the full tier of seeds 1
/// to 3, 1.3e-60, is a foot at the cone of a measured stone with h/w = 2.6e-8 that is nearly all bevel: 16 digits
/// are lost there. The bound leaves ten more for other draws; the 50 that remain tell two formulas apart.
bool is_narrow(const Ball& x) {
  Ball radius;
  arb_get_rad_arb(radius.get(), x.get());
  return x.is_finite() && static_cast<double>(radius) <= 1e-50 * (1.0 + std::fabs(static_cast<double>(x)));
}

class Judge {
 public:
  explicit Judge(Context& context) : factor_(context.produced(1.0)) {}

  /// Two answers to one question meet, number by number.
  void see_same(const Numbers& one, const Numbers& other, const std::string& where) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Ball& left = one[i].second.ball();
      const Ball& right = other[i].second.ball();
      const bool met = is_narrow(left) && is_narrow(right) && (Ball(factor_) * left).overlaps(right);
      see_choice(checks["branches"], met, [&] { return fmt::format("{}, {}", one[i].first, where); });
    }
  }

  /// All answers of a function that stands at a switch. One answer alone: it does not stand there, which is a fault.
  template <class F>
  void see_switch(F&& f, const std::string& where) {
    const auto outcomes = every_outcome(f);
    see_choice(checks["switches"], 1 < outcomes.size(), [&] { return where; });
    for (std::size_t i = 1; i < outcomes.size(); ++i) {
      see_same(outcomes[0], outcomes[i], where);
    }
  }

  Checks checks;

 private:
  double factor_;
};

/// A stone, and a meridian of it.
struct Place {
  Stone<Number> stone;
  Number x, y;  // the meridian's direction
  std::string name;
};

/// From cap to rim.
void see_joint(Judge& judge, const Place& at) {
  const Stone<Number>& stone = at.stone;
  for (const int side : {1, -1}) {
    const Vec3<Number> n(Number(stone.joint_cosine * at.x), Number(stone.joint_cosine * at.y),
                         Number(Number(side) * stone.joint_sine));
    judge.see_switch([&] { return numbers_of(support(stone, n)); }, "support, " + at.name);
  }
  // An attitude whose axis leans so that the plane below meets the joint: cos θ = sin α.
  const Number half = Number(1) / Number(2);
  const Number c = scalar::sqrt(Number(half * (Number(1) + stone.joint_sine)));
  const Number s = half * stone.joint_cosine / c;
  const Pose<Number> pose{.p_WB = {Number(0), Number(0), Number(1)},
                          .q_WB = Quat<Number>(c, Number(-(s * at.y)), Number(s * at.x), Number(0))};
  judge.see_switch([&] { return Numbers{{"surface gap", surface_gap(stone, pose)}}; }, "gap, " + at.name);
}

/// From the cone of points nearest to a cap to those nearest to the rim: ρ d = r₁ (ζ + d), out of the stone.
void see_cone(Judge& judge, const Place& at) {
  const Stone<Number>& stone = at.stone;
  const Number beyond = Number(3) / Number(2);
  const Number rho = stone.bevel_major_radius * beyond;
  for (const int side : {1, -1}) {
    const Vec3<Number> p(Number(rho * at.x), Number(rho * at.y),
                         Number(Number(side) * stone.sphere_offset * (beyond - Number(1))));
    judge.see_switch([&] { return numbers_of(closest_point(stone, p)); }, "closest point, " + at.name);
  }
}

/// From the upper cap to the lower one: in the middle plane, inside. The foot jumps, the distance does not.
void see_middle(Judge& judge, const Place& at) {
  const Number rho = at.stone.bevel_major_radius / Number(3);
  Ball nothing(0);
  arb_add_error_2exp_si(nothing.get(), -300);
  const Vec3<Number> p(Number(rho * at.x), Number(rho * at.y), Number(nothing));
  judge.see_switch(
      [&] {
        return Numbers{{"distance", closest_point(at.stone, p).distance}};
      },
      "middle plane, " + at.name);
}

/// From bevelled to sharp: the bevelled formulas at b = 0 and the sharp ones.
void see_vanishing_bevel(Judge& judge, const Number& w, const Number& h, const std::string& name) {
  const Number none(0);
  const Number offset = formula::measured_sphere_offset(w, h, none);
  const Stone<Number> sharp = formula::sharp_stone(w, h);
  const Stone<Number> bevelled = formula::bevelled_stone(w, h, none, formula::sphere_offset(w, h));
  const Stone<Number> measured = formula::bevelled_stone(formula::generating_width(h, offset), h, none, offset);
  judge.see_same(numbers_of(bevelled), numbers_of(sharp), "b = 0, " + name);
  judge.see_same(numbers_of(measured), numbers_of(sharp), "measured, b = 0, " + name);
  const auto terms = formula::bevel_terms(bevelled, scalar::atan2(bevelled.joint_sine, bevelled.joint_cosine));
  const Moments<Number> moments = formula::bevelled_moments(bevelled, terms), lens = formula::lens_moments(w, h);
  judge.see_same({{"V", formula::bevelled_volume(bevelled, terms)},
                  {"area", formula::bevelled_surface_area(bevelled, terms)},
                  {"I_a", moments.axial},
                  {"I_t", moments.transverse}},
                 {{"V", formula::lens_volume(w, h)},
                  {"area", formula::lens_surface_area(w, h)},
                  {"I_a", lens.axial},
                  {"I_t", lens.transverse}},
                 "mass, b = 0, " + name);
}

Measurement measure_switches(Context& context) {
  Judge judge(context);
  for (int i = 0; i < context.samples(60, 300); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const Number w(shape.width), h(shape.height), b(shape.bevel);
    const Number azimuth(context.uniform(0.0, 6.0));
    const Number x = scalar::cos(azimuth), y = scalar::sin(azimuth);
    const std::string name = describe(shape);
    const std::array<Place, 3> places = {{{make_stone(w, h), x, y, "sharp, " + name},
                                          {make_stone(w, h, b), x, y, name},
                                          {make_measured_stone(w, h, b), x, y, "measured, " + name}}};
    for (const Place& at : places) {
      const bool thin = shape.height < shape.width;
      if (thin || &at != &places.front()) {  // the equator of a sharp ball is exact: nothing is left open
        see_joint(judge, at);
      }
      if (thin) {  // a ball has neither cone nor rim, and a centre in its middle plane
        see_cone(judge, at);
        see_middle(judge, at);
      }
    }
    if (shape.height < shape.width) {
      see_vanishing_bevel(judge, w, h, name);
    }
  }
  return judge.checks.measurement();
}

}  // namespace

std::vector<Claim> enclosure_switch_claims() {
  return {
      {.id = "ENCLOSURE-5",
       .statement =
           "Where a function switches (support and gap at the joint's normal, closest point at the cone between cap "
           "and rim, its distance in the middle plane), balls leave the choice open and both branches meet. At b = 0 "
           "the bevelled formulas, of the measured stone too, meet the sharp ones.",
       .function = "support, surface_gap, closest_point; formula::bevelled_stone, bevelled_volume, "
                   "bevelled_surface_area, bevelled_moments at b = 0",
       .family = OracleFamily::relation,
       .oracle = "each branch beside the other",
       .checks = {within("branches", 0.0, "branches that do not meet", "the functions are continuous there"),
                  none("switches", "places that are no switch")},
       .measure = measure_switches},
  };
}

}  // namespace goishi::verify
