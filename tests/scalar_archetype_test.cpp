/// Formulas of shape, mass and motion with the archetype of a scalar.

#include "tests/scalar_archetype.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <experimental/simd>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/motion/step_formulas.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <limits>
#include <string>

namespace goishi::archetype_test {

namespace {

static_assert(goishi::Field<Archetype> && !goishi::Elementary<Archetype> && !goishi::Ordered<Archetype>);
static_assert(goishi::Elementary<ElementaryArchetype> && !goishi::Ordered<ElementaryArchetype>);
static_assert(goishi::Field<VectorArchetype> && !goishi::Elementary<VectorArchetype>);
static_assert(goishi::Elementary<ElementaryVectorArchetype> && !goishi::Ordered<ElementaryVectorArchetype>);
static_assert(goishi::Ordered<float> && goishi::Ordered<double> && goishi::Ordered<long double>);
static_assert(!goishi::Field<int*> && !goishi::Field<std::string>);

// A batch compares to a mask, so it is a scalar of formulas, not of algorithms.
using Batch = std::experimental::native_simd<double>;
static_assert(goishi::Elementary<Batch> && !goishi::Ordered<Batch>);

// The wider type is wider, and stays for others.
static_assert(std::same_as<goishi::scalar::wider_t<float>, double>);
static_assert(std::same_as<goishi::scalar::wider_t<double>, goishi::DoubleDouble>);
static_assert(std::same_as<goishi::scalar::wider_t<Archetype>, Archetype>);

namespace formula = goishi::formula;

TEST(Archetype, RunsTheRationalFormulas) {
  const Archetype w(22), h(9);
  EXPECT_EQ(formula::sphere_radius(w, h).value(), (22.0 * 22.0 + 81.0) / 36.0);
  EXPECT_EQ(formula::sphere_offset(w, h).value(), 13.0 * 31.0 / 36.0);
  EXPECT_EQ(formula::sharp_stone(w, h).joint_radius.value(), 11.0);
  EXPECT_GT(formula::lens_moments_per_mass(w, h).axial.value(), 0.0);
  EXPECT_GT(formula::arc_integrals(w, h, h).fifteen_c5.value(), 0.0);
}

TEST(Archetype, RunsTheElementaryFormulas) {
  const ElementaryArchetype w(22), h(9), b(1);
  const auto offset = formula::measured_sphere_offset(w, h, b);
  const auto stone = formula::bevelled_stone(formula::generating_width(h, offset), h, b, offset);
  const auto terms = formula::bevel_terms(stone, goishi::scalar::atan2(stone.joint_sine, stone.joint_cosine));
  EXPECT_DOUBLE_EQ(goishi::outer_width(stone).value(), 22.0);
  EXPECT_GT(formula::bevelled_volume(stone, terms).value(), 0.0);
  EXPECT_GT(formula::bevelled_surface_area(stone, terms).value(), 0.0);
  EXPECT_GT(formula::bevelled_moments(stone, terms).axial.value(), 0.0);
  EXPECT_GT(formula::lens_volume(w, h).value(), 0.0);
  EXPECT_GT(formula::lens_surface_area(w, h).value(), 0.0);
  EXPECT_GT(formula::lens_moments(w, h).transverse.value(), 0.0);
}

// --- on vectors: each subject's formulas are called once, with the archetype and with double, and all numbers compared

using goishi::Mat3;
using goishi::Quat;
using goishi::Vec3;

/// A body, its state and a step, of small whole numbers.
template <class T>
struct Example {
  static Vec3<T> vector(int x, int y, int z) { return {T(x), T(y), T(z)}; }
  T dt = T(1) / T(8);
  Quat<T> q{T(1) / T(5), T(2) / T(5), T(2) / T(5), T(4) / T(5)};
  Vec3<T> w = vector(2, -1, 3);
  Vec3<T> gravity = vector(0, 0, -10);
  Vec3<T> inverse_moments = Vec3<T>(T(1) / T(2), T(1) / T(3), T(1) / T(4));
  goishi::RigidBody<T> body{.mass = T(2), .moments = vector(2, 3, 4)};
  goishi::State<T> state{.p_WB = vector(1, 2, 3), .q_WB = q, .v_WB = vector(4, -5, 6), .L_W = vector(7, 8, -9)};
  goishi::Mobility<T> mobility = formula::mobility(goishi::Moments<T>{.axial = T(3), .transverse = T(2)});
  formula::Rotor<T> rotor{.q_WB = q, .L_B = vector(7, 8, -9)};
};

template <class T>
Numbers tensor_formulas() {
  Numbers numbers;
  const Example<T> e;
  const Mat3<T> tensor = formula::principal_tensor(goishi::Moments<T>{.axial = T(3), .transverse = T(2)});
  numbers.add(formula::rotated_tensor(tensor, Mat3<T>(e.q.toRotationMatrix())));
  numbers.add(formula::shifted_tensor(tensor, T(3), e.w));
  return numbers;
}

TEST(Archetype, RunsTheTensorFormulas) {
  expect_same(tensor_formulas<VectorArchetype>(), tensor_formulas<double>());
}

template <class T>
Numbers rational_motion_formulas() {
  Numbers numbers;
  const Example<T> e;
  numbers.add(formula::product(e.q, e.q));
  numbers.add(formula::attitude_rate(e.w, e.q));
  numbers.add(formula::reunited(e.q));
  numbers.add(formula::symmetry_axis(e.q));
  numbers.add(formula::unit_axis(e.q));
  numbers.add(formula::in_body(e.q, e.w));
  numbers.add(formula::angular_velocity_B(e.state, e.body));
  numbers.add(formula::angular_velocity_W(e.state, e.body));
  numbers.add(formula::angular_momentum_W(e.q, e.body, e.w));
  numbers.add(formula::rotational_energy(e.state, e.body));
  numbers.add(formula::translational_energy(e.state, e.body));
  numbers.add(formula::potential_energy(e.state, e.body, e.gravity));
  numbers.add(formula::energy(e.state, e.body, goishi::gravity_W<T>()));
  numbers.add(formula::linear_momentum(e.state, e.body));
  numbers.add(formula::angular_momentum_about(e.w, e.state, e.body));
  numbers.add(formula::seen_from(e.w, e.q, e.gravity, e.state));
  numbers.add(formula::ballistic_flight(e.state, e.gravity, e.dt));
  numbers.add(e.mobility.transverse);
  numbers.add(e.mobility.axial);
  numbers.add(formula::axial_momentum(e.q, e.state.L_W));
  numbers.add(formula::raw_euler_attitude(e.q, e.w, e.dt));
  const auto rk = formula::raw_runge_kutta_4_step<T>(
      {e.q.w(), e.q.x(), e.q.y(), e.q.z(), e.gravity.x(), e.gravity.y(), e.gravity.z()}, e.inverse_moments, e.dt);
  for (const T& number : {rk.w, rk.x, rk.y, rk.z, rk.lx, rk.ly, rk.lz}) {
    numbers.add(number);
  }
  numbers.add(formula::midpoint_residual(e.w, e.gravity, e.inverse_moments, e.dt));
  numbers.add(formula::midpoint_jacobian(e.w, e.inverse_moments, e.dt));
  for (const T& substep : formula::composition_6<T>()) {
    numbers.add(substep);
  }
  return numbers;
}

TEST(Archetype, RunsTheRationalFormulasOfMotion) {
  expect_same(rational_motion_formulas<VectorArchetype>(), rational_motion_formulas<double>());
}

template <class T>
Numbers elementary_motion_formulas() {
  Numbers numbers;
  const Example<T> e;
  numbers.add(formula::rotation_exp(e.w));
  numbers.add(formula::turned_top(e.q, e.w, T(5), e.dt));
  numbers.add(formula::free_rotation(e.q, e.state.L_W, T(5), e.mobility, e.dt));
  numbers.add(formula::free_flight(e.state, e.mobility, e.gravity, e.dt));
  numbers.add(formula::exponential_euler_attitude(e.q, e.w, e.dt));
  numbers.add(formula::midpoint_attitude(e.q, e.w, e.inverse_moments, e.dt));
  const auto add_split = [&](const auto& substeps) {
    formula::Rotor<T> rotor = e.rotor;
    formula::splitting_step(rotor, e.inverse_moments, e.dt, substeps);
    numbers.add(rotor.q_WB);
    numbers.add(rotor.L_B);
  };
  add_split(formula::composition_2<T>());
  add_split(formula::composition_4<T>());
  add_split(formula::composition_6<T>());
  const goishi::JacobiSolution<T> jacobi = formula::jacobi_solution(e.body.moments, e.w);
  const goishi::elliptic::Jacobi<T> by{.sn = T(3) / T(5), .cn = T(4) / T(5), .dn = T(1) / T(2)};
  const goishi::elliptic::Jacobi<T> at = formula::jacobi_sum(jacobi, by);
  numbers.add(formula::jacobi_momentum(jacobi, T(-1), at));
  numbers.add(formula::turn_about_momentum(jacobi, T(4), T(2), formula::third_kind_excess(jacobi, by.sn, at),
                                           formula::momentum_longitude(jacobi, at), e.dt));
  numbers.add(formula::turned_about_momentum(e.q, e.q, formula::shortest_to_z(e.w), e.dt, e.q));
  return numbers;
}

TEST(Archetype, RunsTheElementaryFormulasOfMotion) {
  expect_same(elementary_motion_formulas<ElementaryVectorArchetype>(), elementary_motion_formulas<double>());
}

TEST(Scalar, BatchesGiveWhatTheirLanesGive) {
  const Batch w([](auto lane) { return 1.0 + 0.1 * static_cast<double>(lane); });
  const Batch h = w * Batch(0.4);
  const Batch b = h * Batch(0.1);
  const auto batch = formula::bevelled_stone(w, h, b, formula::sphere_offset(w, h));
  const auto terms = formula::bevel_terms(batch, goishi::scalar::atan2(batch.joint_sine, batch.joint_cosine));
  const Batch volume = formula::bevelled_volume(batch, terms);
  for (std::size_t lane = 0; lane < Batch::size(); ++lane) {
    const auto one =
        formula::bevelled_stone<double>(w[lane], h[lane], b[lane], formula::sphere_offset<double>(w[lane], h[lane]));
    const auto one_terms = formula::bevel_terms(one, std::atan2(one.joint_sine, one.joint_cosine));
    EXPECT_DOUBLE_EQ(volume[lane], formula::bevelled_volume(one, one_terms));
  }
}

TEST(Scalar, IsFiniteKnowsNanAndInfinity) {
  using goishi::scalar::is_finite;
  EXPECT_TRUE(is_finite(0.0));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::max()));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::denorm_min()));
  EXPECT_FALSE(is_finite(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(is_finite(-std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(is_finite(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace

}  // namespace goishi::archetype_test
