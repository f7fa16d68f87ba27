#include "verify/oracles/stone/solid.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "verify/oracles/stone/quadrature.hpp"

namespace goishi::verify {

double outside(const Geometry& geometry, const Point& x_B) {
  const auto& [x, y, z] = x_B;
  const double rho = std::hypot(x, y);
  const double to_lower_centre = std::hypot(rho, z + geometry.sphere_offset);
  const double to_upper_centre = std::hypot(rho, z - geometry.sphere_offset);
  const double from_balls = std::max(to_lower_centre, to_upper_centre) - geometry.sphere_radius;
  if (geometry.tube_radius == 0.0) {
    return from_balls;
  }
  // The torus rules between the lines from the balls' centres through the centre of its circle.
  const double beyond = rho - geometry.torus_radius;
  const bool torus_rules = beyond > 0.0 && std::fabs(z) * geometry.torus_radius < geometry.sphere_offset * beyond;
  return torus_rules ? std::hypot(beyond, z) - geometry.tube_radius : from_balls;
}

namespace {

/// Distance from the centre to the surface in a direction.
class RayCaster {
 public:
  explicit RayCaster(const Geometry& geometry)
      : geometry_(geometry), solver_(gsl_root_fsolver_alloc(gsl_root_fsolver_brent)) {}

  [[nodiscard]] double operator()(const Point& direction) {
    struct Ray {
      const Geometry& geometry;
      const Point& direction;
    } ray{geometry_, direction};
    gsl_function function{
        [](double t, void* data) {
          const Ray& ray_ = *static_cast<Ray*>(data);
          return outside(ray_.geometry, {t * ray_.direction[0], t * ray_.direction[1], t * ray_.direction[2]});
        },
        &ray};
    const double low = 0.25 * geometry_.height;
    const double high = 2.0 * (geometry_.outer_radius + geometry_.height);
    if (gsl_root_fsolver_set(solver_.get(), &function, low, high) != GSL_SUCCESS) {
      throw std::runtime_error("a ray from the centre does not leave the solid");
    }
    for (int i = 0; i < 200; ++i) {
      gsl_root_fsolver_iterate(solver_.get());
      const double a = gsl_root_fsolver_x_lower(solver_.get());
      const double b = gsl_root_fsolver_x_upper(solver_.get());
      if (gsl_root_test_interval(a, b, 0.0, 4e-16) == GSL_SUCCESS) {
        return gsl_root_fsolver_root(solver_.get());
      }
    }
    throw std::runtime_error("a ray's end was not found");
  }

 private:
  struct Free {
    void operator()(gsl_root_fsolver* solver) const { gsl_root_fsolver_free(solver); }
  };
  const Geometry& geometry_;
  std::unique_ptr<gsl_root_fsolver, Free> solver_;
};

struct FreeTable {
  void operator()(gsl_integration_glfixed_table* table) const { gsl_integration_glfixed_table_free(table); }
};

}  // namespace

SolidMoments integrate_solid(const Geometry& geometry, const Rotation& R_WB, const Point& p_WB) {
  using std::numbers::pi;
  RayCaster cast(geometry);
  Quadrature over_azimuth(1e-13), over_polar(2e-14);
  // Four Gauss–Legendre points integrate the radial polynomial, of degree 4 at most, exactly.
  const std::unique_ptr<gsl_integration_glfixed_table, FreeTable> radial(gsl_integration_glfixed_table_alloc(4));
  const double joint_angle = std::atan2(geometry.joint_radius, geometry.bevel / 2.0);

  // `scale` is the size of an integral that does not vanish: products of inertia may.
  const auto integrate = [&](double scale, auto&& integrand) {
    return over_azimuth(
        [&](double azimuth) {
          const auto ring = [&](double polar) {
            const Point u = {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
            const double end = cast(u);
            double sum = 0.0;
            for (std::size_t i = 0; i < 4; ++i) {
              double t = 0.0;
              double weight = 0.0;
              gsl_integration_glfixed_point(0.0, end, i, &t, &weight, radial.get());
              Point x_W = p_WB;
              for (std::size_t row = 0; row < 3; ++row) {
                for (std::size_t column = 0; column < 3; ++column) {
                  x_W[row] += R_WB[row][column] * t * u[column];
                }
              }
              sum += weight * t * t * integrand(x_W);
            }
            return sum * std::sin(polar);
          };
          // Pieces that meet where cap and bevel do; at the equator for a sharp stone.
          const double band =
              geometry.bevel > 0.0 ? over_polar(ring, joint_angle, pi - joint_angle, 1e-15 * scale) : 0.0;
          return over_polar(ring, 0.0, joint_angle, 1e-15 * scale) + band +
                 over_polar(ring, pi - joint_angle, pi, 1e-15 * scale);
        },
        0.0, 2.0 * pi, 1e-14 * scale);
  };
  const double reach = geometry.outer_radius + std::hypot(p_WB[0], p_WB[1], p_WB[2]);
  const double size = geometry.height * geometry.outer_radius * geometry.outer_radius;

  SolidMoments result{};
  result.volume = integrate(size, [](const Point&) { return 1.0; });
  for (std::size_t i = 0; i < 3; ++i) {
    result.first[i] = integrate(size * reach, [i](const Point& x) { return x[i]; });
    for (std::size_t j = 0; j <= i; ++j) {
      result.tensor[i][j] = integrate(size * reach * reach, [i, j](const Point& x) {
        return (i == j ? x[0] * x[0] + x[1] * x[1] + x[2] * x[2] : 0.0) - x[i] * x[j];
      });
      result.tensor[j][i] = result.tensor[i][j];
    }
  }
  return result;
}

MonteCarlo throw_points(const Geometry& geometry, int count, std::mt19937_64& random) {
  const double half_width = geometry.outer_radius;
  const double half_height = geometry.height / 2.0;
  std::uniform_real_distribution<double> across(-half_width, half_width), along(-half_height, half_height);
  std::array<double, 3> sum{}, sum_of_squares{};
  for (int i = 0; i < count; ++i) {
    const Point x = {across(random), across(random), along(random)};
    if (outside(geometry, x) > 0.0) {
      continue;
    }
    const std::array<double, 3> values = {1.0, x[0] * x[0] + x[1] * x[1], x[1] * x[1] + x[2] * x[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += values[k];
      sum_of_squares[k] += values[k] * values[k];
    }
  }
  const double box = 8.0 * half_width * half_width * half_height;
  const auto estimate = [&](std::size_t k) {
    const double mean = sum[k] / count;
    const double variance = sum_of_squares[k] / count - mean * mean;
    return Estimate{box * mean, box * std::sqrt(variance / count)};
  };
  return {estimate(0), estimate(1), estimate(2)};
}

}  // namespace goishi::verify
