#include <cstddef>
#include <cstdint>
#include <goishi/mass/tensor.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <goishi/published/bevel.hpp>
#include <goishi/published/inertia.hpp>
#include <goishi/shape/catalogue.hpp>
#include <goishi/shape/surface.hpp>
#include <vector>

#include "arguments.hpp"

namespace goishi::c {

namespace {

static_assert(is(Feature::upper_cap, GOISHI_UPPER_CAP) && is(Feature::lower_cap, GOISHI_LOWER_CAP) &&
              is(Feature::rim, GOISHI_RIM));
static_assert(is(Tessellation::subdivision, GOISHI_SUBDIVISION) && is(Tessellation::rings, GOISHI_RINGS));
static_assert(is(StoneColor::white, GOISHI_WHITE) && is(StoneColor::black, GOISHI_BLACK));

[[nodiscard]] Fineness read_fineness(const int* pointer, std::size_t size) {
  const auto a = read<GOISHI_FINENESS_SIZE>("fineness", pointer, size);
  return {.rings = a[GOISHI_MESH_RINGS], .rows = a[GOISHI_MESH_ROWS], .segments = a[GOISHI_MESH_SEGMENTS]};
}

[[nodiscard]] Tessellation read_method(int method) {
  return chosen("method", method, Tessellation::rings);
}

[[nodiscard]] Mesh<double> make_mesh(const Body& body, int method, const int* fineness, std::size_t fineness_size,
                                     int weld_how) {
  constexpr int last = GOISHI_WELDED_BY_POSITION;
  require(GOISHI_UNWELDED <= weld_how && weld_how <= last, "weld", weld_how, "must be from 0 to ", last);
  const Mesh<double> mesh = tessellate(body.stone, read_method(method), read_fineness(fineness, fineness_size));
  return weld_how == GOISHI_UNWELDED ? unwelded(mesh)
         : weld_how == GOISHI_WELDED ? weld(mesh, Weld::position_and_normal)
                                     : weld(mesh, Weld::position);
}

[[nodiscard]] std::vector<double> coordinates(const std::vector<Vec>& points) {
  std::vector<double> result;
  result.reserve(3 * points.size());
  for (const Vec& point : points) {
    Row(result) << point;
  }
  return result;
}

}  // namespace
}  // namespace goishi::c

using namespace goishi;
using namespace goishi::c;

extern "C" {

int goishi_catalogue_stone(int number, int color, double bevel, double* stone, size_t stone_size) {
  return guarded([&] {
    require_array("stone", stone, stone_size, GOISHI_STONE_SIZE);
    const CatalogueStone entry = catalogue_stone(number, chosen("color", color, StoneColor::black));
    const Stone<double> shape = make_stone(entry, bevel);
    write({shape.width, shape.height, bevel, 0.0, static_cast<double>(entry.density), 0.0}, stone);
  });
}

int goishi_measures(const double* stone, size_t stone_size, double* measures, size_t measures_size) {
  return guarded([&] {
    const auto [shape, mass] = read_stone("stone", stone, stone_size);
    require_array("measures", measures, measures_size, GOISHI_MEASURES_SIZE);
    write({shape.width, shape.height, shape.bevel, outer_width(shape), shape.sphere_radius, shape.sphere_offset,
           shape.bevel_major_radius, shape.bevel_minor_radius, shape.joint_radius, shape.joint_cosine, shape.joint_sine,
           mass.volume, mass.surface_area, mass.density, mass.mass, mass.moments.axial, mass.moments.transverse,
           mass.moments_per_mass.axial, mass.moments_per_mass.transverse},
          measures);
  });
}

int goishi_published_measures(const double* stone, size_t stone_size, double* published, size_t published_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    require_array("published", published, published_size, GOISHI_PUBLISHED_MEASURES_SIZE);
    const double w = shape.width, h = shape.height;
    require(1e-6 <= h, "height", h, "must be at least 1e-6");
    require(w <= 0.1, "width", w, "must be at most 0.1");
    const PublishedBevel<double> bevel = published_bevel(shape.sphere_radius, shape.sphere_offset, shape.bevel);
    constexpr double cm = 100.0, square_cm = cm * cm, cubic_cm = cm * square_cm;
    const double volume = published_volume(cm * shape.sphere_radius, cm * shape.sphere_offset) / cubic_cm;
    const PublishedTensor sum = published_tensor(static_cast<float>(cm * w), static_cast<float>(cm * h));
    const double axial = mass_properties(make_stone(w, h), Density{1.0}).moments.axial;
    write({bevel.major_radius, bevel.minor_radius, volume, axial / volume, sum.y / square_cm, sum.x / square_cm,
           static_cast<double>(sum.nodes)},
          published);
  });
}

