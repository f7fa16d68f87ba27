#pragma once
/// \file
/// Stronge's law, the reference: the impact as a process in its normal impulse, with stick and slip on the way.
/// Source  W. J. Stronge, "Impact Mechanics", Cambridge University Press (2000); the process is Routh's.

#include <array>
#include <cstddef>
#include <goishi/impact/impulses.hpp>
#include <goishi/impact/material.hpp>
#include <limits>

namespace goishi {

namespace formula {

/// An impact that slips: the velocity of the contact, x and y across the normal and z along it, and the work of the
/// normal force.
template <class T>
struct SlipState {
  Vec3<T> v = Vec3<T>::Constant(scalar::unset<T>());  // [m/s]
  T work = scalar::unset<T>();                        // [J]
};

/// The impact that slips, as a power series in τ. With the slip s = (v_x, v_y), the normal impulse p and Coulomb's law,
///
///     dv/dp = W (−μ s/|s|, 1),   dE/dp = v_z,   dp = c |s| dτ
///
/// In τ the slip decays exponentially, and the solution is analytic as long as s is not 0. With c ~ 1/(1 + μ), infinite
/// friction, which stops the slip without a normal impulse, is a case as any other. Given with `against` = c μ and
/// `along` = c. The coefficients follow from each other: |s|² = v_x² + v_y² gives those of |s|.
/// Domain  s ≠ 0; W in a frame with z along the normal (`in_frame`).   Proof  derivations/impact_laws.cpp.
template <std::size_t order, Elementary T>
[[nodiscard]] std::array<SlipState<T>, order + 1> slip_series(const ContactMatrix<T>& W, const T& against,
                                                              const T& along, const SlipState<T>& start) {
  std::array<SlipState<T>, order + 1> series;
  std::array<T, order + 1> speed;
  series[0] = start;
  speed[0] = scalar::sqrt(T(scalar::sq(start.v.x()) + scalar::sq(start.v.y())));
  for (std::size_t k = 0; k < order; ++k) {
    const T over = T(1) / T(static_cast<int>(k) + 1);
    const Vec3<T>& v = series[k].v;
    const Vec3<T> force(T(-against * v.x()), T(-against * v.y()), T(along * speed[k]));
    series[k + 1].v = formula::scaled(over, formula::product(W, force));
    T power(0), square = T(2) * (start.v.x() * series[k + 1].v.x() + start.v.y() * series[k + 1].v.y());
    for (std::size_t i = 0; i <= k; ++i) {
      power = power + speed[i] * series[k - i].v.z();
    }
    for (std::size_t i = 1; i <= k; ++i) {
      const Vec3<T>&a = series[i].v, &b = series[k + 1 - i].v;
      square = square + (a.x() * b.x() + a.y() * b.y() - speed[i] * speed[k + 1 - i]);
    }
    series[k + 1].work = over * along * power;
    speed[k + 1] = square / (T(2) * speed[0]);
  }
  return series;
}

/// The value of a series at τ.   Proof  derivations/impact_laws.cpp.
template <std::size_t size, Field T>
[[nodiscard]] SlipState<T> value(const std::array<SlipState<T>, size>& series, const T& tau) {
  SlipState<T> sum = series[size - 1];
  for (std::size_t k = size - 1; 0 < k; --k) {
    sum.v = formula::plus(series[k - 1].v, tau, sum.v);
    sum.work = series[k - 1].work + tau * sum.work;
  }
  return sum;
}

}  // namespace formula

namespace detail {

/// Compression lasts until the normal velocity vanishes, restitution until the work of the normal force has given back
/// e² of what compression took; should friction drive the contact together again meanwhile, that work counts, too.
/// Error  3e-13 of the velocity in a plane (claim IMPACT-6), 1e-14 where the slip turns (IMPACT-7), 2e-14 where it stops (IMPACT-9).
template <Ordered T>
class StrongeProcess {
 public:
  explicit StrongeProcess(const Collision<T>& c)
      : collision_(c), friction_(c.friction), given_back_(scalar::sq(c.restitution)) {
    // Two tangents; the axis that the normal has least of gives the first.
    const Vec3<T>& n = c.n;
    const T x = scalar::abs(n.x()), y = scalar::abs(n.y()), z = scalar::abs(n.z());
    const Vec3<T> least = x <= y && x <= z ? Vec3<T>(T(1), T(0), T(0))
                          : y <= z         ? Vec3<T>(T(0), T(1), T(0))
                                           : Vec3<T>(T(0), T(0), T(1));
    const Vec3<T> across = formula::cross(n, least);
    a_ = formula::scaled(T(T(1) / scalar::sqrt(formula::dot(across, across))), across);
    b_ = formula::cross(n, a_);
    W_ = formula::in_frame(c.W, a_, b_, n);
    now_ = {.v = {formula::dot(c.v, a_), formula::dot(c.v, b_), formula::dot(c.v, n)}, .work = T(0)};
    negligible_ = T(4) * std::numeric_limits<T>::epsilon() * scalar::sqrt(formula::dot(c.v, c.v));
    speed_of_work_ = W_.zz / now_.v.z();
    // A unit of τ is then about what the slip takes to decay e-fold, or the velocity to change by the slip.
    against_ = T(1) / (W_.xx + W_.yy + W_.zz / c.friction);
    along_ = T(1) / (c.friction * (W_.xx + W_.yy) + W_.zz);
    // A few e-foldings of the slip: beyond, terms of the series cancel.
    step_ = longest_ = T(8) / (against_ * (W_.xx + W_.yy) + along_ * (scalar::abs(W_.xz) + scalar::abs(W_.yz)));
  }

