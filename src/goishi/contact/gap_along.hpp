#pragma once
/// \file
/// The gap of a stone in free flight along one normal, as a function of time: explicit, its second derivative bounded
/// below, so that its first root cannot be jumped over, and above, so that one that is near is known to be there.

#include <array>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/motion/flight_path.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <string_view>

namespace goishi {

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

/// One stone's part in the gap along a normal: −S(u(t) · n), u · n = A + B cos Ωt + C sin Ωt.
template <class T>
struct Wobble {
  const Stone<T>* stone;
  T A, B, C, rate;
};

namespace formula {

/// A = (k · u)(k · n), B = u · n − A, C = (k × u) · n.
/// Proof  derivations/flight_path.cpp, as of all below but the last two.
template <Field T>
[[nodiscard]] Wobble<T> wobble(const Stone<T>& stone, const FlightPath<T>& path, const Vec3<T>& n) {
  const T along = formula::dot(path.k_W, path.u_W) * formula::dot(path.k_W, n);
  return {&stone, along, T(formula::dot(path.u_W, n) - along), formula::dot(formula::cross(path.k_W, path.u_W), n),
          path.rate};
}

/// u · n where cos Ωt = c and sin Ωt = s, and its rate   [1/s].
template <Field T>
[[nodiscard]] inline T wobble_at(const Wobble<T>& part, const T& c, const T& s) {
  return part.A + part.B * c + part.C * s;
}
template <Field T>
[[nodiscard]] inline T wobble_rate(const Wobble<T>& part, const T& c, const T& s) {
  return part.rate * (part.C * c - part.B * s);
}

/// c₀ + c₁ t + c₂ t²/2, and its rate.
template <Field T>
[[nodiscard]] inline T parabola(const T& c0, const T& c1, const T& c2, const T& t) {
  return c0 + t * (c1 + t * c2 / T(2));
}
template <Field T>
[[nodiscard]] inline T parabola_rate(const T& c1, const T& c2, const T& t) {
  return c1 + t * c2;
}

/// H'² − 2 c H: what is under the root √ of the zeros of H + H' s + c s²/2.
template <Field T>
[[nodiscard]] inline T falling_square(const T& height, const T& rate, const T& c) {
  return scalar::sq(rate) - T(2) * c * height;
}

/// The first zero s > 0 of H + H' s + c s²/2 from H >= 0, where it falls, H' < 0, and where it bends down, c < 0.
template <Field T>
[[nodiscard]] inline T falling_zero(const T& height, const T& rate, const T& root) {
  return T(2) * height / (root - rate);
}
template <Field T>
[[nodiscard]] inline T bending_zero(const T& rate, const T& root, const T& c) {
  return (rate + root) / -c;
}

/// The most that a turning stone adds to |H''|, H its gap along a normal   [m/s²]: d Ω² √(B² + C²), where the axis
/// stands to the normal as u · n = A + B cos Ωt + C sin Ωt, and d is the greatest slope of the support, |S'|: the
/// sphere's offset.
/// Proof  derivations/support.cpp.
template <Elementary T>
[[nodiscard]] T greatest_bend(const T& slope, const T& rate, const T& B, const T& C) {
  return T(slope * scalar::sq(rate) * scalar::sqrt(T(scalar::sq(B) + scalar::sq(C))));
}

/// The most that it adds to H''   [m/s²]: d Ω² √(B² + C²) + Ω² (B² + C²) r₁/cos³ α, the second where the rim's support
/// bends most, at the joint.
/// Proof  derivations/support.cpp.
template <Elementary T>
[[nodiscard]] T greatest_lift(const Stone<T>& stone, const T& rate, const T& B, const T& C) {
  const T ring = stone.bevel_major_radius / (stone.joint_cosine * scalar::sq(stone.joint_cosine));
  return T(formula::greatest_bend(T(stone.sphere_offset), rate, B, C) +
           scalar::sq(rate) * (scalar::sq(B) + scalar::sq(C)) * ring);
}

}  // namespace formula

namespace detail {

/// The first time at which H + H' s + c s²/2 is 0, from H > 0, given H'² − 2 c H; infinity if it never is.
template <Ordered T>
[[nodiscard]] T falling_time_by(const T& square, const T& height, const T& rate, const T& c) {
  const T never = std::numeric_limits<T>::infinity();
  if (square < T(0)) {
    return never;
  }
  const T root = scalar::sqrt(square);
  if (rate < T(0)) {
    return formula::falling_zero(height, rate, root);
  }
  return c < T(0) ? formula::bending_zero(rate, root, c) : never;
}

/// The same of numbers whose squares are lost: in another unit of length.
template <Ordered T>
[[gnu::noinline]] [[nodiscard]] T falling_time_of_little(T height, T rate, T c) {
  if (height < T(1) && scalar::abs(rate) < T(1) && scalar::abs(c) < T(1)) {
    for (T* length : {&height, &rate, &c}) {
      *length = Squares<T>::larger * *length;
    }
  }
  return falling_time_by(formula::falling_square(height, rate, c), height, rate, c);
}

template <Ordered T>
[[gnu::always_inline]] [[nodiscard]] inline T falling_time(const T& height, const T& rate, const T& c) {
  const T square = formula::falling_square(height, rate, c);
  return scalar::abs(square) < Squares<T>::vanished ? falling_time_of_little(height, rate, c)
                                                    : falling_time_by(square, height, rate, c);
}

/// The gap along a fixed normal as a function of time: H(t) = c₀ + c₁ t + c₂ t²/2 − Σ S(u(t)).
template <Ordered T>
class GapAlong {
 public:
  GapAlong(const T& c0, const T& c1, const T& c2)
      : c0_(c0), c1_(c1), c2_(c2), bend_(scalar::max(T(-c2), T(0))), lift_(scalar::max(c2, T(0))) {}

