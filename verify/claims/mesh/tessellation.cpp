/// MESH: a stone's triangles, how they hang together, how far they are from it, how few they are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <map>
#include <set>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/stone/triangles.hpp"
#include "verify/samples/contact.hpp"

namespace goishi::verify {

namespace {

constexpr Tessellation methods[] = {Tessellation::subdivision, Tessellation::rings};

/// f(stone, name): of the catalogue, sharp, with the table's bevel and so that the finished stone has the catalogue's width; the
/// ball, a thin lens, bevels next to nothing and next to all.
template <class F>
void for_each_meshed_stone(F&& f) {
  const double bevel = catalogue::table_bevel * 1e-6;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    f(make_stone(entry), name + ", sharp");
    f(make_stone(entry, bevel), name + ", bevelled");
    f(make_measured_stone(metres<double>(entry.width), metres<double>(entry.height), bevel), name + ", measured");
  });
  f(make_stone(0.022, 0.022), "ball");
  f(make_stone(0.022, 0.022, 0.01), "ball with a band");
  f(make_stone(0.022, 22e-6), "thin");
  f(make_stone(0.022, 22e-6, 1e-6), "thin, bevelled");
  f(make_stone(0.022, 0.0092, 1e-9), "bevel of 1 nm");
  f(make_stone(0.022, 0.0092, 0.0091999), "bevel of nearly all");
}

// --- MESH-1

Measurement measure_corners(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(60, 600); ++i) {
    const Specimen specimen = draw_specimen(context, i, 1e-9);
    const Hull<Digits50> hull = hull_of(specimen);
    const double width = outer_width(specimen.stone);
    const int rings = 1 + i % 7;
    const Fineness fineness{rings, specimen.stone.bevel > 0.0 ? 1 + i % 5 : 0, rings + i % 3};
    const Mesh<double> mesh = tessellate(specimen.stone, methods[i % 2], fineness);
    const auto told = [&] { return fmt::format("{}, {} rings", describe(specimen), rings); };
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      const Exact3 p = exact(context.produced(mesh.points[k])), n = exact(context.produced(mesh.normals[k]));
      const auto radius = [](const Exact3& v) { return Digits50(sqrt(v.x() * v.x() + v.y() * v.y())); };
      const Foot foot = closest_foot(hull, radius(p), p.z());
      checks["point"].see(static_cast<double>(foot.distance), width, told);
      // The support in the vertex's own normal is reached at the vertex: to second order in what it is off.
      const auto [rho, z] =
          farthest(hull, Digits50(radius(n) / sqrt(n.squaredNorm())), Digits50(n.z() / sqrt(n.squaredNorm())));
      const Digits50 beyond = (rho * radius(n) + z * n.z()) - (p.x() * n.x() + p.y() * n.y() + p.z() * n.z());
      checks["normal"].see(std::fabs(static_cast<double>(beyond)), width, told);
      checks["unit"].see(std::fabs(static_cast<double>(Digits50(n.squaredNorm() - 1))), told);
    }
  }
  return checks.measurement();
}

// --- MESH-2

/// Counts of a mesh that know nothing of welding: points and edges by their coordinates.
struct Counted {
  std::set<Point3> points;
  std::map<std::pair<Point3, Point3>, int> directed;  // edges as the triangles pass them
  std::size_t wrong = 0;                              // triangles without area, or not facing outwards
};

Point3 point3(const Vec3<double>& v) {
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
}

Counted count(const Mesh<double>& mesh) {
  Counted counted;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3<double>&a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]], &c = mesh.points[triangle[2]];
    const Vec3<double> across = (b - a).cross(c - a);
    bool right = across.dot(a) > 0.0;  // the origin is inside
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 from = point3(mesh.points[triangle[k]]), to = point3(mesh.points[triangle[(k + 1) % 3]]);
      counted.points.insert(from);
      ++counted.directed[{from, to}];
      right = right && mesh.points[triangle[k]].dot(mesh.normals[triangle[k]]) > 0.0;
    }
    counted.wrong += right ? 0 : 1;
  }
  return counted;
}

