/// The C interface beside the library: stones, meshes, motion. The same numbers, to the last bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <goishi/mass/tensor.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/motion/steppers.hpp>
#include <goishi/published/bevel.hpp>
#include <goishi/published/inertia.hpp>
#include <goishi/shape/catalogue.hpp>
#include <limits>
#include <vector>

#include "tests/web/scenes.hpp"

namespace goishi::web_test {

namespace {

TEST(CInterface, Measures) {
  Scenes scenes;
  for (int i = 0; i < 200; ++i) {
    const Scene scene = scenes.next();
    const Stone<double>& s = scene.shape;
    const MassProperties<double>& m = scene.mass;
    List got(GOISHI_MEASURES_SIZE);
    EXPECT_DONE(goishi_measures(AS_ARRAY(scene.stone), AS_ARRAY(got)));
    expect_same(
        got,
        {s.width, s.height, s.bevel, outer_width(s), s.sphere_radius, s.sphere_offset, s.bevel_major_radius,
         s.bevel_minor_radius, s.joint_radius, s.joint_cosine, s.joint_sine, m.volume, m.surface_area, m.density,
         m.mass, m.moments.axial, m.moments.transverse, m.moments_per_mass.axial, m.moments_per_mass.transverse},
        "measures");
  }
}

TEST(CInterface, Catalogue) {
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      const CatalogueStone entry = catalogue_stone(size.number, color);
      const Stone<double> shape = make_stone(entry, 0.001);
      List got(GOISHI_STONE_SIZE);
      EXPECT_DONE(goishi_catalogue_stone(size.number, static_cast<int>(color), 0.001, AS_ARRAY(got)));
      expect_same(got, {shape.width, shape.height, 0.001, 0.0, static_cast<double>(entry.density), 0.0}, "catalogue");
    }
  }
}

TEST(CInterface, PublishedMeasures) {
  Scenes scenes;
  for (int i = 0; i < 20; ++i) {
    const Scene scene = scenes.next();
    const double w = scene.shape.width, h = scene.shape.height, r = scene.shape.sphere_radius,
                 d = scene.shape.sphere_offset;
    List got(GOISHI_PUBLISHED_MEASURES_SIZE);
    EXPECT_DONE(goishi_published_measures(AS_ARRAY(scene.stone), AS_ARRAY(got)));
    const PublishedBevel<double> bevel = published_bevel(r, d, scene.shape.bevel);
    const PublishedTensor sum = published_tensor(static_cast<float>(100.0 * w), static_cast<float>(100.0 * h));
    const double volume = published_volume(100.0 * r, 100.0 * d) / 1e6;
    const double axial = mass_properties(make_stone(w, h), Density{1.0}).moments.axial;
    expect_same(got,
                {bevel.major_radius, bevel.minor_radius, volume, axial / volume, sum.y / 1e4, sum.x / 1e4,
                 static_cast<double>(sum.nodes)},
                "published");
  }
  // What the talk printed of size 33, in cm².
  List got(GOISHI_PUBLISHED_MEASURES_SIZE);
  EXPECT_DONE(goishi_published_measures(AS_ARRAY((List{0.022, 0.0092, 0.001, 0.0, 2800.0, 0.0})), AS_ARRAY(got)));
  EXPECT_NEAR(1e4 * got[GOISHI_PUBLISHED_SUM_AXIAL], 0.304776, 5e-7);
  EXPECT_NEAR(1e4 * got[GOISHI_PUBLISHED_SUM_TRANSVERSE], 0.177721, 5e-7);
  EXPECT_NEAR(1e4 * got[GOISHI_PUBLISHED_AXIAL], 0.303588, 5e-7);
  EXPECT_NEAR(1e3 * got[GOISHI_PUBLISHED_MINOR_RADIUS], -5.85, 0.005);
}

TEST(CInterface, Tensor) {
  Scenes scenes;
  for (int i = 0; i < 100; ++i) {
    const Scene scene = scenes.next();
    List got(9), expected;
    EXPECT_DONE(goishi_tensor(AS_ARRAY(scene.stone), AS_ARRAY(scene.pose_list()), AS_ARRAY(got)));
    const Mat3<double> tensor = inertia_tensor(scene.mass, scene.start.q_WB, scene.start.p_WB);
    expected << Vec(tensor.row(0)) << Vec(tensor.row(1)) << Vec(tensor.row(2));
    expect_same(got, expected, "tensor");
  }
}

