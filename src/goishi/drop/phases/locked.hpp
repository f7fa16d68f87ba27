#pragma once
/// \file
/// Sliding without turning: rolling resistance holds the stone's attitude (friction too weak, or none), and only its
/// centre moves.

#include <array>
#include <goishi/drop/rest/statics.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>
#include <goishi/drop/state/run.hpp>
#include <goishi/drop/steps/support_loss.hpp>

namespace goishi::detail {

/// What follows a stretch of it.
enum class LockedEnd { none, stopped, support, unlocked, fails };

template <Ordered T>
class LockedSlide {
 public:
  using Motion = std::array<T, 4>;  // x, y, v_x, v_y

  /// Of a stone whose contact is at r from its centre, from a motion on.
  LockedSlide(const Run<T>& run, const Vec3<T>& r, const Motion& y)
      : body_(run.contact_body),
        at_{r, {T(0), T(0), T(1)}},
        length_(run.scales.length),
        speed_(run.scales.speed),
        tolerance_(run.settings.tolerance),
        step_(length_ / speed_),
        y_(y),
        rate_((*this)(y)) {}

  [[nodiscard]] Motion operator()(const Motion& y) const {
    const Vec3<T> f = force(y);
    return {y[2], y[3], formula::damped(T(f.x() + body_.gravity.x()), body_.damping, y[2]),
            formula::damped(T(f.y() + body_.gravity.y()), body_.damping, y[3])};
  }

  /// Plans the next stretch: how long it is and the way, at whose end `end` says what follows.
  [[nodiscard]] T plan(Run<T>& run, const ContactState<T>& contact, const ContactPlace<T>& place,
                       Interpolant<T, 4>& along) {
    DropCounters& counters = run.counters;
    const T speed = size_of(y_[2], y_[3]);
    // Where friction holds by little, the direction of a slip that ends soon settles so much faster than the slip ends that
    // steps keep it alive by their errors.
    const bool turns_fast = T(0) < static_friction(body_) && speed < step_ * friction_per_speed(speed) * speed;
    const T slow = (turns_fast ? T(10) : T(0.01)) * tolerance_ * speed_;
    if (is_in_cone(body_, at_.n, Vec3<T>(-body_.gravity)) && speed <= slow) {
      end_ = LockedEnd::stopped;
      return stop(along, speed);
    }
    if (!(resistance_share(body_, at_, force(y_)) < T(1))) {
      return ends_here(LockedEnd::unlocked, along);
    }
    const T longest = T(100) * length_ / speed_;
    T h = longest < step_ ? longest : step_;
    const T braking = -(y_[2] * rate_[2] + y_[3] * rate_[3]);
    const bool short_of_stop =
        T(0) < static_friction(body_) && T(0) < braking && T(0.9) * scalar::sq(speed) < h * braking;
    if (short_of_stop) {
      h = T(0.9) * scalar::sq(speed) / braking;
    }
    end_ = LockedEnd::none;
    const T shortest = T(1e3) * std::numeric_limits<T>::epsilon() * length_ / speed_;
    while (true) {
      Trial<T, 4> trial;
      const bool possible = step(y_, rate_, h, trial);
      const T error = possible ? T((size_of(trial.error[0], trial.error[1]) / length_ +
                                    size_of(trial.error[2], trial.error[3]) / speed_) /
                                   tolerance_)
                               : T(0);
      if (!possible || (!(error <= T(1)) && shortest < h)) {
        ++counters.steps_rejected;
        if (!(T(1e-3) * shortest < h)) {
          return ends_here(LockedEnd::fails, along);
        }
        h = h * (possible ? step_factor(error, 4) : T(1) / T(5));
        step_ = h;
        continue;
      }
      ++counters.steps_accepted;
      step_ = short_of_stop ? step_ : T(h * step_factor(error, 4));
      along = interpolant(y_, rate_, trial.y, trial.rate, h, bend_of(trial, rate_, h));
      y_ = trial.y;
      rate_ = trial.rate;
      if (const std::optional<T> lost = support_lost(run, contact, place, along)) {
        end_ = LockedEnd::support;
        along = along.cut(*lost);
        y_ = along(T(1));
        h = *lost * h;
      }
      return h;
    }
  }

  [[nodiscard]] LockedEnd end() const { return end_; }
  [[nodiscard]] const Motion& motion() const { return y_; }

