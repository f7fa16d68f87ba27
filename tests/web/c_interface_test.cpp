/// The C interface says what the library says, to the last bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/holds.hpp>
#include <goishi/impact/laws.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/motion/steppers.hpp>
#include <goishi/shape/catalogue.hpp>
#include <limits>
#include <random>
#include <vector>

#include "compiled/drop.hpp"
#include "goishi.h"

namespace goishi::web_test {

namespace {

using Vec = Vec3<double>;
using List = std::vector<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A list that grows by what is shifted into it.
List& operator<<(List& list, double value) {
  list.push_back(value);
  return list;
}
List& operator<<(List& list, const Vec& v) {
  return list << v[0] << v[1] << v[2];
}
List& operator<<(List& list, const State<double>& s) {
  return list << s.p_WB << s.q_WB.w() << s.q_WB.x() << s.q_WB.y() << s.q_WB.z() << s.v_WB << s.L_W;
}
List& operator<<(List& list, const Separation<double>& s) {
  return list << static_cast<double>(s.status) << s.gap << s.n_W << s.p_stone << s.p_other
              << static_cast<double>(s.feature) << static_cast<double>(s.other_feature) << (s.certified ? 1.0 : 0.0);
}

/// NaN is like NaN, and 0 is not −0.
[[nodiscard]] bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

void expect_same(const List& got, const List& expected, const char* what) {
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

const List gravity = {0.5, -0.25, -9.80665};
const Vec g_W(0.5, -0.25, -9.80665);

List motion(const State<double>& state, const RigidBody<double>& body, const Vec& g) {
  List result;
  return result << state << formula::angular_velocity_W(state, body) << formula::energy(state, body, g);
}

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

const List board_list = {19.0, 0.022, 0.0237, 0.0141, 0.01395, 0.1515, 0.0};

TEST(CInterface, TheBoardIsTheLibrarys) {
  List got(GOISHI_BOARD_SIZE);
  EXPECT_DONE(goishi_board(AS_ARRAY(got)));
  expect_same(got, board_list, "board");
}

TEST(CInterface, Separation) {
  Scenes scenes;
  const Board<double> board = make_board<double>();
  for (int i = 0; i < 200; ++i) {
    Scene scene = scenes.next();
    if (i % 2 == 0) {  // at an edge of the board
      scene.start.p_WB.x() += 0.21;
      scene.start.p_WB.z() -= 0.05;
      scene.state[0] = scene.start.p_WB.x();
      scene.state[2] = scene.start.p_WB.z();
    }
    const Vec n = Vec(scenes.vector(1.0) + Vec(0.0, 0.0, 2.0)).normalized();
    const double offset = scenes.between(-0.01, 0.01);
    const List plane = {n[0], n[1], n[2], offset}, pose = scene.pose_list();
    List got(GOISHI_SEPARATION_SIZE), expected;
    EXPECT_DONE(goishi_separation(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(plane), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), Plane<double>{n, offset}), "plane");
    expected.clear();
    EXPECT_DONE(goishi_separation(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(board_list), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), board), "board");
    Scene other = scenes.next();
    const List other_pose = other.pose_list();
    expected.clear();
    EXPECT_DONE(goishi_separation_stones(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(other.stone),
                                         AS_ARRAY(other_pose), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), other.shape, other.pose()), "stone");
  }
}

List hit(const TimeOfImpact<double>& found) {
  List result;
  return result << static_cast<double>(found.status) << found.time << found.contact << found.steps << found.separations;
}

TEST(CInterface, TimeOfImpact) {
  Scenes scenes;
  int hits = 0;
  for (int i = 0; i < 100; ++i) {
    const Scene scene = scenes.next(), other = scenes.next();
    const FlightPath<double> path = path_of(scene.start, make_top_rates(scene.mass.moments), g_W);
    const FlightPath<double> other_path = path_of(other.start, make_top_rates(other.mass.moments), g_W);
    const List plane = {0.0, 0.0, 1.0, 0.01};
    List got(GOISHI_HIT_SIZE);
    EXPECT_DONE(goishi_time_of_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity), AS_ARRAY(plane),
                                      infinity, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, Plane<double>{{0, 0, 1}, 0.01}, infinity)), "plane");
    EXPECT_DONE(goishi_time_of_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity),
                                      AS_ARRAY(board_list), 0.1, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, make_board<double>(), 0.1)), "board");
    hits += static_cast<int>(got[GOISHI_HIT_STATUS]) == GOISHI_HIT ? 1 : 0;
    EXPECT_DONE(goishi_time_of_impact_stones(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(other.stone),
                                             AS_ARRAY(other.state), AS_ARRAY(gravity), 0.3, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, other.shape, other_path, 0.3)), "stone");
  }
  EXPECT_LT(10, hits);
}

