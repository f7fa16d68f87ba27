#pragma once
/// \file
/// Free flight of a stone by what of it is seen from outside: its centre, and its symmetry axis.

#include <goishi/motion/free_flight.hpp>
#include <goishi/vector.hpp>
#include <limits>

namespace goishi {

/// How a stone flies: its centre on a parabola, its symmetry axis precessing about a fixed direction.
///
///     p(t) = p + v t + a t²/2,   u(t) = (k·u) k + cos(Ω t) (u − (k·u) k) + sin(Ω t) k × u
template <class T>
struct FlightPath {
  Vec3<T> p_W = Vec3<T>::Constant(scalar::unset<T>());  // [m]
  Vec3<T> v_W = Vec3<T>::Constant(scalar::unset<T>());  // [m/s]
  Vec3<T> a_W = Vec3<T>::Constant(scalar::unset<T>());  // [m/s²]
  Vec3<T> u_W = Vec3<T>::Constant(scalar::unset<T>());  // unit, symmetry axis at t = 0
  Vec3<T> k_W = {T(0), T(0), T(1)};                     // unit, direction of the angular momentum
  T rate = T(0);                                        // Ω = |L|/I_t [rad/s]
};

namespace formula {

/// Where the centre is at the time t.
/// Proof  derivations/flight_path.cpp, as of all below.
template <Field T>
[[nodiscard]] inline Vec3<T> centre_at(const FlightPath<T>& path, const T& t) {
  const T half = t / T(2);
  return {T(path.p_W.x() + t * (path.v_W.x() + half * path.a_W.x())),
          T(path.p_W.y() + t * (path.v_W.y() + half * path.a_W.y())),
          T(path.p_W.z() + t * (path.v_W.z() + half * path.a_W.z()))};
}

/// The axis turned about k by the angle of this sine and cosine (Rodrigues).
template <Field T>
[[nodiscard]] inline Vec3<T> axis_turned(const FlightPath<T>& path, const scalar::SineCosine<T>& turn) {
  const Vec3<T> along = formula::scaled(formula::dot(path.k_W, path.u_W), path.k_W);
  return formula::plus(along, formula::combination(turn.cos, formula::minus(path.u_W, along), turn.sin,
                                                   formula::cross(path.k_W, path.u_W)));
}

/// The axis at the time t: u turned about k by Ωt.
template <Elementary T>
[[nodiscard]] inline Vec3<T> axis_at(const FlightPath<T>& path, const T& t) {
  return formula::axis_turned(path, scalar::sincos(T(path.rate * t)));
}

/// Sine and cosine of an angle that is greater by δ, to O(δ³): their Taylor polynomials.
template <Field T>
[[nodiscard]] inline scalar::SineCosine<T> turned_on(const scalar::SineCosine<T>& turn, const T& delta) {
  const T half = delta / T(2);
  return {.sin = T(turn.sin + delta * (turn.cos - half * turn.sin)),
          .cos = T(turn.cos - delta * (turn.sin + half * turn.cos))};
}

}  // namespace formula

/// How a body with a symmetry axis flies from a state: what `time_of_impact` asks for.
/// Domain  a state and a mobility as `free_flight` takes them.
template <Ordered T>
[[nodiscard]] FlightPath<T> path_of(const State<T>& state, const Mobility<T>& mobility, const Vec3<T>& gravity) {
  FlightPath<T> path{.p_W = state.p_WB, .v_W = state.v_WB, .a_W = gravity, .u_W = symmetry_axis(state.q_WB)};
  const T square = formula::dot(state.L_W, state.L_W);
  // So small that its square has lost digits, it turns nothing.
  if (std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon() < square) {
    const T momentum = scalar::sqrt(square);
    path.k_W = {T(state.L_W.x() / momentum), T(state.L_W.y() / momentum), T(state.L_W.z() / momentum)};
    path.rate = momentum * mobility.transverse;
  }
  return path;
}

/// The same, from the moments.
template <Ordered T>
[[nodiscard]] FlightPath<T> path_of(const State<T>& state, const Moments<T>& moments, const Vec3<T>& gravity) {
  return path_of(state, make_mobility(moments), gravity);
}

}  // namespace goishi
