#pragma once
/// \file
/// Sliding without turning: rolling resistance holds the stone's attitude (friction too weak, or none), and only its
/// centre moves.

#include <array>
#include <goishi/drop/dormand_prince.hpp>
#include <goishi/drop/kinetics.hpp>

namespace goishi::detail {

/// How a stretch of it ended.
enum class LockedEnd { stopped, time, support, unlocked, too_many_steps };

/// Whether gravity and the contact's force are too weak to turn a stone that does not turn: the share, below 1, of the
/// resistance that their torque takes. `r`: from the centre of mass to the contact point.
template <Ordered T>
[[nodiscard]] T resistance_share(const ContactBody<T>& body, const Vec3<T>& r, const Vec3<T>& force, const T& length) {
  const Vec3<T> torque = formula::cross(r, force);
  // Round-off of a torque that is zero, so that without any resistance a stone still can stand.
  const T slack = T(1e-13) * length;
  const T roll = T(1) / (force.z() * (body.rolling_resistance + slack));
  const T pivot = T(1) / (force.z() * (body.pivot_radius + slack));
  return scalar::sqrt(
      T(scalar::sq(T(torque.x() * roll)) + scalar::sq(T(torque.y() * roll)) + scalar::sq(T(torque.z() * pivot))));
}

/// The torque's greatest power against an angular velocity, per normal force and unit of |ω|: √(δ²ω_h² + κ²ω_z²)/|ω|.
template <Ordered T>
[[nodiscard]] T resistance_lever(const ContactBody<T>& body, const Vec3<T>& w) {
  const T w_h2 = scalar::sq(w.x()) + scalar::sq(w.y()), w_z2 = scalar::sq(w.z());
  const T turning = w_h2 + w_z2;
  return T(0) < turning
             ? scalar::sqrt(
                   T((scalar::sq(body.rolling_resistance) * w_h2 + scalar::sq(body.pivot_radius) * w_z2) / turning))
             : T(0);
}

template <Ordered T>
class LockedSlide {
 public:
  using Motion = std::array<T, 4>;  // x, y, v_x, v_y

  LockedSlide(const ContactBody<T>& body, const Vec3<T>& r, const T& length, const T& speed, const T& tolerance)
      : body_(body), r_(r), length_(length), speed_(speed), tolerance_(tolerance) {}

  [[nodiscard]] Motion operator()(const Motion& y) const {
    const Vec3<T> f = force(y);
    return {y[2], y[3], T(f.x() + body_.gravity.x() - body_.damping * y[2]),
            T(f.y() + body_.gravity.y() - body_.damping * y[3])};
  }

  /// Integrates for at most `left`, or until the contact point leaves where `inside(x, y)` is positive.
  template <class Inside>
  [[nodiscard]] LockedEnd run(Motion& y, T& left, Inside&& inside, int& steps, int most_steps) const {
    T step = length_ / speed_;
    Motion rate = (*this)(y);
    while (true) {
      const T speed = size_of(y[2], y[3]);
      const bool dry = body_.model != FrictionModel::slip_proportional && T(0) < body_.friction;
      const T pull = size_of(body_.gravity.x(), body_.gravity.y());
      const bool holds = dry ? pull <= body_.friction * -body_.gravity.z() : !(T(0) < pull);
      if (holds && speed <= T(0.01) * tolerance_ * speed_) {
        return LockedEnd::stopped;
      }
      if (!(T(0) < left)) {
        return LockedEnd::time;
      }
      if (most_steps <= steps) {
        return LockedEnd::too_many_steps;
      }
      if (!(resistance_share(body_, r_, force(y), length_) < T(1))) {
        return LockedEnd::unlocked;
      }
      T h = step < left ? step : left;
      const T braking = -(y[2] * rate[2] + y[3] * rate[3]);
      const bool short_of_stop = dry && T(0) < braking && T(0.9) * scalar::sq(speed) < h * braking;
      if (short_of_stop) {
        h = T(0.9) * scalar::sq(speed) / braking;
      }
      const Trial<T, 4> trial = dormand_prince(y, rate, h, *this);
      ++steps;
      const T error =
          (size_of(trial.error[0], trial.error[1]) / length_ + size_of(trial.error[2], trial.error[3]) / speed_) /
          tolerance_;
      if (!(error <= T(1)) && T(1e-13) < h) {
        step = h * step_factor(error, 5);
        continue;
      }
      if (!(T(0) < inside(trial.y[0], trial.y[1]))) {
        cross(y, rate, h, inside);
        left = left - h;
        return LockedEnd::support;
      }
      step = short_of_stop ? step : T(h * step_factor(error, 5));
      y = trial.y;
      rate = trial.rate;
      left = left - h;
    }
  }

 private:
  [[nodiscard]] static T size_of(const T& x, const T& y) { return scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))); }

  [[nodiscard]] Vec3<T> force(const Motion& y) const {
    const T N = -body_.gravity.z();
    if (body_.model == FrictionModel::slip_proportional) {
      return {T(-(body_.slip_coefficient * N * y[2])), T(-(body_.slip_coefficient * N * y[3])), N};
    }
    const T speed = size_of(y[2], y[3]);
    const bool smooth = body_.model == FrictionModel::coulomb_contensou;
    T ratio(0);
    if (T(0) < body_.friction && (smooth || T(0) < speed)) {
      ratio = N * formula::patch_friction(body_.friction, body_.contensou, T(0), scalar::sq(speed),
                                          smooth ? body_.creep_square : T(0));
    }
    return {T(-(ratio * y[2])), T(-(ratio * y[3])), N};
  }

  /// The step cut to where the contact point leaves, by bisection: to just outside.
  template <class Inside>
  void cross(Motion& y, const Motion& rate, T& h, Inside&& inside) const {
    T low(0), high = h;
    for (int i = 0; i < 60 && T(1e-15) * length_ / speed_ < high - low; ++i) {
      const T middle = (low + high) / T(2);
      const Trial<T, 4> trial = dormand_prince(y, rate, middle, *this);
      (T(0) < inside(trial.y[0], trial.y[1]) ? low : high) = middle;
    }
    h = high;
    y = dormand_prince(y, rate, h, *this).y;
  }

  const ContactBody<T>& body_;
  Vec3<T> r_;
  T length_, speed_, tolerance_;
};

}  // namespace goishi::detail
