#pragma once
/// \file
/// The same equations near the vertical: Euler angles about x, whose poles are far. On the caps only.

#include "verify/oracles/drop/touching_equations.hpp"

namespace goishi::verify::touching {

using Triple3 = std::array<Long, 3>;

[[nodiscard]] inline Triple3 operator*(Long k, const Triple3& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
[[nodiscard]] inline Triple3 operator+(const Triple3& a, const Triple3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
[[nodiscard]] inline Long dot(const Triple3& a, const Triple3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline Triple3 cross(const Triple3& a, const Triple3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Θ is the axis' angle from x, Φ its azimuth from y to z, Ψ the spin; L_x and L · u are the momenta of Φ and Ψ.
class UprightEquations {
 public:
  UprightEquations(const TouchingBody& body, Part part, const TouchingState& y) : body_(body), y_(y) {
    const Long s = std::sin(y[2]), c = std::cos(y[2]), sp = std::sin(y[3]), cp = std::cos(y[3]);
    side_ = part == Part::lower ? body.hull.sphere_offset : -body.hull.sphere_offset;
    sin_ = s, cos_ = c;
    u_ = {c, s * cp, s * sp};
    n_ = {0, -sp, cp};
    n_rate_ = {0, -cp, -sp};  // for each Φ̇
    spin_ = y[9] / body.axial;
    phi_rate_ = (y[8] - y[9] * c) / (body.transverse * s * s);
    psi_rate_ = spin_ - phi_rate_ * c;
    w_ = phi_rate_ * Triple3{1, 0, 0} + y[7] * n_ + psi_rate_ * u_;
    u_rate_ = cross(w_, u_);
    arm_ = side_ * u_ + Triple3{0, 0, -body.hull.sphere_radius};
    const Long d2 = body.rolling_resistance * body.rolling_resistance, k2 = body.pivot_radius * body.pivot_radius;
    const Long root = std::sqrt(d2 * (w_[0] * w_[0] + w_[1] * w_[1]) + k2 * w_[2] * w_[2]);
    if (root > 0) {
      torque_ = {-d2 * w_[0] / root, -d2 * w_[1] / root, -k2 * w_[2] / root};
    }
  }

  /// Along x and y.
  [[nodiscard]] std::array<Long, 2> slip() const {
    const Triple3 turn = cross(w_, arm_);
    return {y_[5] + turn[0], y_[6] + turn[1]};
  }
  [[nodiscard]] Long heading() const { return 0; }
  [[nodiscard]] Long smooth(Long slip) const { return smooth_friction(body_, slip, w_[2]); }
  [[nodiscard]] Long press() const { return -met({0, 0, 0}).second; }

  [[nodiscard]] Answer at_ratio(Long f_x, Long f_y) const {
    const Long free = met({0, 0, 0}).second, each = met({f_x, f_y, 1}).second - free, N = -free / each;
    return met({N * f_x, N * f_y, N}).first;
  }
  [[nodiscard]] Answer rolling() {
    const Answer pressed = rolled();
    if (!(pressed.N < 0)) {
      return pressed;
    }
    torque_ = -1 * torque_;
    return rolled();
  }

 private:
  [[nodiscard]] Answer rolled() const {
    return met(root_of([&](const Triple3& F) {
             const auto [now, fall] = met(F);
             return Triple3{now.slip_e_rate, now.slip_n_rate, fall};
           }))
        .first;
  }

  /// And how fast the contact point is accelerated upwards.
  [[nodiscard]] std::pair<Answer, Long> met(const Triple3& F) const {
    const Long s = sin_, c = cos_, theta_rate = y_[7], phi_rate = phi_rate_;
    const Triple3 M = cross(arm_, F) + F[2] * torque_;
    const Long theta_bend =
        (body_.transverse * phi_rate * phi_rate * s * c - y_[9] * phi_rate * s + dot(M, n_)) / body_.transverse;
    const Long p_psi_rate = dot(M, u_);
    const Long phi_bend = (M[0] - p_psi_rate * c + y_[9] * s * theta_rate) / (body_.transverse * s * s) -
                          2 * c / s * theta_rate * phi_rate;
    const Long psi_bend = p_psi_rate / body_.axial - phi_bend * c + phi_rate * s * theta_rate;
    const Triple3 w_rate = phi_bend * Triple3{1, 0, 0} + theta_bend * n_ + theta_rate * phi_rate * n_rate_ +
                           psi_bend * u_ + psi_rate_ * u_rate_;
    const Triple3 met = F + Triple3{0, 0, -body_.gravity} + cross(w_rate, arm_) + side_ * cross(w_, u_rate_);
    return {{{y_[5], y_[6], theta_rate, phi_rate, psi_rate_, F[0], F[1], theta_bend, M[0], p_psi_rate},
             F[2],
             F[0],
             F[1],
             met[0],
             met[1]},
            met[2]};
  }

  const TouchingBody& body_;
  TouchingState y_;
  Long side_, sin_, cos_, spin_, phi_rate_, psi_rate_;
  Triple3 u_, n_, n_rate_, w_, u_rate_, arm_, torque_ = {0, 0, 0};
};

}  // namespace goishi::verify::touching
