#pragma once
/// \file
/// Normals of two stones that are known in closed form: where a cap meets a cap, or a cap meets a rim.

#include <goishi/contact/pair.hpp>

namespace goishi {

namespace detail {

/// How two points of two circles turn towards being nearest.
template <class T>
struct RimsTurn {
  T bend1, bend2;  // [m] second derivatives of half the distance's square, over the radii
  T determinant;   // [m²]
  T step1, step2;  // [m²] Newton's steps, times the determinant
};

}  // namespace detail

namespace formula {

/// Half the square of w, which leads from a point of one circle to one of another, by the two angles: its slopes over
/// c_i, its second derivatives over c_i and c₁ c₂, and Newton's step. e leads out to a circle's point, f along it; c
/// is its radius.
/// Domain  a determinant that is not zero.   Proof  derivations/edges.cpp.
template <Field T>
[[nodiscard]] inline detail::RimsTurn<T> rims_turn(const Vec3<T>& w, const T& c1, const Vec3<T>& e1, const Vec3<T>& f1,
                                                   const T& c2, const Vec3<T>& e2, const Vec3<T>& f2) {
  const T slope1 = -formula::dot(w, f1), slope2 = -formula::dot(w, f2);
  const T bend1 = c1 + formula::dot(w, e1), bend2 = c2 + formula::dot(w, e2);
  const T mixed = formula::dot(f1, f2);
  return {.bend1 = bend1,
          .bend2 = bend2,
          .determinant = T(bend1 * bend2 - scalar::sq(mixed) * c1 * c2),
          .step1 = T(c2 * mixed * slope2 - bend2 * slope1),
          .step2 = T(c1 * mixed * slope1 - bend1 * slope2)};
}

}  // namespace formula

namespace detail {

/// The centre of the sphere of the cap that looks along `sign` u, from the stone's centre, seen along −n: what a cap adds to
/// D · n is sign d u · n − R.
template <Ordered T>
[[nodiscard]] Vec3<T> with_sphere(const Vec3<T>& v, const Placed<T>& placed, const T& sign) {
  return formula::plus(v, T(sign * placed.stone.sphere_offset), placed.u_W);
}

/// From the nearest point of a stone's core rim to a point v, both seen from the stone's centre; along the normal. 0 if the
/// point is not outside the rim's cylinder: then the rim's nearest point is not the one that is met along the normal.
template <Ordered T>
[[nodiscard]] Vec3<T> from_rim(const Vec3<T>& v, const Placed<T>& placed) {
  const FromRim<T> seen = formula::from_rim(v, placed.u_W, placed.stone.bevel_major_radius);
  return T(0) < seen.beyond ? seen.away : Vec3<T>(T(0), T(0), T(0));
}

// `all` and not && below: each condition is as good as random, and a branch for each would be guessed wrong.

/// Whether a stone meets a normal v/|v| with the cap that looks along `sign` u.
template <Ordered T>
[[nodiscard]] bool meets_with_cap(const Placed<T>& placed, const T& sign, const Vec3<T>& v, const T& size2) {
  const T axial = sign * formula::dot(placed.u_W, v);
  const bool above = T(0) <= axial, steep = scalar::sq(placed.stone.joint_sine) * size2 <= scalar::sq(axial);
  return all(above, steep);
}

template <Ordered T>
[[nodiscard]] bool meets_with_rim(const Placed<T>& placed, const Vec3<T>& v, const T& size2) {
  const T axial = formula::dot(placed.u_W, v);
  return scalar::sq(axial) <= scalar::sq(placed.stone.joint_sine) * size2;
}

/// The sign of the cap that a stone is likely to turn towards a direction.
template <Ordered T>
[[nodiscard]] T sign_towards(const Placed<T>& placed, const Vec3<T>& v) {
  return scalar::signed_as(T(1), formula::dot(placed.u_W, v));
}

/// Looks for a closed form that holds and at which the cores are apart: then no other normal separates more. Else false;
/// `along` is a direction to search from, or 0.
template <Ordered T>
[[nodiscard]] bool find_apart(const Pair<T>& pair, Vec3<T>& along) {
  const T sign1 = sign_towards(pair.first, pair.between), sign2 = sign_towards(pair.second, pair.between);
  const T &R1 = pair.first.stone.core_sphere_radius, &R2 = pair.second.stone.core_sphere_radius;
  const Vec3<T> from_first = with_sphere(pair.between, pair.first, sign1);
  const Vec3<T> caps = with_sphere(from_first, pair.second, sign2);
  const T caps2 = formula::dot(caps, caps);
  const bool cap1 = meets_with_cap(pair.first, sign1, caps, caps2),
             cap2 = meets_with_cap(pair.second, sign2, caps, caps2);
  if (all(scalar::sq(T(R1 + R2)) < caps2, cap1, cap2)) {
    along = caps;
    return true;
  }
  const Vec3<T> rim2 = from_rim(from_first, pair.second);
  const T rim2_2 = formula::dot(rim2, rim2);
  const bool on_cap1 = meets_with_cap(pair.first, sign1, rim2, rim2_2),
             on_rim2 = meets_with_rim(pair.second, rim2, rim2_2);
  if (all(scalar::sq(R1) < rim2_2, on_cap1, on_rim2)) {
    along = rim2;
    return true;
  }
  const Vec3<T> rim1 = from_rim(with_sphere(pair.between, pair.second, sign2), pair.first);
  const T rim1_2 = formula::dot(rim1, rim1);
  const bool on_cap2 = meets_with_cap(pair.second, sign2, rim1, rim1_2),
             on_rim1 = meets_with_rim(pair.first, rim1, rim1_2);
  if (all(scalar::sq(R2) < rim1_2, on_cap2, on_rim1)) {
    along = rim1;
    return true;
  }
  // Two rims, mostly: nearest to where the better of the two would be.
  along = scalar::sqrt(rim1_2) - R2 < scalar::sqrt(rim2_2) - R1 ? rim2 : rim1;
  turn_to_nearest_rims(pair, along);
  return false;
}

/// Turns a direction to that between the nearest points of the two core rims, x₁ = D − c₁ e₁ and x₂ = c₂ e₂, by Newton's
/// method on half the square of w = x₁ − x₂ as a function of two angles. Unlike the direction of w, that function is smooth
/// where the rims all but touch. Leaves the direction where that leads nowhere.
template <Ordered T>
void turn_to_nearest_rims(const Pair<T>& pair, Vec3<T>& along) {
  constexpr int most_steps = 8;
  const Placed<T>* stones[2] = {&pair.first, &pair.second};
  T c[2];
  const Vec3<T> start = held_along(along);
  Vec3<T> e[2], f[2];  // out to the point, and along the circle
  for (int i = 0; i < 2; ++i) {
    const Vec3<T>& u = stones[i]->u_W;
    c[i] = stones[i]->stone.bevel_major_radius;
    if (!find_unit(formula::cross(u, start), f[i])) {
      return;
    }
    e[i] = formula::cross(f[i], u);
  }
  for (int step = 0; step < most_steps; ++step) {
    const Vec3<T> w = formula::plus(formula::plus(pair.between, T(-c[0]), e[0]), T(-c[1]), e[1]);
    const RimsTurn<T> newton = formula::rims_turn(w, c[0], e[0], f[0], c[1], e[1], f[1]);
    if (!(T(0) < newton.bend1 && T(0) < newton.bend2 && T(0) < newton.determinant)) {
      return;
    }
    const T turn[2] = {T(newton.step1 / newton.determinant), T(newton.step2 / newton.determinant)};
    const T turn2 = scalar::sq(turn[0]) + scalar::sq(turn[1]);
    if (!(turn2 < T(1))) {
      return;
    }
    // By the angles whose halves have the tangents turn/2.
    for (int i = 0; i < 2; ++i) {
      const T square = scalar::sq(turn[i]) / T(4);
      const T over = scalar::sq(scalar::sq(square)) < std::numeric_limits<T>::epsilon() / T(4)
                         ? T(T(1) - square * (T(1) - square * (T(1) - square)))
                         : T(T(1) / (T(1) + square));
      const T cosine = (T(1) - square) * over, sine = turn[i] * over;
      const Vec3<T> next = formula::combination(cosine, e[i], sine, f[i]);
      f[i] = formula::combination(cosine, f[i], T(-sine), e[i]);
      e[i] = next;
    }
    if (turn2 <= T(65536) * std::numeric_limits<T>::epsilon()) {
      along = formula::plus(formula::plus(pair.between, T(-c[0]), e[0]), T(-c[1]), e[1]);
      return;
    }
  }
}

/// Tries every normal at which a cap and a cap, or a cap and a rim, could separate most; each counts for what it gives.
template <Ordered T>
void try_caps(const Pair<T>& pair, PairPoint<T>& best) {
  const auto try_normal = [&](const Vec3<T>& v) {
    Vec3<T> n;
    if (find_unit(v, n)) {
      raise(pair, n, best);
    }
  };
  for (const T& sign : {T(1), T(-1)}) {
    const Vec3<T> from_first = with_sphere(pair.between, pair.first, sign);
    try_normal(with_sphere(from_first, pair.second, T(1)));
    try_normal(with_sphere(from_first, pair.second, T(-1)));
    try_normal(from_rim(from_first, pair.second));
    try_normal(from_rim(with_sphere(pair.between, pair.second, sign), pair.first));
  }
}

}  // namespace detail
}  // namespace goishi
