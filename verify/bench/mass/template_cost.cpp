/// Two functions that do the same, for `template_cost` to count instructions in: the shipped templates at T = double,
/// and what one would write by hand in double.

#include <goishi/mass/inertia.hpp>
#include <numbers>

extern "C" {

void lens_by_template(double width, double height, double* out) {
  const goishi::Stone<double> stone = goishi::formula::sharp_stone(width, height);
  const goishi::Moments<double> moments = goishi::formula::lens_moments(width, height);
  const goishi::Moments<double> per_mass = goishi::formula::lens_moments_per_mass(width, height);
  out[0] = stone.sphere_radius;
  out[1] = stone.sphere_offset;
  out[2] = goishi::formula::lens_volume(width, height);
  out[3] = goishi::formula::lens_surface_area(width, height);
  out[4] = moments.axial;
  out[5] = moments.transverse;
  out[6] = per_mass.axial;
  out[7] = per_mass.transverse;
}

void lens_by_hand(double w, double h, double* out) {
  constexpr double pi = std::numbers::pi;
  const double a = h / 2, c = w / 2;
  const double a2 = a * a, c2 = c * c;
  const double axial = 10 * (c2 * c2) + a2 * (5 * c2 + a2);
  const double transverse = 10 * (c2 * c2) + a2 * (15 * c2 + 7 * a2);
  const double volume = 3 * c2 + a2;
  const double scale = pi / 60 * a;
  const double per_mass = 1 / (20 * volume);
  out[0] = (w * w + h * h) / (4 * h);
  out[1] = (w - h) * (w + h) / (4 * h);
  out[2] = pi / 3 * a * volume;
  out[3] = pi * (w * w + h * h) / 2;
  out[4] = 2 * scale * axial;
  out[5] = scale * transverse;
  out[6] = 2 * per_mass * axial;
  out[7] = per_mass * transverse;
}

/// The bevel, from the lens' offset: one square root, the rest rational.
void bevel_by_template(double height, double bevel, double offset, double* out) {
  const goishi::Bevel<double> result = goishi::formula::bevel(height, bevel, offset);
  out[0] = result.major_radius;
  out[1] = result.minor_radius;
  out[2] = result.core_sphere_radius;
  out[3] = result.joint_radius;
  out[4] = result.joint_cosine;
  out[5] = result.joint_sine;
}

void bevel_by_hand(double h, double b, double d, double* out) {
  const double r = d + h / 2;
  const double y = d + b / 2;
  const double px = std::sqrt((h - b) / 2 * (2 * d + (h + b) / 2));
  const double share = d / y;
  out[0] = px * share;
  out[1] = r / y * (b / 2);
  out[2] = r * share;
  out[3] = px;
  out[4] = px / r;
  out[5] = y / r;
}

}  // extern "C"
