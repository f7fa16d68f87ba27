#pragma once
/// \file
/// One contact with Coulomb friction, solved exactly.

#include <goishi/impact/contact_matrix.hpp>
#include <limits>

namespace goishi {

namespace detail {

/// What friction sees of a contact once the normal velocity is taken to zero: in the contact's frame, z along the normal.
template <class T>
struct Tangential {
  T xx, xy, yy;  // S = W_tt − w wᵀ/W_nn
  T x, y;        // w/W_nn
};

}  // namespace detail

namespace formula {

/// S = W_tt − w wᵀ/W_nn and w/W_nn: what an impulse across the normal does to the velocity there, if one along the normal
/// keeps that along it.
/// Proof  derivations/scene.cpp.
template <Field T>
[[nodiscard]] inline detail::Tangential<T> tangential(const ContactMatrix<T>& W) {
  const T x = W.xz / W.zz, y = W.yz / W.zz;
  return {.xx = T(W.xx - W.xz * x), .xy = T(W.xy - W.xz * y), .yy = T(W.yy - W.yz * y), .x = x, .y = y};
}

/// p_n = −f_n/W_nn − (w/W_nn) · p_t, which takes the normal velocity to zero.
/// Proof  derivations/scene.cpp.
template <Field T>
[[nodiscard]] inline T closing_normal(const detail::Tangential<T>& S, const T& closing, const T& x, const T& y) {
  return closing - (S.x * x + S.y * y);
}

}  // namespace formula

namespace detail {

/// The impulse of a contact that, with none, has the velocity f: in its frame, z along the normal, out of the other body.
///
///     f_n >= 0:   p = 0                                     open
///     else        p = −W⁻¹ f, if |p_t| <= μ p_n             it sticks
///     else        (S + λ 1) p_t = −(f_t − w f_n/W_nn), λ > 0 with |p_t| = μ p_n: slip against friction
///
/// Domain  W positive definite.   Error  |p_t| = μ p_n within 1e-10 of itself, and the normal velocity is 0 to round-off.
template <Ordered T>
[[nodiscard]] Vec3<T> contact_impulse(const ContactMatrix<T>& W, const Tangential<T>& S, const T& friction,
                                      const Vec3<T>& f) {
  if (!(f.z() < T(0))) {
    return Vec3<T>(T(0), T(0), T(0));
  }
  const T closing = -f.z() / W.zz;
  const T bx = f.x() + S.x * W.zz * closing, by = f.y() + S.y * W.zz * closing;  // f_t − w f_n/W_nn
  const T floor = std::numeric_limits<T>::min();
  T x, y, normal, size;
  const auto at = [&](const T& lambda) {
    const T xx = S.xx + lambda, yy = S.yy + lambda;
    const T over = T(1) / (xx * yy - scalar::sq(S.xy));
    x = -over * (yy * bx - S.xy * by);
    y = -over * (xx * by - S.xy * bx);
    normal = formula::closing_normal(S, closing, x, y);
    size = scalar::sqrt(T(scalar::sq(x) + scalar::sq(y)));
  };
  at(T(0));
  if (!(friction * normal < size)) {
    return {x, y, normal};
  }
  if (!(T(0) < friction)) {
    return {T(0), T(0), closing};
  }
  const T b = scalar::sqrt(T(scalar::sq(bx) + scalar::sq(by)));
  const T w = W.zz * scalar::sqrt(T(scalar::sq(S.x) + scalar::sq(S.y)));
  T low(0), high = b * (W.zz + friction * w) / (friction * W.zz * closing), lambda(0);
  constexpr int most_steps = 60;
  const T small = scalar::max(T(1e-10), T(T(8) * std::numeric_limits<T>::epsilon()));
  for (int i = 0; i < most_steps; ++i) {
    const T excess = friction * normal - size;
    if (-small * size <= excess && excess <= small * size) {
      break;
    }
    (excess < T(0) ? low : high) = lambda;
    // Newton on μ p_n/|p_t| − 1, which is nearly straight.
    const T xx = S.xx + lambda, yy = S.yy + lambda;
    const T over = T(1) / (xx * yy - scalar::sq(S.xy));
    const T x_rate = -over * (yy * x - S.xy * y), y_rate = -over * (xx * y - S.xy * x);
    const T size_rate = (x * x_rate + y * y_rate) / (size + floor);
    const T normal_rate = -(S.x * x_rate + S.y * y_rate);
    const T slope = friction * (normal_rate * size - normal * size_rate);
    T next = lambda - excess * size / slope;
    if (!(low < next && next < high)) {
      next = (low + high) / T(2);
    }
    lambda = next;
    at(lambda);
  }
  return {x, y, normal};
}

}  // namespace detail
}  // namespace goishi
