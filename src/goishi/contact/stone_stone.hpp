#pragma once
/// \file
/// Stone against stone, of any sizes: the greatest separation over all normals.
///
/// Where the cores are apart, the first stationary normal is the only one: closed forms are tried, then Newton's method.
/// Where they overlap there may be several, and all are gone through: those of a cap are closed forms, those of two rims
/// lie on a circle that is searched by bounds.

#include <goishi/contact/contact.hpp>
#include <goishi/contact/pair.hpp>
#include <goishi/contact/pair_closed.hpp>
#include <goishi/contact/rim_rim.hpp>
#include <limits>

namespace goishi {

namespace detail {

/// How far inside a core a point is, seen from the centre, times its height and its distance from the sphere's other side:
/// > 0 inside.
template <Ordered T>
[[nodiscard]] T inside_core(const Placed<T>& placed, const Vec3<T>& v) {
  const T signed_height = formula::dot(v, placed.u_W);
  const Vec3<T> radial = formula::plus(v, T(-signed_height), placed.u_W);
  const T height = scalar::abs(signed_height);
  return scalar::sq(placed.stone.bevel_major_radius) - formula::dot(radial, radial) -
         height * (height + T(2) * placed.stone.sphere_offset);
}

/// A point of both the discs in the rims of two cores, seen from the second stone's centre; false if there is none. On the
/// line in both their planes each disc has a chord: the middle of what the chords share.
template <Ordered T>
[[nodiscard]] bool find_disc_crossing(const Pair<T>& pair, Vec3<T>& x) {
  const Vec3<T>&u1 = pair.first.u_W, &u2 = pair.second.u_W;
  const Vec3<T> t = formula::cross(u1, u2);
  const T sine2 = formula::dot(t, t), height = formula::dot(u1, pair.between);
  x = formula::scaled(T(height / sine2), formula::plus(u1, T(-formula::dot(u1, u2)), u2));  // of the line, nearest to 0
  const T along = formula::dot(t, pair.between) / sine2;
  const Vec3<T> to_first = formula::minus(formula::plus(x, along, t), pair.between);
  const T half1 = scalar::sq(pair.first.stone.bevel_major_radius) - formula::dot(to_first, to_first);
  const T half2 = scalar::sq(pair.second.stone.bevel_major_radius) - formula::dot(x, x);
  if (!(T(0) < half1 && T(0) < half2)) {
    return false;
  }
  const T sine = scalar::sqrt(sine2);  // squares of chords may overflow
  const T chord1 = scalar::sqrt(half1) / sine, chord2 = scalar::sqrt(half2) / sine;
  const T low = along - chord1 < -chord2 ? T(-chord2) : T(along - chord1);
  const T high = along + chord1 < chord2 ? T(along + chord1) : chord2;
  x = formula::plus(x, T((low + high) / T(2)), t);
  return low < high;
}

/// Whether the cores overlap for sure: the point of one that is met along a normal is inside the other, or the middle of the
/// two inside both; or a point of both their discs is inside both; or a point of one's rim is in the other.
template <Ordered T>
[[nodiscard]] bool surely_overlap(const Pair<T>& pair, const PairPoint<T>& at) {
  const Placed<T>&first = pair.first, &second = pair.second;
  const T sure = T(64) * std::numeric_limits<T>::epsilon() * scalar::sq(pair.scale);
  // Of points seen from the second stone's centre.
  const auto in_first = [&](const Vec3<T>& x) { return sure < inside_core(first, formula::minus(x, pair.between)); };
  const auto in_second = [&](const Vec3<T>& x) { return sure < inside_core(second, x); };
  const Vec3<T> met = formula::plus(support_point(second.stone, second.u_W, at.second.seen).x_W,
                                    T(-second.stone.bevel_minor_radius), at.n);
  Vec3<T> x;
  const auto in_both = [&](const Vec3<T>& y) { return in_first(y) && in_second(y); };
  if (in_first(met) || in_second(formula::plus(met, at.w)) || in_both(formula::plus(met, T(T(1) / T(2)), at.w)) ||
      (find_disc_crossing(pair, x) && in_both(x))) {
    return true;
  }
  const auto enters = [](const Placed<T>& rim, const auto& in_other, const Vec3<T>& centre) {
    constexpr int points = 24;
    const T step = T(2) * scalar::pi<T>() / T(points);
    const auto [s, c] = scalar::sincos(step);
    Vec3<T> out = across(rim.u_W);
    bool inside = false;
    for (int i = 0; i < points && !inside; ++i) {
      inside = in_other(formula::plus(centre, rim.stone.bevel_major_radius, out));
      out = formula::combination(c, out, s, formula::cross(rim.u_W, out));
    }
    return inside;
  };
  return enters(first, in_second, pair.between) || enters(second, in_first, Vec3<T>(Vec3<T>::Zero()));
}

/// Finds the normal that separates most; false if it may be another.
template <Ordered T>
[[nodiscard]] bool find_maximum(const Pair<T>& pair, PairPoint<T>& best, bool& certified) {
  Vec3<T> along;
  const bool closed = find_apart(pair, along);
  if (!find_unit(along, best.n) && !find_unit(pair.between, best.n)) {
    best.n = pair.first.u_W;
  }
  meet_along(pair, best);
  bool stationary = closed || climb(pair, best);
  // Primal and dual: no normal separates more than the distance of the two core points that are met along this one.
  const T unit = std::numeric_limits<T>::epsilon() * pair.scale, tolerance = T(256) * unit;
  const auto distance = [&] { return scalar::sqrt(formula::dot(best.w, best.w)); };
  // Where cores all but touch, round-off leaves little of the direction between them: other closed forms may separate more.
  T farthest = distance();
  if (!(farthest - best.g <= T(4) * unit)) {
    try_caps(pair, best);
    stationary = climb(pair, best);
    farthest = distance();
  }
  certified = farthest - best.g <= tolerance;
  if (!certified && !(T(0) < best.g)) {
    // Of cores that are apart, a climb may have ended on a lower hill.
    const bool overlap = surely_overlap(pair, best);
    RimSearch<T> rims(pair, best);
    certified = overlap || T(0) < best.g || rims.run_apart(farthest);
    if (!(T(0) < best.g)) {
      certified = rims.run() && certified;
    }
    stationary = climb(pair, best);
    const bool tight = distance() - best.g <= tolerance;
    certified = tight || (certified && !(T(0) < best.g));
  }
  return stationary || certified;
}

/// Inlined where it is called, or the rescaled case would slow the usual one down.
template <Ordered T>
[[gnu::always_inline]] [[nodiscard]] inline Separation<T> separation(const Pair<T>& pair) {
  const Placed<T>&first = pair.first, &second = pair.second;
  PairPoint<T> best;
  bool certified = false;
  const bool converged = find_maximum(pair, best, certified);
  const Vec3<T>& n = best.n;
  const SupportPoint<T> on_first = support_point(first.stone, first.u_W, best.first.seen);
  const SupportPoint<T> on_second = support_point(second.stone, second.u_W, best.second.seen);
  Separation<T> result;
  // Not by the points that are met: those of thin stones have round-off of their spheres.
  result.gap = formula::dot(pair.between, n) - support_value(first.stone, best.first.seen.direction) -
               support_value(second.stone, best.second.seen.direction);
  result.status = !converged          ? SeparationStatus::not_converged
                  : result.gap < T(0) ? SeparationStatus::overlapping
                                      : SeparationStatus::separated;
  result.n_W = n;
  result.p_stone = formula::minus(first.p_W, on_first.x_W);
  result.p_other = formula::plus(second.p_W, on_second.x_W);
  result.feature = on_first.feature == Feature::upper_cap   ? Feature::lower_cap
                   : on_first.feature == Feature::lower_cap ? Feature::upper_cap
                                                            : Feature::rim;
  result.other_feature = OtherFeature::stone;
  result.certified = certified;
  return result;
}

/// The sizes of pairs whose rims may be searched. A rim of a core that all but is a point is round-off of the size, and the
/// search tells what round-off leaves of such a rim: the fourth power of ε times the square of the size is a normal number.
template <class T>
struct PairSizes {
  static constexpr int high = std::numeric_limits<T>::max_exponent, low = std::numeric_limits<T>::min_exponent;
  static inline const T least = two_to<T>(low / 2 + 2 * std::numeric_limits<T>::digits);
  // Next to the axis a rim bends by its radius over round-off of 1, and two such bends are multiplied.
  static inline const T most = two_to<T>(high / 2 - 4 - std::numeric_limits<T>::digits), far = two_to<T>(high / 2);
  static inline const T larger = far, smaller = two_to<T>(-(high / 8 * 3));

