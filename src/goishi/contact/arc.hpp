#pragma once
/// \file
/// An edge of the board: a quarter circle of normals n = a cos t + b sin t, and the separation along them.

#include <goishi/contact/contact.hpp>
#include <limits>

namespace goishi {

namespace detail {

/// The stone's centre, relative to the edge, and its axis, along the two normals a and b; `u_out` is the axis along the edge.
template <class T>
struct Arc {
  T p_a, p_b;
  T u_a, u_b, u_out;
};

/// A normal of the arc, what the separation is there, and its slope by t.
template <class T>
struct ArcPoint {
  T a, b;  // cos t, sin t
  T value, slope;
  T curvature;  // −f'' = f + ρ, ρ the radius of curvature of the stone's outline
  T axial;      // m = u · n
  // κ: the core's support point is (…) n − κ u, so p + κ u is what the separation turns about: f' = (p + κ u) · n'.
  T lever;
};

/// What a normal of the arc sees of the stone.
template <class T>
struct ArcView {
  T axial, axial_rate;  // m = u · n, and m' by t
  T radial_square;      // 1 − m²
  T centre, centre_rate;
};

}  // namespace detail

namespace formula {

/// u · n and p · n along n = (a, b) = (cos t, sin t), their slopes by t, and 1 − m² = m'² + u_out², where nothing
/// cancels.
/// Proof  derivations/edges.cpp, as of all below.
template <Field T>
[[nodiscard]] inline detail::ArcView<T> arc_view(const detail::Arc<T>& arc, const T& a, const T& b) {
  const T axial_rate = arc.u_b * a - arc.u_a * b;
  return {.axial = T(arc.u_a * a + arc.u_b * b),
          .axial_rate = axial_rate,
          .radial_square = T(scalar::sq(axial_rate) + scalar::sq(arc.u_out)),
          .centre = T(arc.p_a * a + arc.p_b * b),
          .centre_rate = T(arc.p_b * a - arc.p_a * b)};
}

/// The separation there, its slope and −f'' = f + r, where the normal meets the cap on its side of the stone: `axial`
/// = |m|, `lever` = ±d.
template <Field T>
[[nodiscard]] inline detail::ArcPoint<T> arc_on_cap(const Stone<T>& stone, const detail::ArcView<T>& view, const T& a,
                                                    const T& b, const T& axial, const T& lever) {
  const T value = view.centre - formula::cap_support(stone, axial, view.radial_square);
  return {.a = a,
          .b = b,
          .value = value,
          .slope = T(view.centre_rate + lever * view.axial_rate),
          .curvature = T(value + stone.sphere_radius),
          .axial = view.axial,
          .lever = lever};
}

/// The same where it meets the rim, whose outline is an ellipse, moved out by r₂: κ = r₁ m/n_r, −f'' = f + r₁
/// u_out²/n_r³ + r₂.
template <Field T>
[[nodiscard]] inline detail::ArcPoint<T> arc_on_rim(const Stone<T>& stone, const detail::ArcView<T>& view, const T& a,
                                                    const T& b, const T& u_out, const T& radial) {
  const T value = view.centre - formula::rim_support(stone, radial);
  const T ring = stone.bevel_major_radius / radial;
  const T lever = ring * view.axial;
  return {.a = a,
          .b = b,
          .value = value,
          .slope = T(view.centre_rate + lever * view.axial_rate),
          .curvature = T(value + ring * scalar::sq(u_out) / view.radial_square + stone.bevel_minor_radius),
          .axial = view.axial,
          .lever = lever};
}

/// What the separation would be at the normal (n_a, n_b), from its value and slope at another, if the outline's radius
/// of curvature were ρ between them: (f + ρ) n₀ · n + f' n₀' · n − ρ, without adding ρ and taking it off, which may be
/// many widths.
template <Field T>
[[nodiscard]] inline T arc_line(const detail::ArcPoint<T>& from, const T& rho, const T& n_a, const T& n_b) {
  const T along = from.a * n_a + from.b * n_b, across = from.a * n_b - from.b * n_a;
  const T chord2 = scalar::sq(T(n_a - from.a)) + scalar::sq(T(n_b - from.b));
  return from.value * along + from.slope * across - rho * chord2 / T(2);
}

/// The vector w of which that is w · n − ρ, along (a, b).
template <Field T>
[[nodiscard]] inline T arc_line_a(const detail::ArcPoint<T>& from, const T& rho) {
  return (from.value + rho) * from.a - from.slope * from.b;
}
template <Field T>
[[nodiscard]] inline T arc_line_b(const detail::ArcPoint<T>& from, const T& rho) {
  return (from.value + rho) * from.b + from.slope * from.a;
}

/// The radius of curvature of the rim's outline where 1 − m² = n_r² is `square`, `radial` its root: r₁ u_out²/n_r³ + r₂.
template <Field T>
[[nodiscard]] inline T arc_rim_radius(const Stone<T>& stone, const T& u_out, const T& square, const T& radial) {
  return stone.bevel_minor_radius + stone.bevel_major_radius * scalar::sq(u_out) / (square * radial);
}

/// |v × u|² of v = p + x u across the edge, whatever x, `size_square` its square: of a thin stone only that tells one
/// angle from another.
template <Field T>
[[nodiscard]] inline T arc_cap_radial_square(const detail::Arc<T>& arc, const T& size_square) {
  return scalar::sq(T(arc.p_a * arc.u_b - arc.p_b * arc.u_a)) + size_square * scalar::sq(arc.u_out);
}

/// The separation reach − r where the normal is along p + `sign` d u, of the length reach, without that difference: of
/// thin stones the two are large. reach² − r² = p² + 2 d p · u − d² u_out² − (r − d)(r + d), across the edge, u along
/// the cap.
template <Field T>
[[nodiscard]] T arc_cap_value(const Stone<T>& stone, const detail::Arc<T>& arc, const T& sign, const T& reach) {
  const T& d = stone.sphere_offset;
  const T along = arc.p_a * arc.u_a + arc.p_b * arc.u_b;
  const T square = scalar::sq(arc.p_a) + scalar::sq(arc.p_b) + T(2) * sign * d * along - scalar::sq(T(d * arc.u_out)) -
                   stone.height / T(2) * (stone.sphere_radius + d);
  return square / (reach + stone.sphere_radius);
}

}  // namespace formula

namespace detail {

template <Ordered T>
[[nodiscard]] ArcPoint<T> arc_point(const Stone<T>& stone, const Arc<T>& arc, const T& a, const T& b) {
  const ArcView<T> view = formula::arc_view(arc, a, b);
  const T& m = view.axial;
  const Direction<T> n{
      .axial = scalar::abs(m), .radial = scalar::sqrt(view.radial_square), .radial_square = view.radial_square};
  return meets_cap(stone, n) ? formula::arc_on_cap(stone, view, a, b, n.axial,
                                                   m < T(0) ? T(-stone.sphere_offset) : T(stone.sphere_offset))
                             : formula::arc_on_rim(stone, view, a, b, arc.u_out, n.radial);
}

/// Whether the cores of stone and board are apart along a normal. A local maximum of the separation where they are is the
/// only one: it is the distance of two convex bodies.
template <Ordered T>
[[nodiscard]] bool is_apart(const Stone<T>& stone, const ArcPoint<T>& point) {
  return T(0) < point.value + stone.bevel_minor_radius;
}

/// The maximum on the cap that looks along `sign` u: n along p + sign d u, `reach` its length; the cores are apart there
/// if it is longer than R. False where there is none.
template <Ordered T>
[[nodiscard]] bool has_cap_maximum(const Stone<T>& stone, const Arc<T>& arc, const T& sign, T& a, T& b, T& reach) {
  a = arc.p_a + sign * stone.sphere_offset * arc.u_a;
  b = arc.p_b + sign * stone.sphere_offset * arc.u_b;
  if (!(T(0) < a && T(0) < b)) {
    return false;
  }
  // n_r sin α <= m cos α, by squares.
  const T size2 = scalar::sq(a) + scalar::sq(b);
  const T m = sign * (arc.u_a * a + arc.u_b * b);
  const T radial2 = formula::arc_cap_radial_square(arc, size2);
  if (!(T(0) <= m && radial2 * scalar::sq(stone.joint_sine) <= scalar::sq(T(m * stone.joint_cosine)))) {
    return false;
  }
  reach = scalar::sqrt(size2);
  a = a / reach;
  b = b / reach;
  return true;
}

/// The normal that divides the chord of two others.
template <Ordered T>
[[nodiscard]] ArcPoint<T> between(const Stone<T>& stone, const Arc<T>& arc, const ArcPoint<T>& low,
                                  const ArcPoint<T>& high, const T& weight) {
  const T a = low.a + weight * (high.a - low.a), b = low.b + weight * (high.b - low.b);
  const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
  return arc_point(stone, arc, T(a * over), T(b * over));
}

/// Whether Newton's method may stop after a step: what a step leaves is, where it converges, step³/previous², and that is
/// to be nothing beside what a normal is good for. Where the curvature changes fast (a sharp rim that touches), steps do
/// not shrink by their squares, and it goes on. So it does where a step may cross the joint, unless nothing is left to
/// gain: beyond the joint the curvature is another, and so is the step.
template <Ordered T>
[[nodiscard]] bool leaves_nothing(const Stone<T>& stone, const ArcPoint<T>& at, const T& step2, const T& previous2) {
  const T epsilon = std::numeric_limits<T>::epsilon();
  const T to_joint = scalar::abs(T(at.axial)) - stone.joint_sine;
  if (scalar::sq(to_joint) <= step2 && scalar::sq(T(epsilon * outer_width(stone))) < scalar::sq(at.slope)) {
    return false;
  }
  return step2 <= T(4096) * epsilon && step2 * scalar::sq(step2) <= scalar::sq(T(T(256) * epsilon * previous2));
}

/// The normal of a point turned by a step that is the last, and the separation that it gains.
template <Ordered T>
void finish(ArcPoint<T>& point, const T& step) {
  point.value = point.value + point.slope * step / T(2);
  const T over = T(1) / scalar::sqrt(T(T(1) + scalar::sq(step)));
  const T a = over * (point.a - step * point.b), b = over * (point.b + step * point.a);
  point.a = a;
  point.b = b;
  point.slope = T(0);
}

/// A zero of the slope between two normals, positive at the first and negative at the second: Newton's method, and
/// bisection where it leaves the interval or does not halve the slope.
template <Ordered T>
[[nodiscard]] ArcPoint<T> bracketed(const Stone<T>& stone, const Arc<T>& arc, ArcPoint<T> low, ArcPoint<T> high) {
  constexpr int most_steps = 100;
  const T weight = low.slope / (low.slope - high.slope);
  ArcPoint<T> now = between(stone, arc, low, high, weight);
  T previous2(0);
  for (int i = 0; i < most_steps; ++i) {
    const T size = scalar::abs(now.slope);
    if (!(T(0) < size)) {
      break;
    }
    (T(0) < now.slope ? low : high) = now;
    const T step = now.slope / now.curvature;
    const T a = now.a - step * now.b, b = now.b + step * now.a;
    const bool inside = T(0) < now.curvature && T(0) < low.a * b - low.b * a && T(0) < a * high.b - b * high.a;
    if (inside) {
      if (leaves_nothing(stone, now, scalar::sq(step), previous2)) {
        finish(now, step);
        break;
      }
      previous2 = scalar::sq(step);
      const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
      now = arc_point(stone, arc, T(a * over), T(b * over));
      if (T(2) * scalar::abs(now.slope) <= size) {
        continue;
      }
      (T(0) < now.slope ? low : high) = now;
    }
    if (scalar::sq(T(high.a - low.a)) + scalar::sq(T(high.b - low.b)) <=
        scalar::sq(std::numeric_limits<T>::epsilon())) {
      break;
    }
    previous2 = T(0);
    now = between(stone, arc, low, high, T(T(1) / T(2)));
  }
  now.slope = T(0);
  return now;
}

/// Newton's method from where the rim would be met if the stones touched: there the core's gap is r₂, and
/// n ∥ p + κ u with κ = (p · u) r₁²/(r₁² u_out² + r₁ r₂), p and u across the edge. False where it leaves the arc or takes
/// its time.
template <Ordered T>
[[nodiscard]] bool find_rim_maximum(const Stone<T>& stone, const Arc<T>& arc, ArcPoint<T>& found) {
  constexpr int most_steps = 6;
  const T& r1 = stone.bevel_major_radius;
  const T lever =
      (arc.p_a * arc.u_a + arc.p_b * arc.u_b) * r1 / (r1 * scalar::sq(arc.u_out) + stone.bevel_minor_radius);
  T a = arc.p_a + lever * arc.u_a, b = arc.p_b + lever * arc.u_b;
  T previous2(0);
  for (int i = 0; i < most_steps; ++i) {
    if (!(T(0) < a && T(0) < b)) {
      return false;
    }
    const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
    found = arc_point(stone, arc, T(a * over), T(b * over));
    const T step = found.slope / found.curvature;
    const T step2 = scalar::sq(step);
    a = found.a - step * found.b;
    b = found.b + step * found.a;
    if (leaves_nothing(stone, found, step2, previous2)) {
      if (!(T(0) < a && T(0) < b)) {
        return false;  // the last step leaves the arc
      }
      finish(found, step);
      return is_apart(stone, found);
    }
    previous2 = step2;
  }
  return false;
}

/// Finds the greatest separation of an arc if the cores are apart there; else false.
template <Ordered T>
[[nodiscard]] bool find_apart(const Stone<T>& stone, const Arc<T>& arc, ArcPoint<T>& found) {
  for (const T& sign : {T(1), T(-1)}) {
    T a, b, reach;
    if (has_cap_maximum(stone, arc, sign, a, b, reach) && stone.core_sphere_radius < reach) {
      found = {.a = a,
               .b = b,
               .value = formula::arc_cap_value(stone, arc, sign, reach),
               .slope = T(0),
               .curvature = reach,
               .axial = arc.u_a * a + arc.u_b * b,
               .lever = sign * stone.sphere_offset};
      return true;
    }
  }
  if (find_rim_maximum(stone, arc, found)) {
    return true;
  }
  const ArcPoint<T> first = arc_point(stone, arc, T(1), T(0));
  if (!(T(0) < first.slope)) {
    found = first;
    return is_apart(stone, found);
  }
  const ArcPoint<T> last = arc_point(stone, arc, T(0), T(1));
  found = last.slope < T(0) ? bracketed(stone, arc, first, last) : last;
  return is_apart(stone, found);
}

}  // namespace detail
}  // namespace goishi
