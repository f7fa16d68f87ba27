#pragma once
/// \file
/// One step of each scheme as a formula, so that its order can be proved by series. Torque-free: L_W is constant, and
/// what a step has to find is the attitude.

#include <array>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>

namespace goishi::formula {

/// An attitude, and the constant L_W as it stands in B.
template <class T>
struct Rotor {
  Quat<T> q_WB;
  Vec3<T> L_B;
};

// --- explicit schemes. Those that return a `raw` attitude leave the unit sphere; the stepper brings it back.

/// q + q̇ Δt with the angular velocity at the step's start: explicit Euler. Not a unit quaternion: |q'|² = 1 + (|ω|Δt/2)².
/// Order 1.   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] Quat<T> raw_euler_attitude(const Quat<T>& q_WB, const Vec3<T>& w_WB, const T& dt) {
  const Quat<T> rate = formula::attitude_rate(w_WB, q_WB);
  return Quat<T>(T(q_WB.w() + dt * rate.w()), T(q_WB.x() + dt * rate.x()), T(q_WB.y() + dt * rate.y()),
                 T(q_WB.z() + dt * rate.z()));
}

/// exp(ω Δt) q with the angular velocity at the step's start: a rotation, no normalising. Order 1.
/// Proof  derivations/steppers.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> exponential_euler_attitude(const Quat<T>& q_WB, const Vec3<T>& w_WB, const T& dt) {
  return formula::rotation_exp(Vec3<T>(dt * w_WB)) * q_WB;
}

/// An attitude and a momentum in B, or their rates, as seven numbers, which the compiler keeps in registers.
template <class T>
struct RotorNumbers {
  T w, x, y, z;  // attitude
  T lx, ly, lz;  // momentum in B
};

/// Rates of a torque-free rotor: q̇ = ½ q (0, ω), and Euler's equations L̇ = L × ω, ω = I⁻¹ L in B. `inverse_moments` are
/// those of I⁻¹.   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] RotorNumbers<T> free_rates(const RotorNumbers<T>& s, const Vec3<T>& inverse_moments) {
  const T hx = s.lx * inverse_moments.x() / T(2), hy = s.ly * inverse_moments.y() / T(2),
          hz = s.lz * inverse_moments.z() / T(2);
  return {.w = T(-(s.x * hx + s.y * hy + s.z * hz)),
          .x = T(s.w * hx + s.y * hz - s.z * hy),
          .y = T(s.w * hy + s.z * hx - s.x * hz),
          .z = T(s.w * hz + s.x * hy - s.y * hx),
          .lx = T(T(2) * (s.ly * hz - s.lz * hy)),
          .ly = T(T(2) * (s.lz * hx - s.lx * hz)),
          .lz = T(T(2) * (s.lx * hy - s.ly * hx))};
}

/// s + h k.   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] RotorNumbers<T> along(const RotorNumbers<T>& s, const RotorNumbers<T>& k, const T& h) {
  return {T(s.w + h * k.w),   T(s.x + h * k.x),   T(s.y + h * k.y),  T(s.z + h * k.z),
          T(s.lx + h * k.lx), T(s.ly + h * k.ly), T(s.lz + h * k.lz)};
}

/// The classical Runge–Kutta step of attitude and momentum. Raw. Order 4.   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] RotorNumbers<T> raw_runge_kutta_4_step(const RotorNumbers<T>& start, const Vec3<T>& inverse_moments,
                                                     const T& dt) {
  const T half = dt / T(2), third = dt / T(3), sixth = dt / T(6);
  const RotorNumbers<T> k1 = formula::free_rates(start, inverse_moments);
  const RotorNumbers<T> k2 = formula::free_rates(formula::along(start, k1, half), inverse_moments);
  const RotorNumbers<T> k3 = formula::free_rates(formula::along(start, k2, half), inverse_moments);
  const RotorNumbers<T> k4 = formula::free_rates(formula::along(start, k3, dt), inverse_moments);
  const RotorNumbers<T> outer = formula::along(formula::along(start, k1, sixth), k4, sixth);
  return formula::along(formula::along(outer, k2, third), k3, third);
}

// --- implicit midpoint on the group

/// What the momentum m at the middle of the step, in B, must make zero: m − L_B − (Δt/2) m × I⁻¹ m, where L_B is the
/// momentum at the start. The momentum at the end is then 2m − L_B, a rotation of L_B.   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] Vec3<T> midpoint_residual(const Vec3<T>& middle, const Vec3<T>& start, const Vec3<T>& inverse_moments,
                                        const T& dt) {
  const Vec3<T> half_turn = dt / T(2) * Vec3<T>(middle.cwiseProduct(inverse_moments));
  return middle - start - middle.cross(half_turn);
}

/// Its derivative with respect to m: 1 − (Δt/2) ([m]× I⁻¹ − [I⁻¹ m]×).   Proof  derivations/steppers.cpp.
template <Field T>
[[nodiscard]] Mat3<T> midpoint_jacobian(const Vec3<T>& middle, const Vec3<T>& inverse_moments, const T& dt) {
  const T half = dt / T(2);
  const Vec3<T>& J = inverse_moments;
  // (Δt/2) m_k (J_column − J_k), with the sign of [m]×.
  const auto entry = [&](int k, int column) { return T(half * (middle[k] * (J[column] - J[k]))); };
  Mat3<T> result;
  result << T(1), entry(2, 1), T(-entry(1, 2)),  //
      T(-entry(2, 0)), T(1), entry(0, 2),        //
      entry(1, 0), T(-entry(0, 1)), T(1);
  return result;
}