  [[nodiscard]] static bool hold(const T& size) { return least < size && size < most; }
  [[nodiscard]] static T factor(const T& size) {
    return size < T(1) ? larger : size < far ? smaller : Squares<T>::smaller;
  }
};

/// The same, seen from the second stone in a world of another size.
template <Ordered T>
[[gnu::noinline]] [[nodiscard]] Separation<T> separation_rescaled(const Pair<T>& pair) {
  const Placed<T>&first = pair.first, &second = pair.second;
  const T factor = PairSizes<T>::factor(pair.scale);
  const Stone<T> one = scaled(factor, first.stone), two = scaled(factor, second.stone);
  const Vec3<T> between = factor * first.p_W - factor * second.p_W;
  return scaled_back(factor, second.p_W,
                     separation(Pair<T>({one, between, first.u_W}, {two, Vec3<T>(Vec3<T>::Zero()), second.u_W})));
}

template <Ordered T>
[[nodiscard]] Separation<T> separation(const Placed<T>& first, const Placed<T>& second) {
  const Pair<T> pair(first, second);
  return PairSizes<T>::hold(pair.scale) ? separation(pair) : separation_rescaled(pair);
}

/// The gap along a unit normal: no more than along the one that separates most.
template <Ordered T>
[[nodiscard]] T gap_along_normal(const Placed<T>& first, const Placed<T>& second, const Vec3<T>& n) {
  return formula::dot(formula::minus(first.p_W, second.p_W), n) -
         support_value(first.stone, see<T>(first.u_W, n).direction) -
         support_value(second.stone, see<T>(second.u_W, n).direction);
}

}  // namespace detail

/// Separation of two stones; n points from the second to the first.
///
/// Domain  finite poses with unit attitudes, else InvalidArgument. Coincident centres are ordinary; so are stones and
///         distances of any magnitude (claims DOMAIN-CONTACT-1, 2).
/// Certificate  `certified` in the result. Separated, or overlapping by no more than the bevels: the distance of the two
///         core points is the separation of the cores (primal = dual). Cores that overlap: every stationary normal was
///         looked at; not certified where that takes too many steps (rims that all but touch along their tangents), and the
///         gap is then a lower bound.
/// Error   gap within 2e-15 of the widths, the distance and the spheres' radii (claim CONTACT-4).
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Stone<T>& other,
                                       const Pose<T>& other_pose) {
  return detail::separation(detail::place(stone, pose), detail::place(other, other_pose));
}

}  // namespace goishi
