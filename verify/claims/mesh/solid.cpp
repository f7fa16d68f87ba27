/// MESH: what a mesh encloses; boxes and supports of stones that stand somewhere.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/mesh/board_mesh.hpp>
#include <goishi/mesh/bounds.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/contact.hpp"

namespace goishi::verify {

namespace {

// --- MESH-4

/// Turned and moved.
Mesh<double> moved(Mesh<double> mesh, const Quat<double>& q, const Vec3<double>& p) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    mesh.points[i] = q * mesh.points[i] + p;
    mesh.normals[i] = q * mesh.normals[i];
  }
  return mesh;
}

/// Inside out.
Mesh<double> reversed(Mesh<double> mesh) {
  for (Triangle& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

Mesh<double> together(Mesh<double> one, const Mesh<double>& other) {
  const auto first = static_cast<std::uint32_t>(one.points.size());
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  one.normals.insert(one.normals.end(), other.normals.begin(), other.normals.end());
  for (const Triangle& t : other.triangles) {
    one.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return one;
}

/// A block with sides a, b, c: a board of one line.
Mesh<double> block(const Vec3<double>& sides) {
  const Board<double> board = make_board<double>({.lines = 1,
                                                  .spacing_x = 1.0,
                                                  .spacing_y = 1.0,
                                                  .border_x = sides.x() / 2.0,
                                                  .border_y = sides.y() / 2.0,
                                                  .thickness = sides.z()});
  return moved(mesh_of(board, {.line_width = 0.1, .star_diameter = 0.1}).block, Quat<double>::Identity(),
               {0.0, 0.0, sides.z() / 2.0});
}

/// Volume, area and diagonal of the tensor of a block about its middle.
struct Block {
  double volume, area;
  Vec3<double> moments;
};
Block exact_block(const Vec3<double>& s) {
  const double V = s.x() * s.y() * s.z();
  const Vec3<double> q = s.cwiseProduct(s);
  return {V, 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()),
          V / 12.0 * Vec3<double>(q.y() + q.z(), q.z() + q.x(), q.x() + q.y())};
}

Measurement measure_polyhedra(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(500, 5000); ++i) {
    const Vec3<double> sides(context.uniform(0.5, 2.0), context.uniform(0.5, 2.0), context.uniform(0.5, 2.0));
    const Quat<double> q = i % 3 == 0 ? exact_attitudes[static_cast<std::size_t>(i / 3) % exact_attitudes.size()]
                                      : draw_attitude(context.random());
    const Vec3<double> p = i % 2 == 0 ? Vec3<double>::Zero() : Vec3<double>(draw_unit(context) * 10.0);
    // Full, or with a hollow of its own shape.
    const double hollow = i % 4 == 0 ? 0.0 : context.uniform(0.1, 0.9);
    Mesh<double> mesh = block(sides);
    Block expected = exact_block(sides);
    if (0.0 < hollow) {
      mesh = together(mesh, reversed(block(hollow * sides)));
      const Block inner = exact_block(hollow * sides);
      expected.volume -= inner.volume;
      expected.area += inner.area;
      expected.moments -= inner.moments;
    }
    const MeshMass<double> found = mesh_mass(moved(mesh, q, p));
    const Mat3<double> R = q.toRotationMatrix(), tensor = R * expected.moments.asDiagonal() * R.transpose();
    const auto told = [&] { return fmt::format("sides {}, hollow {:a}, at {}", describe(sides), hollow, describe(p)); };
    const double far = 1.0 + p.norm();  // corners are rounded there
    checks["volume"].see(std::fabs(context.produced(found.volume) / expected.volume - 1.0), far, told);
    checks["area"].see(std::fabs(context.produced(found.surface_area) / expected.area - 1.0), far, told);
    checks["centre"].see((context.produced(found.centre) - p).norm(), far, told);
    checks["tensor"].see((context.produced(found.tensor) - tensor).norm() / tensor.norm(), far, told);
  }
  return checks.measurement();
}

// --- MESH-6

Measurement measure_bounds(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(1000, 10000); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Hull<Digits50> hull = hull_of(specimen);
    const double width = outer_width(specimen.stone);
    const Quat<double> q = i % 4 == 0 ? exact_attitudes[static_cast<std::size_t>(i / 4) % exact_attitudes.size()]
                                      : draw_attitude(context.random());
    const Pose<double> pose{
        i % 3 == 0 ? Vec3<double>::Zero() : Vec3<double>(draw_unit(context) * width / draw_small(context, 3.0)), q};
    const double scale = width + pose.p_WB.cwiseAbs().maxCoeff();
    const auto told = [&] { return describe(specimen, pose); };
    const Digits50 w(q.w()), x(q.x()), y(q.y()), z(q.z());
    const Exact3 axis = Exact3(2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z) /
                        Digits50(w * w + x * x + y * y + z * z);
    // The support where it stands, by the outline's candidates.
    const auto expected = [&](const Vec3<double>& n) {
      const Exact3 unit = exact(n) / Digits50(sqrt(exact(n).squaredNorm()));
      const Digits50 along = unit.dot(axis), across = sqrt(Digits50(1 - along * along));
      const auto [rho, height] = farthest(hull, across, along);
      return static_cast<double>(Digits50(unit.dot(exact(pose.p_WB)) + rho * across + height * along));
    };
    const Bounds<double> box = bounds(specimen.stone, pose);
    for (int k = 0; k < 3; ++k) {
      const Vec3<double> e = Vec3<double>::Unit(k);
      checks["box"].see(std::fabs(context.produced(box.high[k]) - expected(e)), scale, told);
      checks["box"].see(std::fabs(context.produced(box.low[k]) + expected(-e)), scale, told);
    }
    const Vec3<double> n = i % 5 == 0 ? Vec3<double>::Unit(i % 3) : draw_unit(context);
    const SupportInWorld<double> seen = support(specimen.stone, pose, n);
    checks["support"].see(std::fabs(context.produced(seen.value) - expected(n)), scale, told);
    checks["point"].see(std::fabs(context.produced(seen.p_W).dot(n) - expected(n)), scale, told);
    checks["point in the stone"].see(
        std::max(0.0,
                 signed_distance<double>(specimen.stone, q.conjugate() * (context.produced(seen.p_W) - pose.p_WB))),
        scale, told);
  }
  return checks.measurement();
}

