/// DROP: what statics says of a stone that is laid down, and what the drop does with it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/drop/holds.hpp>
#include <numbers>
#include <utility>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

/// From 10^low to 10^high, all magnitudes alike.
double magnitude(Context& context, double low, double high) {
  return std::pow(10.0, context.uniform(low, high));
}

Vec3<double> turned_down(const Vec3<double>& g, double angle, double side) {
  const Vec3<double> down = g.normalized(), a = down.unitOrthogonal(), b = down.cross(a);
  return g.norm() * (std::cos(angle) * down + std::sin(angle) * (std::cos(side) * a + std::sin(side) * b));
}

/// A stone that lies, leans or stands on a slope.
struct LaidDown {
  Pebble pebble;
  State<double> start;
  DropSettings<double> settings;

  explicit LaidDown(Context& context, int i)
      : pebble(make_pebble(0.022, 0.022 * context.uniform(0.2, 0.8), i % 2 == 0 ? 0.001 : 0.0)) {
    const double w = 0.022, turn = 2.0 * std::numbers::pi;
    const double tilt = i % 5 == 0 ? 0.0 : magnitude(context, -4.0, 0.2);
    const double around = context.uniform(0.0, turn);
    start.q_WB = Eigen::AngleAxisd(tilt, Vec3<double>(std::cos(around), std::sin(around), 0.0));
    start.p_WB = {0.0, 0.0, 0.0};
    start.p_WB.z() = -separation(pebble.stone, {start.p_WB, start.q_WB}, Plane<double>{}).gap;
    start.v_WB = start.L_W = Vec3<double>::Zero();
    const Vec3<double> g(0.0, 0.0, -g_earth);
    settings.gravity = i % 7 == 0 ? g : turned_down(g, magnitude(context, -4.0, 0.0), context.uniform(0.0, turn));
    settings.friction = magnitude(context, -2.0, 0.0);
    settings.rolling_resistance = w * magnitude(context, -4.0, -0.5);
    settings.pivot_radius = w * magnitude(context, -4.0, -0.5);
    settings.tolerance = 1e-6;
    settings.horizon = 0.1;
  }
  [[nodiscard]] Hold<double> hold() const {
    return holds(pebble.stone, {start.p_WB, start.q_WB}, Plane<double>{}, settings);
  }
};

/// The contact of a stone on the plane z = 0, from its centre: the lowest point of the cap's sphere, or of the rim's torus
/// where the sphere's lies beyond the joint.
Long3 lowest_point(const Geometry& shape, const Quat<double>& q_WB) {
  Long3 u = (q_WB * Vec3<double>::UnitZ()).cast<Long>();
  u = u.z() < 0 ? Long3(-u) : u;
  const Long R = static_cast<Long>(shape.torus_radius), d = static_cast<Long>(shape.sphere_offset);
  const Long r = static_cast<Long>(shape.sphere_radius);
  const Long3 z = Long3::UnitZ(), on_sphere = d * u - r * z;
  const Long from_axis = (on_sphere - on_sphere.dot(u) * u).norm();
  if (from_axis <= R * r / std::hypot(R, d)) {
    return on_sphere;
  }
  const Long3 down = -(z - z.dot(u) * u);
  return R * down.normalized() - static_cast<Long>(shape.tube_radius) * z;
}

/// The shares of friction and resistance, by the moments of the weight about the contact.
std::pair<Long, Long> needed_shares(const LaidDown& laid) {
  const Long3 g = laid.settings.gravity.cast<Long>(), r = lowest_point(laid.pebble.shape, laid.start.q_WB);
  const Long N = -g.z();
  const Long3 torque = r.cross(g) / N;
  // Neither resistance counts as less than a hundredth of the other.
  const double roll = *laid.settings.rolling_resistance, pivot = *laid.settings.pivot_radius;
  const Long delta = std::max(roll, pivot / 100.0), kappa = std::max(pivot, roll / 100.0);
  return {std::hypot(g.x(), g.y()) / (N * static_cast<Long>(laid.settings.friction)),
          std::hypot(torque.x() / delta, torque.y() / delta, torque.z() / kappa)};
}

