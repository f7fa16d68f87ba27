/// GSL: production against numerical integration of the solid, which knows no closed form.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <goishi/mass/tensor.hpp>
#include <numbers>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/stone/profile.hpp"
#include "verify/oracles/stone/solid.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

void see_integrals(Worst& worst, const Context& context, const Stone<double>& stone, const Geometry& geometry,
                   const std::string& name) {
  const MassProperties<double> body = mass_properties(stone, Density{1.0});
  const Integrals right = integrate_profile(geometry);
  const auto see = [&](double computed, double expected, const char* quantity) {
    worst.see(relative(context.produced(computed), expected), [&] { return fmt::format("{} of {}", quantity, name); });
  };
  see(body.volume, right.volume, "volume");
  see(body.surface_area, right.surface_area, "area");
  see(body.moments.axial, right.axial, "I_a");
  see(body.moments.transverse, right.transverse, "I_t");
  see(body.moments_per_mass.axial, right.axial / right.volume, "I_a/m");
  see(body.moments_per_mass.transverse, right.transverse / right.volume, "I_t/m");
}

Measurement measure_sharp(Context& context) {
  Worst worst;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const Stone<double> stone = make_stone<double>(entry);
    see_integrals(worst, context, stone, solve_published(stone.width, stone.height, 0.0), name);
  });
  for (int i = 0; i < context.samples(50, 500); ++i) {
    const auto shape = draw_ordinary_shape(context.random());
    see_integrals(worst, context, make_stone(shape.width, shape.height),
                  solve_published(shape.width, shape.height, 0.0), describe(shape));
  }
  return worst.measurement();
}

Measurement measure_bevelled(Context& context) {
  Worst worst;
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    const Stone<double> stone = make_stone(entry, metres<double>(catalogue::table_bevel));
    see_integrals(worst, context, stone, solve_published(stone.width, stone.height, stone.bevel), name + ", b = 1 mm");
  });
  for (int i = 0; i < context.samples(50, 500); ++i) {
    const auto shape = draw_ordinary_shape(context.random());
    see_integrals(worst, context, make_stone(shape.width, shape.height, shape.bevel),
                  solve_published(shape.width, shape.height, shape.bevel), describe(shape));
  }
  return worst.measurement();
}

/// The outline of a stone seen from the side, in mm, all around.
Series outline(const std::string& name, const Stone<double>& stone) {
  using std::numbers::pi;
  const double joint = std::atan2(stone.joint_sine, stone.joint_cosine);
  std::vector<std::pair<double, double>> quarter;
  const auto arc = [&](double x, double z, double radius, double from, double to) {
    for (int i = 0; i <= 40; ++i) {
      const double angle = from + (to - from) * i / 40.0;
      quarter.emplace_back(1e3 * (x + radius * std::cos(angle)), 1e3 * (z + radius * std::sin(angle)));
    }
  };
  arc(stone.bevel_major_radius, 0.0, stone.bevel_minor_radius, 0.0, joint);
  arc(0.0, -stone.sphere_offset, stone.sphere_radius, joint, pi / 2.0);
  Series series{.name = name, .points = quarter};
  for (const auto& [sign_x, sign_z] : {std::pair{-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
    std::vector<std::pair<double, double>> other = quarter;
    if (sign_x * sign_z < 0.0) {
      std::reverse(other.begin(), other.end());
    }
    for (const auto& [x, z] : other) {
      series.points.emplace_back(sign_x * x, sign_z * z);
    }
  }
  return series;
}

Plot outlines() {
  const double w = 0.022, h = 0.0092, b = 0.003;
  return {.title = "22 × 9.2 mm with a bevel of 3 mm, as published and as measured",
          .x_label = "ρ [mm]",
          .y_label = "z [mm]",
          .equal_scale = true,
          .series = {outline("sharp", make_stone(w, h)), outline("published", make_stone(w, h, b)),
                     outline("measured", make_measured_stone(w, h, b))}};
}

Measurement measure_measured(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(20, 200); ++i) {
    const auto shape = draw_ordinary_shape(context.random());
    const Stone<double> stone = make_measured_stone(shape.width, shape.height, shape.bevel);
    const Geometry geometry = solve_measured(shape.width, shape.height, shape.bevel);
    for (const auto& [computed, expected] : {std::pair{stone.sphere_radius, geometry.sphere_radius},
                                             {stone.bevel_major_radius, geometry.torus_radius},
                                             {stone.bevel_minor_radius, geometry.tube_radius}}) {
      checks["radii"].see(relative(context.produced(computed), expected), [&] { return describe(shape); });
    }
    see_integrals(checks["integrals"], context, stone, geometry, describe(shape));
  }
  Measurement result = checks.measurement();
  result.plots.push_back(outlines());
  return result;
}

Measurement measure_tensor(Context& context) {
  Checks checks;
  const auto see = [&](const Stone<double>& stone, const std::string& name) {
    const Geometry geometry = solve_published(stone.width, stone.height, stone.bevel);
    const Eigen::Quaterniond q_WB = draw_attitude(context.random());
    const double reach = 0.7 * stone.width;
    const Eigen::Vector3d p_WB(context.uniform(-reach, reach), context.uniform(-reach, reach),
                               context.uniform(-reach, reach));
    const Eigen::Matrix3d R = q_WB.toRotationMatrix();
    Rotation rotation{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        rotation[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = R(i, j);
      }
    }
    const SolidMoments right = integrate_solid(geometry, rotation, {p_WB.x(), p_WB.y(), p_WB.z()});
    const MassProperties<double> body = mass_properties(stone, Density{1.0});
    const Eigen::Matrix3d tensor = inertia_tensor(body, q_WB, p_WB);
    checks["volume"].see(relative(context.produced(body.volume), right.volume), [&] { return name; });
    const double trace = tensor.trace();
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      checks["centre"].see(std::fabs(right.first[row] / right.volume - context.produced(p_WB[i])), stone.width,
                           [&] { return name; });
      for (int j = 0; j < 3; ++j) {
        const double expected = right.tensor[row][static_cast<std::size_t>(j)];
        checks["tensor"].see(std::fabs(context.produced(tensor(i, j)) - expected), trace,
                             [&] { return fmt::format("entry ({}, {}) of {}", i, j, name); });
      }
    }
  };
  int index = 0;
  const int every = context.samples(25, 9);
  for_each_catalogue_stone([&](const CatalogueStone& entry, const std::string& name) {
    if (index++ % every == 0) {
      see(make_stone<double>(entry), name);
      see(make_stone(entry, metres<double>(catalogue::table_bevel)), name + ", b = 1 mm");
    }
  });
  for (int i = 0; i < context.samples(4, 20); ++i) {
    const double w = context.uniform(0.5, 2.0);
    const double h = w * context.uniform(0.2, 0.9);
    const double b = i % 2 == 0 ? 0.0 : h * context.uniform(0.05, 0.8);
    see(make_stone(w, h, b), describe(ShapeSample<double>{w, h, b}));
  }
  return checks.measurement();
}