/// Each point is on the surface, its normal is that of the surface there, and the arc's length is that of the chords.
TEST(CInterface, Profile) {
  Scenes scenes;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = scenes.next();
    const double w = scene.shape.width;
    const std::size_t steps = 200, parts = 0.0 < scene.shape.bevel ? 3 : 2, row = GOISHI_PROFILE_SIZE;
    List rows(parts * (steps + 1) * row);
    EXPECT_DONE(goishi_profile(AS_ARRAY(scene.stone), steps, AS_ARRAY(rows)));
    double chords = 0.0;
    for (std::size_t k = 0; k < parts * (steps + 1); ++k) {
      const double* at = rows.data() + k * row;
      const Vec p(at[GOISHI_RHO], 0.0, at[GOISHI_ZETA]), n(at[GOISHI_NORMAL_RHO], 0.0, at[GOISHI_NORMAL_ZETA]);
      EXPECT_LE(std::abs(signed_distance(scene.shape, p)), 1e-15 * w);
      EXPECT_NEAR(n.norm(), 1.0, 1e-15);
      EXPECT_NEAR(support(scene.shape, Vec(n.normalized())).value, p.dot(n), 1e-15 * w);
      const std::size_t part = k / (steps + 1);
      const bool rim = parts == 3 && part == 1;
      EXPECT_EQ(at[GOISHI_PROFILE_PART], rim ? GOISHI_RIM : part == 0 ? GOISHI_UPPER_CAP : GOISHI_LOWER_CAP);
      EXPECT_EQ(at[GOISHI_CURVATURE], 1.0 / (rim ? scene.shape.bevel_minor_radius : scene.shape.sphere_radius));
      if (0 < k) {
        chords +=
            (p - Vec(at[GOISHI_RHO - static_cast<int>(row)], 0.0, at[GOISHI_ZETA - static_cast<int>(row)])).norm();
      }
      // A chord that sees the angle θ is θ²/24 shorter than its arc; no step turns by more than π/200.
      EXPECT_NEAR(at[GOISHI_ARC], chords, 1.1e-5 * chords + 1e-15 * w);
    }
    EXPECT_EQ(rows[GOISHI_RHO], 0.0);
    EXPECT_EQ(rows[GOISHI_ZETA], scene.shape.height / 2.0);
    EXPECT_EQ(rows[rows.size() - row + GOISHI_RHO], 0.0);
    EXPECT_EQ(rows[rows.size() - row + GOISHI_ZETA], -scene.shape.height / 2.0);
  }
}

