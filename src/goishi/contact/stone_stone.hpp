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

/// Finds the normal that separates most.
template <Ordered T>
[[nodiscard]] SeparationStatus find_maximum(const Pair<T>& pair, PairPoint<T>& best, bool& certified) {
  Vec3<T> along;
  const bool closed = find_apart(pair, along);
  T size2 = formula::dot(along, along);
  if (!(T(0) < size2)) {
    along = pair.between;
    size2 = formula::dot(along, along);
  }
  if (T(0) < size2) {
    const T over = T(1) / scalar::sqrt(size2);
    best.n = {T(over * along.x()), T(over * along.y()), T(over * along.z())};
  } else {
    best.n = pair.first.u_W;
  }
  look_along(pair, best);
  bool stationary = closed || climb(pair, best);
  if (T(0) < best.g) {
    // Primal and dual: the distance of the two core points is not less than the separation, nor more.
    const T tolerance = T(256) * std::numeric_limits<T>::epsilon() * pair.scale;
    certified = scalar::sqrt(formula::dot(best.w, best.w)) - best.g <= tolerance;
  } else {
    try_caps(pair, best);
    certified = RimSearch<T>(pair, best).run();
    stationary = climb(pair, best);
  }
  const T gap = best.g - (pair.first.stone.bevel_minor_radius + pair.second.stone.bevel_minor_radius);
  return !stationary && !certified ? SeparationStatus::not_converged
         : gap < T(0)              ? SeparationStatus::overlapping
                                   : SeparationStatus::separated;
}

template <Ordered T>
[[nodiscard]] Separation<T> separation(const Pair<T>& pair) {
  const Placed<T>&first = pair.first, &second = pair.second;
  PairPoint<T> best;
  Separation<T> result;
  result.status = find_maximum(pair, best, result.certified);
  const Vec3<T>& n = best.n;
  const SupportPoint<T> on_first = support_point(first.stone, first.u_W, best.first.seen);
  const SupportPoint<T> on_second = support_point(second.stone, second.u_W, best.second.seen);
  result.gap = best.g - (first.stone.bevel_minor_radius + second.stone.bevel_minor_radius);
  result.n_W = n;
  result.p_stone = formula::minus(first.p_W, on_first.x_W);
  result.p_other = formula::plus(second.p_W, on_second.x_W);
  result.feature = on_first.feature == Feature::upper_cap   ? Feature::lower_cap
                   : on_first.feature == Feature::lower_cap ? Feature::upper_cap
                                                            : Feature::rim;
  result.other_feature = OtherFeature::stone;
  return result;
}

template <Ordered T>
[[nodiscard]] Separation<T> separation(const Placed<T>& first, const Placed<T>& second) {
  const Pair<T> pair(first, second);
  if (Squares<T>::hold(pair.scale)) [[likely]] {
    return separation(pair);
  }
  // Seen from the second stone, in a world of another size.
  const T factor = Squares<T>::factor(pair.scale);
  const Stone<T> one = scaled(factor, first.stone), two = scaled(factor, second.stone);
  const Vec3<T> between = factor * first.p_W - factor * second.p_W;
  return scaled_back(factor, second.p_W,
                     separation(Pair<T>({one, between, first.u_W}, {two, Vec3<T>(Vec3<T>::Zero()), second.u_W})));
}

}  // namespace detail

/// Separation of two stones; n points from the second to the first.
///
/// Domain  finite poses with unit attitudes, else InvalidArgument. Coincident centres are ordinary; so are stones and
///         distances of any magnitude (claim DOMAIN-CONTACT-3).
/// Certificate  `certified` in the result. Separated, or overlapping by no more than the bevels: the distance of the two
///         core points is the separation of the cores (primal = dual). Cores that overlap: every stationary normal was
///         looked at; not certified where that takes too many steps (rims that all but touch along their tangents), and the
///         gap is then a lower bound.
/// Error   gap within 1e-12 of the width (claim CONTACT-4).
template <Ordered T>
[[nodiscard]] Separation<T> separation(const Stone<T>& stone, const Pose<T>& pose, const Stone<T>& other,
                                       const Pose<T>& other_pose) {
  return detail::separation(detail::place(stone, pose), detail::place(other, other_pose));
}

}  // namespace goishi
