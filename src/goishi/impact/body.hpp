#pragma once
/// \file
/// A body with a symmetry axis at the moment of an impact: how it answers to an impulse at one of its points.
///
/// Here and in the headers of the default law, `inline` is for speed: without the word g++ 12 leaves templates of this
/// length out of line, and their vectors go through memory.

#include <goishi/error.hpp>
#include <goishi/mass/rigid_body.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/surface.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// A body as an impact sees it. NaN until set.
template <class T>
struct ImpactBody {
  Mobility<T> mobility;
  Vec3<T> p_WB = Vec3<T>::Constant(scalar::unset<T>());  // [m] centre of mass
  Vec3<T> u_W = Vec3<T>::Constant(scalar::unset<T>());   // unit, symmetry axis (`symmetry_axis` of the attitude)
  Vec3<T> v_WB = Vec3<T>::Constant(scalar::unset<T>());  // [m/s]
  Vec3<T> L_W = Vec3<T>::Constant(scalar::unset<T>());   // [kg m²/s] about the centre of mass
};

/// What an impulse changes of a body.
template <class T>
struct BodyVelocity {
  Vec3<T> v_WB = Vec3<T>::Constant(scalar::unset<T>());  // [m/s]
  Vec3<T> L_W = Vec3<T>::Constant(scalar::unset<T>());   // [kg m²/s]
};

namespace formula {

/// Velocity of the body's point at r from its centre of mass   [m/s]: v + ω × r.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> point_velocity(const ImpactBody<T>& body, const Vec3<T>& r_W) {
  return formula::plus(body.v_WB, formula::cross(formula::turning(body.mobility, body.u_W, body.L_W), r_W));
}

/// By how much an impulse p at r from the centre of mass changes the velocity there   [m/s]:
///
///     W p = p/m + (I⁻¹ (r × p)) × r
///
/// n · W n for a unit vector n is the talk's K(n)   [1/kg]: what the velocity along n gains for each unit of impulse
/// along n. For a point whose normal goes through the centre of mass it is 1/m.
/// Domain  u unit.   Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] inline Vec3<T> response(const Mobility<T>& mobility, const Vec3<T>& u_W, const Vec3<T>& r_W,
                                      const Vec3<T>& impulse_W) {
  const Vec3<T> turned = formula::cross(formula::turning(mobility, u_W, formula::cross(r_W, impulse_W)), r_W);
  return formula::plus(turned, mobility.linear, impulse_W);
}

/// The body after an impulse p at r from its centre of mass: v + p/m, L + r × p.
/// Proof  derivations/impact.cpp.
template <Field T>
[[nodiscard]] BodyVelocity<T> pushed(const ImpactBody<T>& body, const Vec3<T>& r_W, const Vec3<T>& impulse_W) {
  return {.v_WB = formula::plus(body.v_WB, body.mobility.linear, impulse_W),
          .L_W = formula::plus(body.L_W, formula::cross(r_W, impulse_W))};
}

}  // namespace formula

namespace detail {

/// As `require_body`, one by one.
template <Ordered T>
void require_each_of(const ImpactBody<T>& body) {
  const auto require_each = [](const char* argument, const Vec3<T>& v) {
    for (const T& coordinate : v) {
      require(scalar::is_finite(coordinate), argument, coordinate, "must be finite");
    }
  };
  require_each("position", body.p_WB);
  require_each("velocity", body.v_WB);
  require_each("angular momentum", body.L_W);
  require_direction(body.u_W, "axis");
  const Mobility<T>& m = body.mobility;
  require(T(0) <= m.linear && scalar::is_finite(m.linear), "mobility", m.linear,
          "must be that of a body: use make_mobility");
  // 1/I_a >= 0, whatever the sign of the difference.
  require(T(0) <= m.transverse && scalar::is_finite(m.transverse) && T(0) <= m.transverse + m.axial &&
              scalar::is_finite(m.axial),
          "mobility", m.transverse, "must be that of a body: use make_mobility");
}

/// Throws InvalidArgument unless everything is finite, the axis a unit vector, and the mobility that of a body. A sum
/// is finite only if all its parts are.
template <Ordered T>
inline void require_body(const ImpactBody<T>& body) {
  const auto sum = [](const Vec3<T>& v) { return T(v.x() + v.y() + v.z()); };
  const Mobility<T>& m = body.mobility;
  const T turning = m.transverse + m.axial;
  const T all = (sum(body.p_WB) + sum(body.v_WB)) + (sum(body.L_W) + (m.linear + turning));
  if (!(scalar::is_finite(all) && is_unit(body.u_W) && T(0) <= m.linear && T(0) <= m.transverse && T(0) <= turning))
      [[unlikely]] {
    require_each_of(body);
  }
}

}  // namespace detail
}  // namespace goishi
