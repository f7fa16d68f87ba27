#pragma once
/// \file
/// Two stones seen along a normal, and Newton's method on the sphere of normals.
///
/// g(n) = D · n − h₁(n) − h₂(n), D from the second centre to the first, h the supports of the *cores*. With a₁, a₂ the
/// support points and w = D − a₁ − a₂: g = w · n, and its gradient on the sphere is the part of w across n.

#include <goishi/contact/contact.hpp>
#include <limits>
#include <utility>

namespace goishi::detail {

/// Refers to its stones, which must outlive it.
template <class T>
struct Pair {
  const Placed<T>& first;
  const Placed<T>& second;
  Vec3<T> between;  // D
  T scale;          // of what is rounded: thin stones have large spheres, whose round-off shows across the normal

  Pair(const Placed<T>& one, const Placed<T>& other)
      : first(one), second(other), between(formula::minus(one.p_W, other.p_W)) {
    scale = outer_width(one.stone) + outer_width(other.stone) + scalar::sqrt(formula::dot(between, between)) +
            one.stone.core_sphere_radius + other.stone.core_sphere_radius;
  }
};

/// One stone of a pair, seen along a normal.
template <class T>
struct PairSide {
  SeenNormal<T> seen;
  bool cap;
};

template <class T>
struct PairPoint {
  Vec3<T> n = Vec3<T>::Zero();
  T g = -std::numeric_limits<T>::infinity();
  Vec3<T> w = Vec3<T>::Zero();
  T slope = std::numeric_limits<T>::infinity();  // length of the part of w across n
  PairSide<T> first, second;
};

/// Takes the support point of a core off w: (…)(n − m u) along the radial part, (…) u along the axis.
template <Ordered T>
void take_core_support(const Placed<T>& placed, const Vec3<T>& n, PairSide<T>& side, T& x, T& y, T& z) {
  const Stone<T>& stone = placed.stone;
  side.seen = see<T>(placed.u_W, n);
  const Direction<T>& seen = side.seen.direction;
  const Vec3<T>& radial = side.seen.radial_part;
  side.cap = meets_cap(stone, seen);
  T across, along;
  if (side.cap) {
    const T height = formula::cap_support_height(stone, seen.axial, seen.radial_square);
    across = stone.core_sphere_radius;
    along = scalar::signed_as(height, side.seen.signed_axial) - stone.bevel_minor_radius * side.seen.signed_axial;
  } else {
    across = stone.bevel_major_radius / seen.radial;
    along = T(0);
  }
  x = x - (across * radial.x() + along * placed.u_W.x());
  y = y - (across * radial.y() + along * placed.u_W.y());
  z = z - (across * radial.z() + along * placed.u_W.z());
}

template <Ordered T>
void measure_slope(PairPoint<T>& at) {
  const Vec3<T> along = formula::plus(at.w, T(-at.g), at.n);
  at.slope = scalar::sqrt(formula::dot(along, along));
}

/// Fills in what a pair looks like along the unit vector `at.n`, but for the slope.
template <Ordered T>
void meet_along(const Pair<T>& pair, PairPoint<T>& at) {
  const Vec3<T>& n = at.n;
  T x = pair.between.x(), y = pair.between.y(), z = pair.between.z();
  take_core_support(pair.first, n, at.first, x, y, z);
  take_core_support(pair.second, n, at.second, x, y, z);
  at.w = {x, y, z};
  at.g = x * n.x() + y * n.y() + z * n.z();
}

/// The same, and the slope.
template <Ordered T>
void look_along(const Pair<T>& pair, PairPoint<T>& at) {
  meet_along(pair, at);
  measure_slope(at);
}

/// Takes the unit normal n instead of `best` if it separates more.
template <Ordered T>
void raise(const Pair<T>& pair, const Vec3<T>& n, PairPoint<T>& best) {
  PairPoint<T> at;
  at.n = n;
  meet_along(pair, at);
  if (best.g < at.g) {
    best = at;
  }
}

/// Newton's step (H₁ + H₂ + g) δ = w across n: H = R on a cap; on the rim r₁/n_r along t = n × u/n_r, and none across it.
/// Eigenvalues that are not positive are turned over, so that it climbs from a saddle too; no longer than 1.
template <Ordered T>
[[nodiscard]] Vec3<T> newton_step(const Pair<T>& pair, const PairPoint<T>& at) {
  T all = at.g;  // what acts in every direction
  const PairSide<T>* rims[2] = {};
  const Placed<T>* stones[2] = {};
  int count = 0;
  for (int i = 0; i < 2; ++i) {
    const PairSide<T>& side = i == 0 ? at.first : at.second;
    const Placed<T>& placed = i == 0 ? pair.first : pair.second;
    if (side.cap) {
      all += placed.stone.core_sphere_radius;
    } else {
      rims[count] = &side;
      stones[count++] = &placed;
    }
  }
  if (count == 0) {
    const Vec3<T> across = formula::plus(at.w, T(-at.g), at.n);
    const T length = T(0) < all ? T(1) / all : T(1) / at.slope;
    return {T(length * across.x()), T(length * across.y()), T(length * across.z())};
  }
  // In the plane across n: e₁ = t of the first rim, e₂ = n × e₁.
  const T over = T(1) / rims[0]->seen.direction.radial;
  const Vec3<T> t = formula::cross(at.n, stones[0]->u_W);
  const Vec3<T> e1 = formula::scaled(over, t);
  const Vec3<T> e2 = formula::cross(at.n, e1);
  T m11 = all + stones[0]->stone.bevel_major_radius * over, m12(0), m22 = all;
  if (count == 2) {
    // t₂ = n × u₂/n_r: its parts along e₁ and e₂ are those of −e₂ and e₁ along the radial part of n.
    const T over2 = T(1) / rims[1]->seen.direction.radial;
    const T t1 = -formula::dot(e2, stones[1]->u_W) * over2, t2 = formula::dot(e1, stones[1]->u_W) * over2;
    const T ring = stones[1]->stone.bevel_major_radius * over2;
    m11 += ring * scalar::sq(t1);
    m12 += ring * t1 * t2;
    m22 += ring * scalar::sq(t2);
  }
  const T w1 = formula::dot(at.w, e1), w2 = formula::dot(at.w, e2);
  const T determinant = m11 * m22 - scalar::sq(m12);
  T s1, s2;
  if (T(0) < m11 && T(0) < determinant) {
    s1 = (m22 * w1 - m12 * w2) / determinant;
    s2 = (m11 * w2 - m12 * w1) / determinant;
  } else {
    // Eigenvalues mean ± spread; the projector on the first is (1 + (M − mean)/spread)/2.
    const T mean = (m11 + m22) / T(2), half_difference = (m11 - m22) / T(2);
    const T spread = scalar::sqrt(T(scalar::sq(half_difference) + scalar::sq(m12)));
    const T high = scalar::abs(T(mean + spread)), low = scalar::abs(T(mean - spread));
    const T least = (high + low) / T(1000);
    const T over_high = T(1) / (high < least ? least : high), over_low = T(1) / (low < least ? least : low);
    const T c = T(0) < spread ? T(half_difference / spread) : T(1), o = T(0) < spread ? T(m12 / spread) : T(0);
    const T middle = (over_high + over_low) / T(2), difference = (over_high - over_low) / T(2);
    s1 = (middle + c * difference) * w1 + o * difference * w2;
    s2 = o * difference * w1 + (middle - c * difference) * w2;
  }
  const T length2 = scalar::sq(s1) + scalar::sq(s2);
  if (T(1) < length2) {
    const T shorter = T(1) / scalar::sqrt(length2);
    s1 = s1 * shorter;
    s2 = s2 * shorter;
  }
  return formula::combination(s1, e1, s2, e2);
}

/// Climbs from `at`, met along its normal, to a maximum of g. False if it does not get there.
template <Ordered T>
[[nodiscard]] bool climb(const Pair<T>& pair, PairPoint<T>& at) {
  // From a rim, whose points bend nothing, to where a cap of a thin stone turns with the steepness of its sphere.
  constexpr int most_steps = 60, most_halvings = 48;
  const T small = T(16) * std::numeric_limits<T>::epsilon() * pair.scale;
  PairPoint<T> other;
  PairPoint<T>*now = &at, *next = &other;
  measure_slope(at);
  bool stationary = at.slope <= small;
  for (int i = 0; i < most_steps && !stationary; ++i) {
    const Vec3<T> step = newton_step(pair, *now);
    T part(1);
    bool climbed = false;
    for (int k = 0; k < most_halvings && !climbed; ++k) {
      const T x = now->n.x() + part * step.x(), y = now->n.y() + part * step.y(), z = now->n.z() + part * step.z();
      const T over = T(1) / scalar::sqrt(T(scalar::sq(x) + scalar::sq(y) + scalar::sq(z)));
      next->n = {T(over * x), T(over * y), T(over * z)};
      look_along(pair, *next);
      // Upwards, or, where g no longer tells, to a smaller slope.
      climbed = now->g < next->g || (now->g - small <= next->g && next->slope < now->slope);
      part = part / T(2);
    }
    if (!climbed) {
      // What is left to gain is below what g can tell.
      stationary = now->slope * scalar::sqrt(formula::dot(step, step)) <= small;
      break;
    }
    std::swap(now, next);
    stationary = now->slope <= small;
  }
  if (now != &at) {
    at = *now;
  }
  return stationary;
}

}  // namespace goishi::detail
