#pragma once
/// \file
/// Whether a stone that is laid down stays there, and how firmly: the statics that end a drop, for whoever asks.

#include <array>
#include <cstddef>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/drop/run.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/drop/statics.hpp>
#include <limits>

namespace goishi {

/// How a stone that does not move is held. A share is the least part of what there is that would still hold it, with all
/// of the other: 0 where none is needed, above 1 where it moves, ∞ where no amount would do.
template <class T>
struct Hold {
  bool holds = false;
  int contacts = 0;                 // places that it touches: none, one or two
  T gap = scalar::unset<T>();       // [m] to the nearest
  T friction = scalar::unset<T>();  // share of μ; above 1 it slides
  T resistance =
      scalar::unset<T>();       // share of δ and κ, against rolling and turning on the spot; above 1 it rolls or tips
  T tilt = scalar::unset<T>();  // [rad] the least angle by which gravity may lean further, to any side, before it moves
};

namespace detail {

/// What asks statics about a stone again and again.
template <Ordered T>
class Holding {
 public:
  using Supports = std::array<Support<T>, 2>;

  Holding(const Stone<T>& stone, const DropSettings<T>& settings, const Supports& supports, std::size_t count)
      : g_(settings.gravity),
        strength_(scalar::sqrt(formula::dot(g_, g_))),
        body_(contact_body(stone, Moments<T>{T(1), T(1)}, filled(settings, stone, strength_), strength_)),
        usual_(body_),
        supports_(supports),
        count_(count) {}

  [[nodiscard]] bool holds() const { return is_held(body_, supports_, count_); }

  [[nodiscard]] T friction_share() {
    if (count_ == 1) {
      const Vec3<T> load = -g_, &n = supports_[0].n;
      const T normal = formula::dot(n, load);
      const Vec3<T> across = formula::plus(load, T(-normal), n);
      const T needed = scalar::sqrt(formula::dot(across, across));
      return !(T(0) < normal)                          ? infinity
             : needed <= round_off_share<T>() * normal ? T(0)
             : static_friction(body_) < infinity       ? T(needed / (normal * static_friction(body_)))
                                                       : T(0);
    }
    return least_share([&](const T& share) { body_.friction = T(0) < share ? T(share * usual_.friction) : T(0); });
  }

  [[nodiscard]] T resistance_share() {
    if (count_ == 1) {
      const T share = detail::resistance_share(body_, supports_[0], Vec3<T>(-g_));
      return T(0) < formula::dot(supports_[0].n, Vec3<T>(-g_)) ? share : infinity;
    }
    return least_share([&](const T& share) {
      body_.rolling_resistance = share * usual_.rolling_resistance;
      body_.pivot_radius = share * usual_.pivot_radius;
    });
  }

  /// What holds is a convex cone of loads: towards each side gravity leaves it once. The sides are looked through, and
  /// the neighbourhood of the nearest is narrowed down.
  [[nodiscard]] T tilt() {
    constexpr int sides = 48, narrowings = 40;
    const Vec3<T> down = g_ / strength_;
    const T x = down.x() < T(0) ? T(-down.x()) : down.x();
    const Vec3<T> other = x < T(0.5) ? Vec3<T>(T(1), T(0), T(0)) : Vec3<T>(T(0), T(1), T(0));
    const Vec3<T> a = formula::cross(down, other).normalized(), b = formula::cross(down, a);
    const auto lean = [&](const T& side, const T& angle) {
      const T s = scalar::sin(angle);
      body_.gravity =
          strength_ * (T(scalar::cos(angle)) * down + T(s * scalar::cos(side)) * a + T(s * scalar::sin(side)) * b);
      const bool held = holds();
      body_.gravity = g_;
      return held;
    };
    const auto angle_to = [&](const T& side, const T& most) {
      T low(0), high = most;
      for (int i = 0; i < std::numeric_limits<T>::digits && low < high; ++i) {
        const T middle = (low + high) / T(2);
        (lean(side, middle) ? low : high) = middle;
      }
      return high;
    };
    T least = scalar::pi<T>(), nearest(0);
    const T part = T(2) * scalar::pi<T>() / T(sides);
    for (int i = 0; i < sides; ++i) {
      const T side = T(i) * part;
      if (!lean(side, least)) {
        least = angle_to(side, least);
        nearest = side;
      }
    }
    T reach = part / T(2);
    for (int i = 0; i < narrowings; ++i) {
      bool nearer = false;
      for (const T& side : {T(nearest - reach), T(nearest + reach)}) {
        if (!lean(side, least)) {
          const T angle = angle_to(side, least);
          nearer = nearer || angle < least;
          nearest = angle < least ? side : nearest;
          least = angle;
        }
      }
      reach = nearer ? reach : T(reach / T(2));
    }
    return least;
  }

