#pragma once
/// \file
/// The rims of two stones whose cores overlap: every normal at which the two could separate most.
///
/// At a maximum of g, g < 0, that both stones meet with their rims, −g is a *local minimum of the distance of the two rim
/// circles*, each point the near one of the other circle and inside its cylinder: the second derivative of that distance is
/// the determinant of H₁ + H₂ + g times what is positive. With c the circles' radii, k = c/n_r and β the angle between their
/// tangents, −g <= min(k) sin² β, and sin β = |n · (u₁ × u₂)|/(n_r₁ n_r₂) with n_r >= c/R on the rim. So one goes round the
/// first circle, its distance from the second as a function of one angle, and leaves out stretches of it by bounds:
/// the distance changes by c₁ per radian at most; the second derivative of its square is bounded above, so that a minimum
/// keeps away from a slope; where the third derivative leaves that second one a sign, there is no minimum or just one, which
/// Newton's method finds. Proof of the determinant: derivations/support.cpp.

#include <array>
#include <goishi/contact/pair.hpp>

namespace goishi {

namespace detail {

/// A point of the first circle, x = D + c₁ (a e + b f), seen from the second stone's centre.
template <class T>
struct RimPoint {
  T a, b;
  T rho, distance;  // from the second's axis; from its circle
  T slope;          // of half the distance's square, by the angle
  T bend;           // its second derivative
};

}  // namespace detail

namespace formula {

/// The point at the angle (a, b) = (cos φ, sin φ) of the circle `centre` + a `cosine` + b `sine`, its radius c₁, and
/// its distance from the circle of the radius c₂ about z: x' = v and x'' = −out, so that ρ' = rise/ρ and ρ'' = (swirl²
/// − inward)/ρ.
/// Domain  not on z.   Proof  derivations/edges.cpp.
template <Elementary T>
[[nodiscard]] inline detail::RimPoint<T> rim_point(const Vec3<T>& centre, const Vec3<T>& cosine, const Vec3<T>& sine,
                                                   const T& c1, const T& c2, const T& a, const T& b) {
  const Vec3<T> out = formula::combination(a, cosine, b, sine), v = formula::combination(T(-b), cosine, a, sine);
  const T x = centre.x() + out.x(), y = centre.y() + out.y(), z = centre.z() + out.z();
  const T rho = scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))), over = T(1) / rho;
  const T near = c2 * over, outward = rho - c2;
  const T rise = x * v.x() + y * v.y(), swirl = (x * v.y() - y * v.x()) * over;
  const T inward = x * out.x() + y * out.y();
  return {.a = a,
          .b = b,
          .rho = rho,
          .distance = scalar::sqrt(T(scalar::sq(outward) + scalar::sq(z))),
          .slope = T(rise * (T(1) - near) + z * v.z()),
          .bend = T(scalar::sq(c1) - inward - z * out.z() - near * (scalar::sq(swirl) - inward))};
}

}  // namespace formula

namespace detail {

/// A unit vector across another.
template <Ordered T>
[[nodiscard]] Vec3<T> across(const Vec3<T>& u) {
  const bool steep = scalar::sq(u.x()) < scalar::sq(u.z());
  const Vec3<T> e = steep ? Vec3<T>(T(0), u.z(), T(-u.y())) : Vec3<T>(u.y(), T(-u.x()), T(0));
  return formula::scaled(T(T(1) / scalar::sqrt(formula::dot(e, e))), e);
}

template <Ordered T>
class RimSearch {
 public:
  RimSearch(const Pair<T>& pair, PairPoint<T>& best)
      : pair_(pair),
        best_(best),
        c1_(pair.first.stone.bevel_major_radius),
        c2_(pair.second.stone.bevel_major_radius),
        swing_(c1_ * scalar::sqrt(formula::dot(pair.between, pair.between))),
        by_square_(T(1) / scalar::sq(c1_)) {
    const Vec3<T>&u = pair.first.u_W, &z = pair.second.u_W;
    e_ = across(u);
    f_ = formula::cross(u, e_);
    const Vec3<T> x = across(z), y = formula::cross(z, x);
    const auto seen = [&](const T& s, const Vec3<T>& v) {
      return Vec3<T>(T(s * formula::dot(x, v)), T(s * formula::dot(y, v)), T(s * formula::dot(z, v)));
    };
    centre_ = seen(T(1), pair.between);
    cosine_ = seen(c1_, e_);
    sine_ = seen(c1_, f_);
    const Vec3<T> both = formula::cross(u, z);
    const T &R1 = pair.first.stone.core_sphere_radius, &R2 = pair.second.stone.core_sphere_radius;
    deepest_ = (R1 < R2 ? R1 : R2) * formula::dot(both, both) * scalar::sq(T(R1 * R2 / (c1_ * c2_)));
    small_ = T(16) * std::numeric_limits<T>::epsilon() * pair.scale;
  }

  /// Goes round; `best` rises to the greatest that is found. False if the bounds left something out.
  [[nodiscard]] bool run() {
    // Balls have no rims, and no two rims hold each other whose axes are parallel.
    const bool rims = T(0) < pair_.first.stone.sphere_offset && T(0) < pair_.second.stone.sphere_offset;
    if (!rims || deepest_ <= small_) {
      return true;
    }
    apart_ = false;
    return go_round();
  }

