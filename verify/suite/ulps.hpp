#pragma once
/// \file
/// Differences: relative, and in units in the last place.

#include <cmath>
#include <limits>

namespace goishi::verify {

/// The gap between |value| and the next number away from zero, in T's own grid.
template <class T>
[[nodiscard]] T ulp_of(T value) {
  const T magnitude = std::fabs(value);
  return std::nextafter(magnitude, std::numeric_limits<T>::infinity()) - magnitude;
}

/// |computed/expected − 1|.
[[nodiscard]] inline double relative(double computed, double expected) {
  return std::fabs(computed / expected - 1.0);
}

/// |computed − exact| in ulps of `exact` as T rounds it. `exact` is a scalar of more digits that T converts to. NaN if
/// either is, or if `computed` is infinite where `exact` is not.
template <class T, class Exact>
[[nodiscard]] double ulps(T computed, const Exact& exact) {
  const T rounded = static_cast<T>(exact);
  if (!std::isfinite(computed) || !std::isfinite(rounded)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Exact difference = Exact(computed) - exact;
  return std::fabs(static_cast<double>(Exact(difference / Exact(ulp_of(rounded)))));
}

}  // namespace goishi::verify
