#pragma once
/// \file
/// Contact that slips under dry friction. The slip is (σ, φ): near σ = 0 only its direction φ is stiff, and turns with
/// a rate of order μg/σ towards where the slip's own rate points. An additive Runge–Kutta pair takes that one variable
/// implicitly, all others explicitly, so that micro-slip costs no more steps than slip.

#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/rolling.hpp>
#include <goishi/drop/equations/stage_rates.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>

namespace goishi::detail {

template <Ordered T>
class Sliding {
 public:
  static constexpr std::size_t used = 12;
  static constexpr bool slip_is_vector = false;

  Sliding(const ContactBody<T>& body, Feature feature, const Vec3<T>& origin)
      : body_(body), feature_(feature), origin_(origin) {}

  /// Of the pair that the last step was taken with.
  [[nodiscard]] int order() const { return order_; }

  /// The rates at y. φ̇ is 0 where the slip has no direction yet.
  [[nodiscard]] Variables<T> operator()(const Variables<T>& y) {
    evaluate(y);
    direct(y[at::direction]);
    Variables<T> rate = all_rates(y);
    const T sigma = y[at::slip];
    rate[at::direction] = least_slip(T(1e-14)) < sigma ? T(slip_.across / sigma) : T(0);
    return rate;
  }

  /// Dormand–Prince where the direction is not stiff, else the additive pair. False where there is no such step.
  [[nodiscard]] bool step(const Variables<T>& y, const Variables<T>& rate, const T& h, Trial<T, variables>& trial) {
    jams_ = false;
    const T sigma = y[at::slip];
    resists_stiffly_ = resistance_is_stiff(body_, y, N_, h);
    if (!resists_stiffly_ && -(h * slope_) < T(3) * sigma && -(h * rate[at::slip]) < sigma) {
      order_ = 5;
      dormand_prince(
          y, rate, h, trial, [this](const Variables<T>& stage) { return inner_rates(stage); }, *this);
      return !jams_;
    }
    order_ = 4;
    return additive_step(y, rate, h, trial);
  }

  /// From the state that was evaluated last.
  void begin_step() {
    slope_ = slip_.across_slope;
    N_ = slip_.N;
  }

  [[nodiscard]] Guards<T> guards() const {
    return {{feature_guard(body_.stone, feature_, now.u), T(now.need.z() / body_.strength), T(1),
             T(sigma_ * body_.frequency / body_.strength), T(slip_.denominator - jam_margin(now.W.zz)), T(1)}};
  }

  /// Whether the last step met Painlevé's case.
  [[nodiscard]] bool jams() const { return jams_; }

  /// Angular momentum and direction of an implicit stage, or of an implicit step of Euler's.
  [[nodiscard]] bool solve_stage(Variables<T>& stage, const T& reach, Variables<T>& k) {
    return solve_turning(
        body_, *this, stage, reach, k,
        [&](Variables<T>& y, Variables<T>& rate) { return solve_direction(y, reach, rate); },
        [&](const Vec3<T>& brake) { return formula::scaled(T(-brake.z() / slip_.denominator), force); });
  }

  /// An error of the direction counts by what it does: to the slip, and over the step through the force.
  [[nodiscard]] T weight_of_direction(const Variables<T>& y, const T& speed, const T& h) const {
    const T reach = y[at::slip] + body_.friction * body_.strength * h;
    return reach / speed;
  }
  [[nodiscard]] T slip_x(const Variables<T>& y) const {
    return y[at::slip] * (seen(y) ? c_ : scalar::cos(y[at::direction]));
  }
  [[nodiscard]] T slip_y(const Variables<T>& y) const {
    return y[at::slip] * (seen(y) ? s_ : scalar::sin(y[at::direction]));
  }

  static constexpr std::array<Guard, guard_count> names = {Guard::feature, Guard::lift_off, Guard::none,
                                                           Guard::slip,    Guard::jam,      Guard::support};

  void carry_from(const Vec3<T>& origin) { origin_ = origin; }

  Kinetics<T> now;
  Vec3<T> force;
  int evaluations = 0;

 private:
  [[nodiscard]] bool additive_step(const Variables<T>& y, const Variables<T>& rate, const T& h,
                                   Trial<T, variables>& trial) {
    const Components components = stiff::direction | (resists_stiffly_ ? stiff::turning : 0U);
    if (!additive_runge_kutta<T, variables>(
            y, rate, h, components, trial, [&](Variables<T>& stage, const T& reach, Variables<T>& k) {
              return resists_stiffly_ ? solve_stage(stage, reach, k) : solve_inner(stage, reach, k);
            })) {
      return false;
    }
    const T turn = trial.rate[at::direction];
    trial.rate = (*this)(trial.y);
    if (!(least_slip(T(1e-6)) < trial.y[at::slip])) {
      trial.rate[at::direction] = turn;
    }
    return !jams_;
  }

  /// The rates, nothing kept but whether they jam.
  [[nodiscard]] Variables<T> inner_rates(const Variables<T>& y) {
    ++evaluations;
    const StageMotion<T> motion = stage_motion(body_, feature_, y);
    const auto [s, c] = scalar::sincos(y[at::direction]);
    const T sigma = y[at::slip];
    const SlipRate<T> slip = formula::stage_slip(body_.mobility, motion, body_.friction, c, s);
    see_jam(slip, formula::stage_stiffness(body_.mobility, motion));
    Variables<T> rate = inner_rates(motion, slip, c, s, sigma);
    rate[at::direction] = least_slip(T(1e-14)) < sigma ? T(slip.across / sigma) : T(0);
    return rate;
  }

