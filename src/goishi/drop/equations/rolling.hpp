#pragma once
/// \file
/// Contact without slip: the equations, and what is watched while they hold.

#include <array>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/resisting.hpp>
#include <goishi/drop/equations/stage_rates.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>
#include <limits>

namespace goishi::detail {

/// What is watched along a step: each is positive as long as the present equations hold.
/// (`turning`, where it ceases, and `onset`, where it is to begin, are not watched by their sign.)
enum class Guard { none, feature, lift_off, grip, slip, jam, support, turning, onset };
inline constexpr std::size_t guard_count = 6;

/// What counts as zero of a guard where the equations change.
template <class T>
[[nodiscard]] constexpr T guard_noise() {
  return scalar::max(T(1e-9), T(64) * std::numeric_limits<T>::epsilon());
}

/// The guards of a state, in the order of `names`; the unused are 1.
template <class T>
struct Guards {
  std::array<T, guard_count> value;
};

/// How far the contact point is from leaving the present feature: > 0 on it. A ball has one feature.
template <Ordered T>
[[nodiscard]] T feature_guard(const Stone<T>& stone, Feature feature, const Vec3<T>& u) {
  if (!(T(0) < stone.sphere_offset)) {
    return T(1);
  }
  const T radial = scalar::sqrt(T(scalar::sq(u.x()) + scalar::sq(u.y()))) * stone.joint_sine;
  const T axial = u.z() * stone.joint_cosine;
  if (feature == Feature::rim) {
    return radial - scalar::abs(axial);
  }
  return (feature == Feature::lower_cap ? axial : T(-axial)) - radial;
}

/// Rolling: the contact point is at rest, and friction is what that takes.
template <Ordered T>
class Rolling {
 public:
  static constexpr std::size_t used = 10;
  static constexpr bool slip_is_vector = false;

  Rolling(const ContactBody<T>& body, Feature feature, const Vec3<T>& origin)
      : body_(body), feature_(feature), origin_(origin) {}

  /// Of the pair that the last step was taken with.
  [[nodiscard]] int order() const { return order_; }

  /// The rates at y; what they came from is kept.
  [[nodiscard]] Variables<T> operator()(const Variables<T>& y) {
    ++evaluations;
    now = kinetics(body_, feature_, y);
    force = formula::rolling_force(now.W, now.brake, now.need);
    const T room = press_room();
    // Without resistance the contact would pull, as under infinite friction it may: resistance goes by the size of the force.
    const bool pulls = (force.z() < T(0)) == (T(0) < room);
    jams_ = jams_ || !(T(1e-6) < room || pulls);
    if (pulls) {
      now.torque = formula::scaled(T(-1), now.torque);
      now.brake = formula::scaled(T(-1), now.brake);
      force = formula::rolling_force(now.W, now.brake, now.need);
    }
    return rates(body_, now, force, T(0), T(0), origin_);
  }

  /// Dormand–Prince where resistance is not stiff, else the additive pair. False where there is no such step.
  [[nodiscard]] bool step(const Variables<T>& y, const Variables<T>& rate, const T& h, Trial<T, variables>& trial) {
    jams_ = false;
    if (!resistance_is_stiff(body_, y, N_, h)) {
      order_ = 5;
      dormand_prince(
          y, rate, h, trial, [this](const Variables<T>& stage) { return inner_rates(stage); }, *this);
      return !jams_;
    }
    order_ = 4;
    if (!additive_runge_kutta<T, variables>(
            y, rate, h, stiff::turning, trial,
            [&](Variables<T>& stage, const T& reach, Variables<T>& k) { return solve_stage(stage, reach, k); })) {
      return false;
    }
    trial.rate = (*this)(trial.y);
    return !jams_;
  }

  /// Of an implicit stage, or of an implicit step of Euler's: from the stage's own L, by `reach`.
  [[nodiscard]] bool solve_stage(Variables<T>& stage, const T& reach, Variables<T>& k) {
    return solve_turning(
        body_, *this, stage, reach, k,
        [&](Variables<T>& y, Variables<T>& rate) {
          rate = (*this)(y);
          return true;
        },
        [&](const Vec3<T>& brake) {
          return formula::scaled(T(-force.z()), formula::rolling_force(now.W, now.brake, brake));
        });
  }

  /// Of the state that was evaluated last. Grip: what is left of the friction cone, per unit of weight. It is gone
  /// before the normal force is, and slipping then decides whether the stone lifts off. Infinite friction has no cone:
  /// there the stone lifts off when it would without any force, and till then the contact may pull, as teeth that
  /// interlock do.
  [[nodiscard]] Guards<T> guards() const {
    const T& weight = body_.strength;
    T grip(1), normal(1);
    if (body_.friction < std::numeric_limits<T>::infinity()) {
      grip = (body_.friction * force.z() - scalar::sqrt(T(scalar::sq(force.x()) + scalar::sq(force.y())))) / weight;
    } else {
      normal = now.need.z() / weight;
    }
    return {{feature_guard(body_.stone, feature_, now.u), normal, grip, T(1), T(1), T(1)}};
  }

  /// Whether the last step met a resistance that no normal force goes with.
  [[nodiscard]] bool jams() const { return jams_; }

  [[nodiscard]] static T weight_of_direction(const Variables<T>&, const T&, const T&) { return T(0); }
  [[nodiscard]] T slip_x(const Variables<T>&) const { return T(0); }
  [[nodiscard]] T slip_y(const Variables<T>&) const { return T(0); }

  static constexpr std::array<Guard, guard_count> names = {Guard::feature, Guard::lift_off, Guard::grip,
                                                           Guard::none,    Guard::none,     Guard::support};

  /// From the state that was evaluated last.
  void begin_step() { N_ = scalar::abs(T(force.z())); }
  void carry_from(const Vec3<T>& origin) { origin_ = origin; }

  Kinetics<T> now;
  Vec3<T> force;  // on the contact point, per unit of mass
  int evaluations = 0;

 private:
  /// The rates, nothing kept.
  [[nodiscard]] Variables<T> inner_rates(const Variables<T>& y) {
    const StageMotion<T> at = stage_motion(body_, feature_, y);
    const T room = formula::stage_room(at);
    // A contact that would pull, or jam, is not among what is short.
    if (!(T(1e-6) * at.lambda < room) || !(T(0) < formula::stage_weight(body_.mobility, at))) {
      return (*this)(y);
    }
    ++evaluations;
    return rates<T>(body_, at, at.torque, formula::stage_rolling_force(body_.mobility, at), T(0), T(0), origin_);
  }

  /// 1 + ẑ · W⁻¹ b, b = J τ × r: below 0, the more a contact presses, the more resistance turns the stone into it. W >= 1, so
  /// that a small b leaves much of it.
  [[nodiscard]] T press_room() const {
    const Vec3<T>& b = now.brake;
    return formula::dot(b, b) < T(0.25) ? T(1) : T(T(1) + formula::solution(now.W, b).z());
  }

  ContactBody<T> body_;
  Feature feature_;
  Vec3<T> origin_;
  int order_ = 5;
  T N_ = T(0);  // [m/s²] normal force where the step begins
  bool jams_ = false;
};

}  // namespace goishi::detail
