#pragma once
/// \file
/// Free flight of a body with a symmetry axis, exactly: no time step.

#include <goishi/mass/rigid_body.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>

namespace goishi {

namespace formula {

/// A turn about the unit vector k in the world by the angle 2α, and one about the symmetry axis in the body by 2β.
///
///     (cos α, k sin α) q (cos β, Bz sin β), of q/|q|
///
/// Proof  derivations/free_flight.cpp.
template <Elementary T>
[[nodiscard]] inline Quat<T> turned_top(const Quat<T>& q_WB, const Vec3<T>& k_W, const T& alpha, const T& beta) {
  const auto [about_k, about_axis] = scalar::sincos(alpha, beta);
  const T w = q_WB.w(), x = q_WB.x(), y = q_WB.y(), z = q_WB.z();
  const T square = (w * w + z * z) + (x * x + y * y);
  const T scale = (T(3) - square) / T(2);  // as `reunited`, so that no chain of flights leaves the unit sphere
  const T c = scale * about_axis.cos, s = scale * about_axis.sin;
  const T C = about_k.cos, X = about_k.sin * k_W.x(), Y = about_k.sin * k_W.y(), Z = about_k.sin * k_W.z();
  const T qw = c * w - s * z, qx = c * x + s * y, qy = c * y - s * x, qz = c * z + s * w;
  return Quat<T>(T((C * qw - X * qx) - (Y * qy + Z * qz)), T((C * qx + X * qw) + (Y * qz - Z * qy)),
                 T((C * qy + Y * qw) + (Z * qx - X * qz)), T((C * qz + Z * qw) + (X * qy - Y * qx)));
}

/// The attitude of a torque-free symmetric top after a time t: a rotation about L in the world, and one about the
/// symmetry axis in the body.
///
///     q(t) = exp(L t / I_t) q(0) exp(Bz L_z t (1/I_a − 1/I_t)),   L_z = L · q(0) Bz
///
/// Limits  L = 0, I_a = I_t, t <= 0: no special cases.   Proof  derivations/free_flight.cpp.
template <Elementary T>
[[nodiscard]] inline Quat<T> free_rotation(const Quat<T>& q_WB, const Vec3<T>& L_W, const T& axial_momentum,
                                           const Mobility<T>& mobility, const T& t) {
  const T time = t * mobility.transverse;
  const T x = time * L_W.x(), y = time * L_W.y(), z = time * L_W.z();
  const T angle = scalar::sqrt(T((x * x + y * y) + (z * z + scalar::tiny<T>())));
  const T over = T(1) / angle;
  return formula::turned_top(q_WB, Vec3<T>(T(over * x), T(over * y), T(over * z)), T(angle / T(2)),
                             T(axial_momentum * (t * mobility.axial) / T(2)));
}

/// The momentum about the symmetry axis, L · q Bz   [kg m²/s].   Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] inline T axial_momentum(const Quat<T>& q_WB, const Vec3<T>& L_W) {
  return formula::dot(L_W, formula::unit_axis(q_WB));
}

/// The state after a time t, of the attitude q by then: p + v t + g t²/2, v + g t.
/// Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] inline State<T> falling(const State<T>& state, const Quat<T>& q, const Vec3<T>& gravity, const T& t) {
  const T half = T(1) / T(2);
  const T gx = t * gravity.x(), gy = t * gravity.y(), gz = t * gravity.z();
  const Vec3<T>&p = state.p_WB, &v = state.v_WB, &L = state.L_W;
  return {.p_WB = {T(p.x() + t * (v.x() + half * gx)), T(p.y() + t * (v.y() + half * gy)),
                   T(p.z() + t * (v.z() + half * gz))},
          .q_WB = Quat<T>(q.w(), q.x(), q.y(), q.z()),  // not as pairs of what was just stored one by one
          .v_WB = {T(v.x() + gx), T(v.y() + gy), T(v.z() + gz)},
          .L_W = {L.x(), L.y(), L.z()}};
}

/// The same, attitude and L_W as they were.   Proof  derivations/free_flight.cpp.
template <Field T>
[[nodiscard]] inline State<T> ballistic_flight(const State<T>& state, const Vec3<T>& gravity, const T& t) {
  return formula::falling(state, state.q_WB, gravity, t);
}

/// Both: the whole state after a time t.   Proof  derivations/free_flight.cpp.
template <Elementary T>
[[nodiscard]] inline State<T> free_flight(const State<T>& state, const Mobility<T>& mobility, const Vec3<T>& gravity,
                                          const T& t) {
  const T axial_momentum = formula::axial_momentum(state.q_WB, state.L_W);
  return formula::falling(state, formula::free_rotation(state.q_WB, state.L_W, axial_momentum, mobility, t), gravity,
                          t);
}

}  // namespace formula

