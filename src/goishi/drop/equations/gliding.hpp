#pragma once
/// \file
/// Contact under the laws of friction that are smooth in the slip.

#include <array>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/rolling.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>

namespace goishi::detail {

/// Friction as a smooth function of the slip: slip-proportional, Coulomb–Contensou, or none. The slip is (s_x, s_y).
template <Ordered T>
class Gliding {
 public:
  static constexpr std::size_t used = 12;
  static constexpr bool slip_is_vector = true;

  Gliding(const ContactBody<T>& body, Feature feature, const Vec3<T>& origin)
      : body_(body), feature_(feature), origin_(origin) {}

  /// Of the pair that the last step was taken with.
  [[nodiscard]] int order() const { return order_; }

  [[nodiscard]] Variables<T> operator()(const Variables<T>& y) {
    evaluate(y);
    return all_rates(y, slip_rate_at(y[at::slip], y[at::direction]));
  }

  /// Dormand–Prince where the slip is not stiff, else the additive pair. False where there is no such step.
  [[nodiscard]] bool step(const Variables<T>& y, const Variables<T>& rate, const T& h, Trial<T, variables>& trial) {
    jams_ = false;
    const bool resists_stiffly = resistance_is_stiff(body_, y, N_, h);
    if (!resists_stiffly && h * stiffness_ < T(1)) {
      order_ = 5;
      dormand_prince(y, rate, h, trial, *this);
      return !jams_;
    }
    order_ = 4;
    const Components components = stiff::slip | (resists_stiffly ? stiff::turning : 0U);
    if (!additive_runge_kutta<T, variables>(
            y, rate, h, components, trial, [&](Variables<T>& stage, const T& reach, Variables<T>& k) {
              return resists_stiffly ? solve_stage(stage, reach, k) : solve_slip(stage, reach, k);
            })) {
      return false;
    }
    trial.rate = (*this)(trial.y);
    return !jams_;
  }

  [[nodiscard]] Guards<T> guards() const {
    return {{feature_guard(body_.stone, feature_, now.u), T(now.need.z() / body_.strength), T(1), T(1), room_, T(1)}};
  }

  /// Angular momentum and slip of an implicit stage, or of an implicit step of Euler's.
  [[nodiscard]] bool solve_stage(Variables<T>& stage, const T& reach, Variables<T>& k) {
    return solve_turning(
        body_, *this, stage, reach, k, [&](Variables<T>& y, Variables<T>& rate) { return solve_slip(y, reach, rate); },
        [&](const Vec3<T>& brake) { return formula::scaled(T(-brake.z() / (room_ + jam_margin(now.W.zz))), force); });
  }

  /// Whether the last step met Painlevé's case.
  [[nodiscard]] bool jams() const { return jams_; }

  [[nodiscard]] static T weight_of_direction(const Variables<T>&, const T& speed, const T&) { return T(1) / speed; }
  [[nodiscard]] T slip_x(const Variables<T>& y) const { return y[at::slip]; }
  [[nodiscard]] T slip_y(const Variables<T>& y) const { return y[at::direction]; }

  static constexpr std::array<Guard, guard_count> names = {Guard::feature, Guard::lift_off, Guard::none,
                                                           Guard::none,    Guard::jam,      Guard::support};

  /// From the state that was evaluated last.
  void begin_step() {
    N_ = scalar::abs(T(force.z()));
    stiffness_ = N_ * ratio_ * (now.W.xx + now.W.yy);
  }
  void carry_from(const Vec3<T>& origin) { origin_ = origin; }

  Kinetics<T> now;
  Vec3<T> force;
  int evaluations = 0;

 private:
  void evaluate(const Variables<T>& y) {
    ++evaluations;
    now = kinetics(body_, feature_, y);
  }

  [[nodiscard]] GlideRate<T> slip_rate_at(const T& s_x, const T& s_y) {
    ratio_ = smooth_friction(body_, T(scalar::sq(s_x) + scalar::sq(s_y)), T(now.w.z()));
    GlideRate<T> slip = formula::glide_rate(now.W, now.brake, now.need, ratio_, s_x, s_y);
    slip.x = formula::damped(slip.x, body_.damping, s_x);
    slip.y = formula::damped(slip.y, body_.damping, s_y);
    return slip;
  }

  [[nodiscard]] Variables<T> all_rates(const Variables<T>& y, const GlideRate<T>& slip) {
    const T &s_x = y[at::slip], &s_y = y[at::direction];
    room_ = slip.denominator - jam_margin(now.W.zz);
    jams_ = jams_ || !(T(0) < room_);
    force = formula::friction_force(slip.N, T(slip.N * ratio_), s_x, s_y);
    Variables<T> rate = rates(body_, now, force, s_x, s_y, origin_);
    rate[at::slip] = slip.x;
    rate[at::direction] = slip.y;
    return rate;
  }

  /// The slip of an implicit stage, s = s' + reach ṡ(s), by Newton. False where that does not converge.
  [[nodiscard]] bool solve_slip(Variables<T>& stage, const T& reach, Variables<T>& k) {
    evaluate(stage);
    const T from_x = stage[at::slip], from_y = stage[at::direction];
    T &s_x = stage[at::slip], &s_y = stage[at::direction];
    s_x = from_x + reach * k[at::slip];
    s_y = from_y + reach * k[at::direction];
    const T least = scalar::sq(T(from_x)) + scalar::sq(T(from_y)) + body_.creep_square;
    constexpr int most_steps = 12;
    for (int i = 0; i < most_steps; ++i) {
      const GlideRate<T> rate = slip_rate_at(s_x, s_y);
      if (!(T(0) < rate.denominator)) {
        return false;
      }
      const GlideSlope<T> slope = slip_slope(rate, s_x, s_y);
      const T xx = T(1) - reach * slope.xx, xy = -(reach * slope.xy), yx = -(reach * slope.yx);
      const T yy = T(1) - reach * slope.yy;
      const T r_x = from_x + reach * rate.x - s_x, r_y = from_y + reach * rate.y - s_y;
      const T over = T(1) / (xx * yy - xy * yx);
      const T d_x = over * (yy * r_x - xy * r_y), d_y = over * (xx * r_y - yx * r_x);
      s_x = s_x + d_x;
      s_y = s_y + d_y;
      const T moved = scalar::sq(d_x) + scalar::sq(d_y);
      if (!(moved < T(1e20) * least)) {
        return false;
      }
      // Newton squares the error: what a change of 1e-8 leaves is round-off.
      if (moved < scalar::sq(scalar::max(T(1e-8), T(4) * std::numeric_limits<T>::epsilon())) * least) {
        k = all_rates(stage, slip_rate_at(s_x, s_y));
        k[at::slip] = (s_x - from_x) / reach;
        k[at::direction] = (s_y - from_y) / reach;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] GlideSlope<T> slip_slope(const GlideRate<T>& rate, const T& s_x, const T& s_y) const {
    const T share = body_.model == FrictionModel::slip_proportional || !(T(0) < ratio_)
                        ? T(0)
                        : T(scalar::sq(T(ratio_ / body_.friction)));
    return formula::glide_slope(now.W, now.brake, rate, ratio_, share, s_x, s_y, body_.damping);
  }

  ContactBody<T> body_;
  Feature feature_;
  Vec3<T> origin_;
  T ratio_ = T(0);                 // friction per normal force and slip
  T N_ = T(0), stiffness_ = T(0);  // [m/s²], [1/s] normal force and friction's effect on the slip where the step begins
  int order_ = 5;
  T room_ = T(1);  // of the normal force's denominator
  bool jams_ = false;
};

}  // namespace goishi::detail
