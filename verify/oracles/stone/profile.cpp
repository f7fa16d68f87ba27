#include "verify/oracles/stone/profile.hpp"

#include <cmath>
#include <numbers>

#include "verify/oracles/stone/quadrature.hpp"

namespace goishi::verify {

namespace {

/// ρ(z) and its derivative, 0 <= z < h/2.
struct Profile {
  const Geometry& g;

  [[nodiscard]] bool on_bevel(double z) const { return z < g.bevel / 2.0; }
  [[nodiscard]] double tube(double z) const { return std::sqrt((g.tube_radius - z) * (g.tube_radius + z)); }
  [[nodiscard]] double radius(double z) const {
    if (on_bevel(z)) {
      return g.torus_radius + tube(z);
    }
    // Pythagoras on the sphere: r² − (z + d)² = (r − d − z)(r + d + z), and r − d is the pole's height.
    return std::sqrt((g.height / 2.0 - z) * (g.sphere_radius + g.sphere_offset + z));
  }
  [[nodiscard]] double slope(double z) const { return on_bevel(z) ? -z / tube(z) : -(z + g.sphere_offset) / radius(z); }
};

}  // namespace

Integrals integrate_profile(const Geometry& geometry) {
  using std::numbers::pi;
  const Profile profile{geometry};
  Quadrature quadrature(2e-14);
  // Upper half, in two pieces that meet where the curvature jumps; twice for the lower half.
  const auto both_halves = [&](auto&& integrand) {
    const double joint = geometry.bevel / 2.0;
    const double bevel = joint > 0.0 ? quadrature(integrand, 0.0, joint) : 0.0;
    return 2.0 * (bevel + quadrature(integrand, joint, geometry.height / 2.0));
  };
  const auto disc = [&](double z) { return pi * profile.radius(z) * profile.radius(z); };
  return {.volume = both_halves(disc),
          .surface_area = both_halves([&](double z) {
            const double slope = profile.slope(z);
            return 2.0 * pi * profile.radius(z) * std::sqrt(1.0 + slope * slope);
          }),
          .axial = both_halves([&](double z) { return disc(z) * profile.radius(z) * profile.radius(z) / 2.0; }),
          .transverse =
              both_halves([&](double z) { return disc(z) * (profile.radius(z) * profile.radius(z) / 4.0 + z * z); })};
}

}  // namespace goishi::verify