 private:
  static constexpr T infinity = std::numeric_limits<T>::infinity();

  /// The least share with which the stone is held, set by `set`: to half a digit less than T has.
  template <class Set>
  [[nodiscard]] T least_share(Set&& set) {
    const auto held = [&](const T& share) {
      set(share);
      const bool result = holds();
      body_ = usual_;
      return result;
    };
    if (held(T(0))) {
      return T(0);
    }
    T low(0), high(1);
    constexpr int most_doublings = 40;
    for (int i = 0; !held(high); ++i) {
      if (i == most_doublings) {
        return infinity;
      }
      low = high;
      high = T(2) * high;
    }
    for (int i = 0; i < std::numeric_limits<T>::digits; ++i) {
      const T middle = (low + high) / T(2);
      (held(middle) ? high : low) = middle;
    }
    return high;
  }

  Vec3<T> g_;
  T strength_;
  ContactBody<T> body_, usual_;
  const Supports& supports_;
  std::size_t count_;
};

template <Ordered T>
[[nodiscard]] Hold<T> held_at(const Stone<T>& stone, const DropSettings<T>& settings,
                              const std::array<Separation<T>, 2>& near, std::size_t count, const Vec3<T>& p_WB) {
  require_settings(settings, stone);
  const T touching = settings.touching * outer_width(stone);
  Hold<T> result;
  std::array<Support<T>, 2> supports = {};
  std::size_t used = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const T& gap = near[i].gap;
    require(-touching <= gap, "position", p_WB.transpose(), "is inside what it stands on, ", -gap, " deep");
    result.gap = i == 0 || gap < result.gap ? gap : result.gap;
    if (gap <= touching) {
      supports[used++] = {near[i].p_stone - p_WB, near[i].n_W};
    }
  }
  result.contacts = static_cast<int>(used);
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (!(T(0) < formula::dot(settings.gravity, settings.gravity))) {
    result.holds = true;
    result.friction = result.resistance = T(0);
    result.tilt = infinity;
    return result;
  }
  if (used == 0) {
    result.friction = result.resistance = infinity;
    result.tilt = T(0);
    return result;
  }
  Holding<T> holding(stone, settings, supports, used);
  result.holds = holding.holds();
  result.friction = holding.friction_share();
  result.resistance = holding.resistance_share();
  result.tilt = result.holds ? holding.tilt() : T(0);
  return result;
}

}  // namespace detail

/// Whether a stone at rest on a plane stays there, under the gravity, friction, rolling resistance and pivot friction of
/// `settings`, and how firmly. It is the function that decides the rest of a drop. (Not whether the rest is stable: a
/// stone on its edge is held by whatever resistance there is. The smooth laws of friction hold nothing on a slope.)
///
/// Domain  a stone of `make_stone`, a finite pose with a unit attitude, not inside the ground by more than
///         `settings.touching` of the width; settings in range; else InvalidArgument. Further away than that it touches
///         nothing, and falls.
/// Units   lengths in m, angles in rad.
/// Error   the tilt within 1e-6 rad; shares of one contact in closed form, of two to the statics' own 1e-8. Claim DROP-31.
template <Ordered T>
[[nodiscard]] Hold<T> holds(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane,
                            const DropSettings<T>& settings = {}) {
  return detail::held_at<T>(stone, settings, {separation(stone, pose, plane), {}}, 1, pose.p_WB);
}

/// The same on the board, on its floor, or leaning on both.
template <Ordered T>
[[nodiscard]] Hold<T> holds(const Stone<T>& stone, const Pose<T>& pose, const Board<T>& board,
                            const DropSettings<T>& settings = {}) {
  return detail::held_at<T>(stone, settings, {separation(stone, pose, board), separation(stone, pose, floor_of(board))},
                            2, pose.p_WB);
}

}  // namespace goishi