List impulse(const Impulse<double>& found) {
  List result;
  return result << static_cast<double>(found.outcome) << found.impulse_W << found.normal << found.velocity_before
                << found.velocity_after << found.energy_change << found.rounds;
}

TEST(CInterface, Impacts) {
  Scenes scenes;
  for (int i = 0; i < 150; ++i) {
    const Scene scene = scenes.next(), other = scenes.next();
    const auto law = static_cast<ImpactLaw>(i % 3);
    const double e = scenes.between(0.0, 1.0), mu = scenes.between(0.0, 0.5);
    const Vec n = scenes.vector(1.0).normalized(), p = scene.start.p_WB + scenes.vector(0.01);
    const List normal = {n[0], n[1], n[2]}, point = {p[0], p[1], p[2]};
    const auto seen = [](const Scene& one) {
      return ImpactBody<double>{.mobility = make_mobility(one.mass),
                                .p_WB = one.start.p_WB,
                                .u_W = symmetry_axis(one.start.q_WB),
                                .v_WB = one.start.v_WB,
                                .L_W = one.start.L_W};
    };
    const Impact<double> found = resolve(law, make_material(e, mu), p, n, seen(scene));
    List got(GOISHI_IMPACT_SIZE), expected = impulse(found.impulse);
    EXPECT_DONE(goishi_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), static_cast<int>(law), e, mu,
                              AS_ARRAY(point), AS_ARRAY(normal), AS_ARRAY(got)));
    expect_same(got, expected << found.body.v_WB << found.body.L_W, "impact");
    const TwoBodyImpact<double> two = resolve(law, make_material(e, mu), p, n, seen(scene), seen(other));
    List got_two(GOISHI_IMPACT_STONES_SIZE), expected_two = impulse(two.impulse);
    EXPECT_DONE(goishi_impact_stones(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(other.stone),
                                     AS_ARRAY(other.state), static_cast<int>(law), e, mu, AS_ARRAY(point),
                                     AS_ARRAY(normal), AS_ARRAY(got_two)));
    expect_same(got_two, expected_two << two.first.v_WB << two.first.L_W << two.second.v_WB << two.second.L_W, "two");
  }
}

[[nodiscard]] List own_settings() {
  List result(GOISHI_SETTINGS_SIZE);
  EXPECT_DONE(goishi_settings(AS_ARRAY(result)));
  return result;
}

[[nodiscard]] List info_of(const goishi_drop* drop) {
  List result(GOISHI_DROP_SIZE);
  EXPECT_DONE(goishi_drop_info(drop, AS_ARRAY(result)));
  return result;
}

void expect_same_drop(const goishi_drop* drop, const Drop<double>& other, const std::vector<Event<double>>& events) {
  const List info = info_of(drop);
  const DropCounters& c = other.counters();
  List expected = {other.time(),
                   static_cast<double>(other.status()),
                   static_cast<double>(other.ground()),
                   other.depth(),
                   other.lower_order() ? 1.0 : 0.0,
                   other.motion_begin(),
                   static_cast<double>(other.kept()),
                   static_cast<double>(events.size())};
  expected << c.impacts << c.root_steps << c.separations << c.contact_evaluations << c.steps_accepted
           << c.steps_rejected << c.evaluations_located << c.edge_impacts;
  const List now = motion(other.state(), other.body(), other.settings().gravity);
  expected.insert(expected.end(), now.begin(), now.end());
  expect_same(info, expected, "info");
  List got(events.size() * GOISHI_EVENT_SIZE), rows;
  EXPECT_DONE(goishi_drop_events(drop, 0, AS_ARRAY(got)));
  for (const Event<double>& event : events) {
    rows << static_cast<double>(event.kind) << event.time << event.energy << event.impulse_W << event.contact_W
         << event.normal_W << static_cast<double>(event.feature) << static_cast<double>(event.other_feature)
         << static_cast<double>(event.outcome) << event.before << event.after;
  }
  expect_same(got, rows, "events");
}

