#pragma once
/// \file
/// Resistance taken implicitly. Where one of δ and κ is much larger than the other, or the turning slow, the torque
/// changes with the angular velocity much faster than anything else moves: explicit steps would follow that.

#include <array>
#include <goishi/drop/equations/kinetics.hpp>
#include <limits>

namespace goishi {

namespace formula {

/// What a change of ω makes of the torque τ of `resistance`: −(D dω − τ (τ · dω))/√(ω · D ω + floor), D = diag(δ², δ²,
/// κ²); `over` is 1 over that root.
/// Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> resistance_slope(const T& delta_square, const T& kappa_square, const T& over,
                                              const Vec3<T>& torque, const Vec3<T>& w_change) {
  const T along = formula::dot(torque, w_change);
  return {T(over * (along * torque.x() - delta_square * w_change.x())),
          T(over * (along * torque.y() - delta_square * w_change.y())),
          T(over * (along * torque.z() - kappa_square * w_change.z()))};
}

/// x of x_a a + x_b b + x_c c = v.
/// Domain  a · (b × c) ≠ 0.   Proof  derivations/contact_phase.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> parts_along(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& v) {
  const Vec3<T> bc = formula::cross(b, c);
  const T over = T(1) / formula::dot(a, bc);
  return {T(over * formula::dot(v, bc)), T(over * formula::dot(v, formula::cross(c, a))),
          T(over * formula::dot(v, formula::cross(a, b)))};
}

}  // namespace formula

namespace detail {

/// What a change of the angular momentum changes by way of the resistance, at one state of a contact.
template <Ordered T>
class ResistanceSlope {
 public:
  ResistanceSlope(const ContactBody<T>& body, const Kinetics<T>& now)
      : body_(body),
        u_(now.u),
        torque_(resistance_torque(body, now.w)),
        roll_square_(scalar::sq(body.rolling_resistance)),
        pivot_square_(scalar::sq(body.pivot_radius)) {
    over_ = T(1) / scalar::sqrt(T(roll_square_ * (scalar::sq(now.w.x()) + scalar::sq(now.w.y())) +
                                  pivot_square_ * scalar::sq(now.w.z()) + resistance_floor(body)));
  }

  /// dτ, per normal force, for dL, dω = J dL.
  [[nodiscard]] Vec3<T> torque(const Vec3<T>& dL) const {
    return formula::resistance_slope(roll_square_, pivot_square_, over_, torque_,
                                     formula::turning(body_.mobility, u_, dL));
  }

  [[nodiscard]] const Vec3<T>& torque() const { return torque_; }

 private:
  const ContactBody<T>& body_;
  Vec3<T> u_, torque_;
  T roll_square_, pivot_square_, over_;
};

/// Whether explicit steps of length h from y would follow the resistance rather than the motion, under a normal force N.
template <Ordered T>
[[nodiscard]] bool resistance_is_stiff(const ContactBody<T>& body, const Variables<T>& y, const T& N, const T& h) {
  if (!body.resists) {
    return false;
  }
  const Vec3<T> u(y[at::u], y[at::u + 1], y[at::u + 2]), L(y[at::L], y[at::L + 1], y[at::L + 2]);
  const Vec3<T> w = formula::turning(body.mobility, u, L);
  const T d2 = scalar::sq(body.rolling_resistance), k2 = scalar::sq(body.pivot_radius);
  const T most = body.mobility.transverse + (T(0) < body.mobility.axial ? body.mobility.axial : T(0));
  const T rate = h * N * most * (d2 < k2 ? k2 : d2);
  // Dormand–Prince's steps stay stable up to rates of 3.3/h; squares save the root.
  return scalar::sq(T(3)) * (d2 * (scalar::sq(w.x()) + scalar::sq(w.y())) + k2 * scalar::sq(w.z())) < scalar::sq(rate);
}

/// The angular momentum of an implicit stage, L = L' + reach L̇(L), L' given in the stage: leaves L there and all rates in
/// k, which comes with a first guess. `evaluate(stage, k)` gives the rates, all else of the stage solved, or false;
/// `force_change(db)` what a change of J τ × r does to the force then. False where Newton's method does not converge.
template <Ordered T, class Equations, class Evaluate, class ForceChange>
[[nodiscard]] bool solve_turning(const ContactBody<T>& body, const Equations& equations, Variables<T>& stage,
                                 const T& reach, Variables<T>& k, Evaluate&& evaluate, ForceChange&& force_change) {
  constexpr int most_steps = 12;
  const Variables<T> given = stage;
  const Vec3<T> from(given[at::L], given[at::L + 1], given[at::L + 2]);
  Vec3<T> L = formula::plus(from, reach, Vec3<T>(k[at::L], k[at::L + 1], k[at::L + 2]));
  for (int i = 0; i < most_steps; ++i) {
    stage = given;
    for (std::size_t n = 0; n < 3; ++n) {
      stage[at::L + n] = L[static_cast<Eigen::Index>(n)];
    }
    if (!evaluate(stage, k)) {
      return false;
    }
    const Vec3<T> rate(k[at::L], k[at::L + 1], k[at::L + 2]);
    const Vec3<T> residual = formula::minus(formula::plus(from, reach, rate), L);
    const Kinetics<T>& now = equations.now;
    const T N = scalar::abs(T(equations.force.z()));
    const ResistanceSlope<T> slope(body, now);
    // The columns of 1 − reach ∂L̇/∂L, as far as resistance makes it.
    const auto column = [&](const Vec3<T>& dL) {
      const Vec3<T> torque = slope.torque(dL);
      const Vec3<T> brake = formula::turned_point(body.mobility, now.u, now.r, torque);
      const Vec3<T> force = force_change(equations.force.z() < T(0) ? formula::scaled(T(-1), brake) : brake);
      const Vec3<T> moment = formula::plus(formula::cross(now.r, force), N, torque);
      return formula::plus(dL, T(-reach), formula::plus(moment, force.z(), slope.torque()));
    };
    const Vec3<T> change = formula::parts_along<T>(column({T(1), T(0), T(0)}), column({T(0), T(1), T(0)}),
                                                   column({T(0), T(0), T(1)}), residual);
    const T size = formula::dot(change, change);
    if (!scalar::is_finite(size)) {
      return false;
    }
    L = formula::plus(L, change);
    // Newton's method all but squares the error: what is left is far below.
    const T least = T(1e-12) * body.frequency / body.mobility.transverse;
    if (size <= scalar::sq(T(scalar::max(T(1e-9), T(8) * std::numeric_limits<T>::epsilon()) *
                             (least + scalar::sqrt(formula::dot(L, L)))))) {
      for (std::size_t n = 0; n < 3; ++n) {
        const auto m = static_cast<Eigen::Index>(n);
        stage[at::L + n] = L[m];
        k[at::L + n] = (L[m] - from[m]) / reach;
      }
      return true;
    }
  }
  return false;
}

}  // namespace detail
}  // namespace goishi