Measurement measure_inside(Context& context) {
  Worst worst;
  const auto see = [&](const Stone<double>& stone, const std::string& name) {
    const Geometry geometry = solve_published(stone.width, stone.height, stone.bevel);
    const MonteCarlo estimate = throw_points(geometry, context.samples(100'000, 1'000'000), context.random());
    const MassProperties<double> body = mass_properties(stone, Density{1.0});
    const auto deviation = [&](double computed, const Estimate& thrown) {
      return std::fabs(context.produced(computed) - thrown.value) / thrown.standard_error;
    };
    worst.see(deviation(body.volume, estimate.volume), [&] { return "volume of " + name; });
    worst.see(deviation(body.moments.axial, estimate.axial), [&] { return "I_a of " + name; });
    worst.see(deviation(body.moments.transverse, estimate.transverse), [&] { return "I_t of " + name; });
  };
  const CatalogueStone entry = catalogue_stone(33, StoneColor::white);
  see(make_stone<double>(entry), "size 33, sharp");
  see(make_stone(entry, 0.001), "size 33, b = 1 mm");
  see(make_stone(entry, 0.006), "size 33, b = 6 mm");
  return worst.measurement();
}

}  // namespace

std::vector<Claim> gsl_claims() {
  const std::string solid_reason =
      "Gauss–Kronrod on smooth pieces is far below its tolerances; measured 2026-11-30 with 40 seeds";
  const std::string profile =
      "GSL adaptive quadrature (QAG, 61 points) of the profile; the sphere through pole and rim and the "
      "touching circle are solved for numerically in 50 digits";
  const std::string profile_reason =
      "production's 8 ulp, 1.8e-15, and as much for the quadrature's sums: its rule is exact long before its "
      "tolerance, "
      "2e-14 (GSL takes none below 50 ε); measured 2026-11-30 with 40 seeds: up to 1.2e-15";
  return {
      {.id = "GSL-1",
       .statement = "Volume, area and moments of sharp lenses agree with integration of the profile: all 96 catalogue "
                    "stones, and random shapes.",
       .function = "mass_properties, sharp",
       .family = OracleFamily::quadrature,
       .oracle = profile,
       .checks = {within("", 4e-15, "relative", profile_reason, epsilon)},
       .measure = measure_sharp},
      {.id = "GSL-2",
       .statement =
           "So do those of bevelled stones as published: all 96 catalogue stones with b = 1 mm, and random shapes.",
       .function = "mass_properties, bevelled",
       .family = OracleFamily::quadrature,
       .oracle = profile,
       .checks = {within("", 4e-15, "relative", profile_reason, epsilon)},
       .measure = measure_bevelled},
      {.id = "GSL-3",
       .statement = "So do radii, volume, area and moments of stones given by their finished, measured width.",
       .function = "make_measured_stone",
       .family = OracleFamily::quadrature,
       .oracle = profile + ", the lens' offset too",
       .checks = {within("radii", 2.0 * epsilon, "relative",
                         "½ ulp of production and of the witness each, and the quotient's", epsilon),
                  within("integrals", 4e-15, "relative", profile_reason, epsilon)},
       .measure = measure_measured},
      {.id = "GSL-4",
       .statement = "The full tensor, products of inertia included, about a shifted point in a rotated frame agrees "
                    "with integration of the solid.",
       .function = "inertia_tensor",
       .family = OracleFamily::quadrature,
       .oracle = "GSL, three nested dimensions, of the solid as points inside both balls and the torus rule; its "
                 "surface found by Brent's method",
       .checks = {within("tensor", 4e-15, "of the trace", solid_reason, epsilon),
                  within("volume", 1e-14, "relative", solid_reason, epsilon),
                  within("centre", 4e-15, "of the width", solid_reason, epsilon)},
       .measure = measure_tensor},
      {.id = "GSL-5",
       .statement =
           "Points thrown at the solid find its volume and moments: the inside test that GSL-4 rests on is right.",
       .function = "mass_properties",
       .family = OracleFamily::quadrature,
       .oracle = "Monte Carlo with the inside test",
       .checks = {within("", 5.0, "standard errors", "nine normal deviates pass 5 once in 190 000 runs", 1.0)},
       .measure = measure_inside},
  };
}

}  // namespace goishi::verify
