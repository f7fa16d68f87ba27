#pragma once
/// \file
/// Drops for the claims: stones in contact with the plane z = 0, and what a state is, read off it in long double by
/// definitions that share no formula with src/.

#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <limits>
#include <numbers>

#include "compiled/drop.hpp"
#include "verify/oracles/contact/wobble.hpp"
#include "verify/oracles/drop/spin.hpp"
#include "verify/oracles/stone/geometry.hpp"
#include "verify/oracles/stone/profile.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/claim.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify {

inline constexpr double g_earth = 9.80665;
inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double tight = 1e-12;  // tolerance where the answer is exact

/// A stone to drop, and the same for the witnesses: by its definition, with moments by quadrature.
struct Pebble {
  Stone<double> stone;
  RigidBody<double> body;
  Geometry shape;
  Long axial, transverse;  // per unit of mass   [m²]

  [[nodiscard]] Rocker rocker(double gravity = g_earth) const {
    return {shape.sphere_radius, shape.sphere_offset, shape.torus_radius, shape.tube_radius, transverse, gravity};
  }
  [[nodiscard]] SpinningCap<Long> cap(double gravity = g_earth) const {
    return {shape.sphere_radius, shape.sphere_offset, axial, transverse, gravity};
  }
};

/// h < w. The mass is that of a stone, 5 g.
[[nodiscard]] inline Pebble make_pebble(double width, double height, double bevel = 0.0) {
  const Stone<double> stone = bevel > 0.0 ? make_stone(width, height, bevel) : make_stone(width, height);
  const Geometry shape = solve_published(width, height, bevel);
  const Integrals integrals = integrate_profile(shape);
  return {stone, make_rigid_body(mass_properties(stone, Mass{0.005})), shape, integrals.axial / integrals.volume,
          integrals.transverse / integrals.volume};
}

[[nodiscard]] inline Pebble size_33(double bevel = 0.0) {
  return make_pebble(0.022, 0.0092, bevel);
}

/// Nothing but friction takes energy, and not that without slip.
[[nodiscard]] inline DropSettings<double> lossless(double friction, double tolerance) {
  DropSettings<double> settings;
  settings.friction = friction;
  settings.rolling_resistance = settings.pivot_radius = 0.0;
  settings.tolerance = tolerance;
  settings.maximum_steps = 200000;  // some ten times what is needed: a motion that has gone wrong ends soon
  return settings;
}

[[nodiscard]] inline DropSettings<double> slip_proportional(double coefficient, double tolerance) {
  DropSettings<double> settings = lossless(0.3, tolerance);
  settings.friction_model = FrictionModel::slip_proportional;
  settings.slip_coefficient = coefficient;
  return settings;
}

inline constexpr double no_slip = std::numeric_limits<double>::infinity();

/// The attitude whose axis leans by θ towards +x.
[[nodiscard]] inline Quat<double> leaning(double tilt) {
  return {std::cos(tilt / 2.0), 0.0, std::sin(tilt / 2.0), 0.0};
}

/// A state on the cap as a witness sees it. Per unit of mass.
struct Witnessed {
  Long3 u, w;     // axis, angular velocity
  Long3 arm;      // from the centre to the contact point: d u − r ẑ
  Long3 slip;     // velocity of the contact point
  Long tilt;      // angle of the axis from the vertical, >= 0
  Long jellett;   // L · arm
  Long energy;    // zero for a centre at rest at z = 0
  Long momentum;  // |L|
};

[[nodiscard]] inline Long3 cap_arm(const Pebble& pebble, const Long3& u) {
  return static_cast<Long>(pebble.shape.sphere_offset) * u - Long3(0, 0, static_cast<Long>(pebble.shape.sphere_radius));
}

[[nodiscard]] inline Witnessed witnessed(const Pebble& pebble, const State<double>& state,
                                         const Vec3<double>& gravity = {0.0, 0.0, -g_earth}) {
  const Quat<Long> q = state.q_WB.cast<Long>().normalized();
  const Long3 L = state.L_W.cast<Long>() / static_cast<Long>(pebble.body.mass), v = state.v_WB.cast<Long>();
  Witnessed seen;
  seen.u = q * Long3(0, 0, 1);
  const Long along = L.dot(seen.u);
  const Long3 across = L - along * seen.u;
  seen.w = across / pebble.transverse + along / pebble.axial * seen.u;
  seen.arm = cap_arm(pebble, seen.u);
  seen.slip = v + seen.w.cross(seen.arm);
  seen.tilt = std::atan2(std::hypot(seen.u.x(), seen.u.y()), seen.u.z());
  seen.jellett = L.dot(seen.arm);
  seen.energy = (v.squaredNorm() + across.squaredNorm() / pebble.transverse + along * along / pebble.axial) / 2 -
                gravity.cast<Long>().dot(state.p_WB.cast<Long>());
  seen.momentum = L.norm();
  return seen;
}