  /// The same of cores that may be apart, no farther than `limit`: at a local minimum of the circles' distance the normal
  /// then points the other way.
  [[nodiscard]] bool run_apart(const T& limit) {
    apart_ = true;
    apart_limit_ = limit;
    return go_round();
  }

 private:
  using RimPoint = detail::RimPoint<T>;

  [[nodiscard]] Vec3<T> place_of(const T& a, const T& b) const {
    return formula::plus(pair_.between, c1_, formula::combination(a, e_, b, f_));
  }

  [[nodiscard]] RimPoint at(const T& a, const T& b) const {
    return formula::rim_point(centre_, cosine_, sine_, c1_, c2_, a, b);
  }

  [[nodiscard]] bool go_round() {
    constexpr int parts = 16;
    const T length = T(2) * scalar::pi<T>() / T(parts);
    const auto [s, c] = scalar::sincos(length);
    const RimPoint start = at(T(1), T(0));
    if (!(T(0) < c1_)) {
      take(start);  // a core that is a point
      return true;
    }
    RimPoint low = start;
    for (int i = 1; i <= parts; ++i) {
      const RimPoint high = i == parts ? start : at(T(c * low.a - s * low.b), T(s * low.a + c * low.b));
      search(low, high, length, 0);
      low = high;
    }
    return complete_;
  }

  void search(const RimPoint& low, const RimPoint& high, const T& length, int depth) {
    const T limit = -best_.g < deepest_ ? T(-best_.g) : deepest_;
    const T reach = c1_ * length;
    if (!apart_ &&
        (T(2) * (limit - small_) <= low.distance + high.distance - reach || T(2) * c2_ <= low.rho + high.rho - reach)) {
      return;
    }
    // A rise of the slope takes its time.
    const T steepest = swing_ + c1_ * c2_;
    const T earliest = low.slope < T(0) ? T(-low.slope / steepest) : T(0);
    const T latest = T(0) < high.slope ? T(length - high.slope / steepest) : length;
    if (latest < earliest) {
      return;
    }
    const T least_rho = (low.rho + high.rho - reach) / T(2);
    if (T(0) < least_rho) {
      // By c₁²: next to the axis the ratio is large, and its square would leave the range of T with those of lengths.
      const T ratio = c1_ / least_rho;
      const T change = (swing_ * by_square_ + c2_ / c1_ * (T(1) + ratio * (T(5) + T(3) * ratio))) * length;
      const T bends = (low.bend + high.bend) * by_square_, slopes = (low.slope + high.slope) * by_square_;
      if (bends < -change) {
        return;  // no minimum where it bends down
      }
      if (change < bends) {
        if (!(T(0) < low.slope) && !(high.slope < T(0))) {
          take(minimum(low, high));
        }
        return;
      }
      const T most_bend = change + scalar::abs(bends);  // twice
      if (most_bend * length < T(2) * scalar::abs(slopes)) {
        return;  // the slope has one sign
      }
    }
    constexpr int deepest_level = 24, most = 3000;
    if (depth == deepest_level || most < count_) {
      complete_ = false;
      return;
    }
    ++count_;
    const RimPoint middle = half_way(low, high);
    search(low, middle, T(length / T(2)), depth + 1);
    search(middle, high, T(length / T(2)), depth + 1);
  }

  [[nodiscard]] RimPoint half_way(const RimPoint& low, const RimPoint& high) const {
    const T a = low.a + high.a, b = low.b + high.b;
    const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
    return at(T(over * a), T(over * b));
  }

  /// The zero of the slope where it only rises.
  [[nodiscard]] RimPoint minimum(RimPoint low, RimPoint high) const {
    constexpr int most_steps = 60;
    RimPoint now = half_way(low, high);
    for (int i = 0; i < most_steps; ++i) {
      (now.slope < T(0) ? low : high) = now;
      const T step = -now.slope / now.bend;
      const T a = now.a - step * now.b, b = now.b + step * now.a;
      const bool inside = T(0) < low.a * b - low.b * a && T(0) < a * high.b - b * high.a;
      const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
      now = inside ? at(T(over * a), T(over * b)) : half_way(low, high);
      if (scalar::sq(step) <= T(4096) * std::numeric_limits<T>::epsilon()) {
        break;
      }
    }
    return now;
  }

  /// The normal from a point of the first circle to the nearest of the second.
  void take(const RimPoint& point) {
    const Vec3<T> x = place_of(point.a, point.b);
    const Vec3<T>& u = pair_.second.u_W;
    const Vec3<T> radial = formula::plus(x, T(-formula::dot(u, x)), u);
    const Vec3<T> w = formula::plus(x, T(-(c2_ / point.rho)), radial);
    Vec3<T> n;
    if (find_unit(w, n)) {
      raise(pair_, formula::scaled(apart_ ? T(1) : T(-1), n), best_);
    }
  }

  const Pair<T>& pair_;
  PairPoint<T>& best_;
  T c1_, c2_;
  T swing_;      // c₁ |D|
  T by_square_;  // 1/c₁²
  Vec3<T> e_, f_;
  Vec3<T> centre_, cosine_, sine_;  // the first circle D + a c₁ e + b c₁ f, by the second stone's axes
  T deepest_;
  T small_, apart_limit_ = T(0);
  int count_ = 0;
  bool apart_ = false, complete_ = true;
};

}  // namespace detail
}  // namespace goishi
