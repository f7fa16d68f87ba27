#pragma once
/// \file
/// Lagrange's equations of a stone that touches a plane, for any contact force, in Euler angles about the vertical. What
/// `touching_body.cpp` is made of; they divide by sin² θ, so that near the vertical `touching_upright.hpp` takes over.

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "verify/oracles/drop/touching_body.hpp"

namespace goishi::verify::touching {

using Long = long double;

/// S(θ) and its derivatives.
struct Support {
  Long S, a, a_slope;
};

/// Of the part that touches: the lower cap, the rim, the upper cap.
enum class Part { lower, rim, upper };

[[nodiscard]] inline Support support_at(const Hull<Long>& hull, Part part, Long theta) {
  const Long c = std::cos(theta), s = std::sin(theta);
  if (part == Part::rim) {
    return {hull.torus_radius * s + hull.tube_radius, hull.torus_radius * c, -hull.torus_radius * s};
  }
  const Long d = part == Part::lower ? hull.sphere_offset : -hull.sphere_offset;
  return {hull.sphere_radius - d * c, d * s, d * c};
}

/// Tilt at which the lower cap ends.
[[nodiscard]] inline Long joint_of(const Hull<Long>& hull) {
  return std::atan2(hull.joint_radius, hull.band + hull.sphere_offset);
}

[[nodiscard]] inline Part part_at(const Hull<Long>& hull, Long theta) {
  const Long joint = joint_of(hull);
  return theta < joint ? Part::lower : std::numbers::pi_v<Long> - joint < theta ? Part::upper : Part::rim;
}

/// What a contact force does to a state.
struct Answer {
  TouchingState rate;
  Long N;                         // normal force
  Long F_e, F_n;                  // friction
  Long slip_e_rate, slip_n_rate;  // of the slip's components
};

/// Where a function that is linear in three numbers, but for a constant, vanishes.
template <class F>
[[nodiscard]] std::array<Long, 3> root_of(const F& residual) {
  const std::array<Long, 3> zero = residual({0, 0, 0});
  Long m[3][4];
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<Long, 3> unit{0, 0, 0};
    unit[j] = 1;
    const std::array<Long, 3> there = residual(unit);
    for (std::size_t i = 0; i < 3; ++i) {
      m[i][j] = there[i] - zero[i];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    m[i][3] = -zero[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < 3; ++k) {
      pivot = std::fabs(m[pivot][i]) < std::fabs(m[k][i]) ? k : pivot;
    }
    std::swap(m[i], m[pivot]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != i) {
        const Long factor = m[k][i] / m[i][i];
        for (std::size_t j = i; j < 4; ++j) {
          m[k][j] -= factor * m[i][j];
        }
      }
    }
  }
  return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

/// Friction per normal force and slip of the smooth laws.
[[nodiscard]] inline Long smooth_friction(const TouchingBody& body, Long slip, Long w_z) {
  if (body.law == TouchingBody::Law::slip_proportional) {
    return body.coefficient;
  }
  return body.mu / std::hypot(slip, body.patch * w_z, body.creep);
}

/// The equations at one state, for any contact force.
class Equations {
 public:
  Equations(const TouchingBody& body, Part part, const TouchingState& y) : body_(body), y_(y) {
    const auto [S, a, a_slope] = support_at(body.hull, part, y[2]);
    S_ = S;
    a_ = a;
    a_slope_ = a_slope;
    sin_ = std::sin(y[2]);
    cos_ = std::cos(y[2]);
    e_ = {std::cos(y[3]), std::sin(y[3])};
    spin_ = y[9] / body.axial;
    phi_rate_ = (y[8] - y[9] * cos_) / (body.transverse * sin_ * sin_);
    psi_rate_ = spin_ - phi_rate_ * cos_;
    arm_ = S_ * sin_ + a_ * cos_;
    v_e_ = y[5] * e_[0] + y[6] * e_[1];
    v_n_ = -y[5] * e_[1] + y[6] * e_[0];
    const Long w_e = psi_rate_ * sin_, w_n = y[7], w_z = phi_rate_ + psi_rate_ * cos_;
    const Long d2 = body.rolling_resistance * body.rolling_resistance, k2 = body.pivot_radius * body.pivot_radius;
    const Long root = std::sqrt(d2 * (w_e * w_e + w_n * w_n) + k2 * w_z * w_z);
    if (root > 0) {
      torque_ = {-d2 * w_e / root, -d2 * w_n / root, -k2 * w_z / root};
    }
    w_z_ = w_z;
    gyration_ = body.transverse * phi_rate_ * phi_rate_ * sin_ * cos_ - body.axial * spin_ * phi_rate_ * sin_;
  }

