/// The oracle of free rotation: it must be right where the answer is known, and refuse to judge where it is not sure.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "verify/oracles/motion/free_body.hpp"

namespace {

using namespace goishi::verify;

using Quad3 = std::array<Quad, 3>;
using Quad4 = std::array<Quad, 4>;

Quad4 product(const Quad4& p, const Quad4& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

double difference(const Quad4& one, const Quad4& other) {
  Quad least = 0, most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    least += (one[i] - other[i]) * (one[i] - other[i]);
    most += (one[i] + other[i]) * (one[i] + other[i]);
  }
  return static_cast<double>(sqrt(least < most ? least : most));  // q and −q are the same attitude
}

double difference(const Quad3& one, const Quad3& other) {
  Quad sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += (one[i] - other[i]) * (one[i] - other[i]);
  }
  return static_cast<double>(sqrt(sum));
}

Quad4 unit(Quad4 q) {
  const Quad norm = sqrt(Quad(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
  for (Quad& coordinate : q) {
    coordinate /= norm;
  }
  return q;
}

/// q (I ω) in W.
Quad3 momentum(const Quad3& moments, const Quad4& q, const Quad3& spin) {
  const Quad4 L = {0, moments[0] * spin[0], moments[1] * spin[1], moments[2] * spin[2]};
  const Quad4 turned = product(product(q, L), {q[0], -q[1], -q[2], -q[3]});
  return {turned[1], turned[2], turned[3]};
}

Quad energy(const Quad3& moments, const Quad3& spin) {
  return (moments[0] * spin[0] * spin[0] + moments[1] * spin[1] * spin[1] + moments[2] * spin[2] * spin[2]) / 2;
}

FreeBody draw_body(std::mt19937_64& random, double middle_only) {
  std::uniform_real_distribution<double> second(0.1, 1.0), any(-1.0, 1.0);
  const double x = second(random), y = second(random), z = second(random);
  FreeBody body{.moments = {y + z, x + z, x + y},
                .attitude = {any(random), any(random), any(random), any(random)},
                .spin = {any(random), any(random), any(random)}};
  if (middle_only > 0.0) {  // near the separatrix: about the middle moment, and hardly about the others
    body.moments = {1.0, 1.5, 2.0};
    body.spin = {middle_only * any(random), 2.0, middle_only * any(random)};
  }
  return body;
}

TEST(FreeBody, SpinsAboutEachPrincipalAxisUniformly) {
  const Quad4 given = {2, -1, 3, 1};  // to be normalised
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double time : {2.5, -2.5}) {
      FreeBody body{.moments = {3, 5, 9}, .attitude = given, .spin = {0, 0, 0}};
      body.spin[axis] = 1.25;
      const FreeBodyReference found = integrate_free_body(body, time);
      const Quad half = body.spin[axis] * time / 2;
      Quad4 turn = {cos(half), 0, 0, 0};
      turn[axis + 1] = sin(half);
      EXPECT_LE(difference(found.attitude, product(unit(given), turn)), 1e-24) << "axis " << axis << ", t = " << time;
      EXPECT_LE(difference(found.spin, body.spin), 1e-24) << "axis " << axis << ", t = " << time;
    }
  }
}

TEST(FreeBody, StaysWhereItDoesNotTurn) {
  for (const double time : {0.0, 1e6}) {
    const FreeBodyReference found =
        integrate_free_body({.moments = {1, 1, 2}, .attitude = {0, 2, 0, 0}, .spin = {0, 0, 0}}, time);
    EXPECT_EQ(difference(found.attitude, Quad4{0, 1, 0, 0}), 0.0);
    EXPECT_EQ(difference(found.spin, Quad3{0, 0, 0}), 0.0);
  }
  const FreeBody spinning{.moments = {1, 1, 2}, .attitude = {1, 0, 0, 0}, .spin = {1, 2, 3}};
  EXPECT_EQ(difference(integrate_free_body(spinning, 0).spin, spinning.spin), 0.0);
}