Measurement measure_topology(Context& context) {
  Checks checks;
  std::string welded;
  const int finest = context.samples(3, 5);
  for_each_meshed_stone([&](const Stone<double>& stone, const std::string& name) {
    for (const Tessellation method : methods) {
      for (int level = 0; level <= finest_level; ++level) {
        const auto told = [&] { return fmt::format("{}, {}, level {}", name, to_string(method), level); };
        if (finest < level && !(name == "size 33 white, bevelled" && (level < 7 || context.tier() == Tier::full))) {
          continue;
        }
        const Mesh<double> mesh = tessellate(stone, method, level);
        const Topology topology = goishi::topology(mesh);
        see_choice(checks["closed"], topology.is_closed() && topology.euler_characteristic() == 2, told);
        const Mesh<double> soup = unwelded(mesh), again = weld(soup), solid = weld(mesh, Weld::position);
        see_choice(checks["welding"],
                   soup.points.size() == 3 * mesh.triangles.size() && again.points.size() == mesh.points.size() &&
                       again.triangles.size() == mesh.triangles.size() && solid.points.size() == topology.points,
                   told);
        if (level <= 3) {
          const Counted counted = count(mesh);
          std::size_t single = 0;
          for (const auto& [edge, times] : counted.directed) {
            const auto back = counted.directed.find({edge.second, edge.first});
            single += times == 1 && back != counted.directed.end() && back->second == 1 ? 0 : 1;
          }
          see_choice(checks["facing"], counted.wrong == 0, told);
          see_choice(checks["counts"],
                     single == 0 && counted.points.size() == topology.points &&
                         counted.directed.size() == 2 * topology.edges && mesh.triangles.size() == topology.triangles,
                     told);
        }
        if (name == "size 33 white, sharp" && level <= 6 && method == Tessellation::subdivision) {
          welded += fmt::format("{}{}: {} → {} → {}", welded.empty() ? "" : "; ", level, soup.points.size(),
                                mesh.points.size(), solid.points.size());
        }
      }
    }
  });
  return checks.measurement(
      {{"corners of all triangles → vertices by position and normal → by position, of a sharp 33, by level", welded}});
}

// --- MESH-3

/// The greatest distance of the surface from the mesh, in a sector of it: sampled, and refined from the best of the samples.
double sampled_distance(const Hull<long double>& hull, const Mesh<double>& mesh, int steps) {
  Triangles triangles;
  for (const Triangle& t : mesh.triangles) {
    triangles.add(point3(mesh.points[t[0]]), point3(mesh.points[t[1]]), point3(mesh.points[t[2]]));
  }
  const auto at = [&](double s, double azimuth) {
    const auto [rho, z] = outline(hull, static_cast<long double>(std::clamp(s, 0.0, 1.0)));
    const double r = static_cast<double>(rho);
    return triangles.distance({r * std::cos(azimuth), r * std::sin(azimuth), static_cast<double>(z)});
  };
  struct Sample {
    double distance, s, azimuth;
  };
  std::vector<Sample> samples;
  const double sector = 2.0 * 3.141592653589793 / 5.0;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double s = static_cast<double>(i) / steps, azimuth = sector * (j + 0.5) / steps;
      samples.push_back({at(s, azimuth), s, azimuth});
    }
  }
  std::ranges::sort(samples, std::greater(), &Sample::distance);
  double greatest = 0.0;
  for (std::size_t k = 0; k < std::min<std::size_t>(60, samples.size()); ++k) {
    Sample best = samples[k];
    for (double step = 1.0 / steps; step > 1e-5 / steps; step /= 2.0) {
      for (bool better = true; better;) {
        better = false;
        for (const auto& [ds, da] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
          const double s = best.s + ds, azimuth = best.azimuth + sector * da, there = at(s, azimuth);
          if (best.distance < there) {
            best = {there, s, azimuth};
            better = true;
          }
        }
      }
    }
    greatest = std::max(greatest, best.distance);
  }
  return greatest;
}

