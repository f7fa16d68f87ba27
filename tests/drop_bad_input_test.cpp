/// Drops: errors of the caller.

#include <gtest/gtest.h>

#include <functional>
#include <goishi/mass/inertia.hpp>
#include <limits>
#include <string>

#include "compiled/drop.hpp"
#include "tests/expectations.hpp"

namespace goishi::drop_test {

namespace {

using test::infinity;
using test::nan;

struct Scene {
  Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
  State<double> start{
      .p_WB = {0.0, 0.0, 0.05}, .q_WB = Quat<double>::Identity(), .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
  DropSettings<double> settings = {};
};

/// On the plane and on the board.
void expect_invalid(const std::string& argument, const std::function<void(Scene&)>& spoil) {
  Scene scene;
  spoil(scene);
  test::expect_invalid(argument, [&] { (void)drop(scene.stone, scene.body, scene.start, scene.settings); });
  test::expect_invalid(argument,
                       [&] { (void)drop(scene.stone, scene.body, scene.start, make_board<double>(), scene.settings); });
}

TEST(BadDrop, Material) {
  for (const double bad : {-1e-300, 1.0000000000000002, 2.0, infinity, nan}) {
    expect_invalid("restitution", [&](Scene& scene) { scene.settings.restitution = bad; });
  }
  for (const double bad : {-1e-300, -infinity, nan}) {
    expect_invalid("friction", [&](Scene& scene) { scene.settings.friction = bad; });
  }
}

TEST(BadDrop, Lengths) {
  for (const double bad : {-1e-300, infinity, nan}) {
    expect_invalid("rolling_resistance", [&](Scene& scene) { scene.settings.rolling_resistance = bad; });
    expect_invalid("pivot_radius", [&](Scene& scene) { scene.settings.pivot_radius = bad; });
    expect_invalid("patch_radius", [&](Scene& scene) { scene.settings.patch_radius = bad; });
    expect_invalid("slip_coefficient", [&](Scene& scene) { scene.settings.slip_coefficient = bad; });
    expect_invalid("damping", [&](Scene& scene) { scene.settings.damping = bad; });
    expect_invalid("touching", [&](Scene& scene) { scene.settings.touching = bad; });
    expect_invalid("closing_speed", [&](Scene& scene) { scene.settings.closing_speed = bad; });
  }
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    expect_invalid("contact_speed", [&](Scene& scene) { scene.settings.contact_speed = bad; });
    expect_invalid("edge_speed", [&](Scene& scene) { scene.settings.edge_speed = bad; });
    expect_invalid("creep_speed", [&](Scene& scene) { scene.settings.creep_speed = bad; });
  }
}

TEST(BadDrop, Limits) {
  for (const double bad : {0.0, -1.0, nan}) {
    expect_invalid("horizon", [&](Scene& scene) { scene.settings.horizon = bad; });
  }
  for (const double bad : {0.0, 1e-15, 0.1, nan}) {
    expect_invalid("tolerance", [&](Scene& scene) { scene.settings.tolerance = bad; });
  }
  expect_invalid("maximum_impacts", [](Scene& scene) { scene.settings.maximum_impacts = 0; });
  expect_invalid("maximum_events", [](Scene& scene) { scene.settings.maximum_events = 0; });
  expect_invalid("maximum_steps", [](Scene& scene) { scene.settings.maximum_steps = 0; });
}

TEST(BadDrop, Gravity) {
  for (const double bad : {infinity, -infinity, nan}) {
    expect_invalid("gravity", [&](Scene& scene) { scene.settings.gravity.y() = bad; });
  }
}

TEST(BadDrop, Start) {
  for (const double bad : {infinity, nan}) {
    expect_invalid("position", [&](Scene& scene) { scene.start.p_WB.x() = bad; });
    expect_invalid("velocity", [&](Scene& scene) { scene.start.v_WB.z() = bad; });
    expect_invalid("angular momentum", [&](Scene& scene) { scene.start.L_W.y() = bad; });
  }
  expect_invalid("attitude", [](Scene& scene) { scene.start.q_WB.w() = 1.1; });
}

TEST(BadDrop, Body) {
  expect_invalid("mass", [](Scene& scene) { scene.body.mass = 0.0; });
  expect_invalid("mass", [](Scene& scene) { scene.body.mass = nan; });
  expect_invalid("moments", [](Scene& scene) { scene.body.moments.y() *= 1.1; });
}

}  // namespace

}  // namespace goishi::drop_test
