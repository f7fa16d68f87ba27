#pragma once
/// \file
/// A contact of a cluster as the solver sees it.

#include <cstddef>
#include <goishi/contact/rim_rim.hpp>
#include <goishi/drop/rest/statics.hpp>
#include <goishi/impact/contact_matrix.hpp>
#include <goishi/scene/cluster/cone.hpp>
#include <limits>

namespace goishi {

namespace formula {

/// By how much the velocity of the point at r changes in time because the body turns, with no impulse   [m/s²]: ω × ṙ +
/// ω̇ × r. L does not change, so that ω̇ = (1/I_a − 1/I_t)(u · L) ω × u.
/// Proof  derivations/scene.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> carried_rate(const Mobility<T>& mobility, const Vec3<T>& u, const T& axial_momentum,
                                          const Vec3<T>& w, const Vec3<T>& r, const Vec3<T>& r_rate) {
  const Vec3<T> w_rate = formula::scaled(T(mobility.axial * axial_momentum), formula::cross(w, u));
  return formula::plus(formula::cross(w, r_rate), formula::cross(w_rate, r));
}

/// ṙ of the point of a plane that a cap touches, from the centre: r = ± d u − r n, `offset` = ± d.
/// Proof  derivations/scene.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> cap_contact_rate(const T& offset, const Vec3<T>& w, const Vec3<T>& u) {
  return formula::scaled(offset, formula::cross(w, u));
}

/// ṙ of the point of a plane that the rim touches: r = −r₁ e − r₂ n, e the unit vector along n − (u · n) u, n_r its length.
/// Proof  derivations/scene.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> rim_contact_rate(const T& major_radius, const Vec3<T>& w, const Vec3<T>& u,
                                              const Vec3<T>& n, const Vec3<T>& e, const T& n_r) {
  const Vec3<T> u_rate = formula::cross(w, u);
  const Vec3<T> q = formula::combination(T(-formula::dot(u_rate, n)), u, T(-formula::dot(u, n)), u_rate);
  return formula::scaled(T(-(major_radius / n_r)), formula::plus(q, T(-formula::dot(e, q)), e));
}

}  // namespace formula

namespace detail {

inline constexpr std::size_t no_index = std::numeric_limits<std::size_t>::max();

/// A body as the solver moves it.
template <class T>
struct Mover {
  Mobility<T> mobility;
  Vec3<T> u;  // axis
  Vec3<T> v, w;
  Vec3<T> free_v, free_w;  // with no contact
  T reach;                 // [m]

  /// m v² + ω · I ω   [J], of velocities that it may have.
  [[nodiscard]] T twice_kinetic_energy(const Vec3<T>& v_W, const Vec3<T>& w_W) const {
    const T axial = mobility.transverse + mobility.axial, along = formula::dot(u, w_W);
    const T turning = formula::dot(w_W, w_W) - scalar::sq(along);
    return formula::dot(v_W, v_W) / mobility.linear + turning / mobility.transverse + scalar::sq(along) / axial;
  }
};

template <class T>
struct Row {
  std::size_t a = no_index, b = no_index;  // bodies; no second one: what does not answer
  Vec3<T> n, t1, t2;                       // unit, n out of the second
  Vec3<T> ra, rb;                          // from the centres to the contact
  T friction, rolling, pivot;
  /// What is added to the velocity of the first relative to the second before it is judged: a gap that may close, that the
  /// bodies turn, that the second moves by itself. In the contact's frame.
  Vec3<T> bias;
  T turning = T(0);  // [m/s] b · n, what of it is due to turning
  T most = T(0);     // [m/s²] that turning is believed to do, by how fast all turns before the step

  ContactMatrix<T> W;
  Tangential<T> S;
  ContactMatrix<T> turn;  // (I_a⁻¹ + I_b⁻¹)⁻¹ in W
  Vec3<T> other_w;        // of a second that moves by itself

  Vec3<T> p;       // impulse, in the contact's frame
  Vec3<T> torque;  // angular impulse of resistance, in W

  [[nodiscard]] Vec3<T> in_world(const Vec3<T>& local) const {
    return formula::plus(formula::combination(T(local.x()), t1, T(local.y()), t2), T(local.z()), n);
  }
  [[nodiscard]] Vec3<T> in_frame(const Vec3<T>& world) const {
    return {formula::dot(t1, world), formula::dot(t2, world), formula::dot(n, world)};
  }
};

/// I⁻¹ of a body with an axis   [1/(kg m²)].
template <Ordered T>
[[nodiscard]] inline ContactMatrix<T> turning_matrix(const Mobility<T>& mobility, const Vec3<T>& u) {
  const T &t = mobility.transverse, &a = mobility.axial;
  return {.xx = T(t + a * u.x() * u.x()),
          .yy = T(t + a * u.y() * u.y()),
          .zz = T(t + a * u.z() * u.z()),
          .xy = T(a * u.x() * u.y()),
          .xz = T(a * u.x() * u.z()),
          .yz = T(a * u.y() * u.z())};
}

template <Ordered T>
[[nodiscard]] inline ContactMatrix<T> inverted(const ContactMatrix<T>& A) {
  const Vec3<T> x = formula::solution(A, Vec3<T>(T(1), T(0), T(0))),
                y = formula::solution(A, Vec3<T>(T(0), T(1), T(0))),
                z = formula::solution(A, Vec3<T>(T(0), T(0), T(1)));
  return {.xx = x.x(), .yy = y.y(), .zz = z.z(), .xy = y.x(), .xz = z.x(), .yz = z.y()};
}

/// Fills in what follows from bodies, normal and place.
template <Ordered T>
void prepare(Row<T>& row, const Mover<T>& a, const Mover<T>* b) {
  row.t1 = across(row.n);
  row.t2 = formula::cross(row.n, row.t1);
  ContactMatrix<T> W = formula::contact_matrix(a.mobility, a.u, row.ra);
  ContactMatrix<T> I = turning_matrix(a.mobility, a.u);
  if (b != nullptr) {
    W = formula::sum(W, formula::contact_matrix(b->mobility, b->u, row.rb));
    I = formula::sum(I, turning_matrix(b->mobility, b->u));
  }
  row.W = formula::in_frame(W, row.t1, row.t2, row.n);
  row.S = formula::tangential(row.W);
  if (T(0) < row.rolling) {
    row.turn = inverted(I);
  }
}

}  // namespace detail
}  // namespace goishi