TEST(FreeBody, KeepsMomentumInTheWorldAndEnergy) {
  std::mt19937_64 random(1);
  for (const double middle_only : {0.0, 0.0, 0.0, 1e-3, 1e-9}) {
    const FreeBody body = draw_body(random, middle_only);
    const FreeBodyReference found = integrate_free_body(body, 4.0);
    const Quad3 before = momentum(body.moments, unit(body.attitude), body.spin);
    EXPECT_LE(difference(momentum(body.moments, found.attitude, found.spin), before), 1e-22);
    const Quad ratio = energy(body.moments, found.spin) / energy(body.moments, body.spin) - 1;
    EXPECT_LE(std::fabs(static_cast<double>(ratio)), 1e-22);
    EXPECT_LE(found.disagreement, free_body_agreement);
  }
}

TEST(FreeBody, ComesBack) {
  std::mt19937_64 random(2);
  for (const double middle_only : {0.0, 1e-3}) {
    const FreeBody body = draw_body(random, middle_only);
    const FreeBodyReference there = integrate_free_body(body, 3.0);
    const FreeBodyReference back =
        integrate_free_body({.moments = body.moments, .attitude = there.attitude, .spin = there.spin}, -3.0);
    EXPECT_LE(difference(back.attitude, unit(body.attitude)), 1e-22);
    EXPECT_LE(difference(back.spin, body.spin), 1e-22);
  }
}

/// The same flight in any units: only the integrators' step count could tell.
TEST(FreeBody, DoesNotCareForUnits) {
  const FreeBody body{.moments = {2, 3, 4}, .attitude = {1, 0, 0, 0}, .spin = {1, 2, 3}};
  const FreeBodyReference found = integrate_free_body(body, 1.0);
  const Quad tiny = 1e-300, fast = 1024;
  const FreeBodyReference other = integrate_free_body(
      {.moments = {2 * tiny, 3 * tiny, 4 * tiny}, .attitude = {1, 0, 0, 0}, .spin = {fast, 2 * fast, 3 * fast}},
      1 / fast);
  EXPECT_LE(difference(found.attitude, other.attitude), 1e-24);
}

/// Hull et al. (1972), problem B5, y' = (y₂y₃, −y₁y₃, −0.51 y₁y₂): Euler's equations of a body with moments (2, 3, 1),
/// y_i = ω_i / s_i.
TEST(FreeBody, GivesDetestB5) {
  const Quad part = Quad(51) / 100;
  const Quad3 s = {sqrt(Quad(3 * part)), sqrt(part), sqrt(Quad(3))};
  const FreeBodyReference found =
      integrate_free_body({.moments = {2, 3, 1}, .attitude = {1, 0, 0, 0}, .spin = {0, s[1], s[2]}}, 20.0);
  const std::array<const char*, 3> published = {"-0.939657079872920396", "-0.342117775400074907",
                                                "0.741412659619995301"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(std::fabs(static_cast<double>(Quad(found.spin[i] / s[i] - Quad(published[i])))), 1e-18) << "y" << i + 1;
  }
}

TEST(FreeBody, TriesOnceMoreAndThenRefusesToJudge) {
  const FreeBody body{.moments = {2, 3, 4}, .attitude = {1, 0, 0, 0}, .spin = {1, 2, 3}};
  EXPECT_EQ(integrate_free_body(body, 1.0).tolerance, free_body_tolerances[0]);
  EXPECT_EQ(integrate_free_body(body, 1.0, {1e-15, 1e-25}).tolerance, 1e-25);
  EXPECT_THROW((void)integrate_free_body(body, 1.0, {1e-12, 1e-15}), std::runtime_error);
  const FreeBody unknown{.moments = {2, 3, 4}, .attitude = {1, 0, 0, 0}, .spin = {1, std::nan(""), 3}};
  EXPECT_THROW((void)integrate_free_body(unknown, 1.0), std::runtime_error);
}

/// On the separatrix the body nears the middle axis, and then even the round-off of 34 digits outgrows the agreement.
TEST(FreeBody, RefusesToJudgeWhatIsTooUnstable) {
  const FreeBody body{.moments = {1, 10, 10.9}, .attitude = {1, 0, 0, 0}, .spin = {std::sqrt(1.09) * 0.125, 1, 0.125}};
  EXPECT_LE(integrate_free_body(body, 20.0).disagreement, free_body_agreement);
  EXPECT_THROW((void)integrate_free_body(body, 36.0, {1e-25, 1e-26}), std::runtime_error);
}

}  // namespace
