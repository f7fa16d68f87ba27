#pragma once
/// \file
/// Where along a step something that is watched changes its sign.

#include <cstddef>
#include <goishi/drop/settings.hpp>
#include <limits>

namespace goishi::detail {

/// What counts as zero there.
template <class T>
[[nodiscard]] constexpr T crossing_noise() {
  return scalar::max(T(1e-12), T(32) * std::numeric_limits<T>::epsilon());
}

/// Illinois on the share of a step: `old` is what is watched at its beginning, `now` what is at `share`, where the one of
/// index `which` is no longer positive; both are led to where that one is zero. `values_at(θ)` are they in between. From a
/// change of equations on it may be zero at first: some shorter way is to show it above `shown`, or it stays where it is.
template <Ordered T, class Values, class ValuesAt>
void find_crossing(const Values& old, std::size_t which, const T& shown, Values& now, T& share, ValuesAt&& values_at) {
  constexpr int most_steps = 60;
  const T small = crossing_noise<T>();
  T low(0), high = share, low_value = old[which], high_value = now[which];
  for (int i = 0; i < most_steps && !(shown < low_value); ++i) {
    const T middle = high / T(2);
    const Values then = values_at(middle);
    if (shown < then[which]) {
      low = middle;
      low_value = then[which];
    } else {
      share = high = middle;
      now = then;
      high_value = then[which];
    }
  }
  if (!(shown < low_value)) {
    return;
  }
  int last = 0;
  for (int i = 0; i < most_steps; ++i) {
    if (-small < now[which] && now[which] < small) {
      break;
    }
    const T middle = low + (high - low) * (low_value / (low_value - high_value));
    if (!(low < middle && middle < high)) {
      break;
    }
    share = middle;
    now = values_at(middle);
    const T value = now[which];
    const int side = value < T(0) ? -1 : 1;
    (side < 0 ? high : low) = middle;
    (side < 0 ? high_value : low_value) = value;
    if (side == last) {
      (side < 0 ? low_value : high_value) = (side < 0 ? low_value : high_value) / T(2);
    }
    last = side;
  }
}

}  // namespace goishi::detail