  /// H'' >= −`bend`: each S is concave in u with |S'| <= d, so it adds at most d Ω² √(B² + C²). H'' <= `lift_`, too.
  void add(const Wobble<T>& part) {
    parts_[static_cast<std::size_t>(count_++)] = part;
    bend_ = bend_ + formula::greatest_bend(part.stone->sphere_offset, part.rate, part.B, part.C);
    lift_ = lift_ + formula::greatest_lift(*part.stone, part.rate, part.B, part.C);
    is_loose_ = is_loose_ || T(8) * part.stone->bevel_major_radius < part.stone->sphere_offset;
    const T swing = scalar::sqrt(T(scalar::sq(part.B) + scalar::sq(part.C)));
    const T least = scalar::abs(part.A) - swing;
    highest_ = highest_ + support_at(*part.stone, scalar::max(least, T(0)));
  }

  struct Value {
    T gap, rate;
    scalar::SineCosine<T> turn;  // of the last stone
  };

  [[nodiscard]] Value operator()(const T& t) const {
    Value value{formula::parabola(c0_, c1_, c2_, t), formula::parabola_rate(c1_, c2_, t), {T(0), T(1)}};
    for (int i = 0; i < count_; ++i) {
      const Wobble<T>& part = parts_[static_cast<std::size_t>(i)];
      value.turn = scalar::sincos(T(part.rate * t));
      const auto& [s, c] = value.turn;
      const T u = formula::wobble_at(part, c, s), u_rate = formula::wobble_rate(part, c, s);
      const Direction<T> n = seen(u);
      const Stone<T>& stone = *part.stone;
      const bool cap = meets_cap(stone, n);
      value.gap = value.gap -
                  (cap ? formula::cap_support(stone, n.axial, n.radial_square) : formula::rim_support(stone, n.radial));
      // −S' by u · n: d on the cap, on either side.
      const T slope = cap ? scalar::signed_as(stone.sphere_offset, u) : formula::rim_slope(stone, u, n.radial);
      value.rate = value.rate + slope * u_rate;
    }
    return value;
  }

  [[nodiscard]] const T& bend() const { return bend_; }

  /// Whether a root is less than ε/4 of the time behind a safe step from where H falls at that rate. After the step H is at
  /// most (M + M⁺) s²/2, M⁺ the lift, and falls at a rate of H' + 2 M⁺ s or faster until there.
  [[nodiscard]] bool ends_within(const T& step, const T& rate, const T& time) const {
    const T slowest = -(rate + T(2) * lift_ * step);
    return T(0) < slowest &&
           (bend_ + lift_) * scalar::sq(step) <= std::numeric_limits<T>::epsilon() / T(2) * time * slowest;
  }

  /// Whether `bend` says little of a thin stone that flies tilted: it has the caps' slope, d, and the rim's is far below.
  [[nodiscard]] bool is_loose() const { return is_loose_; }

