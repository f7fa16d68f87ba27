#pragma once
/// \file
/// Sliding without turning: rolling resistance holds the stone's attitude (friction too weak, or none), and only its
/// centre moves.

#include <array>
#include <goishi/drop/dormand_prince.hpp>
#include <goishi/drop/run.hpp>
#include <goishi/drop/statics.hpp>

namespace goishi::detail {

/// How a stretch of it ended.
enum class LockedEnd { stopped, time, support, unlocked, too_many_steps };

template <Ordered T>
class LockedSlide {
 public:
  using Motion = std::array<T, 4>;  // x, y, v_x, v_y

  LockedSlide(Run<T>& run, const Vec3<T>& r)
      : run_(run),
        body_(run.contact_body),
        at_{r, {T(0), T(0), T(1)}},
        length_(run.scales.length),
        speed_(run.scales.speed),
        tolerance_(run.settings.tolerance) {}

  [[nodiscard]] Motion operator()(const Motion& y) const {
    const Vec3<T> f = force(y);
    return {y[2], y[3], formula::damped(T(f.x() + body_.gravity.x()), body_.damping, y[2]),
            formula::damped(T(f.y() + body_.gravity.y()), body_.damping, y[3])};
  }

  /// Integrates up to the horizon, or until the contact point leaves where `inside(x, y)` is positive. The run's time
  /// goes along.
  template <class Inside>
  [[nodiscard]] LockedEnd run(Motion& y, Inside&& inside) {
    const T longest = T(100) * length_ / speed_;
    T step = length_ / speed_;
    Motion rate = (*this)(y);
    while (run_.has_budget()) {
      const T speed = size_of(y[2], y[3]);
      if (is_in_cone(body_, at_.n, Vec3<T>(-body_.gravity)) && speed <= T(0.01) * tolerance_ * speed_) {
        stop(y, rate, speed);
        return LockedEnd::stopped;
      }
      const T left = run_.left();
      if (!(T(0) < left)) {
        return LockedEnd::time;
      }
      if (!(resistance_share(body_, at_, force(y)) < T(1))) {
        return LockedEnd::unlocked;
      }
      T h = step < left ? step : left;
      h = longest < h ? longest : h;
      const T braking = -(y[2] * rate[2] + y[3] * rate[3]);
      const bool short_of_stop =
          T(0) < static_friction(body_) && T(0) < braking && T(0.9) * scalar::sq(speed) < h * braking;
      if (short_of_stop) {
        h = T(0.9) * scalar::sq(speed) / braking;
      }
      bool possible = true;
      const Trial<T, 4> trial = stepped(y, rate, h, possible);
      const T error =
          (size_of(trial.error[0], trial.error[1]) / length_ + size_of(trial.error[2], trial.error[3]) / speed_) /
          tolerance_;
      if (!possible || (!(error <= T(1)) && shortest() < h)) {
        ++run_.result.counters.steps_rejected;
        step = h * (possible ? step_factor(error, 4) : T(1) / T(5));
        continue;
      }
      ++run_.result.counters.steps_accepted;
      if (!(T(0) < inside(trial.y[0], trial.y[1]))) {
        cross(y, rate, h, inside);
        run_.time = run_.time + h;
        return LockedEnd::support;
      }
      step = short_of_stop ? step : T(h * step_factor(error, 4));
      y = trial.y;
      rate = trial.rate;
      run_.time = run_.time + h;
    }
    return LockedEnd::too_many_steps;
  }

 private:
  [[nodiscard]] static T size_of(const T& x, const T& y) { return scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))); }

  [[nodiscard]] T shortest() const { return T(1e3) * std::numeric_limits<T>::epsilon() * length_ / speed_; }

  /// The last of the slip, which the present friction brakes: v²/2 over its rate.
  void stop(Motion& y, const Motion& rate, const T& speed) {
    const T braking = -(y[2] * rate[2] + y[3] * rate[3]);
    const T rest = T(0) < braking && T(0) < static_friction(body_) ? T(scalar::sq(speed) / braking) : T(0);
    const T t = run_.left() < rest ? run_.left() : rest;
    y = {T(y[0] + t / T(2) * y[2]), T(y[1] + t / T(2) * y[3]), T(0), T(0)};
    run_.time = run_.time + t;
  }

  /// Dormand–Prince, or where a smooth law is stiff the additive pair.
  [[nodiscard]] Trial<T, 4> stepped(const Motion& y, const Motion& rate, const T& h, bool& possible) const {
    const T braked = h * (friction_per_speed(size_of(y[2], y[3])) + body_.damping);
    if (body_.model == FrictionModel::dry || braked < T(1)) {
      return dormand_prince(y, rate, h, *this);
    }
    Trial<T, 4> trial =
        additive_runge_kutta<T, 4>(y, rate, h, 0b1100U, possible,
                                   [&](Motion& stage, const T& reach, Motion& k) { return solve(stage, reach, k); });
    if (possible) {
      trial.rate = (*this)(trial.y);
    }
    return trial;
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

  /// The step cut to where the contact point leaves, by bisection: to just outside.
  template <class Inside>
  void cross(Motion& y, const Motion& rate, T& h, Inside&& inside) const {
    T low(0), high = h;
    for (int i = 0; i < 60 && shortest() < high - low; ++i) {
      const T middle = (low + high) / T(2);
      const Trial<T, 4> trial = dormand_prince(y, rate, middle, *this);
      (T(0) < inside(trial.y[0], trial.y[1]) ? low : high) = middle;
    }
    h = high;
    y = dormand_prince(y, rate, h, *this).y;
  }

  Run<T>& run_;
  const ContactBody<T>& body_;
  Support<T> at_;
  T length_, speed_, tolerance_;
};

}  // namespace goishi::detail
