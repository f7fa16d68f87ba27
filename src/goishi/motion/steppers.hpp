#pragma once
/// \file
/// The ladder of time steppers that people use for a rigid body in free flight, behind one interface: from the published
/// loop to schemes of order 6, and the exact flight. For a stone use the exact flight; the others are here for bodies
/// without a symmetry axis, and to be measured against.

#include <array>
#include <cstdint>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/motion/step_formulas.hpp>
#include <goishi/published/attitude_step.hpp>
#include <goishi/vector.hpp>
#include <optional>
#include <string_view>

namespace goishi {

enum class Scheme {
  published,
  explicit_euler,
  exponential_euler,
  implicit_midpoint,
  runge_kutta_4,
  splitting_2,
  splitting_4,
  splitting_6,
  exact
};

/// What is known of a scheme. Orders are those of the error after a given time, proved in derivations/steppers.cpp and
/// measured by claim ORDER-1.
struct SchemeInfo {
  Scheme scheme;
  std::string_view name;
  int attitude_order;  // 0: does not converge to the true motion; `exact_order`: no step error
  int position_order;
  bool needs_symmetry;  // only for bodies with I_x = I_y
  std::string_view what;
};
inline constexpr int exact_order = 99;

inline constexpr std::array<SchemeInfo, 9> schemes = {{
    {Scheme::published, "published", 0, 1, false,
     "the talk's loop: semi-implicit Euler, constant angular velocity, quaternion renormalised"},
    {Scheme::explicit_euler, "explicit-euler", 1, 1, false,
     "angular momentum as state, explicit Euler attitude, quaternion renormalised"},
    {Scheme::exponential_euler, "exponential-euler", 1, exact_order, false,
     "angular momentum as state, attitude by the exponential of the angular velocity"},
    {Scheme::implicit_midpoint, "implicit-midpoint", 2, exact_order, false,
     "implicit midpoint on the rotation group: keeps momentum and energy"},
    {Scheme::runge_kutta_4, "runge-kutta-4", 4, exact_order, false,
     "the classical Runge-Kutta method on attitude and angular momentum"},
    {Scheme::splitting_2, "splitting-2", 2, exact_order, false, "three exact rotations, Strang's product"},
    {Scheme::splitting_4, "splitting-4", 4, exact_order, false, "five Strang products (Suzuki)"},
    {Scheme::splitting_6, "splitting-6", 6, exact_order, false, "nine Strang products (Kahan and Li)"},
    {Scheme::exact, "exact", exact_order, exact_order, true, "closed form of the symmetric top"},
}};

[[nodiscard]] constexpr const SchemeInfo& info(Scheme scheme) {
  return schemes[static_cast<std::size_t>(scheme)];
}

[[nodiscard]] constexpr std::optional<Scheme> scheme_named(std::string_view name) {
  for (const SchemeInfo& one : schemes) {
    if (one.name == name) {
      return one.scheme;
    }
  }
  return std::nullopt;
}

/// How stepping ended.
enum class StepStatus {
  completed,
  diverged,      // the step is too large for the scheme: a number overflowed, or the attitude left the unit sphere by
                 // more than a factor 2
  not_converged  // the step is too large for the implicit equation: Newton's method found no solution
};

[[nodiscard]] constexpr std::string_view to_string(StepStatus status) {
  switch (status) {
    case StepStatus::completed:
      return "completed";
    case StepStatus::diverged:
      return "diverged";
    case StepStatus::not_converged:
      break;
  }
  return "not converged";
}

/// Where stepping ended: the state after the last good step, and how many steps were good.
template <class T>
struct Stepped {
  State<T> state;
  StepStatus status = StepStatus::completed;
  std::int64_t steps = 0;
};

/// A scheme for a body in uniform gravity.
///
///     const Stepper<double> stepper(Scheme::runge_kutta_4, make_rigid_body(mass_properties(stone, Density{2800.0})));
///     const auto [state, status, steps] = stepper.advance(start, 1e-3, 1000);
///
/// L_W is constant in all of them but `published`, which keeps the angular velocity instead. Where the talk's linear
/// part is not asked for, the parabola is exact.
template <Ordered T>
class Stepper {
 public:
  /// Domain  one of the nine schemes; a body of `make_rigid_body`; one with I_x = I_y if the scheme needs symmetry; finite gravity and
  ///         inverse moments; else InvalidArgument.
  Stepper(Scheme scheme, const RigidBody<T>& body, const Vec3<T>& gravity = gravity_W<T>(),
          Freedom freedom = Freedom::both)
      : scheme_(scheme),
        body_(make_rigid_body(body.mass, body.moments)),
        inverse_moments_(body.moments.cwiseInverse()),
        gravity_(gravity),
        freedom_(freedom) {
    require(scalar::is_finite(inverse_moments_), "moments", body.moments.transpose(),
            "must not be so small that their inverses are no numbers");
    require(Scheme::published <= scheme && scheme <= Scheme::exact, "scheme", static_cast<int>(scheme),
            "must be one of the nine");
    require(scalar::is_finite(gravity), "gravity", detail::length(gravity), "must be finite");
    const T& x = body.moments.x();
    const T& y = body.moments.y();
    require(!info(scheme).needs_symmetry || (x <= y && y <= x), "moments", body.moments.transpose(),
            "must have I_x = I_y for the scheme '", info(scheme).name, "', which needs a symmetry axis Bz");
  }