/// The attitude at the end: q · cay(ω Δt), ω = I⁻¹ m, a turn by 2 atan(|ω|Δt/2). |L|, L_W and the energy are kept exactly.
/// Order 2.   Proof  derivations/steppers.cpp.
template <Elementary T>
[[nodiscard]] Quat<T> midpoint_attitude(const Quat<T>& q_WB, const Vec3<T>& middle, const Vec3<T>& inverse_moments,
                                        const T& dt) {
  const Vec3<T> half_turn = dt / T(2) * Vec3<T>(middle.cwiseProduct(inverse_moments));
  const T over = T(1) / scalar::sqrt(T(T(1) + half_turn.dot(half_turn)));
  return q_WB * Quat<T>(over, T(over * half_turn.x()), T(over * half_turn.y()), T(over * half_turn.z()));
}

// --- splitting into three exact rotations

/// The exact flow of the energy L_i²/(2 I_i) alone: the body turns about its axis i with the constant rate L_i/I_i.
/// Proof  derivations/steppers.cpp.
template <int i, Elementary T>
void turn_about(Rotor<T>& rotor, const Vec3<T>& inverse_moments, const T& dt) {
  constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
  const T half = rotor.L_B[i] * inverse_moments[i] * dt / T(2);
  const auto [s, c] = scalar::sincos(half);
  const T cosine = T(1) - T(2) * scalar::sq(s), sine = T(2) * s * c;
  const T L_j = rotor.L_B[j], L_k = rotor.L_B[k];
  rotor.L_B[j] = cosine * L_j + sine * L_k;
  rotor.L_B[k] = cosine * L_k - sine * L_j;
  Eigen::Matrix<T, 4, 1>& q = rotor.q_WB.coeffs();  // x, y, z, w
  const T q_i = q[i], q_j = q[j], q_k = q[k], q_w = q[3];
  q[3] = c * q_w - s * q_i;
  q[i] = c * q_i + s * q_w;
  q[j] = c * q_j + s * q_k;
  q[k] = c * q_k - s * q_j;
}

/// n₁ 10⁻⁹ + n₂ 10⁻¹⁸ + n₃ 10⁻²⁷: 27 digits of a constant that no root gives, in every scalar.
template <Field T>
[[nodiscard]] constexpr T digits(int n1, int n2, int n3) {
  const T unit = T(1) / T(1000000000);
  return unit * (T(n1) + unit * (T(n2) + unit * T(n3)));
}

/// Substeps of a symmetric composition, in units of Δt: the first half and the middle; the rest mirrors.
template <class T, std::size_t half_count>
using Substeps = std::array<T, half_count>;

/// Order 2 (Strang 1968): one substep.
template <Field T>
[[nodiscard]] constexpr Substeps<T, 1> composition_2() {
  return {T(1)};
}

/// Order 4 (Suzuki 1990): γ, γ, 1 − 4γ, γ, γ with γ = 1/(4 − 4^⅓).   Source  claim ORDER-2.
template <Field T>
[[nodiscard]] constexpr Substeps<T, 3> composition_4() {
  const T outer = formula::digits<T>(414490771, 794375737, 142354063);
  return {outer, outer, T(T(1) - T(4) * outer)};
}

/// Order 6 (Kahan and Li 1997), nine substeps.   Source  claim ORDER-2.
template <Field T>
[[nodiscard]] constexpr Substeps<T, 5> composition_6() {
  const T a = formula::digits<T>(392161444, 7314139, 279250560);
  const T b = formula::digits<T>(332599136, 789359438, 599748634);
  const T c = -formula::digits<T>(706246172, 557639359, 809964820);
  const T d = formula::digits<T>(82213596, 293550800, 231490449);
  return {a, b, c, d, T(T(1) - T(2) * (a + b + c + d))};
}

/// A symmetric composition of Strang steps x/2 y/2 z y/2 x/2, the last x of each merged with the first of the next.
/// Symmetric in time; |L| is kept.   Proof  derivations/steppers.cpp.
template <Elementary T, std::size_t half_count>
void splitting_step(Rotor<T>& rotor, const Vec3<T>& inverse_moments, const T& dt,
                    const Substeps<T, half_count>& substeps) {
  constexpr std::size_t count = 2 * half_count - 1;
  const auto substep = [&](std::size_t i) -> const T& { return substeps[i < half_count ? i : count - 1 - i]; };
  const T half = dt / T(2);
  formula::turn_about<0>(rotor, inverse_moments, T(half * substep(0)));
  for (std::size_t i = 0; i < count; ++i) {
    const T mine = half * substep(i);
    formula::turn_about<1>(rotor, inverse_moments, mine);
    formula::turn_about<2>(rotor, inverse_moments, T(dt * substep(i)));
    formula::turn_about<1>(rotor, inverse_moments, mine);
    formula::turn_about<0>(rotor, inverse_moments, i + 1 < count ? T(mine + half * substep(i + 1)) : mine);
  }
}

}  // namespace goishi::formula