  /// In the frame (e, n) of the tilt.
  [[nodiscard]] std::array<Long, 2> slip() const {
    return {v_e_ - S_ * y_[7], v_n_ + phi_rate_ * a_ + psi_rate_ * arm_};
  }

  /// The horizontal impulse at the contact, on which the surface gives what keeps them together, that takes the slip.
  [[nodiscard]] TouchingState stuck_at_once() const {
    const auto [s_e, s_n] = slip();
    const Long about = body_.transverse + a_ * a_;
    const Long P_e = -s_e / (1 + S_ * S_ / about);
    // For one unit across: of φ̇ and ψ̇.
    const Long phi = (a_ - arm_ * cos_) / (body_.transverse * sin_ * sin_), psi = arm_ / body_.axial - phi * cos_;
    const Long P_n = -s_n / (1 + phi * a_ + psi * arm_);
    TouchingState y = y_;
    y[5] += P_e * e_[0] - P_n * e_[1];
    y[6] += P_e * e_[1] + P_n * e_[0];
    y[7] -= S_ * P_e / about;
    y[8] += a_ * P_n;
    y[9] += arm_ * P_n;
    return y;
  }

  [[nodiscard]] Answer at_ratio(Long f_e, Long f_n) const {
    const Long lever = -S_ * f_e - a_ + torque_[1];
    const Long N = press() / (1 - a_ * lever / body_.transverse);
    return answer((gyration_ + N * lever) / body_.transverse, N * f_e, N * f_n);
  }

  /// How fast the contact point would be accelerated into the plane if nothing held it.
  [[nodiscard]] Long press() const {
    return body_.gravity + a_slope_ * y_[7] * y_[7] + a_ * gyration_ / body_.transverse;
  }

  /// Resistance goes by the size of the normal force: an infinitely rough contact may pull.
  [[nodiscard]] Answer rolling() {
    const Answer pressed = rolled();
    if (!(pressed.N < 0)) {
      return pressed;
    }
    for (Long& part : torque_) {
      part = -part;
    }
    return rolled();
  }

  [[nodiscard]] Long smooth(Long slip) const { return smooth_friction(body_, slip, w_z_); }
  /// Of the slip's first direction from x.
  [[nodiscard]] Long heading() const { return y_[3]; }

 private:
  [[nodiscard]] Answer rolled() const {
    // Affine in (θ̈, F_e, F_n): the θ equation and both slips' rates.
    const auto residual = [&](const std::array<Long, 3>& x) {
      const Answer now = answer(x[0], x[1], x[2]);
      return std::array<Long, 3>{body_.transverse * x[0] - (gyration_ - S_ * x[1] + now.N * (torque_[1] - a_)),
                                 now.slip_e_rate, now.slip_n_rate};
    };
    const std::array<Long, 3> x = root_of(residual);
    return answer(x[0], x[1], x[2]);
  }

  [[nodiscard]] Answer answer(Long theta_bend, Long F_e, Long F_n) const {
    Answer result;
    const Long theta_rate = y_[7];
    const Long N = body_.gravity + a_ * theta_bend + a_slope_ * theta_rate * theta_rate;
    const Long p_phi_rate = a_ * F_n + N * torque_[2];
    const Long p_psi_rate = arm_ * F_n + N * (torque_[0] * sin_ + torque_[2] * cos_);
    const Long phi_bend =
        (p_phi_rate - p_psi_rate * cos_ + y_[9] * sin_ * theta_rate) / (body_.transverse * sin_ * sin_) -
        2 * cos_ / sin_ * theta_rate * phi_rate_;
    const Long psi_bend = p_psi_rate / body_.axial - phi_bend * cos_ + phi_rate_ * sin_ * theta_rate;
    result.rate = {
        y_[5],      y_[6],      theta_rate, phi_rate_, psi_rate_, F_e * e_[0] - F_n * e_[1], F_e * e_[1] + F_n * e_[0],
        theta_bend, p_phi_rate, p_psi_rate};
    result.N = N;
    result.F_e = F_e;
    result.F_n = F_n;
    result.slip_e_rate = F_e + phi_rate_ * v_n_ - a_ * theta_rate * theta_rate - S_ * theta_bend;
    result.slip_n_rate = F_n - phi_rate_ * v_e_ + phi_bend * a_ + phi_rate_ * a_slope_ * theta_rate + psi_bend * arm_ +
                         psi_rate_ * (S_ + a_slope_) * cos_ * theta_rate;
    return result;
  }

  const TouchingBody& body_;
  TouchingState y_;
  Long S_, a_, a_slope_, sin_, cos_, spin_, phi_rate_, psi_rate_, arm_, v_e_, v_n_, w_z_, gyration_;
  std::array<Long, 2> e_;
  std::array<Long, 3> torque_ = {0, 0, 0};  // along e, n, z, per normal force
};

}  // namespace goishi::verify::touching
