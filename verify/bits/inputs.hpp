#pragma once
/// \file
/// Inputs by whole numbers and powers of two alone, so that they are the same everywhere, and results as numbers.

#include <cstdint>
#include <goishi/impact/body.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/shape/stone.hpp>

#include "verify/bits/kinds.hpp"

namespace goishi::verify::bits {

/// xorshift64 (Marsaglia 2003). Never two calls in one list of arguments: compilers evaluate them in different order.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15U + 1) {}

  /// In [low, high).
  template <class T = double>
  [[nodiscard]] T between(double low, double high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<T>(low + (high - low) * (static_cast<double>(state_ >> 11) * 0x1p-53));
  }
  [[nodiscard]] int below(int n) { return static_cast<int>(between(0, n)); }

  template <class T>
  [[nodiscard]] Vec3<T> vector(double size) {
    Vec3<T> v;
    for (int i = 0; i < 3; ++i) {
      v[i] = between<T>(-size, size);
    }
    return v;
  }
  /// Unit, to the library's own rounding.
  template <class T>
  [[nodiscard]] Vec3<T> direction() {
    const Vec3<T> v = vector<T>(1);
    return formula::scaled(T(T(1) / scalar::sqrt(formula::dot(v, v))), v);
  }
  template <class T>
  [[nodiscard]] Quat<T> attitude() {
    const Vec3<T> n = direction<T>();
    const auto [s, c] = scalar::sincos(between<T>(-3, 3));
    return Quat<T>(c, T(s * n.x()), T(s * n.y()), T(s * n.z()));
  }
  template <class T>
  [[nodiscard]] Pose<T> pose(double size) {
    const Vec3<T> p = vector<T>(size);
    return {.p_WB = p, .q_WB = attitude<T>()};
  }
  /// Sharp, bevelled or measured; thin, ordinary or a ball.
  template <class T>
  [[nodiscard]] Stone<T> stone() {
    const T w = between<T>(0.02, 0.024), share = between<T>(0.01, 1), band = between<T>(0.001, 0.9);
    const int kind = below(8);
    const T h = kind == 7 ? w : T(w * share);
    return kind < 3   ? make_stone<T>(w, h)
           : kind < 6 ? make_stone<T>(w, h, T(h * band))
                      : make_measured_stone<T>(w, h, T(h * band));
  }
  template <class T>
  [[nodiscard]] State<T> state(const Moments<T>& moments) {
    const Pose<T> at = pose<T>(0.3);
    const Vec3<T> v = vector<T>(2), w = vector<T>(40);
    return {.p_WB = at.p_WB, .q_WB = at.q_WB, .v_WB = v, .L_W = formula::scaled(moments.axial, w)};
  }

 private:
  std::uint64_t state_;
};

template <class T>
void add(Hash& hash, const Vec3<T>& v) {
  hash.add(v.x());
  hash.add(v.y());
  hash.add(v.z());
}
template <class T>
void add(Hash& hash, const Mat3<T>& m) {
  for (int i = 0; i < 9; ++i) {
    hash.add(m(i / 3, i % 3));
  }
}
template <class T>
void add(Hash& hash, const Quat<T>& q) {
  hash.add(q.w());
  hash.add(q.x());
  hash.add(q.y());
  hash.add(q.z());
}
template <class T>
void add(Hash& hash, const State<T>& state) {
  add(hash, state.p_WB);
  add(hash, state.q_WB);
  add(hash, state.v_WB);
  add(hash, state.L_W);
}

}  // namespace goishi::verify::bits
