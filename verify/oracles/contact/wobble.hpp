#pragma once
/// \file
/// A stone that moves in a plane: it rocks, or slides, on a horizontal plane. Its tilt θ is the angle of its axis from
/// the vertical, S(θ) the height of its centre, and per unit of mass
///
///     N = g + S'' θ̇² + S' θ̈ + c S' θ̇       I_t θ̈ = −S' N − S F − δ N sgn θ̇ − c I_t θ̇       ẍ = F − c ẋ
///
/// with F = −μ N sgn(ẋ − S θ̇) in sliding, and in rolling what keeps ẋ = S θ̇. Energy and quadrature give the period,
/// an integration in time what friction does. In long double; shares no formula with src/.

#include <array>
#include <functional>
#include <vector>

namespace goishi::verify {

/// Lengths in m, I_t per unit of mass. On the cap S = r − d cos θ, beyond the joint S = r₁ sin θ + r₂.
struct Rocker {
  using Long = long double;
  Long sphere_radius, sphere_offset, torus_radius, tube_radius;
  Long transverse;  // I_t/m   [m²]
  Long gravity;

  [[nodiscard]] Long joint() const;  // the tilt at which the contact passes from cap to rim
};

enum class Footing { rolling, frictionless };

/// Of rocking between −θ₀ and θ₀ without loss, θ₀ < 90°: by Gauss and Kronrod's quadrature of dθ/θ̇.
[[nodiscard]] long double rocking_period(const Rocker& rocker, Footing footing, long double amplitude);

/// What takes energy; all zero by default.
struct Losses {
  long double rolling_resistance = 0;  // δ   [m]
  long double damping = 0;             // c   [1/s]
  long double friction = 0;            // μ, of sliding
};

/// Where the motion is: time, tilt, its rate, the centre's place and velocity.
struct PlanarMotion {
  long double time = 0, tilt = 0, rate = 0, x = 0, v = 0;
};

/// On the cap, by Fehlberg's method of order 8 with fixed steps of 5e-4 s.
[[nodiscard]] PlanarMotion rocked(const Rocker& rocker, Footing footing, const Losses& losses,
                                  const PlanarMotion& start, long double duration);

/// The turning points that follow on a start at rest, till resistance holds the stone in one.
[[nodiscard]] std::vector<PlanarMotion> turning_points(const Rocker& rocker, Footing footing, const Losses& losses,
                                                       long double tilt);

/// Where slip ends that starts with v > S θ̇: dry sliding on the cap.
[[nodiscard]] PlanarMotion end_of_slide(const Rocker& rocker, const Losses& losses, const PlanarMotion& start);

}  // namespace goishi::verify