  [[nodiscard]] Scheme scheme() const { return scheme_; }
  [[nodiscard]] const RigidBody<T>& body() const { return body_; }
  [[nodiscard]] const Vec3<T>& gravity() const { return gravity_; }

  /// `steps` steps of `dt`, or fewer if one fails (see the status). Runge–Kutta integrates the momentum in B beside the
  /// attitude and carries it from step to step of one call; the other schemes have no memory.
  /// Domain  a finite state with a unit attitude; dt > 0 and finite; steps >= 0; else InvalidArgument. Of bodies of any size
  ///         (DOMAIN-14): what overflows on the way, Δt/I too, is a status.
  /// Error   of a step: the scheme's own, round-off, and as much of the angle as |q|² is off.
  [[nodiscard]] Stepped<T> advance(const State<T>& start, const T& dt, std::int64_t steps) const {
    require_state(start);
    require_positive("step", dt);
    require(steps >= 0, "steps", steps, "must not be negative");
    switch (scheme_) {
      case Scheme::published:
        return run<Scheme::published>(start, dt, steps);
      case Scheme::explicit_euler:
        return run<Scheme::explicit_euler>(start, dt, steps);
      case Scheme::exponential_euler:
        return run<Scheme::exponential_euler>(start, dt, steps);
      case Scheme::implicit_midpoint:
        return run<Scheme::implicit_midpoint>(start, dt, steps);
      case Scheme::runge_kutta_4:
        return run<Scheme::runge_kutta_4>(start, dt, steps);
      case Scheme::splitting_2:
        return run<Scheme::splitting_2>(start, dt, steps);
      case Scheme::splitting_4:
        return run<Scheme::splitting_4>(start, dt, steps);
      case Scheme::splitting_6:
        return run<Scheme::splitting_6>(start, dt, steps);
      case Scheme::exact:
        break;
    }
    return run<Scheme::exact>(start, dt, steps);
  }

  /// One step.
  [[nodiscard]] Stepped<T> step(const State<T>& start, const T& dt) const { return advance(start, dt, 1); }

 private:
  template <Scheme scheme>
  [[nodiscard]] Stepped<T> run(const State<T>& start, const T& dt, std::int64_t steps) const {
    Stepped<T> result{.state = start};
    // What Runge-Kutta integrates beside the attitude; the others take it from L_W in every step.
    Vec3<T> L_B = formula::in_body(start.q_WB, start.L_W);
    State<T>& state = result.state;
    for (; result.steps < steps; ++result.steps) {
      Vec3<T> p = state.p_WB, v = state.v_WB;
      if (freedom_ != Freedom::angular) {
        move<scheme>(p, v, dt);
        if (!(scalar::is_finite(p) && scalar::is_finite(v))) {
          result.status = StepStatus::diverged;
          break;
        }
      }
      if (freedom_ != Freedom::linear) {
        result.status = turn<scheme>(state, L_B, dt);
        if (result.status != StepStatus::completed) {
          break;
        }
      }
      state.p_WB = p;
      state.v_WB = v;
    }
    return result;
  }

  template <Scheme scheme>
  void move(Vec3<T>& p, Vec3<T>& v, const T& dt) const {
    const Vec3<T> gain = dt * gravity_;
    if constexpr (info(scheme).position_order == exact_order) {
      p += dt * (v + gain / T(2));
      v += gain;
    } else {
      v += gain;
      p += dt * v;
    }
  }

  /// Takes the next attitude over, if it is one: a quaternion whose square overflowed in normalising is 0, not a unit.
  [[nodiscard]] static StepStatus settle(State<T>& state, const Quat<T>& next) {
    const T square = detail::squared_norm(next);
    if (!(T(1) / T(4) < square && square < T(4))) {
      return StepStatus::diverged;
    }
    state.q_WB = next;
    return StepStatus::completed;
  }

