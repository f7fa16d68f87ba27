/// Meshes: how they hang together, what is refused, what they enclose; boxes and supports of stones that stand somewhere.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <goishi/mesh/board_mesh.hpp>
#include <goishi/mesh/bounds.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <limits>

#include "tests/expectations.hpp"

namespace goishi::mesh_test {

namespace {

using test::expect_invalid;
using test::expect_near;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

Mesh<double> tetrahedron() {
  Mesh<double> mesh;
  mesh.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  mesh.normals.resize(4, Vec3<double>::UnitZ());
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

Stone<double> bevelled() {
  return make_stone(0.022, 0.0092, 0.001);
}
Stone<double> sharp() {
  return make_stone(0.022, 0.0092);
}

// --- tessellation

TEST(Mesh, LevelZeroIsTwoPentagons) {
  const Mesh<double> mesh = tessellate(sharp(), Tessellation::subdivision, 0);
  EXPECT_EQ(mesh.triangles.size(), 10U);
  EXPECT_EQ(mesh.points.size(), 12U);  // two centres, and the rim's five once for each side
  EXPECT_EQ(weld(mesh, Weld::position).points.size(), 7U);
  EXPECT_EQ(mesh.points.front(), Vec3<double>(0.0, 0.0, 0.0046));
  EXPECT_EQ(unwelded(mesh).points.size(), 30U);
}

TEST(Mesh, UnweldedHasTheSameTriangles) {
  const Mesh<double> mesh = tessellate(bevelled(), Tessellation::subdivision, 1), apart = unwelded(mesh);
  ASSERT_EQ(apart.triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = mesh.triangles[i][k], own = apart.triangles[i][k];
      EXPECT_EQ(own, 3 * i + k);
      EXPECT_EQ(apart.points[own], mesh.points[corner]);
      EXPECT_EQ(apart.normals[own], mesh.normals[corner]);
    }
  }
}

TEST(Mesh, ALevelTakesFourTimesTheTriangles) {
  for (int level = 0; level <= 6; ++level) {
    const std::size_t n = std::size_t{1} << level;
    EXPECT_EQ(tessellate(sharp(), Tessellation::subdivision, level).triangles.size(), 10 * n * n);
    EXPECT_EQ(tessellate(sharp(), Tessellation::rings, level).triangles.size(), 10 * n * (2 * n - 1));
    for (const Tessellation method : {Tessellation::subdivision, Tessellation::rings}) {
      const Fineness fineness = fineness_of_level(bevelled(), level);
      EXPECT_EQ(tessellate(bevelled(), method, level).triangles.size(), triangle_count(method, fineness));
    }
  }
}

TEST(Mesh, ALevelKeepsTheCornersOfTheOneBefore) {
  const Mesh<double> coarse = tessellate(sharp(), Tessellation::subdivision, 3);
  const Mesh<double> fine = tessellate(sharp(), Tessellation::subdivision, 4);
  for (const Vec3<double>& p : coarse.points) {
    double nearest = 1.0;
    for (const Vec3<double>& q : fine.points) {
      nearest = std::min(nearest, (p - q).norm());
    }
    EXPECT_LT(nearest, 1e-17);
  }
}

TEST(Mesh, ABallHasNoEdge) {
  const Mesh<double> mesh = tessellate(make_stone(0.022, 0.022), Tessellation::subdivision, 2);
  EXPECT_EQ(weld(mesh, Weld::position).points.size(), mesh.points.size());
  EXPECT_TRUE(topology(mesh).is_closed());
}

TEST(Mesh, ARimMayBeFinerThanTheCaps) {
  for (const int segments : {3, 4, 7, 20}) {
    const Fineness fineness{3, 2, segments};
    const Mesh<double> mesh = tessellate(bevelled(), Tessellation::subdivision, fineness);
    EXPECT_EQ(mesh.triangles.size(), triangle_count(Tessellation::subdivision, fineness));
    EXPECT_TRUE(topology(mesh).is_closed());
    EXPECT_EQ(topology(mesh).euler_characteristic(), 2);
    const Mesh<double> rings = tessellate(bevelled(), Tessellation::rings, {3, 2, segments});
    EXPECT_EQ(rings.triangles.size(), triangle_count(Tessellation::rings, fineness));
    EXPECT_TRUE(topology(rings).is_closed());
  }
}

TEST(Mesh, NormalsAreTheSurfacesOwn) {
  const Mesh<double> mesh = tessellate(bevelled(), Tessellation::subdivision, 4);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_NEAR(mesh.normals[i].norm(), 1.0, 4e-16);
    EXPECT_LT(
        (closest_point(bevelled(), Vec3<double>(mesh.points[i] + 1e-3 * mesh.normals[i])).p_B - mesh.points[i]).norm(),
        1e-17);
  }
}

TEST(Mesh, InFloat) {
  const Stone<float> stone = make_stone(0.022F, 0.0092F, 0.001F);
  const Mesh<float> mesh = tessellate(stone, Tessellation::subdivision, 4);
  EXPECT_TRUE(topology(mesh).is_closed());
  EXPECT_EQ(topology(mesh).euler_characteristic(), 2);
  EXPECT_NEAR(static_cast<double>(deviation(mesh, stone)),
              deviation(tessellate(bevelled(), Tessellation::subdivision, 4), bevelled()), 1e-7 * 0.022);
}

TEST(Mesh, RefusesWhatIsNotASize) {
  for (const int level : {-1, 9, 1 << 30}) {
    expect_invalid("level", [&] { static_cast<void>(tessellate(sharp(), Tessellation::rings, level)); });
  }
  const auto refused = [](const char* argument, const Stone<double>& stone, const Fineness& fineness) {
    expect_invalid(argument, [&] { static_cast<void>(tessellate(stone, Tessellation::subdivision, fineness)); });
  };
  refused("rings", sharp(), {0, 0, 1});
  refused("rings", sharp(), {1025, 0, 1025});
  refused("rows", sharp(), {1, 1, 1});
  refused("rows", bevelled(), {1, 0, 1});
  refused("rows", bevelled(), {1, 1025, 1});
  refused("segments", bevelled(), {2, 1, 1});
  refused("segments", bevelled(), {2, 1, 1025});
  refused("stone", Stone<double>(), {1, 0, 1});
}

// --- welding, topology

TEST(Mesh, WeldingJoinsWhatIsEqual) {
  Mesh<double> mesh = unwelded(tetrahedron());
  EXPECT_EQ(mesh.points.size(), 12U);
  EXPECT_EQ(weld(mesh).points.size(), 4U);
  mesh.normals[0] = Vec3<double>::UnitX();
  EXPECT_EQ(weld(mesh).points.size(), 5U);
  EXPECT_EQ(weld(mesh, Weld::position).points.size(), 4U);
  mesh.points[0].x() = -0.0;  // equal to 0
  EXPECT_EQ(weld(mesh, Weld::position).points.size(), 4U);
  mesh.points[0].x() = 1e-300;
  EXPECT_EQ(weld(mesh, Weld::position).points.size(), 5U);
  mesh.triangles.pop_back();
  EXPECT_EQ(weld(mesh, Weld::position).triangles.size(), 3U);
}

TEST(Mesh, TopologySeesHolesAndTurnedTriangles) {
  Mesh<double> mesh = tetrahedron();
  const Topology whole = topology(mesh);
  EXPECT_TRUE(whole.is_closed());
  EXPECT_EQ(whole.edges, 6U);
  EXPECT_EQ(whole.euler_characteristic(), 2);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(topology(mesh).loose_edges, 3U);
  mesh.triangles.erase(mesh.triangles.begin());
  EXPECT_EQ(topology(mesh).loose_edges, 3U);
  EXPECT_FALSE(topology(mesh).is_closed());
  mesh = tetrahedron();
  mesh.triangles.push_back({1, 2, 3});
  EXPECT_EQ(topology(mesh).loose_edges, 3U);
  mesh = tetrahedron();
  mesh.triangles.push_back({1, 1, 2});
  EXPECT_EQ(topology(mesh).degenerate, 1U);
  EXPECT_FALSE(topology(mesh).is_closed());
  EXPECT_EQ(topology(Mesh<double>()).points, 0U);
}

TEST(Mesh, RefusesTrianglesOfNoPoints) {
  Mesh<double> mesh = tetrahedron();
  mesh.triangles[1][2] = 4;
  expect_invalid("triangles", [&] { static_cast<void>(weld(mesh)); });
  expect_invalid("triangles", [&] { static_cast<void>(mesh_mass(mesh)); });
  mesh = tetrahedron();
  mesh.normals.pop_back();
  expect_invalid("normals", [&] { static_cast<void>(topology(mesh)); });
}

// --- distance

TEST(Mesh, ASharpRimIsAsFarAsItsChords) {
  const Mesh<double> mesh = tessellate(make_stone(1.0, 0.01), Tessellation::subdivision, {2, 0, 2});
  EXPECT_NEAR(deviation(mesh, make_stone(1.0, 0.01)), 0.5 * (1.0 - std::cos(scalar::pi<double>() / 10.0)), 1e-9);
}

TEST(Mesh, AToleranceIsKept) {
  for (const Stone<double>& stone : {sharp(), bevelled(), make_stone(0.022, 0.022), make_stone(0.022, 1e-5, 1e-7)}) {
    for (const Tessellation method : {Tessellation::subdivision, Tessellation::rings}) {
      for (const double tolerance : {1.0, 1e-3, 1e-4, 1.7e-5}) {
        const double off = deviation(tessellate(stone, method, fineness_for(stone, method, tolerance)), stone);
        EXPECT_LE(off, tolerance);
      }
    }
  }
  EXPECT_EQ(fineness_for(sharp(), Tessellation::subdivision, 1.0), (Fineness{1, 0, 1}));
}

TEST(Mesh, RefusesTolerancesThatAreNone) {
  for (const double tolerance : {0.0, -1e-3, no_number, 1e-30, 1e-15, 1e-12}) {
    expect_invalid("tolerance",
                   [&] { static_cast<void>(fineness_for(sharp(), Tessellation::subdivision, tolerance)); });
  }
  Mesh<double> open = tessellate(sharp(), Tessellation::subdivision, 1);
  open.triangles.pop_back();
  expect_invalid("mesh", [&] { static_cast<void>(deviation(open, sharp())); });
  open.triangles.push_back({0, 0, 1});
  expect_invalid("mesh", [&] { static_cast<void>(deviation(open, sharp())); });
}

// --- mass

TEST(Mesh, ATetrahedronsMass) {
  const MeshMass<double> mass = mesh_mass(tetrahedron());
  EXPECT_DOUBLE_EQ(mass.volume, 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(mass.surface_area, 1.5 + std::sqrt(3.0) / 2.0);
  expect_near(mass.centre, {0.25, 0.25, 0.25}, 1e-16);
  // ∫ x² = 1/60, ∫ xy = 1/120 about the corner; the centre's share is V/16.
  EXPECT_NEAR(mass.tensor(0, 0), 2.0 / 60.0 - 2.0 / 96.0, 1e-16);
  EXPECT_NEAR(mass.tensor(0, 1), -(1.0 / 120.0 - 1.0 / 96.0), 1e-16);
}

TEST(Mesh, NoVolumeIsRefused) {
  Mesh<double> mesh = tetrahedron();
  for (Triangle& triangle : mesh.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  expect_invalid("mesh", [&] { static_cast<void>(mesh_mass(mesh)); });
  expect_invalid("mesh", [] { static_cast<void>(mesh_mass(Mesh<double>())); });
  mesh = tetrahedron();
  mesh.points[1].x() = no_number;
  expect_invalid("mesh", [&] { static_cast<void>(mesh_mass(mesh)); });
}

// --- the board

TEST(Mesh, TheBoardIsABlockWithLinesAndStars) {
  const Board<double> board = make_board<double>();
  const BoardMesh<double> mesh = mesh_of(board);
  EXPECT_EQ(mesh.block.points.size(), 24U);
  EXPECT_TRUE(topology(mesh.block).is_closed());
  EXPECT_EQ(topology(mesh.block).points, 8U);
  const MeshMass<double> mass = mesh_mass(mesh.block);
  EXPECT_NEAR(mass.volume, 0.4242 * 0.4545 * 0.1515, 1e-16);
  expect_near(mass.centre, {0.0, 0.0, -0.07575}, 1e-16);
  EXPECT_EQ(mesh.lines.triangles.size(), 2U * 38U);
  EXPECT_EQ(mesh.star_points.triangles.size(), 9U * 32U);
  for (const Mesh<double>* flat : {&mesh.lines, &mesh.star_points}) {
    for (const Triangle& t : flat->triangles) {
      const Vec3<double> a = flat->points[t[0]], b = flat->points[t[1]], c = flat->points[t[2]];
      EXPECT_GT((b - a).cross(c - a).z(), 0.0);
      EXPECT_EQ(a.z(), 0.0);
      EXPECT_LT(std::fabs(a.x()), board.half_width);
    }
  }
  expect_near(mesh.lines.points[0], {-0.1985, -0.2138, 0.0}, 1e-16);
}

TEST(Mesh, MarksThatDoNotFitAreRefused) {
  const Board<double> board = make_board<double>();
  const auto refused = [&](const char* argument, const BoardMarks<double>& marks) {
    expect_invalid(argument, [&] { static_cast<void>(mesh_of(board, marks)); });
  };
  refused("line_width", {.line_width = 0.0});
  refused("line_width", {.line_width = 0.022});
  refused("star_diameter", {.star_diameter = no_number});
  refused("star_segments", {.star_segments = 2});
  refused("star_segments", {.star_segments = 1001});
  expect_invalid("board", [] { static_cast<void>(mesh_of(Board<double>())); });
}

// --- boxes, supports

TEST(Mesh, BoxesOfStonesThatStand) {
  const Stone<double> stone = sharp();
  const Bounds<double> flat = bounds(stone, {{1.0, 2.0, 3.0}, {1.0, 0.0, 0.0, 0.0}});
  expect_near(flat.low, {0.989, 1.989, 2.9954}, 1e-15);
  expect_near(flat.high, {1.011, 2.011, 3.0046}, 1e-15);
  const Bounds<double> upright = bounds(stone, {{0.0, 0.0, 0.0}, {std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0}});
  expect_near(upright.high, {0.011, 0.0046, 0.011}, 1e-17);
  expect_invalid("position", [&] { static_cast<void>(bounds(stone, {{0.0, 0.0, no_number}, {1.0, 0.0, 0.0, 0.0}})); });
  expect_invalid("attitude", [&] { static_cast<void>(bounds(stone, {{0.0, 0.0, 0.0}, {1.0, 0.1, 0.0, 0.0}})); });
}

TEST(Mesh, SupportInTheWorld) {
  const Stone<double> stone = bevelled();
  const Pose<double> pose{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}};  // upside down
  const SupportInWorld<double> top = support(stone, pose, Vec3<double>(0.0, 0.0, 1.0));
  EXPECT_DOUBLE_EQ(top.value, 0.0046);
  EXPECT_EQ(top.feature, Feature::lower_cap);
  expect_near(top.p_W, {1.0, 0.0, 0.0046}, 1e-17);
  const SupportInWorld<double> side = support(stone, pose, Vec3<double>(1.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(side.value, 1.0 + outer_width(stone) / 2.0);
  EXPECT_EQ(side.feature, Feature::rim);
  expect_invalid("normal", [&] { static_cast<void>(support(stone, pose, Vec3<double>(1.0, 1.0, 0.0))); });
}

}  // namespace

}  // namespace goishi::mesh_test