Measurement measure_statics(Context& context) {
  Checks checks;
  int held = 0, moved = 0, near = 0;
  for (int i = 0; i < context.samples(300, 10'000); ++i) {
    LaidDown laid(context, i);
    const Hold<double> hold = laid.hold();
    const double share = context.produced(std::max(hold.friction, hold.resistance));
    const auto describe_it = [&] {
      return fmt::format("case {}: shares of friction {:.6g}, of resistance {:.6g}", i, hold.friction, hold.resistance);
    };
    see_choice(checks["verdict"], hold.holds == (share < 1.0), describe_it);
    const auto [friction, resistance] = needed_shares(laid);
    const auto off = [&](double found, Long right) {
      return as_double(std::fabs(context.produced(found) - right) / (1 + right));
    };
    // Round-off of the lever counts as resistance, which is the more the less there is.
    const double least = std::min(*laid.settings.rolling_resistance, *laid.settings.pivot_radius);
    checks["shares"].see(
        std::max(off(hold.friction, friction), off(hold.resistance, resistance)) * (least / laid.pebble.stone.width),
        describe_it);
    if (std::fabs(share - 1.0) < 0.01) {
      ++near;  // moves too slowly to tell
      continue;
    }
    const DropResult<double> drop = goishi::drop(laid.pebble.stone, laid.pebble.body, laid.start, laid.settings);
    const double way = (context.produced(drop.state.p_WB) - laid.start.p_WB).norm() / laid.pebble.stone.width +
                       drop.state.q_WB.angularDistance(laid.start.q_WB);
    if (share < 1.0) {
      ++held;
      checks["held"].see(drop.status == DropStatus::rest ? way : 1.0, describe_it);
    } else {
      ++moved;
      see_choice(checks["moves"], way > 1e-7, describe_it);
    }
    if (hold.holds && i % 10 == 0) {
      const auto leaned = [&](double part, double side) {
        LaidDown other = laid;
        other.settings.gravity = turned_down(laid.settings.gravity, part * hold.tilt, side);
        return other.hold().holds;
      };
      bool within = true, all_beyond = true;
      for (int k = 0; k < 360; k += 5) {
        within = within && leaned(1.0 - 1e-6, k * degree);
        all_beyond = all_beyond && leaned(1.001, k * degree);
      }
      see_choice(checks["tilt"], within && !all_beyond, describe_it);
    }
  }
  Measurement result = checks.measurement();
  result.figures = {{"held", fmt::format("{}", held)},
                    {"moved", fmt::format("{}", moved)},
                    {"within a hundredth of the limit, not dropped", fmt::format("{}", near)}};
  return result;
}

}  // namespace

std::vector<Claim> drop_statics_claims() {
  return {
      {.id = "DROP-31",
       .statement = "A stone that `holds` says is held stays where it is laid down; one that is not held "
                    "moves. Its shares of friction and resistance say which, and gravity may lean by its tilt.",
       .function = "holds",
       .family = OracleFamily::relation,
       .oracle =
           "the drop of the same stone, from rest; the moments of its weight about the lowest point, in long double",
       .checks = {within("held", 1e-14, "of the width, and rad",
                         "it does not move, but for the round-off of its attitude", epsilon),
                  none("moves", "stones that stay, but are not held"),
                  within("shares", 3e-13, "of 1 and the share, times w over the least resistance",
                         "512 ε of the width count as resistance; measured 2026-11-30 with 20 seeds: up to 1.2e-13",
                         epsilon),
                  none("verdict", "stones of which the shares say otherwise"), none("tilt", "wrong angles")},
       .measure = measure_statics},
  };
}

}  // namespace goishi::verify
