#pragma once
/// \file
/// A stone in free flight as contact sees it, and the gap along one normal as a function of time: explicit, its second
/// derivative bounded below, so that its first root cannot be jumped over.

#include <array>
#include <goishi/contact/stone_plane.hpp>
#include <limits>
#include <string_view>

namespace goishi {

/// How a stone flies: its centre on a parabola, its symmetry axis precessing about a fixed direction.
///
///     p(t) = p + v t + a t²/2,   u(t) = (k·u) k + cos(Ω t) (u − (k·u) k) + sin(Ω t) k × u
template <class T>
struct FlightPath {
  Vec3<T> p_W = Vec3<T>::Constant(scalar::unset<T>());  // [m]
  Vec3<T> v_W = Vec3<T>::Constant(scalar::unset<T>());  // [m/s]
  Vec3<T> a_W = Vec3<T>::Constant(scalar::unset<T>());  // [m/s²]
  Vec3<T> u_W = Vec3<T>::Constant(scalar::unset<T>());  // unit, symmetry axis at t = 0
  Vec3<T> k_W = {T(0), T(0), T(1)};                     // unit, direction of the angular momentum
  T rate = T(0);                                        // Ω = |L|/I_t [rad/s]
};

enum class ImpactStatus {
  hit,
  none,         // no contact within the horizon
  overlapping,  // the bodies overlap at t = 0
  not_converged
};

[[nodiscard]] constexpr std::string_view to_string(ImpactStatus status) {
  constexpr std::string_view names[] = {"hit", "none", "overlapping", "not converged"};
  return names[static_cast<std::size_t>(status)];
}

namespace formula {

/// The most that a turning stone adds to |H''|, H its gap along a normal   [m/s²]: d Ω² √(B² + C²), where the axis stands
/// to the normal as u · n = A + B cos Ωt + C sin Ωt.   Proof  derivations/support.cpp.
template <Elementary T>
[[nodiscard]] T greatest_bend(const T& sphere_offset, const T& rate, const T& B, const T& C) {
  return T(sphere_offset * scalar::sq(rate) * scalar::sqrt(T(scalar::sq(B) + scalar::sq(C))));
}

}  // namespace formula

namespace detail {

template <Ordered T>
[[nodiscard]] Vec3<T> centre_at(const FlightPath<T>& path, const T& t) {
  return path.p_W + t * (path.v_W + t / T(2) * path.a_W);
}

template <Ordered T>
[[nodiscard]] Vec3<T> axis_at(const FlightPath<T>& path, const T& t) {
  const T angle = path.rate * t;
  const Vec3<T> along = path.k_W.dot(path.u_W) * path.k_W;
  return along + scalar::cos(angle) * (path.u_W - along) + scalar::sin(angle) * path.k_W.cross(path.u_W);
}

/// One stone's part in the gap along a normal: −S(u(t) · n), u · n = A + B cos Ωt + C sin Ωt.
template <class T>
struct Wobble {
  const Stone<T>* stone;
  T A, B, C, rate;
};

template <Ordered T>
[[nodiscard]] Wobble<T> wobble(const Stone<T>& stone, const FlightPath<T>& path, const Vec3<T>& n) {
  const T along = path.k_W.dot(path.u_W) * path.k_W.dot(n);
  return {&stone, along, path.u_W.dot(n) - along, path.k_W.cross(path.u_W).dot(n), path.rate};
}

template <Ordered T>
[[nodiscard]] T magnitude_of(const T& x) {
  return x < T(0) ? T(-x) : x;
}

/// The gap along a fixed normal as a function of time: H(t) = c₀ + c₁ t + c₂ t²/2 − Σ S(u(t)).
template <Ordered T>
class GapAlong {
 public:
  GapAlong(const T& c0, const T& c1, const T& c2) : c0_(c0), c1_(c1), c2_(c2) { bend_ = c2 < T(0) ? T(-c2) : T(0); }

  /// H'' >= −`bend`: each S is concave in u with |S'| <= d, so it adds at most d Ω² √(B² + C²).
  void add(const Wobble<T>& part) {
    parts_[static_cast<std::size_t>(count_++)] = part;
    const T swing = scalar::sqrt(T(scalar::sq(part.B) + scalar::sq(part.C)));
    bend_ = bend_ + formula::greatest_bend(part.stone->sphere_offset, part.rate, part.B, part.C);
    const T least = magnitude_of(part.A) - swing;
    highest_ = highest_ + support_at(*part.stone, least < T(0) ? T(0) : least);
  }

  struct Value {
    T gap, rate;
  };