/// What rolling on the cap keeps beside energy and Jellett's integral: ω_u² (I_t I_a + I_t r² (1 − z²) + I_a (d − r z)²).
[[nodiscard]] inline Long routh(const Pebble& pebble, const Witnessed& seen) {
  const Long spin = seen.w.dot(seen.u);
  return spin * spin * (pebble.transverse * pebble.axial + pebble.cap().lever(seen.u.z()));
}

/// On the cap, the contact point over the origin's vertical but for the lever; turning with ω, the centre moving along
/// the plane with v.
[[nodiscard]] inline State<double> set_on_cap(const Pebble& pebble, const Quat<double>& q, const Vec3<double>& w_W,
                                              const Vec3<double>& v) {
  const Long3 u = q.cast<Long>() * Long3(0, 0, 1), w = w_W.cast<Long>(), arm = cap_arm(pebble, u);
  const Long3 L =
      static_cast<Long>(pebble.body.mass) * (pebble.transverse * w + (pebble.axial - pebble.transverse) * w.dot(u) * u);
  State<double> state;
  state.q_WB = q;
  state.p_WB = {0.0, 0.0, static_cast<double>(-arm.z())};
  state.v_WB = {v.x(), v.y(), static_cast<double>(-w.cross(arm).z())};
  state.L_W = L.cast<double>();
  return state;
}

/// The same without slip.
[[nodiscard]] inline State<double> set_rolling(const Pebble& pebble, const Quat<double>& q, const Vec3<double>& w_W) {
  const Long3 arm = cap_arm(pebble, q.cast<Long>() * Long3(0, 0, 1));
  return set_on_cap(pebble, q, w_W, Long3(-w_W.cast<Long>().cross(arm)).cast<double>());
}

/// Leaning by θ, turning about the vertical on the spot.
[[nodiscard]] inline State<double> spun(const Pebble& pebble, double tilt, double spin) {
  return set_on_cap(pebble, leaning(tilt), {0.0, 0.0, spin}, {0.0, 0.0, 0.0});
}

[[nodiscard]] inline DropResult<double> drop(const Pebble& pebble, const State<double>& start,
                                             DropSettings<double> settings, Long horizon) {
  settings.horizon = static_cast<double>(horizon);
  return goishi::drop(pebble.stone, pebble.body, start, settings);
}

/// Dropped, up to a time or rest, and its motion kept.
[[nodiscard]] inline Drop<double> moved(const Pebble& pebble, const State<double>& start,
                                        const DropSettings<double>& settings, double until) {
  Drop<double> motion(pebble.stone, pebble.body, start, settings);
  motion.keep_motion();
  motion.advance_to(until);
  return motion;
}

/// The first event of a kind, or null.
[[nodiscard]] inline const Event<double>* first_event(const DropResult<double>& dropped, EventKind kind) {
  for (const Event<double>& event : dropped.events) {
    if (event.kind == kind) {
      return &event;
    }
  }
  return nullptr;
}

/// From 5 cm, in any attitude, spinning with up to 30 rad/s.
[[nodiscard]] inline State<double> draw_fall(Context& context, const RigidBody<double>& body) {
  State<double> state;
  state.p_WB = {0.0, 0.0, 0.05};
  state.v_WB = Vec3<double>::Zero();
  state.q_WB = draw_attitude(context.random());
  state.L_W = formula::angular_momentum_W(
      state.q_WB, body,
      Vec3<double>(context.uniform(0.0, 30.0) * (draw_attitude(context.random()) * Vec3<double>::UnitZ())));
  return state;
}

/// Under the usual settings.
[[nodiscard]] inline DropResult<double> dropped(const Pebble& pebble, const State<double>& start, double tolerance) {
  DropSettings<double> settings;
  settings.tolerance = tolerance;
  return drop(pebble.stone, pebble.body, start, settings);
}

}  // namespace goishi::verify
