#pragma once
/// \file
/// The sharp biconvex lens: the intersection of two balls of radius r whose centres stand 2d apart on the axis.

#include <goishi/error.hpp>
#include <goishi/scalar.hpp>

namespace goishi {

namespace formula {

/// Radius of the two spheres   [m].
///
///     r = (w² + h²) / (4 h)
///
/// Domain  0 < h <= w.   Limits  h = w: w/2 (the ball).   h -> 0: ∞, as w²/(4h).
/// Error   all terms positive; claim SHAPE-1.   Proof  derivations/lens.cpp.
template <Field T>
[[nodiscard]] constexpr T sphere_radius(const T& width, const T& height) {
  return T((scalar::sq(width) + scalar::sq(height)) / (T(4) * height));
}

/// Distance of a sphere's centre from the plane of the rim   [m].
///
///     d = (w − h)(w + h) / (4 h)  =  r − h/2
///
/// Domain  0 < h <= w.   Limits  h = w: 0 (the ball).   h -> 0: ∞, as w²/(4h).
/// Error   the factored form keeps its digits near the ball, where r − h/2 cancels; claim SHAPE-1.
/// Proof   derivations/lens.cpp.
template <Field T>
[[nodiscard]] constexpr T sphere_offset(const T& width, const T& height) {
  return T((width - height) * (width + height) / (T(4) * height));
}

}  // namespace formula

namespace detail {

template <Ordered T>
void require_lens(const char* width_name, const T& width, const T& height) {
  require_length(width_name, width);
  require_length("height", height);
  require(!(width < height), "height", height, "must not exceed the ", width_name, " (", width, ")");
}

}  // namespace detail
}  // namespace goishi