TEST(CInterface, Meshes) {
  Scenes scenes;
  for (int i = 0; i < 16; ++i) {
    const Scene scene = scenes.next();
    for (const Tessellation method : {Tessellation::subdivision, Tessellation::rings}) {
      const int how = static_cast<int>(method);
      std::vector<int> fineness(GOISHI_FINENESS_SIZE);
      EXPECT_DONE(goishi_fineness(AS_ARRAY(scene.stone), how, -1, 5e-5, AS_ARRAY(fineness)));
      EXPECT_EQ((Fineness{fineness[0], fineness[1], fineness[2]}), fineness_for(scene.shape, method, 5e-5));
      EXPECT_DONE(goishi_fineness(AS_ARRAY(scene.stone), how, 2, 0.0, AS_ARRAY(fineness)));
      const Fineness by_level = fineness_of_level(scene.shape, 2);
      EXPECT_EQ((Fineness{fineness[0], fineness[1], fineness[2]}), by_level);
      const Mesh<double> whole = tessellate(scene.shape, method, by_level);
      const std::vector<Mesh<double>> expected = {unwelded(whole), weld(whole, Weld::position_and_normal),
                                                  weld(whole, Weld::position)};
      for (int weld_how = GOISHI_UNWELDED; weld_how <= GOISHI_WELDED_BY_POSITION; ++weld_how) {
        const Mesh<double>& mesh = expected[static_cast<std::size_t>(weld_how)];
        std::size_t vertices = 0, triangles = 0;
        EXPECT_DONE(
            goishi_mesh_counts(AS_ARRAY(scene.stone), how, AS_ARRAY(fineness), weld_how, &vertices, &triangles));
        ASSERT_EQ(vertices, mesh.points.size());
        ASSERT_EQ(triangles, mesh.triangles.size());
        List points(3 * vertices), normals(3 * vertices), expected_points, expected_normals;
        std::vector<std::uint32_t> corners(3 * triangles), expected_corners;
        EXPECT_DONE(goishi_mesh(AS_ARRAY(scene.stone), how, AS_ARRAY(fineness), weld_how, AS_ARRAY(points),
                                AS_ARRAY(normals), AS_ARRAY(corners)));
        for (std::size_t k = 0; k < vertices; ++k) {
          expected_points << mesh.points[k];
          expected_normals << mesh.normals[k];
        }
        for (const Triangle& triangle : mesh.triangles) {
          expected_corners.insert(expected_corners.end(), triangle.begin(), triangle.end());
        }
        expect_same(points, expected_points, "points");
        expect_same(normals, expected_normals, "normals");
        EXPECT_EQ(corners, expected_corners);
        List figures(GOISHI_MESH_FIGURES_SIZE);
        EXPECT_DONE(goishi_mesh_figures(AS_ARRAY(scene.stone), how, AS_ARRAY(fineness), weld_how, AS_ARRAY(figures)));
        const Topology found = topology(mesh);
        const MeshMass<double> enclosed = mesh_mass(mesh);
        expect_same(figures,
                    {static_cast<double>(vertices), static_cast<double>(triangles), static_cast<double>(found.points),
                     static_cast<double>(found.edges), 0.0, deviation(mesh, scene.shape), enclosed.volume,
                     enclosed.surface_area},
                    "figures");
      }
    }
  }
}

TEST(CInterface, StateOfASpin) {
  Scenes scenes;
  for (int i = 0; i < 100; ++i) {
    const Scene scene = scenes.next();
    const Vec w_B = scenes.vector(50.0);
    const List velocity = {0.1, -0.2, 0.3}, spin = {w_B[0], w_B[1], w_B[2]};
    List pose = scene.pose_list(), got(GOISHI_STATE_SIZE);
    for (std::size_t k = GOISHI_ATTITUDE; k < GOISHI_POSE_SIZE; ++k) {
      pose[k] *= 3.0;  // of no unit length
    }
    EXPECT_DONE(goishi_state(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(velocity), AS_ARRAY(spin), AS_ARRAY(got)));
    const Quat<double> q(got[3], got[4], got[5], got[6]);
    EXPECT_LE(std::abs(q.squaredNorm() - 1.0), 1e-15);
    EXPECT_LE(q.angularDistance(scene.start.q_WB), 1e-15);
    List expected;
    expected << State<double>{.p_WB = scene.start.p_WB,
                              .q_WB = q,
                              .v_WB = {0.1, -0.2, 0.3},
                              .L_W = formula::angular_momentum_W<double>(q, scene.body(), w_B)};
    expect_same(got, expected, "state");
  }
}

TEST(CInterface, FreeFlight) {
  Scenes scenes;
  for (int i = 0; i < 200; ++i) {
    const Scene scene = scenes.next();
    const double time = scenes.between(-2.0, 2.0);
    const auto freedom = static_cast<Freedom>(i % 3);
    List got(GOISHI_MOTION_SIZE);
    EXPECT_DONE(goishi_free_flight(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity),
                                   static_cast<int>(freedom), time, AS_ARRAY(got)));
    expect_same(got, motion(free_flight(scene.start, scene.mass.moments, g_W, time, freedom), scene.body(), g_W),
                "motion");
  }
}