int goishi_tensor(const double* stone, size_t stone_size, const double* pose, size_t pose_size, double* tensor,
                  size_t tensor_size) {
  return guarded([&] {
    const MassProperties<double> mass = read_stone("stone", stone, stone_size).mass;
    const Pose<double> there = read_pose("pose", pose, pose_size);
    require_array("tensor", tensor, tensor_size, 9);
    const Mat3<double> found = inertia_tensor(mass, there.q_WB, there.p_WB);
    std::vector<double> rows;
    Row(rows) << Vec(found.row(0)) << Vec(found.row(1)) << Vec(found.row(2));
    write(rows, tensor);
  });
}

int goishi_profile(const double* stone, size_t stone_size, size_t steps, double* rows, size_t rows_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    const bool sharp = !(0.0 < shape.bevel);
    const std::size_t room = count_rows("rows", rows, rows_size, GOISHI_PROFILE_SIZE), parts = sharp ? 2 : 3;
    require(room % parts == 0 && room / parts - 1 == steps && 0 < steps, "steps", steps,
            "must be at least 1, and rows have room for ", parts, " times as many and one more");
    const double cap_angle = scalar::atan2(shape.joint_cosine, shape.joint_sine);
    const double band_angle = scalar::pi<double>() - 2.0 * cap_angle;
    std::vector<double> result;
    result.reserve(rows_size);
    double begin_arc = 0.0, begin_angle = 0.0;
    const auto part = [&](Feature feature, double angle, double radius) {
      for (std::size_t i = 0; i <= steps; ++i) {
        const double turned = angle * (static_cast<double>(i) / static_cast<double>(steps));
        // Of the lower cap, from its pole back, so that it is the mirror image of the upper one.
        const bool lower = feature == Feature::lower_cap;
        const double theta = lower ? angle - turned : begin_angle + turned;
        const Vec n_B(scalar::sin(theta), 0.0, lower ? -scalar::cos(theta) : scalar::cos(theta));
        const Vec p_B = support(shape, n_B).p_B;
        Row(result) << begin_arc + radius * turned << p_B.x() << p_B.z() << n_B.x() << n_B.z() << 1.0 / radius
                    << as_number(feature);
      }
      begin_arc = begin_arc + radius * angle;
      begin_angle = begin_angle + angle;
    };
    part(Feature::upper_cap, cap_angle, shape.sphere_radius);
    if (!sharp) {
      part(Feature::rim, band_angle, shape.bevel_minor_radius);
    }
    part(Feature::lower_cap, cap_angle, shape.sphere_radius);
    write(result, rows);
  });
}

// --- A stone as triangles

int goishi_fineness(const double* stone, size_t stone_size, int method, int level, double tolerance, int* fineness,
                    size_t fineness_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    const Tessellation how = read_method(method);
    require_array("fineness", fineness, fineness_size, GOISHI_FINENESS_SIZE);
    const Fineness found = level == -1 ? fineness_for(shape, how, tolerance) : fineness_of_level(shape, level);
    fineness[GOISHI_MESH_RINGS] = found.rings;
    fineness[GOISHI_MESH_ROWS] = found.rows;
    fineness[GOISHI_MESH_SEGMENTS] = found.segments;
  });
}

int goishi_mesh_figures(const double* stone, size_t stone_size, int method, const int* fineness, size_t fineness_size,
                        int weld, double* figures, size_t figures_size) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    require_array("figures", figures, figures_size, GOISHI_MESH_FIGURES_SIZE);
    const Mesh<double> mesh = make_mesh(body, method, fineness, fineness_size, weld);
    const Topology found = topology(mesh);
    const MeshMass<double> enclosed = mesh_mass(mesh);
    write({static_cast<double>(mesh.points.size()), static_cast<double>(mesh.triangles.size()),
           static_cast<double>(found.points), static_cast<double>(found.edges), static_cast<double>(found.loose_edges),
           deviation(mesh, body.stone), enclosed.volume, enclosed.surface_area},
          figures);
  });
}

int goishi_mesh_counts(const double* stone, size_t stone_size, int method, const int* fineness, size_t fineness_size,
                       int weld, size_t* vertices, size_t* triangles) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    require_pointer("vertices", vertices);
    require_pointer("triangles", triangles);
    const Mesh<double> mesh = make_mesh(body, method, fineness, fineness_size, weld);
    *vertices = mesh.points.size();
    *triangles = mesh.triangles.size();
  });
}

int goishi_mesh(const double* stone, size_t stone_size, int method, const int* fineness, size_t fineness_size, int weld,
                double* points, size_t points_size, double* normals, size_t normals_size, uint32_t* corners,
                size_t corners_size) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    const Mesh<double> mesh = make_mesh(body, method, fineness, fineness_size, weld);
    require_array("points", points, points_size, 3 * mesh.points.size());
    require_array("normals", normals, normals_size, 3 * mesh.points.size());
    require_array("corners", corners, corners_size, 3 * mesh.triangles.size());
    write(coordinates(mesh.points), points);
    write(coordinates(mesh.normals), normals);
    for (const Triangle& triangle : mesh.triangles) {
      corners = std::copy(triangle.begin(), triangle.end(), corners);
    }
  });
}

}  // extern "C"
