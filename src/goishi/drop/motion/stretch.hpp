#pragma once
/// \file
/// A stretch of a drop's motion: what its state is at any time of it. A flight and a series of bounces are closed forms,
/// a stretch of contact is a polynomial in the variables that were integrated.

#include <array>
#include <cstddef>
#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>
#include <goishi/motion/free_flight.hpp>
#include <optional>
#include <variant>

namespace goishi::detail {

/// Which equations hold: no slip, dry slip, slip under a smooth law of friction or none.
enum class ContactMode { rolling, sliding, gliding };

/// What of a contact stays as it is along a stretch of it. The attitude is `q_origin`, carried with the symmetry axis from
/// `origin` by the shortest rotation, and turned about it by the spin angle.
template <class T>
struct ContactFrame {
  Feature feature = Feature::rim;
  ContactMode mode = ContactMode::rolling;
  T level = T(0);  // [m] z of what is touched
  Vec3<T> origin = Vec3<T>::Zero();
  Quat<T> q_origin = Quat<T>::Identity();
};

/// The slip as a vector along the plane.
template <Ordered T>
[[nodiscard]] std::array<T, 2> slip_of(ContactMode mode, const Variables<T>& y) {
  if (mode == ContactMode::sliding) {
    const auto [s, c] = scalar::sincos(y[at::direction]);
    return {T(y[at::slip] * c), T(y[at::slip] * s)};
  }
  return {y[at::slip], y[at::direction]};
}

/// At a unit axis u.
template <Ordered T>
[[nodiscard]] inline Quat<T> attitude_of(const ContactFrame<T>& frame, const Vec3<T>& u, const T& spin) {
  return formula::reunited(formula::carried_attitude(frame.origin, frame.q_origin, u, spin));
}

/// The state of the world at the variables of a contact, with the motion there.
template <Ordered T>
[[nodiscard]] State<T> state_of(const ContactFrame<T>& frame, const Variables<T>& y, const ContactPlace<T>& now,
                                const T& mass) {
  const std::array<T, 2> s = slip_of(frame.mode, y);
  State<T> state;
  state.p_WB = {y[at::x], y[at::y], T(frame.level + now.height)};
  state.q_WB = attitude_of<T>(frame, now.u, y[at::spin]);
  state.v_WB = formula::centre_velocity(now, s[0], s[1]);
  state.L_W = mass * now.L;
  return state;
}

template <class T>
struct Standing {
  State<T> state;
};

template <class T>
struct Flying {
  State<T> from;
  Vec3<T> gravity;
};

/// Bounces that the drop sums: after the one that leaves with v come e v, e² v …, each of which lasts 2 v/g. Between
/// them nothing but the height changes its rate.
template <class T>
struct Bouncing {
  State<T> from;  // leaving
  T g, restitution;
};

/// Energy and losses, per unit of mass, at both ends of a stretch: the velocities along it are taken to what lies between,
/// as those at its ends are.
template <class T>
struct Ledger {
  T begin, end;     // [m²/s²]
  T slack;          // [m/s] by which they are off at most
  Vec3<T> gravity;  // that it is kept in
};

/// What a ledger may take of a kinetic energy, or add: no more than a step's error is.
template <Ordered T>
[[nodiscard]] T taken_of(const T& kinetic, const T& excess, const T& slack) {
  const T step_error = T(2) * slack * scalar::sqrt(kinetic);
  const T most = step_error < T(0.01) * kinetic ? step_error : T(T(0.01) * kinetic);
  return excess < -most ? T(-most) : most < excess ? most : excess;
}

template <class T>
struct Touching {
  ContactFrame<T> frame;
  Interpolant<T, variables> along;
  T length;  // [s] of its whole
  std::optional<Ledger<T>> ledger;
};

/// In time   [s]; an end may be infinite.
template <class T>
struct Stretch {
  T begin, end;
  std::variant<Standing<T>, Flying<T>, Bouncing<T>, Touching<T>> motion;
};

/// The least power eⁿ, n = 0, 1, …, that is not below `least`: by squares, e², e⁴, e⁸ …, from the greatest exponent down.
/// Domain  0 < least <= 1, 0 < e < 1.
template <Ordered T>
[[nodiscard]] T least_power(const T& e, const T& least) {
  constexpr std::size_t most = 256;  // squares: of a rational number next to 1 in any type
  std::array<T, most> squares;
  std::size_t count = 0;
  for (T power = e; count < most && least <= power; power = scalar::sq(power)) {
    squares[count++] = power;
  }
  T result(1);
  while (0 < count) {
    const T next = result * squares[--count];
    result = least <= next ? next : result;
  }
  return result;
}

/// A time t after the first bounce: n bounces later, which take first (1 − eⁿ)/(1 − e).
template <Ordered T>
[[nodiscard]] State<T> bouncing(const Bouncing<T>& motion, const Mobility<T>& mobility, const T& t) {
  using Wide = scalar::wider_t<T>;
  State<T> state = motion.from;
  const T v = state.v_WB.z();
  state.v_WB.z() = T(0);
  state = formula::free_flight(state, mobility, Vec3<T>(Vec3<T>::Zero()), t);
  const T& e = motion.restitution;
  const T first = T(2) * v / motion.g, left = T(1) - t * (T(1) - e) / first;
  if (!(T(0) < v) || !(T(0) < left) || !(T(0) < e && e < T(1))) {
    return state;
  }
  const Wide power = least_power(Wide(e), Wide(left < T(1) ? left : T(1)));
  const T begin = first * T((Wide(1) - power) / (Wide(1) - Wide(e)));
  const T s = t < begin ? T(0) : T(t - begin), up = v * T(power);
  const T height = s * (up - motion.g * s / T(2));
  state.p_WB.z() = state.p_WB.z() + (height < T(0) ? T(0) : height);
  state.v_WB.z() = up - motion.g * s;
  return state;
}

/// Takes the velocities to what a ledger has at a share of its stretch, all by one factor.
template <Ordered T>
void keep_ledger(State<T>& state, const ContactPlace<T>& now, const T& loss, const Ledger<T>& ledger, const T& theta) {
  const Vec3<T>& v = state.v_WB;
  const T kinetic = (formula::dot(now.L, now.w) + formula::dot(v, v)) / T(2);
  const T energy = formula::contact_energy(now, ledger.gravity, T(state.p_WB.x()), T(state.p_WB.y()), kinetic);
  if (T(0) < kinetic) {
    const T excess = energy + loss - (ledger.begin + theta * (ledger.end - ledger.begin));
    const T factor = formula::slowing(taken_of<T>(kinetic, excess, ledger.slack), kinetic);
    state.v_WB = formula::scaled(factor, v);
    state.L_W = formula::scaled(factor, state.L_W);
  }
}

/// The state at a time of a stretch.
template <Ordered T>
[[nodiscard]] State<T> state_in(const Stretch<T>& stretch, const T& time, const ContactBody<T>& body,
                                const Mobility<T>& mobility, const T& mass) {
  const T t = time - stretch.begin;
  if (const auto* touching = std::get_if<Touching<T>>(&stretch.motion)) {
    const T theta = t < touching->length ? T(t / touching->length) : T(1);
    const Variables<T> y = touching->along(theta);
    const ContactPlace<T> now = place_of(body, touching->frame.feature, y);
    State<T> state = state_of<T>(touching->frame, y, now, mass);
    if (touching->ledger) {
      keep_ledger<T>(state, now, y[at::loss], *touching->ledger, theta);
    }
    return state;
  }
  if (const auto* flying = std::get_if<Flying<T>>(&stretch.motion)) {
    return T(0) < t ? formula::free_flight(flying->from, mobility, flying->gravity, t) : flying->from;
  }
  if (const auto* bounces = std::get_if<Bouncing<T>>(&stretch.motion)) {
    return bouncing(*bounces, mobility, t);
  }
  return std::get<Standing<T>>(stretch.motion).state;
}

}  // namespace goishi::detail