  [[nodiscard]] Variables<T> inner_rates(const StageMotion<T>& motion, const SlipRate<T>& slip, const T& c, const T& s,
                                         const T& sigma) const {
    const Vec3<T> F = formula::friction_force(slip.N, T(body_.friction * slip.N), c, s);
    Variables<T> rate = rates<T>(body_, motion, motion.torque, F, T(sigma * c), T(sigma * s), origin_);
    rate[at::slip] = formula::damped(slip.along, body_.damping, sigma);
    return rate;
  }

  /// The direction of an implicit stage, nothing kept but whether it jams.
  [[nodiscard]] bool solve_inner(Variables<T>& stage, const T& reach, Variables<T>& k) {
    ++evaluations;
    const StageMotion<T> motion = stage_motion(body_, feature_, stage);
    const T sigma = stage[at::slip], W_zz = formula::stage_stiffness(body_.mobility, motion);
    T turn = k[at::direction];
    scalar::SineCosine<T> direction{.sin = T(0), .cos = T(1)};
    SlipRate<T> slip;
    const auto look = [&](const T phi) {  // a copy, so that both are one call
      direction = scalar::sincos(phi);
      slip = formula::stage_slip(body_.mobility, motion, body_.friction, direction.cos, direction.sin);
    };
    if (!solve(sigma, stage[at::direction], reach, turn, slip, look, W_zz)) {
      return false;
    }
    see_jam(slip, W_zz);
    stage[at::direction] = stage[at::direction] + reach * turn;
    k = inner_rates(motion, slip, direction.cos, direction.sin, sigma);
    k[at::direction] = turn;
    return true;
  }

  /// A share of the speed that the stone's own scales have   [m/s].
  [[nodiscard]] T least_slip(const T& share) const { return share * body_.strength / body_.frequency; }

  /// The direction of an implicit stage.
  [[nodiscard]] bool solve_direction(Variables<T>& stage, const T& reach, Variables<T>& k) {
    evaluate(stage);
    T turn = k[at::direction];
    if (!solve(
            stage[at::slip], stage[at::direction], reach, turn, slip_, [this](const T& phi) { direct(phi); },
            now.W.zz)) {
      return false;
    }
    stage[at::direction] = stage[at::direction] + reach * turn;
    k = all_rates(stage);
    k[at::direction] = turn;
    return true;
  }

  /// Whether cosine and sine of the direction are at hand.
  [[nodiscard]] bool seen(const Variables<T>& y) const {
    return !(y[at::direction] < phi_) && !(phi_ < y[at::direction]);
  }

  void evaluate(const Variables<T>& y) {
    ++evaluations;
    now = kinetics(body_, feature_, y);
    sigma_ = y[at::slip];
  }

  void direct(const T phi) {  // a copy, so that both are one call
    phi_ = phi;
    const auto [s, c] = scalar::sincos(phi);
    c_ = c;
    s_ = s;
    slip_ = formula::slip_rate(now.W, now.brake, now.need, body_.friction, c_, s_);
  }

  void see_jam(const SlipRate<T>& slip, const T& W_zz) { jams_ = jams_ || !(jam_margin(W_zz) < slip.denominator); }

  [[nodiscard]] Variables<T> all_rates(const Variables<T>& y) {
    see_jam(slip_, now.W.zz);
    force = formula::friction_force(slip_.N, T(body_.friction * slip_.N), c_, s_);
    Variables<T> rate = rates(body_, now, force, T(y[at::slip] * c_), T(y[at::slip] * s_), origin_);
    rate[at::slip] = formula::damped(slip_.along, body_.damping, y[at::slip]);
    return rate;
  }

  /// φ̇ of an implicit stage: σ φ̇ = across(φ₀ + reach φ̇), by Newton. False where that is not stable, or does not
  /// converge.
  /// `look` sets the rate of the slip in a direction.
  template <class Look>
  [[nodiscard]] bool solve(const T& sigma, const T& phi, const T& reach, T& turn, const SlipRate<T>& slip, Look&& look,
                           const T& W_zz) {
    constexpr int most_steps = 12;
    for (int i = 0; i < most_steps; ++i) {
      look(T(phi + reach * turn));
      if (i == 0) {  // of a step that is short enough, where it begins; later tries may be anywhere
        see_jam(slip, W_zz);
      }
      const T residual = slip.across - sigma * turn;
      const T slope = sigma - reach * slip.across_slope;
      if (!(T(0) < slope) || !(T(0) < slip.denominator)) {
        return false;
      }
      const T change = residual / slope;
      turn = turn + change;
      const T moved = reach * change;
      if (-T(1) < moved && moved < T(1)) {
        // Newton squares the error: what a change of 1e-6 leaves is 1e-12.
        if (scalar::sq(moved) < T(1e-12)) {
          if (T(1e-26) < scalar::sq(moved)) {
            look(T(phi + reach * turn));
          }
          return true;
        }
      } else {
        return false;
      }
    }
    return false;
  }

  ContactBody<T> body_;
  Feature feature_;
  Vec3<T> origin_;
  SlipRate<T> slip_ = {};
  T c_ = T(1), s_ = T(0), phi_ = T(0), sigma_ = T(0);
  bool jams_ = false, resists_stiffly_ = false;
  T slope_ = T(0), N_ = T(0);  // [m/s²] of σ φ̇ by φ, and the normal force, where the step begins
  int order_ = 4;
};

}  // namespace goishi::detail