Measurement measure_deviation(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(12, 60); ++i) {
    // As thick as stones are, and thinner; the ball; sharp every third.
    const Specimen specimen = draw_specimen(context, i, 0.02);
    const Stone<double>& stone = specimen.stone;
    const int rings = 1 + i % 6;
    const Tessellation method = methods[i % 2];
    const Fineness fineness{rings, stone.bevel > 0.0 ? std::min(40, detail::rows_for(stone, rings)) : 0, rings + i % 4};
    const Mesh<double> mesh = tessellate(stone, method, fineness);
    const double stated = context.produced(deviation(mesh, stone));
    const double found = sampled_distance(narrow(hull_of(specimen)), mesh, context.samples(60, 120));
    const auto told = [&] {
      return fmt::format("{}, {}, {} rings, {} rows", describe(specimen), to_string(method), rings, fineness.rows);
    };
    worst.see(std::fabs(stated / found - 1.0), told);
  }
  return worst.measurement();
}

// --- MESH-5

/// ∫ √(κ₁ κ₂) dA over a stone   [m], of which a mesh with its corners on the surface needs 2/(3√3 δ) triangles at least, for a
/// small distance δ: where they are equilateral, measured by the curvatures.
double curvature_integral(const Hull<long double>& hull) {
  const double pi = 3.141592653589793;
  const double caps = 4.0 * pi * static_cast<double>(hull.height / 2 - hull.band);  // area over r, of two
  if (!(hull.tube_radius > 0)) {
    return caps;
  }
  const double r1 = static_cast<double>(hull.torus_radius), r2 = static_cast<double>(hull.tube_radius);
  const double joint = std::asin(std::min(1.0, static_cast<double>(hull.band) / r2));
  constexpr int steps = 2000;
  double band = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double phi = joint * (2.0 * (i + 0.5) / steps - 1.0);
    band += std::sqrt(std::cos(phi) * (r1 + r2 * std::cos(phi)) * r2);
  }
  return caps + 2.0 * pi * band * 2.0 * joint / steps;
}

Measurement measure_fineness(Context& context) {
  Checks checks;
  double least[2] = {1e300, 1e300}, most[2] = {0.0, 0.0};
  int stones = 0;
  int place = 0;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    if (place++ % context.samples(17, 5) != 0) {
      return;
    }
    for (const double bevel : {0.0, 1e-6 * catalogue::table_bevel}) {
      const Stone<double> stone = make_stone(entry, bevel);
      const Hull<long double> hull = narrow(construct_hull(1e-6 * entry.width, 1e-6 * entry.height, bevel));
      ++stones;
      for (std::size_t method = 0; method < 2; ++method) {
        const double tolerance = 1e-6 * std::pow(10.0, context.uniform(-0.5, 0.0));
        const Fineness fineness = fineness_for(stone, methods[method], tolerance);
        const Mesh<double> mesh = tessellate(stone, methods[method], fineness);
        const auto told = [&] {
          return fmt::format("{}, bevel {} m, {}, tolerance {:a}", name, bevel, to_string(methods[method]), tolerance);
        };
        const double part = context.produced(deviation(mesh, stone)) / tolerance;
        checks["kept"].see(part, told);
        const double best = 2.0 / (3.0 * std::sqrt(3.0)) * curvature_integral(hull) / tolerance;
        const double ratio = context.produced(static_cast<double>(mesh.triangles.size())) / best;
        least[method] = std::min(least[method], ratio);
        most[method] = std::max(most[method], ratio);
        checks[method == 0 ? "subdivision" : "rings"].see(ratio, told);
      }
    }
  });
  return checks.measurement(
      {{"triangles over the least possible, subdivision", fmt::format("{:.2f} … {:.2f}", least[0], most[0])},
       {"the same, rings", fmt::format("{:.2f} … {:.2f}", least[1], most[1])},
       {"stones", fmt::format("{}", stones)}});
}

// --- pictures

/// The edges of what is seen from the front, above: a stone beside others.
void draw_wires(Series& wires, const Mesh<double>& mesh, double shift) {
  const double tilt = 1.0, c = std::cos(tilt), s = std::sin(tilt);  // rad, between the line of sight and the axis
  std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;
  const Mesh<double> solid = weld(mesh, Weld::position);
  const auto seen = [&](const Vec3<double>& p) {
    return std::pair{1e3 * (p.x() + shift), 1e3 * (c * p.y() + s * p.z())};
  };
  for (const Triangle& triangle : solid.triangles) {
    const Vec3<double>&a = solid.points[triangle[0]], &b = solid.points[triangle[1]], &d = solid.points[triangle[2]];
    const Vec3<double> across = (b - a).cross(d - a);
    if (-s * across.y() + c * across.z() <= 0.0) {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      if (drawn.emplace(std::min(from, to), std::max(from, to)).second) {
        wires.points.push_back(seen(solid.points[from]));
        wires.points.push_back(seen(solid.points[to]));
      }
    }
  }
}

