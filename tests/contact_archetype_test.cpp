/// Formulas of contact, impact and drop with the archetype of a scalar.

#include <gtest/gtest.h>

#include <goishi/contact/arc.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/contact/gap_along.hpp>
#include <goishi/contact/pair_closed.hpp>
#include <goishi/contact/rim_rim.hpp>
#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/contact_motion.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/resisting.hpp>
#include <goishi/drop/equations/slip.hpp>
#include <goishi/drop/phases/flight_phase.hpp>
#include <goishi/drop/rest/rest.hpp>
#include <goishi/drop/rest/statics.hpp>
#include <goishi/impact/contact_matrix.hpp>

#include "tests/scalar_archetype.hpp"

namespace goishi::archetype_test {

namespace {

template <class T>
Vec3<T> vector(int x, int y, int z) {
  return {T(x), T(y), T(z)};
}

/// A stone by whole numbers; nothing is asked of it but its fields.
template <class T>
Stone<T> whole_stone() {
  Stone<T> stone;
  stone.width = T(22);
  stone.height = T(9);
  stone.sphere_radius = T(15);
  stone.sphere_offset = T(11);
  stone.bevel_major_radius = T(10);
  stone.bevel_minor_radius = T(1);
  stone.core_sphere_radius = T(14);
  stone.joint_cosine = T(3) / T(5);
  return stone;
}

template <class T>
Mobility<T> whole_mobility() {
  return formula::mobility(T(1), Moments<T>{.axial = T(3), .transverse = T(2)});
}

template <class T>
void add(Numbers& numbers, const ContactMatrix<T>& W) {
  for (const T& number : {W.xx, W.yy, W.zz, W.xy, W.xz, W.yz}) {
    numbers.add(number);
  }
}

template <class T>
Numbers impact_formulas() {
  Numbers numbers;
  const Mobility<T> m = whole_mobility<T>();
  const Vec3<T> u(T(2) / T(3), T(1) / T(3), T(2) / T(3)), r = vector<T>(1, -2, 3), p = vector<T>(4, 5, -6);
  numbers.add(formula::turning(m, u, p));
  numbers.add(formula::response(m, u, r, p));
  const ImpactBody<T> body{m, vector<T>(0, 1, 2), u, vector<T>(3, -1, 2), vector<T>(-2, 5, 1)};
  numbers.add(formula::point_velocity(body, r));
  numbers.add(formula::pushed(body, r, p).L_W);
  const ContactMatrix<T> W = formula::contact_matrix(m, u, r);
  add(numbers, W);
  add(numbers, formula::sum(W, W));
  add(numbers, formula::in_frame(W, vector<T>(1, 0, 0), vector<T>(0, 0, 1), vector<T>(0, -1, 0)));
  numbers.add(formula::product(W, p));
  numbers.add(formula::solution(W, p));
  numbers.add(formula::tangential_solution(W, T(2), T(-3)));
  return numbers;
}

TEST(Archetype, RunsTheFormulasOfImpact) {
  expect_same(impact_formulas<VectorArchetype>(), impact_formulas<double>());
}

template <class T>
void add(Numbers& numbers, const ContactGeometry<T>& geometry) {
  numbers.add(geometry.height);
  numbers.add(geometry.slope);
  numbers.add(geometry.curvature);
}

template <class T>
Numbers rational_drop_formulas() {
  Numbers numbers;
  const Stone<T> stone = whole_stone<T>();
  const Vec3<T> u(T(2) / T(3), T(1) / T(3), T(2) / T(3)), L = vector<T>(1, -2, 3), gravity = vector<T>(1, 0, -10);
  add(numbers, formula::cap_contact(stone, T(1), T(u.z()), T(5) / T(9)));
  const ContactGeometry<T> rim = formula::rim_contact(stone, T(3) / T(5), T(4) / T(5));
  add(numbers, rim);
  const ContactMotion<T> now = formula::contact_motion(whole_mobility<T>(), gravity, rim, u, L);
  numbers.add(now.w);
  numbers.add(now.u_rate);
  numbers.add(now.r);
  numbers.add(now.spin_rate);
  numbers.add(now.point);
  numbers.add(now.need);
  add(numbers, now.W);
  numbers.add(formula::contact_kinetic_energy(now, T(2), T(-1)));
  const Vec3<T> brake = vector<T>(1, 2, 3);
  numbers.add(formula::rolling_force(now.W, brake, now.need));
  const SlipRate<T> slip = formula::slip_rate(now.W, brake, now.need, T(1) / T(3), T(3) / T(5), T(4) / T(5));
  for (const T& number : {slip.N, slip.denominator, slip.along, slip.across, slip.across_slope}) {
    numbers.add(number);
  }
  const GlideRate<T> glide = formula::glide_rate(now.W, brake, now.need, T(1) / T(7), T(2), T(-1));
  for (const T& number : {glide.N, glide.denominator, glide.x, glide.y}) {
    numbers.add(number);
  }
  const GlideSlope<T> slope = formula::glide_slope(now.W, brake, glide, T(1) / T(7), T(1) / T(5), T(2), T(-1), T(3));
  for (const T& number : {slope.xx, slope.xy, slope.yx, slope.yy}) {
    numbers.add(number);
  }
  numbers.add(formula::friction_force(T(3), T(2), T(1), T(-5)));
  numbers.add(formula::damped(T(3), T(2), T(-5)));
  numbers.add(formula::carried_spin_rate(vector<T>(0, 0, 1), u, L, T(5)));
  numbers.add(formula::turned_point(whole_mobility<T>(), u, now.r, brake));
  numbers.add(formula::centre_velocity(now, T(2), T(-1)));
  numbers.add(formula::contact_energy(now, gravity, T(2), T(-1), T(7)));
  const ContactGain<T> gain = formula::contact_gain(whole_mobility<T>(), now, L, brake);
  numbers.add(gain.point);
  numbers.add(formula::contact_work(L, brake, gain));
  numbers.add(formula::reunited_axis(u));
  const detail::Kinetics<T> kinetics{now, L, brake};
  const T damped = formula::damping_power(now, T(3), T(2), T(-1));
  for (const T& rate : formula::contact_rates(kinetics, L, T(3), damped, brake, T(2), T(-1), vector<T>(0, 0, 1))) {
    numbers.add(rate);
  }
  numbers.add(formula::resistance_slope(T(4), T(9), T(2), L, brake));
  numbers.add(formula::parts_along(u, L, brake, gravity));
  numbers.add(formula::bounces_time(T(3), T(10), T(1) / T(2)));
  return numbers;
}

TEST(Archetype, RunsTheRationalFormulasOfDrop) {
  expect_same(rational_drop_formulas<VectorArchetype>(), rational_drop_formulas<double>());
}

template <class T>
Numbers elementary_drop_formulas() {
  Numbers numbers;
  numbers.add(formula::resistance(T(4), T(9), vector<T>(1, -2, 3), T(1)));
  numbers.add(formula::patch_friction(T(1) / T(3), T(2), T(3), T(4), T(5)));
  const Vec3<T> u(T(2) / T(3), T(1) / T(3), T(2) / T(3));
  numbers.add(formula::shortest_rotation(vector<T>(0, 0, 1), u));
  numbers.add(formula::carried_attitude(vector<T>(0, 0, 1), Quat<T>(T(1), T(0), T(0), T(0)), u, T(2)));
  numbers.add(formula::resistance_share(u, vector<T>(1, -2, 3), T(2), T(4), T(9)));
  numbers.add(formula::resistance_lever(T(4), T(9), T(2), T(3)));
  numbers.add(formula::slowing(T(1), T(3)));
  return numbers;
}

TEST(Archetype, RunsTheElementaryFormulasOfDrop) {
  expect_same(elementary_drop_formulas<ElementaryVectorArchetype>(), elementary_drop_formulas<double>());
}

template <class T>
void add(Numbers& numbers, const detail::ArcPoint<T>& point) {
  for (const T& number : {point.a, point.b, point.value, point.slope, point.curvature, point.axial, point.lever}) {
    numbers.add(number);
  }
}

template <class T>
FlightPath<T> whole_path() {
  return {.p_W = vector<T>(1, 2, 3),
          .v_W = vector<T>(4, -5, 6),
          .a_W = vector<T>(0, 0, -10),
          .u_W = Vec3<T>(T(2) / T(3), T(1) / T(3), T(2) / T(3)),
          .k_W = vector<T>(0, 0, 1),
          .rate = T(7)};
}

template <class T>
Numbers rational_contact_formulas() {
  Numbers numbers;
  const Stone<T> stone = whole_stone<T>();
  numbers.add(formula::rim_slope(stone, T(3) / T(5), T(4) / T(5)));
  numbers.add(formula::support_point(formula::rim_support_reach(stone, T(4)), vector<T>(1, 2, 3), T(5)));
  numbers.add(formula::level_contact(vector<T>(1, 2, 3), T(4), T(5)));
  numbers.add(formula::centre_at(whole_path<T>(), T(3)));
  const Wobble<T> wobble = formula::wobble(stone, whole_path<T>(), vector<T>(0, 1, 0));
  numbers.add(formula::wobble_at(wobble, T(3) / T(5), T(4) / T(5)));
  numbers.add(formula::wobble_rate(wobble, T(3) / T(5), T(4) / T(5)));
  numbers.add(formula::parabola(T(1), T(2), T(3), T(4)));
  numbers.add(formula::parabola_rate(T(2), T(3), T(4)));
  numbers.add(formula::falling_square(T(1), T(2), T(3)));
  numbers.add(formula::falling_zero(T(1), T(-2), T(3)));
  numbers.add(formula::bending_zero(T(1), T(2), T(-3)));
  const detail::Arc<T> arc{T(1), T(2), T(3), T(4), T(5)};
  const T a = T(3) / T(5), b = T(4) / T(5);
  const detail::ArcView<T> view = formula::arc_view(arc, a, b);
  add(numbers, formula::arc_on_cap(stone, view, a, b, T(2), T(11)));
  const detail::ArcPoint<T> point = formula::arc_on_rim(stone, view, a, b, T(5), T(7));
  add(numbers, point);
  numbers.add(formula::arc_line(point, T(3), b, a));
  numbers.add(formula::arc_line_a(point, T(3)));
  numbers.add(formula::arc_line_b(point, T(3)));
  numbers.add(formula::arc_rim_radius(stone, T(5), T(49), T(7)));
  numbers.add(formula::arc_cap_radial_square(arc, T(5)));
  numbers.add(formula::arc_cap_value(stone, arc, T(-1), T(20)));
  const detail::RimsTurn<T> turn = formula::rims_turn(vector<T>(1, 2, 3), T(4), vector<T>(1, 0, 0), vector<T>(0, 1, 0),
                                                      T(5), vector<T>(0, 0, 1), vector<T>(1, 1, 0));
  for (const T& number : {turn.bend1, turn.bend2, turn.determinant, turn.step1, turn.step2}) {
    numbers.add(number);
  }
  return numbers;
}

template <class T>
Numbers elementary_contact_formulas() {
  Numbers numbers;
  numbers.add(formula::axis_at(whole_path<T>(), T(2)));
  numbers.add(formula::greatest_bend(T(1), T(2), T(3), T(4)));
  numbers.add(formula::greatest_lift(whole_stone<T>(), T(2), T(3), T(4)));
  const FromRim<T> from = formula::from_rim(vector<T>(1, 2, 3), vector<T>(0, 0, 1), T(2));
  numbers.add(from.beyond);
  numbers.add(from.away);
  const detail::RimPoint<T> point = formula::rim_point(vector<T>(1, 2, 3), vector<T>(4, 0, 0), vector<T>(0, 4, 0), T(4),
                                                       T(5), T(3) / T(5), T(4) / T(5));
  for (const T& number : {point.rho, point.distance, point.slope, point.bend}) {
    numbers.add(number);
  }
  return numbers;
}

TEST(Archetype, RunsTheFormulasOfContact) {
  expect_same(rational_contact_formulas<VectorArchetype>(), rational_contact_formulas<double>());
  expect_same(elementary_contact_formulas<ElementaryVectorArchetype>(), elementary_contact_formulas<double>());
}

}  // namespace

}  // namespace goishi::archetype_test
