#pragma once
/// \file
/// The talk's law: the normal impulse, then friction from the velocity after it.

#include <goishi/impact/impulses.hpp>
#include <goishi/impact/material.hpp>
#include <limits>

namespace goishi {

/// When the published law is done: the contact approaches with no more than this part of its first approach speed,
/// 1e-9, and round-off of its velocity. Stopped sooner, stones sink into the board; each further digit takes more
/// rounds where e is near 0, because a round then leaves a fixed part of the approach.
template <Field T>
[[nodiscard]] constexpr T published_tolerance() {
  return T(1) / T(1000000000);
}

/// After so many rounds the published law gives up (`ImpactOutcome::not_converged`): where e is near 0 and friction
/// takes back nearly all that the normal impulse gives, a round gains next to nothing. IMPACT-4 counts such impacts.
inline constexpr int published_most_rounds = 1000;

namespace detail {

/// One round, from the velocity v: an impulse along n, then one against the slip that it leaves, |j_t| <= μ j.
template <Ordered T>
[[nodiscard]] LawImpulse<T> published_round(const Collision<T>& c, const T& normal_mobility, const Vec3<T>& v) {
  const T j = formula::normal_impulse(formula::dot(v, c.n), normal_mobility, c.restitution);
  const Vec3<T> along_n = formula::scaled(j, c.n);
  const Vec3<T> pushed = formula::plus(v, formula::product(c.W, along_n));
  const Vec3<T> slip = formula::plus(pushed, T(-formula::dot(pushed, c.n)), c.n);
  const T speed = scalar::sqrt(formula::dot(slip, slip));
  if (!(T(0) < speed)) {
    return {ImpactOutcome::stuck, along_n, 1};
  }
  const Vec3<T> t = formula::scaled(T(T(1) / speed), slip);
  const T stopping = formula::stopping_impulse(speed, formula::dot(t, formula::product(c.W, t)));
  const T limit = -(c.friction * j);
  const bool slides = stopping < limit;
  return {slides ? ImpactOutcome::slid : ImpactOutcome::stuck, formula::plus(along_n, slides ? limit : stopping, t), 1};
}

/// Rounds until the contact no longer approaches. Friction couples back into the normal velocity, so the effective
/// restitution is not e, and a contact can still approach after a round (claims PUBLISHED-15, PUBLISHED-16). No round
/// adds energy, and the sum of impulses in a cone is in the cone.
template <Ordered T>
[[nodiscard]] LawImpulse<T> published(const Collision<T>& c) {
  const T normal_mobility = formula::dot(c.n, formula::product(c.W, c.n));
  const T round_off = T(8) * std::numeric_limits<T>::epsilon() * scalar::sqrt(formula::dot(c.v, c.v));
  const T tolerated = published_tolerance<T>() * formula::dot(c.v, c.n) - round_off;  // negative
  LawImpulse<T> sum{ImpactOutcome::not_converged, Vec3<T>::Zero(), 0};
  Vec3<T> v = c.v;
  while (sum.rounds < published_most_rounds) {
    const LawImpulse<T> round = published_round(c, normal_mobility, v);
    sum.p = formula::plus(sum.p, round.p);
    ++sum.rounds;
    v = formula::plus(c.v, formula::product(c.W, sum.p));
    if (tolerated <= formula::dot(v, c.n)) {
      sum.outcome = round.outcome;
      break;
    }
  }
  return sum;
}

}  // namespace detail
}  // namespace goishi