  /// A bound of −H'' from t to t + s: as `bend`, by the slopes that the axis comes to in that time.
  [[nodiscard]] T bend_within(const T& t, const T& s) const {
    T bend = scalar::max(T(-c2_), T(0));
    for (int i = 0; i < count_; ++i) {
      const Wobble<T>& part = parts_[static_cast<std::size_t>(i)];
      const T angle = part.rate * t, swing = scalar::sqrt(T(scalar::sq(part.B) + scalar::sq(part.C)));
      const auto [sine, cosine] = scalar::sincos(angle);
      const T now = scalar::abs(formula::wobble_at(part, cosine, sine));
      const T later = now + swing * scalar::abs(part.rate) * s, most = scalar::abs(part.A) + swing;
      const Direction<T> n = seen(scalar::min(later, most));
      const T slope =
          meets_cap(*part.stone, n) ? part.stone->sphere_offset : formula::rim_slope(*part.stone, n.axial, n.radial);
      bend = bend + formula::greatest_bend(slope, part.rate, part.B, part.C);
    }
    return bend;
  }

  /// The next time, from t, at which the centres are so near that the bodies could touch, to `nothing`: t itself, or when
  /// the parabola comes down to the highest support that the wobbles reach; infinity when it does not.
  [[nodiscard]] T within_reach(const T& t, const T& nothing) const {
    const T over = formula::parabola(c0_, c1_, c2_, t) - (highest_ + nothing);
    return T(0) < over ? T(t + falling_time(over, formula::parabola_rate(c1_, c2_, t), c2_)) : t;
  }

 private:
  [[nodiscard]] static Direction<T> seen(const T& u) {
    const T m = scalar::abs(u);
    const T square = (T(1) - m) * (T(1) + m);
    const T safe = scalar::max(square, T(0));
    return {.axial = m, .radial = scalar::sqrt(safe), .radial_square = safe};
  }
  [[nodiscard]] static T support_at(const Stone<T>& stone, const T& u) { return support_value(stone, seen(u)); }

  T c0_, c1_, c2_;
  T bend_, lift_;
  T highest_ = T(0);
  bool is_loose_ = false;
  std::array<Wobble<T>, 2> parts_ = {};
  int count_ = 0;
};

/// The longest step that cannot jump over a root, from H >= 0: the first root of H + H' s − M s²/2, M the `bend`; from
/// H = 0 and H' > 0 the one after.
template <Ordered T>
[[nodiscard]] inline T safe_step(const T& gap, const T& rate, const T& bend) {
  return falling_time(gap, rate, T(-bend));
}

/// The same where the bend of a whole flight says little: doubled as often as the bend within that time allows, each time
/// counted as a step.
template <Ordered T>
[[gnu::noinline]] [[nodiscard]] T safe_step_within(const GapAlong<T>& gap, const T& t, const T& height, const T& rate,
                                                   int& steps) {
  constexpr int most_doublings = 60;
  T step = safe_step(height, rate, gap.bend());
  for (int i = 0; i < most_doublings; ++i, ++steps) {
    const T longer = T(2) * step, safe = safe_step(height, rate, gap.bend_within(t, longer));
    if (!(longer <= safe)) {
      return step < safe ? safe : step;
    }
    step = longer;
  }
  return step;
}

/// How the search for a root ended.
template <class T>
struct RootSearch {
  ImpactStatus status;
  T time;
  int steps;
  T seen_at;                     // when the gap was asked for last
  scalar::SineCosine<T> turned;  // how far the last stone had turned by then
};

/// What counts as nothing: of a gap [m] and of its rate [m/s], their round-off.
template <class T>
struct RoundOff {
  T gap, rate;