  [[nodiscard]] Value operator()(const T& t) const {
    Value value{T(c0_ + t * (c1_ + t * c2_ / T(2))), T(c1_ + t * c2_)};
    for (int i = 0; i < count_; ++i) {
      const Wobble<T>& part = parts_[static_cast<std::size_t>(i)];
      const T angle = part.rate * t;
      const T c = scalar::cos(angle), s = scalar::sin(angle);
      const T u = part.A + part.B * c + part.C * s;
      const T u_rate = part.rate * (part.C * c - part.B * s);
      value.gap = value.gap - support_at(*part.stone, u);
      value.rate = value.rate - support_slope(*part.stone, u) * u_rate;
    }
    return value;
  }

  [[nodiscard]] const T& bend() const { return bend_; }

  /// The next time, from t, at which the centres are so near that the bodies could touch: t itself, or when the parabola
  /// comes down to the highest support that the wobbles reach; infinity when it does not.
  [[nodiscard]] T within_reach(const T& t) const {
    const T over = c0_ + t * (c1_ + t * c2_ / T(2)) - highest_;
    if (!(T(0) < over)) {
      return t;
    }
    const T rate = c1_ + t * c2_;
    const T root2 = scalar::sq(rate) - T(2) * c2_ * over;
    const T never = std::numeric_limits<T>::infinity();
    if (root2 < T(0)) {
      return never;
    }
    // over + rate s + c₂ s²/2 = 0, the first s > 0.
    const T root = scalar::sqrt(root2);
    if (rate < T(0)) {
      return t + T(2) * over / (root - rate);
    }
    return c2_ < T(0) ? T(t + (rate + root) / (-c2_)) : never;
  }

 private:
  [[nodiscard]] static Direction<T> seen(const T& u) {
    const T m = magnitude_of(u);
    const T square = (T(1) - m) * (T(1) + m);
    const T safe = square < T(0) ? T(0) : square;
    return {.axial = m, .radial = scalar::sqrt(safe), .radial_square = safe};
  }
  [[nodiscard]] static T support_at(const Stone<T>& stone, const T& u) { return support_value(stone, seen(u)); }
  [[nodiscard]] static T support_slope(const Stone<T>& stone, const T& u) {
    const Direction<T> n = seen(u);
    return meets_cap(stone, n) ? T(u < T(0) ? stone.sphere_offset : T(-stone.sphere_offset))
                               : T(-(stone.bevel_major_radius * u / n.radial));
  }

  T c0_, c1_, c2_;
  T bend_ = T(0), highest_ = T(0);
  std::array<Wobble<T>, 2> parts_ = {};
  int count_ = 0;
};

/// The longest step that cannot jump over a root, from H >= 0: the root of H + H' s − M s²/2.
template <Ordered T>
[[nodiscard]] T safe_step(const T& gap, const T& rate, const T& bend) {
  if (!(T(0) < bend)) {
    return rate < T(0) ? T(gap / -rate) : std::numeric_limits<T>::infinity();
  }
  const T root = scalar::sqrt(T(scalar::sq(rate) + T(2) * bend * gap));
  if (rate < T(0)) {
    return T(2) * gap / (root - rate);
  }
  return (rate + root) / bend;
}

/// How the search for a root ended.
template <class T>
struct RootSearch {
  ImpactStatus status;
  T time;
  int steps;
};

/// The first root of the gap along one normal, from `start`, where it is not negative.
template <Ordered T>
[[nodiscard]] RootSearch<T> first_root(const GapAlong<T>& gap, const T& start, const T& horizon) {
  constexpr int most_steps = 1000000;
  T t = start;
  for (int steps = 1; steps <= most_steps; ++steps) {
    t = gap.within_reach(t);
    if (!(t <= horizon) || !scalar::is_finite(t)) {
      return {ImpactStatus::none, horizon, steps};
    }
    const typename GapAlong<T>::Value now = gap(t);
    const bool touching = !(T(0) < now.gap);
    // On the surface and leaving it: the step is what it takes for the gap to come back at the earliest.
    if (touching && now.rate <= T(0)) {
      return {ImpactStatus::hit, t, steps};
    }
    const T step = safe_step(touching ? T(0) : now.gap, now.rate, gap.bend());
    const T next = t + step;
    if (!(t < next)) {
      return {ImpactStatus::hit, t, steps};
    }
    t = next;
  }
  return {ImpactStatus::not_converged, t, most_steps};
}

template <Ordered T>
void require_path(const FlightPath<T>& path) {
  require_point(path.p_W, "position");
  require_point(path.v_W, "velocity");
  require_point(path.a_W, "acceleration");
  require_direction(path.u_W, "axis");
  require_direction(path.k_W, "precession axis");
  require(scalar::is_finite(path.rate), "rate", path.rate, "must be finite");
}

template <Ordered T>
[[nodiscard]] Placed<T> placed_at(const Stone<T>& stone, const FlightPath<T>& path, const T& t) {
  const Vec3<T> u = axis_at(path, t);
  return {.stone = stone, .p_W = centre_at(path, t), .u_W = u / u.norm()};
}

}  // namespace detail

}  // namespace goishi
