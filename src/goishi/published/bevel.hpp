#pragma once
/// \file
/// The talk's bevel, for comparison only.

#include <goishi/scalar.hpp>

namespace goishi {

template <class T>
struct PublishedBevel {
  T major_radius;  // r₁
  T minor_radius;  // r₂
};

/// The talk's CalculateBevel, but for its argument list, in the unit of r, d and b:
///
///     P_x = √(r² + y²), where √(r² − y²) is right;   r₁ = P_x d / y,   r₂ = r − √(d² + r₁²),   y = d + b/2
///
/// Its r₂ is negative: no ball touches both caps so (claim PUBLISHED-5). Use `make_stone`.
template <Elementary T>
[[nodiscard]] PublishedBevel<T> published_bevel(const T& r, const T& d, const T& b) {
  const T y = b / T(2) + d;
  const T px = scalar::sqrt(T(y * y + r * r));
  const T major_radius = px * d / y;
  return {.major_radius = major_radius, .minor_radius = T(r - scalar::sqrt(T(d * d + major_radius * major_radius)))};
}

}  // namespace goishi