namespace detail {

/// L_z for the spin. A needle (I_a below I_t/4) turns ε |L| of round-off in it into a large error of L_z/I_a, so there
/// it is taken in the next wider type.
template <Ordered T>
[[nodiscard]] T axial_momentum(const Quat<T>& q_WB, const Vec3<T>& L_W, const Mobility<T>& mobility) {
  if (T(3) * mobility.transverse < mobility.axial) {
    using Wide = scalar::wider_t<T>;
    return T(formula::axial_momentum(Quat<Wide>(q_WB.template cast<Wide>()), Vec3<Wide>(L_W.template cast<Wide>())));
  }
  return formula::axial_momentum(q_WB, L_W);
}

template <Ordered T>
void require_counted(const State<T>& state, const T& t) {
  const Quat<T>& q = state.q_WB;
  require(scalar::is_finite(state.p_WB) && scalar::is_finite(state.v_WB) &&
              scalar::is_finite(T((q.w() + q.x()) + (q.y() + q.z()))),
          "time", t, "must not take the body farther than its arithmetic can count");
}

/// Says what is wrong of a flight that gives no numbers, or starts with an attitude that is not unit; or nothing, if only a
/// sum of its numbers is none.
template <Ordered T>
[[gnu::noinline, gnu::cold]] void check_flight(const State<T>& state, const Vec3<T>& gravity, const T& t,
                                               const State<T>& result) {
  require_state(state);
  require(scalar::is_finite(gravity), "gravity", gravity.transpose(), "must be finite");
  require(scalar::is_finite(t), "time", t, "must be finite");
  require_counted(result, t);
}

/// Every number of a flight is in one of these, so that their sum tells of all whether they are numbers.
template <Ordered T>
[[nodiscard]] inline bool is_counted(const State<T>& result, const Vec3<T>& gravity, const T& t) {
  const auto sum = [](const Vec3<T>& v) { return T((v.x() + v.y()) + v.z()); };
  const Quat<T>& q = result.q_WB;
  return scalar::is_finite(T((sum(result.p_WB) + sum(result.v_WB)) + (sum(result.L_W) + (sum(gravity) + t)) +
                             ((q.w() + q.x()) + (q.y() + q.z()))));
}

}  // namespace detail

/// What of the motion a scene needs. The talk's dynamics demo shows the three of them.
enum class Freedom { linear, angular, both };

/// The state of a stone after it has flown freely for a time t, in closed form. Gravity is the vector in W
/// (`gravity_W()`).
///
/// Domain  a finite state whose attitude is a unit quaternion; a mobility of `make_mobility`; finite gravity; any finite t,
///         negative ones too, with which position, velocity, t/I and the squares of the angles do not overflow (DOMAIN-5); else
///         InvalidArgument.
/// Error   attitude <= 8 ε (1 + |L| t / I_t + |ω_z t (1 − I_a/I_t)|) rad for I_a >= I_t/1000, thinner needles lose in
///         proportion (FLIGHT-1); |L| within 16 ε, energy of rotation within 16 ε √max(1, I_t/I_a), for every t (FLIGHT-2).
/// Cost    two pairs of sine and cosine, one root.
/// Proof   derivations/free_flight.cpp.
template <Ordered T>
[[nodiscard]] State<T> free_flight(const State<T>& state, const Mobility<T>& mobility, const Vec3<T>& gravity,
                                   const T& t, Freedom freedom = Freedom::both) {
  const bool unit = detail::is_unit(state.q_WB);
  const T axial_momentum = detail::axial_momentum(state.q_WB, state.L_W, mobility);
  const Quat<T> q = formula::free_rotation(state.q_WB, state.L_W, axial_momentum, mobility, t);
  State<T> result = formula::falling(state, q, gravity, t);
  if (freedom == Freedom::linear) {
    result.q_WB = state.q_WB;
  } else if (freedom == Freedom::angular) {
    result.p_WB = state.p_WB;
    result.v_WB = state.v_WB;
  }
  if (!(unit && detail::is_counted(result, gravity, t))) [[unlikely]] {
    detail::check_flight(state, gravity, t, result);
  }
  return result;
}

/// The same, from the moments.
template <Ordered T>
[[nodiscard]] State<T> free_flight(const State<T>& state, const Moments<T>& moments, const Vec3<T>& gravity, const T& t,
                                   Freedom freedom = Freedom::both) {
  return free_flight(state, make_mobility(moments), gravity, t, freedom);
}

/// A free flight that is asked for at many times: what of it is constant is made once. No root and no division is left.
///
///     const Flight<double> flight(state, mobility, gravity_W<double>());
///     const State<double> then = flight.at(0.25);
template <Ordered T>
class Flight {
 public:
  /// Domain  as `free_flight`.
  Flight(const State<T>& start, const Mobility<T>& mobility, const Vec3<T>& gravity)
      : start_(start), gravity_(gravity) {
    detail::check_flight(start, gravity, T(0), start);
    // By its greatest component, so that no square is lost.
    const Vec3<T>& L = start.L_W;
    const T most = scalar::max(scalar::abs(T(L.x())), scalar::max(scalar::abs(T(L.y())), scalar::abs(T(L.z()))));
    if (T(0) < most) {
      const Vec3<T> direction(T(L.x() / most), T(L.y() / most), T(L.z() / most));
      const T length = scalar::sqrt(formula::dot(direction, direction));
      k_W_ = {T(direction.x() / length), T(direction.y() / length), T(direction.z() / length)};
      alpha_ = most * length * mobility.transverse / T(2);
      beta_ = detail::axial_momentum(start.q_WB, L, mobility) * mobility.axial / T(2);
    }
    require(scalar::is_finite(alpha_) && scalar::is_finite(beta_), "angular momentum", most,
            "must not turn the body faster than its arithmetic can count");
  }

  /// The state after a time t.
  /// Domain, error  as `free_flight`.   Cost  a pair of sines and cosines.
  [[nodiscard]] State<T> at(const T& t) const {
    const Quat<T> q = formula::turned_top(start_.q_WB, k_W_, T(t * alpha_), T(t * beta_));
    State<T> result = formula::falling(start_, q, gravity_, t);
    if (!detail::is_counted(result, gravity_, t)) [[unlikely]] {
      detail::check_flight(start_, gravity_, t, result);
    }
    return result;
  }

  [[nodiscard]] const State<T>& start() const { return start_; }
  [[nodiscard]] const Vec3<T>& gravity() const { return gravity_; }

 private:
  State<T> start_;
  Vec3<T> gravity_;
  Vec3<T> k_W_ = {T(0), T(0), T(0)};  // direction of L
  T alpha_ = T(0), beta_ = T(0);      // [rad/s] half the rates about k, and about the symmetry axis
};

}  // namespace goishi