TEST(CInterface, Drops) {
  Scenes scenes;
  for (int i = 0; i < 6; ++i) {
    const Scene scene = scenes.next();
    const bool on_plane = i % 3 == 2;
    List settings = own_settings();
    DropSettings<double> same_settings;
    settings[GOISHI_TOLERANCE] = same_settings.tolerance = 1e-6;
    if (i % 2 == 1) {  // all that is left to the library is set
      settings[GOISHI_RESTITUTION] = same_settings.restitution = 0.25;
      settings[GOISHI_ROLLING_RESISTANCE] = 2e-4;
      same_settings.rolling_resistance = 2e-4;
      settings[GOISHI_PIVOT_RADIUS] = 1e-4;
      same_settings.pivot_radius = 1e-4;
      settings[GOISHI_HORIZON] = 5.0;
      same_settings.horizon = 5.0;
      settings[GOISHI_LAW] = GOISHI_STRONGE;
      same_settings.law = ImpactLaw::stronge;
    }
    const List ground = on_plane ? List{0.0, 0.0, 1.0, 0.0} : board_list;
    goishi_drop* drop = nullptr;
    EXPECT_DONE(goishi_drop_create(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(ground), AS_ARRAY(settings),
                                   5000, &drop));
    Drop<double> other =
        on_plane ? Drop<double>(scene.shape, scene.body(), scene.start, same_settings)
                 : Drop<double>(scene.shape, scene.body(), scene.start, make_board<double>(), same_settings);
    other.keep_motion(5000);
    std::vector<Event<double>> events;
    EXPECT_DONE(goishi_drop_advance(drop, 0.125));
    static_cast<void>(other.advance(0.125, events));
    expect_same_drop(drop, other, events);

    goishi_drop* copy = nullptr;
    EXPECT_DONE(goishi_drop_copy(drop, &copy));
    const Vec p(0.01, 0.0, 0.01), P(2e-4, 0.0, 1e-3);
    const List point = {p[0], p[1], p[2]}, push = {P[0], P[1], P[2]};
    EXPECT_DONE(goishi_drop_push(drop, AS_ARRAY(point), AS_ARRAY(push)));
    other.apply_impulse(p, P, events);
    EXPECT_DONE(goishi_drop_advance(drop, infinity));
    static_cast<void>(other.advance_to_rest(events));
    settings[GOISHI_GRAVITY] = 0.5;
    same_settings.gravity = {0.5, 0.0, -9.80665};
    EXPECT_DONE(goishi_drop_change(drop, AS_ARRAY(settings)));
    other.change(same_settings, events);
    EXPECT_DONE(goishi_drop_advance(drop, 0.25));
    static_cast<void>(other.advance(0.25, events));
    expect_same_drop(drop, other, events);

    for (const Side side : {Side::before, Side::after}) {
      List times, expected;
      for (const Event<double>& event : events) {
        times << event.time << scenes.between(0.0, other.time());
      }
      for (const double time : times) {
        const List one = motion(other.state_at(time, side), other.body(), other.settings().gravity);
        expected.insert(expected.end(), one.begin(), one.end());
      }
      List got(times.size() * GOISHI_MOTION_SIZE);
      EXPECT_DONE(goishi_drop_motions(drop, AS_ARRAY(times), static_cast<int>(side), AS_ARRAY(got)));
      expect_same(got, expected, "motions");
    }
    EXPECT_EQ(info_of(copy)[GOISHI_DROP_TIME], 0.125);  // the copy has stayed
    goishi_drop_free(drop);
    goishi_drop_free(copy);
  }
}

TEST(CInterface, TheSettingsAreTheLibrarys) {
  const List settings = own_settings();
  const DropSettings<double> own;
  expect_same(settings,
              {own.restitution,
               own.friction,
               0.0,
               0.0,
               -9.80665,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_DRY,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_UNSET,
               0.0,
               GOISHI_CHATTERJEE_RUINA,
               GOISHI_UNSET,
               2147483647.0,
               100000.0,
               2000000.0,
               own.tolerance,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_UNSET,
               own.touching},
              "settings");
}

TEST(CInterface, Holds) {
  Scenes scenes;
  for (int i = 0; i < 24; ++i) {
    Scene scene = scenes.next();
    const double tilt = i % 4 == 0 ? 0.0 : scenes.between(0.0, 0.02);
    scene.start.q_WB = Quat<double>(std::cos(tilt / 2.0), std::sin(tilt / 2.0), 0.0, 0.0);
    scene.start.p_WB = {0.0, 0.0, support(scene.shape, Vec(scene.start.q_WB.conjugate() * Vec(0.0, 0.0, -1.0))).value};
    List pose;
    pose << scene.start;
    pose.resize(GOISHI_POSE_SIZE);
    List settings = own_settings();
    DropSettings<double> same_settings;
    settings[GOISHI_GRAVITY] = 0.25;
    same_settings.gravity.x() = 0.25;
    const List ground = i % 2 == 0 ? List{0.0, 0.0, 1.0, 0.0} : board_list;
    const Hold<double> hold = i % 2 == 0 ? holds(scene.shape, scene.pose(), Plane<double>{}, same_settings)
                                         : holds(scene.shape, scene.pose(), make_board<double>(), same_settings);
    List got(GOISHI_HOLD_SIZE);
    EXPECT_DONE(
        goishi_holds(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(ground), AS_ARRAY(settings), AS_ARRAY(got)));
    expect_same(got,
                {hold.holds ? 1.0 : 0.0, static_cast<double>(hold.contacts), hold.gap, hold.friction, hold.resistance,
                 hold.tilt},
                "hold");
  }
}

TEST(CInterface, Version) {
  EXPECT_STREQ(goishi_version(), GOISHI_EXPECTED_VERSION);
}

}  // namespace

}  // namespace goishi::web_test