  /// The next attitude (and, in the published loop, momentum); nothing changes where a step fails.
  template <Scheme scheme>
  [[nodiscard]] StepStatus turn(State<T>& state, [[maybe_unused]] Vec3<T>& L_B, const T& dt) const {
    const Quat<T> q = state.q_WB;
    if constexpr (scheme == Scheme::published) {
      const auto [next, L_W] = detail::published_turn(q, angular_velocity(state), body_, dt);
      if (!scalar::is_finite(L_W) || settle(state, next) != StepStatus::completed) {
        return StepStatus::diverged;
      }
      state.L_W = L_W;
      return StepStatus::completed;
    } else if constexpr (scheme == Scheme::explicit_euler) {
      return settle(state, detail::normalized(formula::raw_euler_attitude(q, angular_velocity(state), dt)));
    } else if constexpr (scheme == Scheme::exponential_euler) {
      return settle(state, formula::reunited(formula::exponential_euler_attitude(q, angular_velocity(state), dt)));
    } else if constexpr (scheme == Scheme::implicit_midpoint) {
      const std::optional<Vec3<T>> middle = middle_momentum(formula::in_body(q, state.L_W), dt);
      return middle ? settle(state, formula::reunited(formula::midpoint_attitude(q, *middle, inverse_moments_, dt)))
                    : StepStatus::not_converged;
    } else if constexpr (scheme == Scheme::runge_kutta_4) {
      const formula::RotorNumbers<T> next = formula::raw_runge_kutta_4_step<T>(
          {q.w(), q.x(), q.y(), q.z(), L_B.x(), L_B.y(), L_B.z()}, Vec3<T>(dt * inverse_moments_), T(1));
      const T square = scalar::sq(next.w) + scalar::sq(next.x) + (scalar::sq(next.y) + scalar::sq(next.z));
      if (!(T(1) / T(4) < square && square < T(4))) {
        return StepStatus::diverged;
      }
      // A defect whose square is round-off needs no root.
      const T defect = square - T(1);
      const T over = scalar::sq(defect) < std::numeric_limits<T>::epsilon() ? T(T(1) - defect / T(2))
                                                                            : T(T(1) / scalar::sqrt(square));
      state.q_WB = Quat<T>(T(over * next.w), T(over * next.x), T(over * next.y), T(over * next.z));
      L_B = {next.lx, next.ly, next.lz};
      return StepStatus::completed;
    } else if constexpr (scheme == Scheme::exact) {
      const Mobility<T> mobility = formula::mobility(body_);
      const T axial_momentum = detail::axial_momentum(q, state.L_W, mobility);
      return settle(state, formula::free_rotation(q, state.L_W, axial_momentum, mobility, dt));
    } else {
      formula::Rotor<T> rotor{.q_WB = q, .L_B = formula::in_body(q, state.L_W)};
      formula::splitting_step(rotor, inverse_moments_, dt, composition<scheme>());
      return settle(state, formula::reunited(rotor.q_WB));
    }
  }

  [[nodiscard]] Vec3<T> angular_velocity(const State<T>& state) const {
    return state.q_WB * Vec3<T>(formula::in_body(state.q_WB, state.L_W).cwiseProduct(inverse_moments_));
  }

  template <Scheme scheme>
  [[nodiscard]] static constexpr auto composition() {
    if constexpr (scheme == Scheme::splitting_2) {
      return formula::composition_2<T>();
    } else if constexpr (scheme == Scheme::splitting_4) {
      return formula::composition_4<T>();
    } else {
      static_assert(scheme == Scheme::splitting_6);
      return formula::composition_6<T>();
    }
  }

  /// The momentum at the middle of an implicit step, by Newton's method from the start. Quadratic: the last update is
  /// at round-off, or there is no solution near.
  [[nodiscard]] std::optional<Vec3<T>> middle_momentum(const Vec3<T>& start, const T& dt) const {
    constexpr int most_iterations = 20;
    // Sums, not roots of squares, which overflow and vanish.
    const auto size_of = [](const Vec3<T>& v) {
      const Vec3<T> size = v.cwiseAbs();
      return T(size.x() + size.y() + size.z());
    };
    const T small = T(4) * std::numeric_limits<T>::epsilon() * size_of(start);
    Vec3<T> middle = start;
    for (int i = 0; i < most_iterations; ++i) {
      const Mat3<T> jacobian = formula::midpoint_jacobian(middle, inverse_moments_, dt);
      const Vec3<T> residual = formula::midpoint_residual(middle, start, inverse_moments_, dt);
      const Vec3<T> x = jacobian.col(0), y = jacobian.col(1), z = jacobian.col(2);  // by Cramer's rule
      const Vec3<T> yz = formula::cross(y, z);
      const T determinant = formula::dot(x, yz);
      const Vec3<T> update(T(formula::dot(residual, yz) / determinant),
                           T(formula::dot(residual, formula::cross(z, x)) / determinant),
                           T(formula::dot(residual, formula::cross(x, y)) / determinant));
      middle -= update;
      if (size_of(update) <= small) {
        return middle;
      }
    }
    return std::nullopt;
  }

  Scheme scheme_;
  RigidBody<T> body_;
  Vec3<T> inverse_moments_;
  Vec3<T> gravity_;
  Freedom freedom_;
};

}  // namespace goishi