  [[nodiscard]] LawImpulse<T> run() {
    for (int steps = 1; steps <= most_steps; ++steps) {
      if (step()) {
        return result(slip() <= negligible_ ? ImpactOutcome::stuck : ImpactOutcome::slid, steps);
      }
    }
    return result(ImpactOutcome::not_converged, most_steps);
  }

 private:
  static constexpr std::size_t order = 16;
  static constexpr int most_steps = 1000;
  using State = formula::SlipState<T>;
  using Series = std::array<State, order + 1>;

  [[nodiscard]] T slip() const { return scalar::sqrt(T(scalar::sq(now_.v.x()) + scalar::sq(now_.v.y()))); }

  /// What is still to happen in this phase, below 0 until it is over. Work counts from the start of the phase.
  [[nodiscard]] T progress(const State& state) const {
    return compressing_ ? state.v.z() : T(state.work + given_back_ * compression_);
  }

  /// Ends the phase; true if it was the last.
  [[nodiscard]] bool next_phase() {
    if (!compressing_) {
      return true;
    }
    compressing_ = false;
    compression_ = now_.work;
    now_.work = T(0);
    return !(progress(now_) < T(0));
  }

  /// To the end of the phase, to the end of the slip, or part of the way; true if the impact ended.
  [[nodiscard]] bool step() {
    const T speed = slip();
    if (speed <= negligible_) {
      return straight(formula::product(W_, force_from_rest()), T(1), T(0));
    }
    const T x = now_.v.x() / speed, y = now_.v.y() / speed;
    const Vec3<T> rate = formula::product(W_, Vec3<T>(T(-against_ * x), T(-against_ * y), along_));
    // Rates are about 1 in these units.
    const bool turns = T(64) * std::numeric_limits<T>::epsilon() < scalar::abs(T(rate.y() * x - rate.x() * y));
    return turns ? curved() : straight(rate, along_, T(-(rate.x() * x + rate.y() * y) / speed));
  }

  // --- slip in a direction that does not turn, and stick

  /// The velocity changes at a constant rate, while the normal impulse grows by `along`; the slip lasts 1/ending, or
  /// for good if `ending` is not positive.
  [[nodiscard]] bool straight(const Vec3<T>& rate, const T& along, const T& ending) {
    const T vn = now_.v.z();
    // Compression: v_n + rate.z l = 0. Restitution: along (v_n l + rate.z l²/2) is the work to come.
    const T ahead = -progress(now_) / (compressing_ ? T(1) : along);
    const T square = scalar::sq(vn) + T(2) * rate.z() * ahead;
    const T pace = compressing_ ? rate.z() : T(0) < square ? T((vn + scalar::sqrt(square)) / T(2)) : T(0);
    const bool stops = ending * ahead > pace;
    const T length = stops ? T(T(1) / ending) : T(ahead / pace);
    now_.work = now_.work + along * length * (vn + rate.z() * length / T(2));
    now_.v = formula::plus(now_.v, length, rate);
    if (stops) {
      now_.v.x() = now_.v.y() = T(0);
      return false;
    }
    return next_phase();
  }

