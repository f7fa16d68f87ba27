#pragma once
/// \file
/// Golden section search.

#include <cmath>

namespace goishi::verify {

/// The least of f in [low, high] by golden section, f having one minimum there.
template <class T, class F>
[[nodiscard]] T golden(F&& f, T low, T high, T close) {
  const T ratio = (std::sqrt(T(5)) - 1) / 2;
  T a = high - ratio * (high - low), b = low + ratio * (high - low);
  T f_a = f(a), f_b = f(b);
  while (high - low > close) {
    if (f_a < f_b) {
      high = b, b = a, f_b = f_a, a = high - ratio * (high - low), f_a = f(a);
    } else {
      low = a, a = b, f_a = f_b, b = low + ratio * (high - low), f_b = f(b);
    }
  }
  return f_a < f_b ? a : b;
}

}  // namespace goishi::verify
