#pragma once
/// \file
/// Torque-free rotation of any rigid body, by high-order integration of the raw Newton–Euler equations (Odeint) in
/// `__float128`: 113 bits, 34 digits. g++ only, with its extensions on.

#include <array>
#include <boost/multiprecision/float128.hpp>

namespace goishi::verify {

using Quad = boost::multiprecision::float128;

/// Principal moments, attitude (w, x, y, z; body to world; normalised before use) and angular velocity in B. Inputs are
/// taken as exact.
struct FreeBody {
  std::array<Quad, 3> moments;
  std::array<Quad, 4> attitude;
  std::array<Quad, 3> spin;
};

/// The same body after a time.
struct FreeBodyReference {
  std::array<Quad, 4> attitude;  // unit
  std::array<Quad, 3> spin;      // ω in B
  double disagreement;           // of the two integrators: attitude [rad] plus relative spin
  double tolerance;              // a step's, at which they agreed
};

/// The two integrators must agree to this before they judge.
inline constexpr double free_body_agreement = 1e-22;

/// What a step may be off, relatively: at first, and if that does not make the two agree.
inline constexpr std::array<double, 2> free_body_tolerances = {1e-25, 1e-29};

/// By Bulirsch–Stoer and by Fehlberg 7(8), to the first tolerance and, if they do not agree to 1e-22, to the second.
/// Throws std::runtime_error if they still do not: an oracle that does not agree with itself judges nothing. Negative
/// times run backwards.
///
/// Limits  on the separatrix of the middle axis every error, round-off too, grows e-fold in one or two radians of
///         |ω| t: it refuses after 30 to 50 of them.
/// Cost    about 10 ms a radian of |ω| t.
[[nodiscard]] FreeBodyReference integrate_free_body(const FreeBody& body, const Quad& time,
                                                    const std::array<double, 2>& tolerances = free_body_tolerances);

}  // namespace goishi::verify