  /// Whether the bodies touch, and not because they are about to part.
  [[nodiscard]] bool touches(const typename GapAlong<T>::Value& now) const {
    return now.gap <= gap && now.rate <= rate;
  }
};

/// The first time, from `start`, at which the gap along one normal is zero and does not open: a root; the start, if the
/// bodies touch there; or where the gap comes down to round-off and opens again. Where it may overlap, `overlapping` if it
/// is below round-off at the start.
template <Ordered T>
[[nodiscard]] inline RootSearch<T> first_root(const GapAlong<T>& gap, const T& start, const T& horizon,
                                              const RoundOff<T>& nothing, int most_steps, bool may_overlap = false) {
  T t = start, touch = start;
  bool touched = false;
  typename GapAlong<T>::Value now{};
  for (int steps = 1; steps <= most_steps; ++steps) {
    const T sure = t;
    t = gap.within_reach(t, nothing.gap);
    if (!(t <= horizon) || !scalar::is_finite(t)) {
      return {touched ? ImpactStatus::hit : ImpactStatus::none, touched ? touch : horizon, steps, sure, now.turn};
    }
    now = gap(t);
    // A hit at a time; of a gap that T cannot hold, when it is so late, only that nothing touches until the step before.
    const auto hit = [&](const T& when) {
      const bool known = scalar::is_finite(now.gap);
      return RootSearch<T>{known ? ImpactStatus::hit : ImpactStatus::not_converged, known ? when : sure, steps, t,
                           now.turn};
    };
    if (may_overlap && now.gap < -nothing.gap && !(start < t)) {
      return {ImpactStatus::overlapping, t, steps, t, now.turn};
    }
    bool last = false;
    if (nothing.touches(now)) {
      if (!(T(0) < now.gap) || !(start < t)) {
        return hit(t);
      }
      // So fast that what is left of the way takes a time that is round-off.
      last = T(512) * std::numeric_limits<T>::epsilon() * now.rate < -nothing.rate;
      touched = true;
      touch = t;
    } else if (touched) {
      return hit(touch);
    }
    // On the surface and leaving it: the step is what it takes for the gap to come back at the earliest.
    const T height = scalar::max(now.gap, T(0));
    const T step =
        gap.is_loose() ? safe_step_within(gap, t, height, now.rate, steps) : safe_step(height, now.rate, gap.bend());
    const T next = t + step;
    if (last || (next <= horizon && gap.ends_within(step, now.rate, next))) {
      return hit(next);
    }
    if (!(t < next)) {
      return hit(t);
    }
    t = next;
  }
  return {ImpactStatus::not_converged, t, most_steps, t, now.turn};
}

/// |x| + |y| + |z|.
template <Ordered T>
[[nodiscard]] T size_of(const Vec3<T>& v) {
  return scalar::abs(T(v.x())) + scalar::abs(T(v.y())) + scalar::abs(T(v.z()));
}

/// Says what is wrong with a path that `require_path` does not take.
template <Ordered T>
[[noreturn]] void refuse_path(const Stone<T>& stone, const FlightPath<T>& path) {
  const auto require_square = [](const Vec3<T>& v, const char* argument) {
    require(size_of(v) < Squares<T>::most, argument, v.transpose(),
            "must be finite, and so must the square of 16 times it");
  };
  require_square(path.p_W, "position");
  require_square(path.v_W, "velocity");
  require_square(path.a_W, "acceleration");
  require(stone.sphere_radius < Squares<T>::most, "stone", stone.sphere_radius,
          "must have a sphere radius whose square is finite (the radius is shown)");
  throw_invalid("rate", path.rate, "must be finite, and so must 256 r² Ω⁴, r the radius of the stone's sphere");
}

/// Refuses a flight of numbers whose squares T cannot hold: from √max/16 on.
template <Ordered T>
inline void require_path(const Stone<T>& stone, const FlightPath<T>& path) {
  const T& most = Squares<T>::most;
  const T& r = stone.sphere_radius;
  const bool held = all(size_of(path.p_W) < most, size_of(path.v_W) < most, size_of(path.a_W) < most, r < most,
                        r * scalar::sq(path.rate) < most);
  if (!all(T(0) < stone.height, held, is_unit(path.u_W), is_unit(path.k_W))) [[unlikely]] {
    require_stone(stone);
    if (!held) {
      refuse_path(stone, path);
    }
    require_direction(path.u_W, "axis");
    require_direction(path.k_W, "precession axis");
  }
}

template <Ordered T>
[[nodiscard]] inline Placed<T> placed_at(const Stone<T>& stone, const FlightPath<T>& path, const T& t,
                                         const scalar::SineCosine<T>& turn) {
  return {
      .stone = stone, .p_W = formula::centre_at(path, t), .u_W = formula::reunited(formula::axis_turned(path, turn))};
}
template <Ordered T>
[[nodiscard]] Placed<T> placed_at(const Stone<T>& stone, const FlightPath<T>& path, const T& t) {
  return placed_at(stone, path, t, scalar::sincos(T(path.rate * t)));
}

/// The same at a root, mostly by the little that it has turned since it was seen.
template <Ordered T>
[[nodiscard]] inline Placed<T> placed_at(const Stone<T>& stone, const FlightPath<T>& path, const RootSearch<T>& root) {
  const T since = path.rate * (root.time - root.seen_at);
  const bool little = scalar::abs(since) * scalar::sq(since) < std::numeric_limits<T>::epsilon();
  return little ? placed_at(stone, path, root.time, formula::turned_on(root.turned, since))
                : placed_at(stone, path, root.time);
}

}  // namespace detail

}  // namespace goishi