// --- MESH-7, MESH-8

constexpr std::array<const char*, 4> quantities = {"volume", "area", "axial", "transverse"};

std::array<double, 4> values(const MeshMass<double>& mass) {
  return {mass.volume, mass.surface_area, mass.tensor(2, 2), (mass.tensor(0, 0) + mass.tensor(1, 1)) / 2.0};
}
std::array<double, 4> values(const MassProperties<double>& mass) {
  return {mass.volume, mass.surface_area, mass.moments.axial, mass.moments.transverse};
}

/// f(name, truth, of each level what the mesh encloses), of catalogue stones: n rings and, of bevelled ones, n rows.
template <class F>
void for_each_refined(Context& context, int levels, F&& f) {
  int i = 0;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const bool bevelled = i % 2 == 0;
    if (context.tier() == Tier::quick && i++ % 7 != 0) {
      return;
    }
    for (const double bevel : {0.0, bevelled ? 1e-6 * catalogue::table_bevel : 5e-4}) {
      const Stone<double> stone = make_stone(entry, bevel);
      std::vector<std::array<double, 4>> found;
      for (int level = 0; level <= levels; ++level) {
        const int n = 2 << level;
        found.push_back(
            values(mesh_mass(tessellate(stone, Tessellation::subdivision, Fineness{n, bevel > 0.0 ? n : 0, n}))));
      }
      f(fmt::format("{}, bevel {} m", name, bevel), values(mass_properties(stone, Density{1.0})), found);
    }
  });
}