TEST(CInterface, FreeRotation) {
  Scenes scenes;
  for (int i = 0; i < 100; ++i) {
    const Scene scene = scenes.next();
    const double time = scenes.between(-2.0, 2.0);
    const List moments = {scene.mass.moments.axial, scene.mass.moments.transverse};
    const List attitude(scene.state.begin() + GOISHI_ATTITUDE, scene.state.begin() + GOISHI_POSE_SIZE);
    const List momentum(scene.state.begin() + GOISHI_MOMENTUM, scene.state.end());
    List rotation(7), whole(GOISHI_MOTION_SIZE);
    EXPECT_DONE(
        goishi_free_rotation(AS_ARRAY(moments), AS_ARRAY(attitude), AS_ARRAY(momentum), time, AS_ARRAY(rotation)));
    EXPECT_DONE(goishi_free_flight(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity), GOISHI_ANGULAR,
                                   time, AS_ARRAY(whole)));
    List expected(whole.begin() + GOISHI_ATTITUDE, whole.begin() + GOISHI_POSE_SIZE);
    expected.insert(expected.end(), whole.begin() + GOISHI_ANGULAR_VELOCITY, whole.begin() + GOISHI_ENERGY);
    expect_same(rotation, expected, "rotation");
  }
}

TEST(CInterface, FlightInSteps) {
  Scenes scenes;
  for (const SchemeInfo& info : schemes) {
    for (int i = 0; i < 6; ++i) {
      const Scene scene = scenes.next();
      const RigidBody<double> body = scene.body();
      List rows(5 * GOISHI_FLIGHT_SIZE), expected;
      std::size_t done = 0;
      int ended = -1;
      EXPECT_DONE(goishi_flight(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity), GOISHI_BOTH,
                                static_cast<int>(info.scheme), 1e-3, 7, AS_ARRAY(rows), &done, &ended));
      EXPECT_EQ(done, 5U);
      EXPECT_EQ(ended, GOISHI_COMPLETED);
      const Stepper<double> stepper(info.scheme, body, g_W);
      State<double> stepped = scene.start;
      for (int row = 0; row < 5; ++row) {
        stepped = row == 0 ? stepped : stepper.advance(stepped, 1e-3, 7).state;
        const double time = 7 * row * 1e-3;
        const State<double> exact = free_flight(scene.start, scene.mass.moments, g_W, time);
        expected << time;
        for (const State<double>& state : {stepped, exact}) {
          const List one = motion(state, body, g_W);
          expected.insert(expected.end(), one.begin(), one.end());
        }
        // The errors by another way: the chord of the rotation, and the greatest coordinate.
        const double* errors = rows.data() + row * GOISHI_FLIGHT_SIZE + GOISHI_ATTITUDE_ERROR;
        const double chord = std::min((stepped.q_WB.coeffs() - exact.q_WB.coeffs()).norm(),
                                      (stepped.q_WB.coeffs() + exact.q_WB.coeffs()).norm());
        EXPECT_NEAR(errors[0], 4.0 * std::asin(chord / 2.0), 1e-15 + 1e-12 * errors[0]);
        const double greatest = (stepped.p_WB - exact.p_WB).cwiseAbs().maxCoeff();
        EXPECT_LE(greatest, errors[1]);
        EXPECT_LE(errors[1], 1.75 * greatest);
        expected << errors[0] << errors[1];
      }
      expect_same(rows, expected, "flight");
    }
  }
}

TEST(CInterface, AFlightThatFailsSaysHowFarItWent) {
  Scene scene = Scenes().next();
  scene.state[GOISHI_MOMENTUM] = 1e3;
  List rows(4 * GOISHI_FLIGHT_SIZE, 77.0);
  std::size_t done = 0;
  int ended = -1;
  EXPECT_DONE(goishi_flight(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity), GOISHI_BOTH,
                            GOISHI_RUNGE_KUTTA_4, 1.0, 1, AS_ARRAY(rows), &done, &ended));
  EXPECT_EQ(ended, GOISHI_DIVERGED);
  EXPECT_EQ(done, 1U);
  EXPECT_EQ(rows[GOISHI_FLIGHT_TIME], 0.0);
  EXPECT_EQ(rows[GOISHI_FLIGHT_SIZE], 77.0);
}

TEST(CInterface, Version) {
  EXPECT_STREQ(goishi_version(), GOISHI_EXPECTED_VERSION);
}

}  // namespace

}  // namespace goishi::web_test
