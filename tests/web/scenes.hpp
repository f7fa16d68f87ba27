#pragma once
/// \file
/// Stones and their motion, as the library has them and as arrays; what is the same to the last bit.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <goishi/contact/contact.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <limits>
#include <random>
#include <vector>

#include "goishi.h"

namespace goishi::web_test {

using Vec = Vec3<double>;
using List = std::vector<double>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A list that grows by what is shifted into it.
inline List& operator<<(List& list, double value) {
  list.push_back(value);
  return list;
}
inline List& operator<<(List& list, const Vec& v) {
  return list << v[0] << v[1] << v[2];
}
inline List& operator<<(List& list, const State<double>& s) {
  return list << s.p_WB << s.q_WB.w() << s.q_WB.x() << s.q_WB.y() << s.q_WB.z() << s.v_WB << s.L_W;
}
inline List& operator<<(List& list, const Separation<double>& s) {
  return list << static_cast<double>(s.status) << s.gap << s.n_W << s.p_stone << s.p_other
              << static_cast<double>(s.feature) << static_cast<double>(s.other_feature) << (s.certified ? 1.0 : 0.0);
}

/// NaN is like NaN, and 0 is not −0.
[[nodiscard]] inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

inline void expect_same(const List& got, const List& expected, const char* what) {
  ASSERT_EQ(got.size(), expected.size()) << what;
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_TRUE(same(got[i], expected[i])) << what << " " << i << ": " << got[i] << ", not " << expected[i];
  }
}

#define EXPECT_DONE(call) EXPECT_EQ(call, GOISHI_OK) << goishi_message()
#define AS_ARRAY(list) (list).data(), (list).size()

/// Stones of all kinds, and how they move.
struct Scene {
  List stone, state;
  Stone<double> shape;
  MassProperties<double> mass;
  State<double> start;

  [[nodiscard]] RigidBody<double> body() const { return make_rigid_body(mass); }
  [[nodiscard]] Pose<double> pose() const { return {start.p_WB, start.q_WB}; }
  [[nodiscard]] List pose_list() const { return {state.begin(), state.begin() + GOISHI_POSE_SIZE}; }
};

class Scenes {
 public:
  [[nodiscard]] double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  [[nodiscard]] Vec vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }

  [[nodiscard]] Scene next() {
    const int kind = count_++ % 4;
    const double width = between(0.01, 0.03), height = width * between(0.1, 1.0), part = between(0.05, 0.9);
    const double bevel = kind % 2 == 0 ? height * part : 0.0;
    const bool measured = kind == 2;
    Scene scene;
    scene.shape = measured ? make_measured_stone(width, height, bevel) : make_stone(width, height, bevel);
    const double density = kind < 3 ? between(1000.0, 4000.0) : 0.0, weight = kind < 3 ? 0.0 : between(0.001, 0.01);
    scene.mass = kind < 3 ? mass_properties(scene.shape, Density{density}) : mass_properties(scene.shape, Mass{weight});
    scene.stone = {width, height, bevel, measured ? 1.0 : 0.0, density, weight};
    const Vec first = vector(1.0), second = vector(1.0);
    scene.start = {.p_WB = 0.02 * first,
                   .q_WB = Quat<double>(1.0, second[0], second[1], second[2]).normalized(),
                   .v_WB = vector(0.5),
                   .L_W = vector(1e-5)};
    scene.start.p_WB.z() += 0.05;
    scene.state << scene.start;
    return scene;
  }

 private:
  std::mt19937_64 random_{20261130};
  int count_ = 0;
};

inline const List gravity = {0.5, -0.25, -9.80665};
inline const Vec g_W(0.5, -0.25, -9.80665);

inline List motion(const State<double>& state, const RigidBody<double>& body, const Vec& g) {
  List result;
  return result << state << formula::angular_velocity_W(state, body) << formula::energy(state, body, g);
}

}  // namespace goishi::web_test