 private:
  [[nodiscard]] static T size_of(const T& x, const T& y) { return scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))); }

  [[nodiscard]] T ends_here(LockedEnd end, Interpolant<T, 4>& along) {
    end_ = end;
    along = {};
    along.c[0] = y_;
    return T(0);
  }

  /// The last of the slip, which the present friction brakes: v²/2 over its rate.
  [[nodiscard]] T stop(Interpolant<T, 4>& along, const T& speed) {
    const T braking = -(y_[2] * rate_[2] + y_[3] * rate_[3]);
    const T t = T(0) < braking && T(0) < static_friction(body_) ? T(scalar::sq(speed) / braking) : T(0);
    along = {};
    along.c[0] = y_;
    along.c[1] = {T(t * y_[2]), T(t * y_[3]), T(-y_[2]), T(-y_[3])};
    along.c[2] = {T(-(t / T(2) * y_[2])), T(-(t / T(2) * y_[3])), T(0), T(0)};
    y_ = {T(y_[0] + t / T(2) * y_[2]), T(y_[1] + t / T(2) * y_[3]), T(0), T(0)};
    return t;
  }

  /// Dormand–Prince, or where a smooth law is stiff the additive pair.
  [[nodiscard]] bool step(const Motion& y, const Motion& rate, const T& h, Trial<T, 4>& trial) const {
    const T braked = h * (friction_per_speed(size_of(y[2], y[3])) + body_.damping);
    if (body_.model == FrictionModel::dry || braked < T(1)) {
      dormand_prince(y, rate, h, trial, *this);
      return true;
    }
    if (!additive_runge_kutta<T, 4>(y, rate, h, 0b1100U, trial,
                                    [&](Motion& stage, const T& reach, Motion& k) { return solve(stage, reach, k); })) {
      return false;
    }
    trial.rate = (*this)(trial.y);
    return true;
  }

  /// The velocity of an implicit stage, v = v' + reach v̇(v), by Newton's method.
  [[nodiscard]] bool solve(Motion& stage, const T& reach, Motion& k) const {
    constexpr int most_steps = 30;
    const T from_x = stage[2], from_y = stage[3];
    for (int i = 0; i < most_steps; ++i) {
      k = (*this)(stage);
      const T r_x = from_x + reach * k[2] - stage[2], r_y = from_y + reach * k[3] - stage[3];
      // v̇ = g − k(|v|) v − …: its slope is −k across v, and −k (1 − share) along it.
      const T speed2 = scalar::sq(stage[2]) + scalar::sq(stage[3]);
      const T across = T(1) + reach * (friction_per_speed(scalar::sqrt(speed2)) + body_.damping);
      const bool patch = body_.model == FrictionModel::coulomb_contensou && T(0) < speed2;
      const T share = patch ? T(speed2 / (speed2 + body_.creep_square)) : T(0);
      const T along = across - share * reach * friction_per_speed(scalar::sqrt(speed2));
      const T part = patch ? T((stage[2] * r_x + stage[3] * r_y) / speed2) : T(0);
      const T extra = part * (T(1) / along - T(1) / across);
      const T d_x = r_x / across + extra * stage[2], d_y = r_y / across + extra * stage[3];
      stage[2] = stage[2] + d_x;
      stage[3] = stage[3] + d_y;
      const T moved = size_of(d_x, d_y);
      if (!scalar::is_finite(moved)) {
        return false;
      }
      if (moved <= T(1e-3) * tolerance_ * size_of(stage[2], stage[3]) || !(T(0) < moved)) {
        k = (*this)(stage);
        k[2] = (stage[2] - from_x) / reach;
        k[3] = (stage[3] - from_y) / reach;
        return true;
      }
    }
    return false;
  }

  /// What friction takes of the velocity   [1/s].
  [[nodiscard]] T friction_per_speed(const T& speed) const {
    const T N = -body_.gravity.z();
    if (body_.model != FrictionModel::dry) {
      return N * smooth_friction(body_, scalar::sq(speed), T(0));
    }
    return T(0) < body_.friction && T(0) < speed ? T(N * body_.friction / speed) : T(0);
  }

  [[nodiscard]] Vec3<T> force(const Motion& y) const {
    return formula::friction_force(T(-body_.gravity.z()), friction_per_speed(size_of(y[2], y[3])), y[2], y[3]);
  }

  /// The share of the way at which the support is lost first, by bisection: just beyond.
  [[nodiscard]] static std::optional<T> support_lost(Run<T>& run, const ContactState<T>& contact,
                                                     const ContactPlace<T>& place, const Interpolant<T, 4>& along) {
    if (!run.board) {
      return std::nullopt;
    }
    const auto lasts = [&](const T& share) {
      const Motion y = along(share);
      return T(0) < contact.support_left(run, place, y[0], y[1]).gap;
    };
    T low(0), high(1);
    if (lasts(high)) {
      SupportLoss search(run, contact, along, 0, std::nullopt, [&](const Motion&) { return place; });
      const std::optional<T> lost = search();
      run.counters.evaluations_located += search.views();
      if (!lost) {
        return std::nullopt;
      }
      high = *lost;
    }
    run.counters.evaluations_located += std::numeric_limits<T>::digits;
    for (int i = 0; i < std::numeric_limits<T>::digits && low < high; ++i) {
      const T middle = (low + high) / T(2);
      (lasts(middle) ? low : high) = middle;
    }
    return high;
  }

  ContactBody<T> body_;
  Support<T> at_;
  T length_, speed_, tolerance_;
  T step_;  // [s] to try next
  Motion y_, rate_;
  LockedEnd end_ = LockedEnd::none;
};

}  // namespace goishi::detail
