#pragma once
/// \file
/// How the talk came to its inertia tensor, for comparison only. Use `mass_properties`.

#include <cmath>
#include <goishi/scalar.hpp>
#include <goishi/shape/lens.hpp>

namespace goishi {

/// The "volume" of the talk's program, d² + πr/4 + πd/24 with lengths in cm: it adds an area and two lengths (PUBLISHED-2).
template <Elementary T>
[[nodiscard]] T published_volume(const T& sphere_radius, const T& sphere_offset) {
  const T pi = scalar::pi<T>();
  return sphere_offset * sphere_offset + pi * sphere_radius / T(4) + pi * sphere_offset / T(24);
}

/// A sum over nodes inside a sharp stone of mass 1, by the talk's axes: y is that of symmetry.
struct PublishedTensor {
  int nodes = 0;
  double x = 0, y = 0, z = 0;  // the diagonal [cm²]
};

/// The sum that gave the printed tensor of size 33, to its last digit (claim PUBLISHED-3): nodes a millimetre apart, each with
/// the mass of a cell, of which the density is 1 over `published_volume`.
/// Domain  lengths in cm, in float as the program had them; everything else is in double.
[[nodiscard]] inline PublishedTensor published_tensor(float width, float height) {
  const double spacing = double{1} / 10, slack = double{1} / 1000;  // [cm]
  const double w = static_cast<double>(width), h = static_cast<double>(height);
  const double r = formula::sphere_radius(w, h), d = r - h / 2;
  const int across = static_cast<int>(std::ceil(w / spacing));  // 23 for 2.2f, which is 22.0000005 times that
  const int through = static_cast<int>(std::ceil(h / spacing));
  const double dx = w / across, dy = h / through;
  const double cell_mass = dx * dy * dx / published_volume(r, d);
  PublishedTensor sum;
  for (int i = 0; i <= across; ++i) {
    for (int j = 0; j <= through; ++j) {
      for (int k = 0; k <= across; ++k) {
        const double x = -w / 2 + i * dx, y = -h / 2 + j * dy, z = -w / 2 + k * dx;
        const double along = std::fabs(y) + d;
        if (std::sqrt(x * x + along * along + z * z) <= r + slack) {
          ++sum.nodes;
          sum.x += cell_mass * (y * y + z * z);
          sum.y += cell_mass * (x * x + z * z);
          sum.z += cell_mass * (x * x + y * y);
        }
      }
    }
  }
  return sum;
}

}  // namespace goishi
