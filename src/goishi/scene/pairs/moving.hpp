#pragma once
/// \file
/// How a stone moves for a while, as its pairs see it: where it is, how fast, and what bounds both.

#include <goishi/contact/gap_along.hpp>
#include <goishi/drop/drop.hpp>
#include <goishi/scene/cluster/row.hpp>
#include <limits>

namespace goishi::detail {

/// When two points that go straight on come as near as `distance`, further apart than it now: the first root of |x + v t| = R, in
/// the form that does not cancel. Infinite if they do not.
template <Ordered T>
[[nodiscard]] T meeting_time(const Vec3<T>& between, const Vec3<T>& v, const T& distance) {
  const T approach = -formula::dot(between, v), open = formula::dot(between, between) - scalar::sq(distance);
  const T square = scalar::sq(approach) - formula::dot(v, v) * open;
  return T(0) < approach && T(0) <= square ? T(open / (approach + scalar::sqrt(square)))
                                           : std::numeric_limits<T>::infinity();
}

/// A stone on a flight, or along a stretch of contact. It refers to the stone and to the stretch.
template <class T>
struct Moving {
  const Stone<T>* stone = nullptr;
  const ContactBody<T>* body = nullptr;   // of a stretch of contact
  const Touching<T>* touching = nullptr;  // likewise; else it flies
  FlightPath<T> path = {};                // from `begin`
  T begin = T(0), end = T(0);             // [s]
  T speed = T(0);                         // [m/s] of any point of its surface, as long as nothing else touches it
};

/// Where it is and how it moves at a time. The turning about its own axis moves no surface, and is left out of a flight's.
template <class T>
struct Sight {
  Placed<T> placed;
  Vec3<T> v, w;
};

template <Ordered T>
[[nodiscard]] Sight<T> sight(const Moving<T>& moving, const T& time) {
  const T t = time - moving.begin;
  if (moving.touching != nullptr) {
    const Touching<T>& touching = *moving.touching;
    const Variables<T> y = touching.along(t < touching.length ? T(t / touching.length) : T(1));
    const ContactPlace<T> now = place_of(*moving.body, touching.frame.feature, y);
    const std::array<T, 2> s = slip_of(touching.frame.mode, y);
    return {{*moving.stone, Vec3<T>(y[at::x], y[at::y], T(touching.frame.level + now.height)), now.u},
            formula::centre_velocity(now, s[0], s[1]),
            now.w};
  }
  const FlightPath<T>& path = moving.path;
  return {placed_at(*moving.stone, path, t), formula::plus(path.v_W, t, path.a_W),
          formula::scaled(path.rate, path.k_W)};
}

/// Where only the centre of a stone alone is, along its present stretch.
template <Ordered T>
[[nodiscard]] Vec3<T> centre_of(const Drop<T>& drop, const T& time) {
  const Stretch<T>& stretch = drop.stretch();
  const T t = time - stretch.begin;
  if (const auto* touching = std::get_if<Touching<T>>(&stretch.motion)) {
    const Variables<T> y = touching->along(t < touching->length ? T(t / touching->length) : T(1));
    const ContactFrame<T>& frame = touching->frame;
    return {y[at::x], y[at::y], T(frame.level + geometry_of(drop.stone(), frame.feature, axis_of(y)).height)};
  }
  if (const auto* flying = std::get_if<Flying<T>>(&stretch.motion)) {
    const State<T>& from = flying->from;
    return formula::plus(from.p_WB, t, formula::plus(from.v_WB, T(t / T(2)), flying->gravity));
  }
  if (const auto* bouncing = std::get_if<Bouncing<T>>(&stretch.motion)) {
    const State<T>& from = bouncing->from;
    return formula::plus(from.p_WB, t, Vec3<T>(from.v_WB.x(), from.v_WB.y(), T(0)));
  }
  return std::get<Standing<T>>(stretch.motion).state.p_WB;
}

/// The most that −H'' of a gap along a fixed normal gets from this stone   [m/s²].
template <Ordered T>
[[nodiscard]] T bend_of(const Moving<T>& moving) {
  const Stone<T>& stone = *moving.stone;
  if (moving.touching == nullptr) {
    const FlightPath<T>& path = moving.path;
    return scalar::sqrt(formula::dot(path.a_W, path.a_W)) + stone.sphere_offset * scalar::sq(path.rate);
  }
  // Of the polynomials: |y''| <= Σ k (k − 1) |c_k|, |y'| <= Σ k |c_k|, over the length's powers.
  const Touching<T>& touching = *moving.touching;
  const auto bounds = [&](std::size_t i, T& rate, T& bend) {
    for (std::size_t k = 1; k < touching.along.c.size(); ++k) {
      const T size = scalar::abs(T(touching.along.c[k][i]));
      const auto power = static_cast<int>(k);
      rate = rate + T(power) * size;
      bend = bend + T(power * (power - 1)) * size;
    }
  };
  T across(0), turn_rate(0), turn(0), unused(0);
  bounds(at::x, unused, across);
  bounds(at::y, unused, across);
  for (std::size_t i = at::u; i < at::u + 3; ++i) {
    bounds(i, turn_rate, turn);
  }
  // The height is the support's: its slope is d at most, its bend on the rim r₁/n_r³.
  const bool rim = touching.frame.feature == Feature::rim;
  const T least = stone.joint_cosine;
  const T support_bend = rim ? T(stone.bevel_major_radius / (least * least * least)) : T(0);
  const T height = stone.sphere_offset * turn + support_bend * scalar::sq(turn_rate);
  return (across + height + stone.sphere_offset * turn) / scalar::sq(touching.length);
}

/// No faster   [m/s], until a time   [s], and until they are raised.
template <class T>
struct SpeedBounds {
  T centre = T(0), surface = T(0);
  T until = std::numeric_limits<T>::infinity();
};

/// Bounds of the speeds of a stone alone from a time on, of its centre and of any point of its surface, until its stretch ends,
/// something else touches it or, in a flight, its fall has added √(c g), c its reach, or what its speed is already.
/// `lever` = √(1 + c²/k²), k² = I_t/m: |v| + c |ω| <= lever √(2 e) where v² + k² ω² <= 2 e.
template <Ordered T>
[[nodiscard]] SpeedBounds<T> speed_bounds(const Drop<T>& drop, const T& reach, const T& lever,
                                          const Mobility<T>& mobility, const T& time) {
  const Stretch<T>& stretch = drop.stretch();
  const auto size = [](const Vec3<T>& v) { return scalar::sqrt(formula::dot(v, v)); };
  if (const auto* flying = std::get_if<Flying<T>>(&stretch.motion)) {
    const T now = size(formula::plus(flying->from.v_WB, T(time - stretch.begin), flying->gravity));
    const T g = size(flying->gravity);
    const T more = scalar::max(now, scalar::sqrt(T(reach * g)));
    const T grows = T(0) < g ? T(g * (stretch.end - time)) : T(0);
    const T centre = now + scalar::min(grows, more);
    const T turning = reach * mobility.transverse * size(flying->from.L_W);
    return {centre, T(centre + turning), more < grows ? T(time + more / g) : stretch.end};
  }
  if (const auto* bouncing = std::get_if<Bouncing<T>>(&stretch.motion)) {
    const T centre = size(bouncing->from.v_WB);
    return {centre, T(centre + reach * mobility.transverse * size(bouncing->from.L_W)), stretch.end};
  }
  if (const auto* touching = std::get_if<Touching<T>>(&stretch.motion)) {
    const ContactBody<T>& body = drop.contact_body();
    const Variables<T>& y = touching->along.c[0];
    const ContactPlace<T> now = place_of(body, touching->frame.feature, y);
    const std::array<T, 2> s = slip_of(touching->frame.mode, y);
    const Vec3<T>& g = body.gravity;
    const T fall = scalar::abs(T(g.z())) * (now.height - drop.stone().height / T(2));
    const T energy = formula::contact_kinetic_energy(now, s[0], s[1]) + (fall < T(0) ? T(0) : fall);
    const T slope = scalar::sqrt(T(scalar::sq(g.x()) + scalar::sq(g.y()))) * touching->length;
    const T centre = T(1.01) * scalar::sqrt(T(T(2) * energy));
    return {T(centre + slope), T(lever * centre + slope), stretch.end};
  }
  return {T(0), T(0), stretch.end};
}

/// How a stone alone moves along its present stretch.
template <Ordered T>
[[nodiscard]] Moving<T> moving_of(const Drop<T>& drop, const Mobility<T>& mobility) {
  const Stretch<T>& stretch = drop.stretch();
  Moving<T> moving{.stone = &drop.stone(), .begin = stretch.begin, .end = stretch.end};
  if (const auto* touching = std::get_if<Touching<T>>(&stretch.motion)) {
    moving.body = &drop.contact_body();
    moving.touching = touching;
  } else if (const auto* flying = std::get_if<Flying<T>>(&stretch.motion)) {
    moving.path = path_of(flying->from, mobility, flying->gravity);
  } else if (const auto* bouncing = std::get_if<Bouncing<T>>(&stretch.motion)) {
    // Less than `closing_speed`²/2g high: as if it stayed down.
    State<T> from = bouncing->from;
    from.v_WB.z() = T(0);
    moving.path = path_of(from, mobility, Vec3<T>(Vec3<T>::Zero()));
  } else {
    moving.path = path_of(std::get<Standing<T>>(stretch.motion).state, mobility, Vec3<T>(Vec3<T>::Zero()));
    moving.path.v_W = Vec3<T>::Zero();
  }
  return moving;
}

}  // namespace goishi::detail