  /// The force, for each unit of normal impulse, on a contact that does not slip: what holds it; or if friction cannot,
  /// that of a slip which starts from nothing and is kept in its direction by its own rate. There is one such
  /// direction; it is found from the direction against the force that would hold, by following the way in which it
  /// turns.
  [[nodiscard]] Vec3<T> force_from_rest() const {
    constexpr int most_turns = 100;
    const Vec3<T> holding = formula::tangential_solution(W_, T(-W_.xz), T(-W_.yz));
    const T needed = scalar::sqrt(formula::dot(holding, holding));
    if (needed <= friction_) {
      return {holding.x(), holding.y(), T(1)};
    }
    T x = -(holding.x() / needed), y = -(holding.y() / needed);
    Vec3<T> force;
    for (int i = 0; i < most_turns; ++i) {
      force = {T(-friction_ * x), T(-friction_ * y), T(1)};
      const Vec3<T> rate = formula::product(W_, force);
      // How fast the direction turns, and how that falls with the angle: by more than 0 where the slip goes outwards.
      const T across = rate.y() * x - rate.x() * y;
      const T slope = (rate.x() * x + rate.y() * y) +
                      friction_ * (W_.xx * scalar::sq(y) - T(2) * W_.xy * x * y + W_.yy * scalar::sq(x));
      const T turn = across / slope, turned_x = x - turn * y, turned_y = y + turn * x;
      const T size = scalar::sqrt(T(scalar::sq(turned_x) + scalar::sq(turned_y)));
      x = turned_x / size;
      y = turned_y / size;
      if (scalar::abs(turn) < std::numeric_limits<T>::epsilon()) {
        break;
      }
    }
    return force;
  }

  // --- slip in a direction that turns

  /// A step of the slip, as long as the last terms of the series are round-off; true if the impact ended within it.
  [[nodiscard]] bool curved() {
    const Series series = formula::slip_series<order>(W_, against_, along_, now_);
    // Sums of magnitudes: squares would underflow in float.
    const auto term = [&](std::size_t k) {
      const Vec3<T>& v = series[k].v;
      T size = (scalar::abs(v.x()) + scalar::abs(v.y())) +
               (scalar::abs(v.z()) + scalar::abs(T(speed_of_work_ * series[k].work)));
      for (std::size_t i = 0; i < k; ++i) {
        size = size * step_;
      }
      return size;
    };
    step_ = T(4) * step_;
    step_ = longest_ < step_ ? longest_ : step_;
    while (negligible_ < term(order) + term(order - 1)) {
      step_ = step_ / T(2);
    }
    const State next = formula::value(series, step_);
    if (T(0) <= progress(next)) {
      now_ = end_of_phase(series, next);
      return next_phase();
    }
    now_ = next;
    return false;
  }

  /// Where the phase ends within the step to `beyond`, by false position (Illinois).
  [[nodiscard]] State end_of_phase(const Series& series, const State& beyond) const {
    constexpr int most_trials = 60;
    T low(0), high = step_, low_value = progress(now_), high_value = progress(beyond);
    State there = beyond;
    int last = 0;
    for (int i = 0; i < most_trials && low_value < high_value; ++i) {
      const T h = low + (high - low) * (low_value / (low_value - high_value));
      there = formula::value(series, h);
      const T value = progress(there);
      const int side = T(0) < value ? 1 : value < T(0) ? -1 : 0;
      if (side == 0 || !(low < h && h < high)) {
        break;
      }
      (side > 0 ? high : low) = h;
      (side > 0 ? high_value : low_value) = value;
      if (side == last) {
        T& other = side > 0 ? low_value : high_value;
        other = other / T(2);
      }
      last = side;
    }
    return there;
  }

  /// The impulse is what made the change of velocity.
  [[nodiscard]] LawImpulse<T> result(ImpactOutcome outcome, int steps) const {
    const Vec3<T> across = formula::plus(formula::scaled(now_.v.x(), a_), now_.v.y(), b_);
    const Vec3<T> after = formula::plus(across, now_.v.z(), collision_.n);
    return {outcome, formula::solution(collision_.W, formula::minus(after, collision_.v)), steps};
  }

  const Collision<T>& collision_;
  T friction_;
  T given_back_;        // e²
  Vec3<T> a_, b_;       // tangents
  ContactMatrix<T> W_;  // in the frame of a, b and n
  T against_, along_;   // of `slip_series`
  T negligible_;        // [m/s]
  T speed_of_work_;     // [1/(N s)] makes work comparable with velocity
  State now_;
  T step_, longest_;
  T compression_ = T(0);  // work of the compression, < 0
  bool compressing_ = true;
};

template <Ordered T>
[[nodiscard]] LawImpulse<T> stronge(const Collision<T>& collision) {
  return StrongeProcess<T>(collision).run();
}

}  // namespace detail
}  // namespace goishi
