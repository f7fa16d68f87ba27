#pragma once
/// \file
/// The contact matrix: what the velocity at a contact gains for each unit of impulse there, in every direction.

#include <goishi/impact/body.hpp>

namespace goishi {

/// A symmetric 3 × 3 matrix. NaN until set.
template <class T>
struct ContactMatrix {
  T xx = scalar::unset<T>();
  T yy = scalar::unset<T>();
  T zz = scalar::unset<T>();
  T xy = scalar::unset<T>();
  T xz = scalar::unset<T>();
  T yz = scalar::unset<T>();
};

/// The contact matrix of one body by its parts (`formula::point_matrix`): an impulse takes no matrix to answer, nor its
/// inverse. NaN until set.
template <class T>
struct PointMatrix {
  Mobility<T> mobility;
  T across = scalar::unset<T>();  // 1/m + r²/I_t [1/kg]
  Vec3<T> r_W = Vec3<T>::Constant(scalar::unset<T>());
  Vec3<T> c_W = Vec3<T>::Constant(scalar::unset<T>());  // r × u, across r
};

namespace formula {

/// The same matrix by its parts.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline PointMatrix<T> point_matrix(const Mobility<T>& mobility, const Vec3<T>& u_W, const Vec3<T>& r_W) {
  const Vec3<T> c = formula::cross(r_W, u_W);
  return {.mobility = {mobility.linear, mobility.transverse, mobility.axial},
          .across = T(mobility.linear + mobility.transverse * formula::dot(r_W, r_W)),
          .r_W = {r_W.x(), r_W.y(), r_W.z()},
          .c_W = {c.x(), c.y(), c.z()}};
}

/// W p = (1/m + r²/I_t) p − (r · p) r/I_t + (1/I_a − 1/I_t)(c · p) c.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> product(const PointMatrix<T>& W, const Vec3<T>& p) {
  const T along_r = -(W.mobility.transverse * formula::dot(W.r_W, p));
  const T along_c = W.mobility.axial * formula::dot(W.c_W, p);
  return formula::plus(formula::combination(W.across, p, along_r, W.r_W), along_c, W.c_W);
}

/// W⁻¹ v: r and c are two of its eigenvectors, of the values 1/m and λ_c = 1/m + r²/I_t + (1/I_a − 1/I_t) c².
///
///     W⁻¹ v = (v + (m/I_t)(r · v) r − (1/I_a − 1/I_t)(c · v) c / λ_c) / (1/m + r²/I_t)
///
/// Domain  1/m > 0, and no quotient overflows.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> solution(const PointMatrix<T>& W, const Vec3<T>& v) {
  const T over = T(1) / W.across;
  const T along_r = W.mobility.transverse / W.mobility.linear * formula::dot(W.r_W, v);
  const T along_c =
      -(W.mobility.axial / (W.across + W.mobility.axial * formula::dot(W.c_W, W.c_W)) * formula::dot(W.c_W, v));
  return formula::combination(over, v, T(over * along_r), W.r_W, T(over * along_c), W.c_W);
}

/// The contact matrix of a body at r from its centre of mass, in W   [1/kg]: an impulse p there changes the velocity
/// there by W p (`response`). With c = r × u,
///
///     W = (1/m) 1 − [r]× I⁻¹ [r]× = (1/m) 1 + (1/I_t)(|r|² 1 − r rᵀ) + (1/I_a − 1/I_t) c cᵀ
///
/// No tensor in W is built. Symmetric; its least eigenvalue is 1/m, along r.
/// Domain  u unit.   Limits  r = 0: 1/m.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline ContactMatrix<T> contact_matrix(const Mobility<T>& mobility, const Vec3<T>& u_W,
                                                     const Vec3<T>& r_W) {
  const T x2 = scalar::sq(r_W.x()), y2 = scalar::sq(r_W.y()), z2 = scalar::sq(r_W.z());
  const T& t = mobility.transverse;
  const Vec3<T> c = formula::cross(r_W, u_W);
  const T cx = mobility.axial * c.x(), cy = mobility.axial * c.y(), cz = mobility.axial * c.z();
  return {.xx = T(mobility.linear + t * (y2 + z2) + cx * c.x()),
          .yy = T(mobility.linear + t * (z2 + x2) + cy * c.y()),
          .zz = T(mobility.linear + t * (x2 + y2) + cz * c.z()),
          .xy = T(cx * c.y() - t * (r_W.x() * r_W.y())),
          .xz = T(cx * c.z() - t * (r_W.x() * r_W.z())),
          .yz = T(cy * c.z() - t * (r_W.y() * r_W.z()))};
}

/// Of two bodies that push each other: the relative velocity gains what both do.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] ContactMatrix<T> sum(const ContactMatrix<T>& a, const ContactMatrix<T>& b) {
  return {.xx = T(a.xx + b.xx),
          .yy = T(a.yy + b.yy),
          .zz = T(a.zz + b.zz),
          .xy = T(a.xy + b.xy),
          .xz = T(a.xz + b.xz),
          .yz = T(a.yz + b.yz)};
}

/// W p.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] Vec3<T> product(const ContactMatrix<T>& W, const Vec3<T>& p) {
  return {T(W.xx * p.x() + W.xy * p.y() + W.xz * p.z()), T(W.xy * p.x() + W.yy * p.y() + W.yz * p.z()),
          T(W.xz * p.x() + W.yz * p.y() + W.zz * p.z())};
}

/// W⁻¹ v, by cofactors.
/// Domain  W positive definite, as a contact matrix is, and its determinant neither over- nor underflows (`resolve` scales it).
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> solution(const ContactMatrix<T>& W, const Vec3<T>& v) {
  const T a = W.yy * W.zz - W.yz * W.yz, b = W.xz * W.yz - W.xy * W.zz, c = W.xy * W.yz - W.xz * W.yy;
  const T d = W.xx * W.zz - W.xz * W.xz, e = W.xy * W.xz - W.xx * W.yz, f = W.xx * W.yy - W.xy * W.xy;
  const T scale = T(1) / (W.xx * a + W.xy * b + W.xz * c);
  return {T(scale * (a * v.x() + b * v.y() + c * v.z())), T(scale * (b * v.x() + d * v.y() + e * v.z())),
          T(scale * (c * v.x() + e * v.y() + f * v.z()))};
}

/// The same matrix in the frame of three orthonormal vectors: x along a, y along b, z along n.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] ContactMatrix<T> in_frame(const ContactMatrix<T>& W, const Vec3<T>& a, const Vec3<T>& b,
                                        const Vec3<T>& n) {
  const Vec3<T> Wa = formula::product(W, a), Wb = formula::product(W, b), Wn = formula::product(W, n);
  return {.xx = formula::dot(a, Wa),
          .yy = formula::dot(b, Wb),
          .zz = formula::dot(n, Wn),
          .xy = formula::dot(a, Wb),
          .xz = formula::dot(a, Wn),
          .yz = formula::dot(b, Wn)};
}

/// In the plane across z: the impulse (x, y, 0) that changes the velocity across z by (v_x, v_y), whatever it does
/// along z.
/// Domain  as of `solution`.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] Vec3<T> tangential_solution(const ContactMatrix<T>& W, const T& vx, const T& vy) {
  const T scale = T(1) / (W.xx * W.yy - W.xy * W.xy);
  return {T(scale * (W.yy * vx - W.xy * vy)), T(scale * (W.xx * vy - W.xy * vx)), T(0)};
}

}  // namespace formula
}  // namespace goishi
