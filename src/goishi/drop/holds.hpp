#pragma once
/// \file
/// Whether a stone that is laid down stays there, and how firmly: the statics that end a drop, for whoever asks.

#include <array>
#include <cstddef>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/drop/rest/statics.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/drop/state/run.hpp>
#include <goishi/vector.hpp>
#include <limits>

namespace goishi {

/// How a stone that does not move is held. A share is the least part of what there is that would still hold it, with all
/// of the other: 0 where none is needed, 1 at the limit, above 1 where it moves, ∞ where no amount would do.
template <class T>
struct Hold {
  bool holds = false;
  int contacts = 0;                 // places that it touches: none, one or two
  T gap = scalar::unset<T>();       // [m] to the nearest
  T friction = scalar::unset<T>();  // share of μ; above 1 it slides
  T resistance =
      scalar::unset<T>();  // share of δ and κ, against rolling and turning on the spot; above 1 it rolls or tips
  /// [rad] The least angle by which gravity may lean further, to any side, before it moves. At most π/2, and that where
  /// there is no gravity.
  T tilt = scalar::unset<T>();

  explicit operator bool() const { return holds; }
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
        // How a stone turns does not enter statics: any moments do.
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
    if (!(static_friction(body_) < infinity)) {
      return holds() ? T(0) : infinity;
    }
    return least_share([&](const T& share) { body_.friction = share * usual_.friction; });
  }

  [[nodiscard]] T resistance_share() {
    if (count_ == 1) {
      const Vec3<T> load = -g_;
      const T share = detail::resistance_share(body_, supports_[0], load);
      return !(T(0) < formula::dot(supports_[0].n, load)) ? infinity
             : body_.resists                              ? share
             : share < T(1)                               ? T(0)
                                                          : infinity;
    }
    return least_share([&](const T& share) {
      body_.rolling_resistance = share * usual_.rolling_resistance;
      body_.pivot_radius = share * usual_.pivot_radius;
    });
  }

  /// The loads that are held are a convex cone: towards each side gravity leaves it once. The sides are looked through,
  /// and the neighbourhood of the nearest is narrowed down.
  [[nodiscard]] T tilt() {
    constexpr int sides = 48, narrowings = 40;
    const Vec3<T> down = g_ / strength_;
    const T x = scalar::abs(T(down.x()));
    const Vec3<T> other = x < T(0.5) ? Vec3<T>(T(1), T(0), T(0)) : Vec3<T>(T(0), T(1), T(0));
    const Vec3<T> a = detail::unit(formula::cross(down, other)), b = formula::cross(down, a);
    const auto lean = [&](const T& side, const T& angle) {
      const auto [leaning, towards] = scalar::sincos(angle, side);
      body_.gravity =
          strength_ * (leaning.cos * down + T(leaning.sin * towards.cos) * a + T(leaning.sin * towards.sin) * b);
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
    T least = scalar::pi<T>() / T(2), nearest(0);
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

  /// The least share with which the stone is held, set by `set`.
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
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const T touching = settings.touching * outer_width(stone), g2 = formula::dot(settings.gravity, settings.gravity);
  T reach = touching;
  if (1 < count && T(0) < g2) {
    const T g = scalar::sqrt(g2), height = hop_height(filled(settings, stone, g), g);
    reach = reach < height ? height : reach;
  }
  Hold<T> result;
  std::array<Support<T>, 2> supports = {};
  std::size_t used = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const T& gap = near[i].gap;
    require(-touching <= gap, "position", p_WB.transpose(), "is inside what it stands on, ", -gap, " deep");
    result.gap = i == 0 || gap < result.gap ? gap : result.gap;
    if (gap <= reach) {
      supports[used++] = {near[i].p_stone - p_WB, near[i].n_W};
    }
  }
  result.contacts = static_cast<int>(used);
  if (!(T(0) < g2)) {
    result.holds = true;
    result.friction = result.resistance = T(0);
    result.tilt = scalar::pi<T>() / T(2);
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
/// Error   in double, of one contact: shares 3e-13 w/δ, the tilt a thousandth of itself (claim DROP-31). Of two contacts, what
///         the statics of a drop takes for balanced: 1e-8 of the weight. In float 1e-3 of the weight.
/// Cost    the tilt asks statics some thousand times: 0.13 ms at one contact, 10 ms at two (EPYC, -O3, 2026-11-30).
template <Ordered T>
[[nodiscard]] Hold<T> holds(const Stone<T>& stone, const Pose<T>& pose, const Plane<T>& plane,
                            const DropSettings<T>& settings = {}) {
  return detail::held_at<T>(stone, settings, {separation(stone, pose, plane), {}}, 1, pose.p_WB);
}

/// The same on the board, on its floor, or leaning on both. What is within the height of a micro-impact, 2 edge_speed²/g,
/// counts as touched, as it does where a drop ends so.
template <Ordered T>
[[nodiscard]] Hold<T> holds(const Stone<T>& stone, const Pose<T>& pose, const Board<T>& board,
                            const DropSettings<T>& settings = {}) {
  return detail::held_at<T>(stone, settings, {separation(stone, pose, board), separation(stone, pose, floor_of(board))},
                            2, pose.p_WB);
}

}  // namespace goishi
