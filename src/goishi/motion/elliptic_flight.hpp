#pragma once
/// \file
/// Free flight of any rigid body, exactly: Jacobi's solution, without a time step. A stone needs `free_flight` only.

#include <cmath>
#include <goishi/motion/elliptic.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <utility>

namespace goishi {

/// Jacobi's solution in the frame F, whose axes are the body's, with moments I_a, I_b, I_c, I_b strictly between the
/// others, and L_c > 0: L_F = (A cn u, B sn u, C dn u), u = u₀ + λ t, sn, cn and dn of the parameter m.
template <class T>
struct JacobiSolution {
  T ratio, ratio2;  // B/A, and its square
  T n;              // −κ B²/A², of the integral of the third kind; κ = I_c (I_b − I_a)/(I_b (I_c − I_a))
  T size;           // |L|
  T A, B, C;        // in the unit of L
  T rate;           // λ
  T sn, cn, dn;     // of u₀
  T m, m1;          // the parameter, and 1 − m
};

namespace formula {

/// Of the body's moments, along F, and its momentum at the start. Near the middle axis u₀ is large, and infinite on
/// it: so it is not asked for.
/// Domain  L not along the first or the third axis: A > 0.   Proof  derivations/elliptic_flight.cpp, as of all below.
template <Elementary T>
[[nodiscard]] JacobiSolution<T> jacobi_solution(const Vec3<T>& moments, const Vec3<T>& L_F) {
  const T& I_a = moments.x();
  const T& I_b = moments.y();
  const T& I_c = moments.z();
  JacobiSolution<T> jacobi;
  jacobi.ratio2 = I_b * (I_a - I_c) / (I_a * (I_b - I_c));
  const T kappa = I_c * (I_b - I_a) / (I_b * (I_c - I_a));
  jacobi.n = I_c * (I_b - I_a) / (I_a * (I_b - I_c));
  jacobi.ratio = scalar::sqrt(jacobi.ratio2);
  jacobi.size = scalar::sqrt(formula::dot(L_F, L_F));
  jacobi.A = scalar::sqrt(T(scalar::sq(L_F.x()) + scalar::sq(L_F.y()) / jacobi.ratio2));
  jacobi.B = jacobi.ratio * jacobi.A;
  jacobi.C = scalar::sqrt(T(scalar::sq(L_F.z()) + kappa * scalar::sq(L_F.y())));
  jacobi.rate = jacobi.C / jacobi.ratio * ((I_c - I_a) / (I_a * I_c));
  jacobi.sn = L_F.y() / jacobi.B;
  jacobi.cn = L_F.x() / jacobi.A;
  jacobi.dn = L_F.z() / jacobi.C;
  jacobi.m = kappa * scalar::sq(T(jacobi.B / jacobi.C));
  // As a difference of what is given: what it loses near the separatrix, nobody has.
  jacobi.m1 = scalar::sq(jacobi.dn) + jacobi.n * scalar::sq(T(L_F.x() / jacobi.C));
  return jacobi;
}

/// sn, cn and dn of u₀ + v from those of v: the addition theorems.
template <Field T>
[[nodiscard]] elliptic::Jacobi<T> jacobi_sum(const JacobiSolution<T>& start, const elliptic::Jacobi<T>& by) {
  const T over = T(1) / (scalar::sq(by.cn) + scalar::sq(T(by.sn * start.dn)));  // 1/(1 − m sn² sn₀²)
  return {.sn = T(over * (start.sn * by.cn * by.dn + by.sn * start.cn * start.dn)),
          .cn = T(over * (start.cn * by.cn - start.sn * start.dn * by.sn * by.dn)),
          .dn = T(over * (start.dn * by.dn - start.m * start.sn * start.cn * by.sn * by.cn))};
}

/// (|L| B)/(C A) times what Π(n) of v has beyond Π(n) of u₀ + v less that of u₀: its addition theorem. `sum` is at u₀
/// + v.
template <Elementary T>
[[nodiscard]] T third_kind_excess(const JacobiSolution<T>& start, const T& sn_by, const elliptic::Jacobi<T>& sum) {
  const T &n = start.n, &m = start.m;
  const T product = n * start.sn * sn_by;
  return scalar::atan2(T(-product * sum.sn * scalar::sqrt(T((n - T(1)) * (m - n) / n))),
                       T(T(1) - n * scalar::sq(sum.sn) + product * sum.cn * sum.dn));
}

/// The angle about the third axis from L at the start to L at `at`, less than half a turn.
template <Elementary T>
[[nodiscard]] T momentum_longitude(const JacobiSolution<T>& start, const elliptic::Jacobi<T>& at) {
  return scalar::atan2(T(start.ratio * (start.cn * at.sn - start.sn * at.cn)),
                       T(start.cn * at.cn + start.ratio2 * start.sn * at.sn));
}

/// The turn ψ about L in a time t: |L| t/I_c + (|L| B)/(C A) ΔΠ(n) − Δatan2(L_b, L_a), with ΔΠ by `third`, Π(n) of λt,
/// and the excess. Its rate is (2E + |L| L_c/I_c)/(|L| + L_c).
template <Field T>
[[nodiscard]] T turn_about_momentum(const JacobiSolution<T>& start, const T& I_c, const T& third, const T& excess,
                                    const T& longitude, const T& t) {
  return start.size * t / I_c + start.size / start.C * start.ratio * third - excess - longitude;
}

/// L_F, in the half turn whose sign of cn and sn is `flip`.
template <Field T>
[[nodiscard]] Vec3<T> jacobi_momentum(const JacobiSolution<T>& jacobi, const T& flip, const elliptic::Jacobi<T>& at) {
  return {T(flip * jacobi.A * at.cn), T(flip * jacobi.B * at.sn), T(jacobi.C * at.dn)};
}

/// The shortest rotation that takes a unit vector to Fz, as a quaternion of the length √(2 (1 + z)).
template <Field T>
[[nodiscard]] Quat<T> shortest_to_z(const Vec3<T>& unit) {
  return Quat<T>(T(T(1) + unit.z()), unit.y(), T(-unit.x()), T(0));
}

/// The attitude after a turn ψ about L, that took L_F from where the rotation S₀ takes it to Fz to where S does:
/// q(t) = q(0) S₀⁻¹ exp(ẑ ψ) S.
template <Elementary T>
[[nodiscard]] Quat<T> turned_about_momentum(const Quat<T>& q_WB, const Quat<T>& q_BF, const Quat<T>& start_S,
                                            const T& psi, const Quat<T>& end_S) {
  const auto [s, c] = scalar::sincos(T(psi / T(2)));
  const Quat<T> turn(c, T(0), T(0), s);
  const Quat<T> q = formula::product(formula::product(q_BF, start_S.conjugate()), formula::product(turn, end_S));
  return formula::product(q_WB, formula::product(q, q_BF.conjugate()));
}

}  // namespace formula

namespace detail {

/// The frame F in which Jacobi's solution is written: axes along ±Bx, ±By, ±Bz, right-handed; the momentum circles
/// about the third axis and is positive on it; the second has the middle moment.
template <class T>
struct JacobiFrame {
  Mat3<T> R_BF;
  Vec3<T> moments;  // I_a, I_b, I_c, along the axes of F, in any unit
  Vec3<T> L_F;      // likewise
};

template <Ordered T>
[[nodiscard]] JacobiFrame<T> jacobi_frame(const Vec3<T>& moments, const Vec3<T>& L_B) {
  // Indices of the least, middle and greatest moment.
  int a = 0, b = 1, c = 2;
  const auto sort = [&](int& i, int& j) {
    if (moments[j] < moments[i]) {
      std::swap(i, j);
    }
  };
  sort(a, b);
  sort(b, c);
  sort(a, b);
  // L circles about the greatest axis if 2 E I_b < L², else about the least.
  const T& I_a = moments[a];
  const T& I_b = moments[b];
  const T& I_c = moments[c];
  if (!(scalar::sq(L_B[a]) * I_c * (I_b - I_a) < scalar::sq(L_B[c]) * I_a * (I_c - I_b))) {
    std::swap(a, c);
  }
  Vec3<T> f1 = Vec3<T>::Zero(), f3 = Vec3<T>::Zero();
  f1[a] = T(1);
  f3[c] = L_B[c] < T(0) ? T(-1) : T(1);
  JacobiFrame<T> frame;
  frame.R_BF << f1, f3.cross(f1), f3;
  frame.moments = {moments[a], moments[b], moments[c]};
  frame.L_F = {L_B[a], frame.R_BF.col(1)[b] * L_B[b], frame.R_BF.col(2)[c] * L_B[c]};
  return frame;
}

/// The third kind of integral, Π(n; φ) = ∫₀^φ dφ / ((1 − n sin²φ) √(1 − m sin²φ)).
/// Domain  |φ| <= π/2, given by its sine and cosine; n <= 0; m₁ = 1 − m > 0.
template <Ordered T>
[[nodiscard]] T third_integral(const T& sine, const T& cosine, const T& m1, const T& n) {
  const T s2 = scalar::sq(sine), c2 = scalar::sq(cosine);
  const T delta2 = c2 + m1 * s2;
  return sine * (elliptic::carlson_f<T>(c2, delta2, T(1)) +
                 n * s2 / T(3) * elliptic::carlson_j<T>(c2, delta2, T(1), T(T(1) - n * s2)));
}

/// The attitude of an asymmetric body after a time t, by the addition theorems from the start on.
template <Ordered T>
[[nodiscard]] Quat<T> asymmetric_rotation(const Quat<T>& q_WB, const JacobiFrame<T>& frame, const T& t) {
  const JacobiSolution<T> start = formula::jacobi_solution(frame.moments, frame.L_F);
  const T m1 = scalar::max(start.m1, std::numeric_limits<T>::min());

  // Whole half turns, and the rest.
  const elliptic::JacobiFunctions<T> jacobi(m1);
  const T K = jacobi.quarter_period();
  const T v = start.rate * t;
  using std::floor;
  const T half_turns = T(floor(T(v / (T(2) * K) + T(1) / T(2))));
  const elliptic::Jacobi<T> by = jacobi(T(v - T(2) * K * half_turns));
  const elliptic::Jacobi<T> end = formula::jacobi_sum(start, by);

  const T third =
      third_integral(by.sn, by.cn, m1, start.n) + T(2) * half_turns * third_integral<T>(T(1), T(0), m1, start.n);
  const T longitude = formula::momentum_longitude(start, end) + half_turns * scalar::pi<T>();
  const T psi = formula::turn_about_momentum(start, frame.moments.z(), third,
                                             formula::third_kind_excess(start, by.sn, end), longitude, t);

  const T half = half_turns / T(2);
  const T flip = half - T(floor(half)) < T(1) / T(4) ? T(1) : T(-1);
  const Vec3<T> end_L = formula::jacobi_momentum(start, flip, end);
  return formula::turned_about_momentum(q_WB, Quat<T>(frame.R_BF),
                                        detail::normalized(formula::shortest_to_z(Vec3<T>(frame.L_F / start.size))),
                                        psi, detail::normalized(formula::shortest_to_z(detail::unit(end_L))));
}

/// The attitude of a body two of whose moments are equal, whatever the axis.
template <Ordered T>
[[nodiscard]] Quat<T> symmetric_rotation(const State<T>& state, const Vec3<T>& moments, int axis, const T& t) {
  // Cyclic permutation of the axes that brings `axis` to z.
  Mat3<T> R_BF = Mat3<T>::Zero();
  for (int i = 0; i < 3; ++i) {
    R_BF((axis + 1 + i) % 3, i) = T(1);
  }
  const Quat<T> q_BF(R_BF);
  const Quat<T> q_WF = formula::product(state.q_WB, q_BF);
  const Mobility<T> mobility =
      formula::mobility(Moments<T>{.axial = moments[axis], .transverse = moments[(axis + 1) % 3]});
  return formula::product(
      formula::free_rotation(q_WF, state.L_W, axial_momentum(q_WF, state.L_W, mobility), mobility, t),
      q_BF.conjugate());
}

template <Ordered T>
[[nodiscard]] Quat<T> any_rotation(const State<T>& state, const Vec3<T>& moments, const T& t) {
  const auto equal = [&](int i, int j) { return moments[i] <= moments[j] && moments[j] <= moments[i]; };
  for (const int axis : {2, 0, 1}) {
    if (equal((axis + 1) % 3, (axis + 2) % 3)) {
      return symmetric_rotation(state, moments, axis, t);
    }
  }
  // In the next wider type: the phases of a nearly round body with its momentum across the odd axis, and those near the
  // separatrix, are differences of large numbers. In units of the greatest moment and momentum: their squares are then
  // numbers of Wide, whatever they are.
  using Wide = scalar::wider_t<T>;
  const Quat<Wide> q = formula::reunited(Quat<Wide>(state.q_WB.template cast<Wide>()));
  const Vec3<Wide> momentum = formula::in_body(q, Vec3<Wide>(state.L_W.template cast<Wide>()));
  Eigen::Index k = 0;
  const Wide size = momentum.cwiseAbs().maxCoeff(&k), unit = Wide(moments.maxCoeff());
  if (!(Wide(0) < size)) {
    return state.q_WB;
  }
  const Vec3<Wide> L_B = momentum / size, I = moments.template cast<Wide>() / unit;
  const Wide time = size / unit * Wide(t);
  // Along an axis of the body L stays there: about the middle one, for a time without end. Nearer to it than the least
  // root is on it.
  const Wide across = scalar::sq(L_B[(k + 1) % 3]) + scalar::sq(L_B[(k + 2) % 3]);
  if (!(scalar::tiny<Wide>() < scalar::sq(std::numeric_limits<Wide>::epsilon()) * across)) {
    const Wide half = L_B[k] * time / (Wide(2) * I[k]);
    const auto [sine, cosine] = scalar::sincos(half);
    Quat<Wide> turn(cosine, Wide(0), Wide(0), Wide(0));
    turn.vec()[k] = sine;
    return formula::product(q, turn).template cast<T>();
  }
  return asymmetric_rotation(q, jacobi_frame(I, L_B), time).template cast<T>();
}

}  // namespace detail

/// The state of any rigid body after it has flown freely for a time t: no time step, whatever the moments.
///
/// Domain  a finite state with a unit attitude; a body of `make_rigid_body`; finite gravity and t, negative ones too, with which
///         position, velocity and angles do not overflow (DOMAIN-6); else InvalidArgument.
/// Limits  two equal moments: the symmetric top (`free_flight`). L along an axis of the body, the middle one too: a spin
///         about it, for good.
/// Error   attitude <= 4 ε (1 + |L| t/I_least) (1 + G/1000) in float and double (ELLIPTIC-3): near the separatrix (the flip
///         about the middle axis) an error of the start grows by up to G = min(1/s, exp λ|t|), s = |1 − 2E I_b/L²|,
///         λ = |L| √((I_b − I_a)(I_c − I_b)/(I_a I_c))/I_b. At an attitude whose products with L are exact, L along an axis
///         is exact, and G = 0 (ELLIPTIC-6).
/// Source  Jacobi 1850; Odeint references.
template <Ordered T>
[[nodiscard]] State<T> elliptic_flight(const State<T>& state, const RigidBody<T>& body, const Vec3<T>& gravity,
                                       const T& t, Freedom freedom = Freedom::both) {
  require_state(state);
  const RigidBody<T> checked = make_rigid_body(body.mass, body.moments);
  require(scalar::is_finite(gravity), "gravity", gravity.transpose(), "must be finite");
  require(scalar::is_finite(t), "time", t, "must be finite");
  State<T> result = freedom == Freedom::angular ? state : formula::ballistic_flight(state, gravity, t);
  if (freedom != Freedom::linear) {
    result.q_WB = formula::reunited(detail::any_rotation(state, checked.moments, t));
  }
  detail::require_counted(result, t);
  return result;
}

}  // namespace goishi