Measurement measure_extrapolated(Context& context) {
  Checks checks;
  for_each_refined(context, 6, [&](const std::string& name, const auto& truth, auto found) {
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      // Romberg's table: each column takes the next even power away.
      std::vector<double> column;
      for (const auto& values : found) {
        column.push_back(values[q]);
      }
      for (double power = 4.0; column.size() > 1; power *= 4.0) {
        for (std::size_t k = 0; k + 1 < column.size(); ++k) {
          column[k] = column[k + 1] + (column[k + 1] - column[k]) / (power - 1.0);
        }
        column.pop_back();
      }
      checks[quantities[q]].see(std::fabs(column.front() / context.produced(truth[q]) - 1.0), [&] { return name; });
    }
  });
  return checks.measurement();
}

Measurement measure_order(Context& context) {
  Checks checks;
  for_each_refined(context, 5, [&](const std::string& name, const auto& truth, const auto& found) {
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      const auto off = [&](std::size_t level) { return context.produced(truth[q]) - found[level][q]; };
      const double order = std::log2(off(4) / off(5));
      checks[quantities[q]].see(std::fabs(order - 2.0), [&] { return fmt::format("{}: {}", name, order); });
    }
  });
  return checks.measurement();
}

}  // namespace

std::vector<Claim> mesh_solid_claims() {
  return {
      {.id = "MESH-4",
       .statement = "Volume, area, centre and tensor of closed meshes are those of the blocks that they bound, full or "
                    "hollow, turned and moved.",
       .function = "mesh_mass, mesh_of",
       .family = OracleFamily::exact,
       .oracle = "a block's V = abc, I = V (b² + c²)/12",
       .checks = {within("volume", 2e-14, "relative", "some roundings"), within("area", 4e-15, "relative", "the same"),
                  within("centre", 2e-14, "of size and distance", "the same"),
                  within("tensor", 4e-14, "relative", "the same")},
       .measure = measure_polyhedra},
      {.id = "MESH-6",
       .statement = "Box and support of a stone that stands somewhere are exact.",
       .function = "bounds, support",
       .family = OracleFamily::other_formula,
       .oracle = "the stone by ruler and compass, 50 digits",
       .checks = {within("box", 1e-15, "of width and distance", "some roundings"),
                  within("support", 2e-15, "of width and distance", "the same"),
                  within("point", 2e-15, "of width and distance", "the same"),
                  within("point in the stone", 2e-15, "of width and distance", "the same")},
       .measure = measure_bounds},
      {.id = "MESH-7",
       .statement = "Meshes that are refined tend to the closed forms of volume, area and moments: Richardson's "
                    "extrapolation meets them.",
       .function = "mass_properties",
       .family = OracleFamily::quadrature,
       .oracle = "the divergence theorem on meshes with 2 … 128 rings, extrapolated",
       .checks = {within("volume", 2e-11, "relative",
                         "what is left of the sums, of a bar of 1e-10; measured 2026-11-30: up to 1.8e-12"),
                  within("area", 2e-11, "relative",
                         "what is left of the sums, of a bar of 1e-10; measured 2026-11-30: up to 1.8e-12"),
                  within("axial", 2e-12, "relative", "the same; up to 3.3e-14"),
                  within("transverse", 2e-11, "relative",
                         "what is left of the sums, of a bar of 1e-10; measured 2026-11-30: up to 1.8e-12")},
       .measure = measure_extrapolated},
      {.id = "MESH-8",
       .statement = "What a mesh encloses is of second order in its edges.",
       .function = "tessellate, mesh_mass",
       .family = OracleFamily::exact,
       .oracle = "the closed forms",
       .checks = {within("volume", 0.01, "of the order", "the next term is of fourth order"),
                  within("area", 0.01, "of the order", "the same"), within("axial", 0.01, "of the order", "the same"),
                  within("transverse", 0.01, "of the order", "the same")},
       .measure = measure_order},
  };
}

}  // namespace goishi::verify
