/// Elementary functions, mass and meshes.

#include <array>
#include <goishi/mass/tensor.hpp>
#include <goishi/mesh/bounds.hpp>
#include <goishi/mesh/deviation.hpp>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>

#include "verify/bits/inputs.hpp"
#include "verify/bits/kinds.hpp"

namespace goishi::verify::bits {

namespace {

template <class T>
void add_elementary(Hash& hash, T x, T y) {
  for (const auto& [s, c] : scalar::sincos(x, y)) {
    hash.add(s);
    hash.add(c);
  }
  const auto [s, c] = scalar::sincos(x);
  hash.add(s);
  hash.add(c);
  hash.add(scalar::atan2(x, y));
}

template <class T>
void add_mass(Hash& hash, Random& random) {
  const Stone<T> stone = random.stone<T>();
  const auto body = mass_properties(stone, Density<T>{random.between<T>(1000, 3000)});
  const auto weighed = mass_properties(stone, Mass<T>{random.between<T>(0.001, 0.01)});
  for (const T& length :
       {stone.width, stone.sphere_radius, stone.sphere_offset, stone.bevel_major_radius, stone.bevel_minor_radius,
        stone.core_sphere_radius, stone.joint_radius, stone.joint_cosine, stone.joint_sine, body.volume,
        body.surface_area, body.mass, body.moments.axial, body.moments.transverse, body.moments_per_mass.axial,
        body.moments_per_mass.transverse, weighed.density, weighed.moments.axial, weighed.moments.transverse}) {
    hash.add(length);
  }
  const Pose<T> pose = random.pose<T>(0.1);
  const Mat3<T> tensor = inertia_tensor(body, pose.q_WB, pose.p_WB);
  add(hash, tensor);
  const PrincipalAxes<T> axes = principal_axes(tensor);
  add(hash, axes.moments);
  add(hash, axes.R_WP);
}

}  // namespace

void hash_elementary(Hash& hash) {
  Random random(1);
  for (int i = 0; i < 8000; ++i) {
    const double size = scalar::detail::power_of_two(random.below(i % 4 == 0 ? 1000 : 20));
    const double x = size * random.between(-1, 1), y = random.between(-100, 100);
    add_elementary(hash, x, y);
    add_elementary(hash, static_cast<float>(x), static_cast<float>(y));
  }
}

void hash_mass(Hash& hash) {
  Random random(2);
  for (int i = 0; i < 1500; ++i) {
    add_mass<double>(hash, random);
    add_mass<float>(hash, random);
  }
}

void hash_mesh(Hash& hash) {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Stone<double> stone = random.stone<double>();
    const auto mesh =
        tessellate(stone, i % 2 == 0 ? Tessellation::subdivision : Tessellation::rings, 2 + random.below(3));
    for (const Vec3<double>& point : mesh.points) {
      add(hash, point);
    }
    for (const Vec3<double>& normal : mesh.normals) {
      add(hash, normal);
    }
    const auto mass = mesh_mass(mesh);
    hash.add(mass.volume);
    hash.add(mass.surface_area);
    add(hash, mass.centre);
    add(hash, mass.tensor);
    if (i % 8 == 0) {
      hash.add(deviation(mesh, stone));
    }
    const Pose<double> pose = random.pose<double>(0.2);
    add(hash, bounds(stone, pose).low);
    add(hash, bounds(stone, pose).high);
    add(hash, support(stone, pose, random.direction<double>()).p_W);
  }
}

}  // namespace goishi::verify::bits
