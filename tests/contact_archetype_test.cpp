/// Formulas of contact, impact and drop with the archetype of a scalar.

#include <gtest/gtest.h>

#include <goishi/drop/carried.hpp>
#include <goishi/drop/contact_motion.hpp>
#include <goishi/drop/slip.hpp>
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
  numbers.add(formula::carried_spin_rate(vector<T>(0, 0, 1), u, L, T(5)));
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
  numbers.add(formula::shortest_rotation(vector<T>(0, 0, 1), Vec3<T>(T(2) / T(3), T(1) / T(3), T(2) / T(3))));
  return numbers;
}

TEST(Archetype, RunsTheElementaryFormulasOfDrop) {
  expect_same(elementary_drop_formulas<ElementaryVectorArchetype>(), elementary_drop_formulas<double>());
}

}  // namespace

}  // namespace goishi::archetype_test