std::vector<Plot> pictures() {
  std::vector<Plot> plots;
  for (const double bevel : {0.0, 1e-6 * catalogue::table_bevel}) {
    for (const Tessellation method : methods) {
      Plot plot{.title = fmt::format("Stones 22, 33 and 40, {}, level 3, by {}", bevel > 0.0 ? "bevelled" : "sharp",
                                     to_string(method)),
                .x_label = "mm",
                .y_label = "mm",
                .equal_scale = true,
                .series = {}};
      int place = 0;
      for (const int number : {22, 33, 40}) {
        const Mesh<double> mesh = tessellate(make_stone(catalogue_stone(number, StoneColor::white), bevel), method, 3);
        Series wires{
            .name = fmt::format("{}: {} triangles, {} vertices", number, mesh.triangles.size(), mesh.points.size()),
            .points = {},
            .segments = true};
        draw_wires(wires, mesh, 0.024 * place++);
        plot.series.push_back(std::move(wires));
      }
      plots.push_back(std::move(plot));
    }
  }
  return plots;
}

Measurement measure_topology_with_pictures(Context& context) {
  Measurement measurement = measure_topology(context);
  measurement.plots = pictures();
  return measurement;
}

}  // namespace

std::vector<Claim> mesh_tessellation_claims() {
  return {
      {.id = "MESH-1",
       .statement = "The corners of a mesh lie on the stone's surface, and their normals are the surface's there.",
       .function = "tessellate",
       .family = OracleFamily::other_formula,
       .oracle = "closest point and support of the stone by ruler and compass, 50 digits",
       .checks = {within("point", 2e-15, "of the width",
                         "some roundings of sines and roots; measured 2026-11-30 with 20 seeds: up to 1.6e-16", 1e-16),
                  within("normal", 2e-15, "of the width",
                         "how far the stone goes beyond the corner, along its normal: the same"),
                  within("unit", 2e-15, "relative", "the same, of a square")},
       .measure = measure_corners},
      {.id = "MESH-2",
       .statement = "Meshes of all stones are closed surfaces without a hole, each triangle facing outwards; welding "
                    "finds what is shared (with pictures).",
       .function = "tessellate, weld, unwelded, topology",
       .family = OracleFamily::brute_force,
       .oracle = "sets of coordinates; Euler's formula",
       .checks = {none("closed", "meshes"), none("welding", "meshes"), none("facing", "meshes"),
                  none("counts", "meshes")},
       .measure = measure_topology_with_pictures},
      {.id = "MESH-3",
       .statement = "The distance between mesh and stone is what is stated.",
       .function = "deviation",
       .family = OracleFamily::brute_force,
       .oracle = "the surface, sampled and searched, against every triangle",
       .checks = {within("", 1e-9, "relative",
                         "it is reached, as meshes of `tessellate` are convex; the search's last step; measured "
                         "2026-11-30 with 12 seeds: up to 2.3e-11",
                         2e-11)},
       .measure = measure_deviation},
      {.id = "MESH-5",
       .statement = "A tolerance is kept, and by few triangles: within 1.3 of the least possible.",
       .function = "fineness_for",
       .family = OracleFamily::other_formula,
       .oracle = "Fejes Tóth's bound: triangles that are equilateral as the curvatures measure, everywhere",
       .checks =
           {within("kept", 1.0, "of the tolerance", "what was asked for"),
            within("subdivision", 1.3, "of the least possible", "what was asked for"),
            within("rings", 2.7, "of the least possible",
                   "long triangles at the pole, right ones at the rim; measured 2026-11-30 with 5 seeds: 2.1 to 2.52")},
       .measure = measure_fineness},
  };
}

}  // namespace goishi::verify
