#pragma once
/// \file
/// The talk's loop, from fall to collision response, as it was published: a fixed step of semi-implicit Euler, the
/// attitude by explicit Euler and normalised; a stone found inside the board is pushed out along the least axis (over
/// the playing surface: up, by its whole depth), then gets one normal impulse and one of friction from the velocity
/// after it; then momenta decay exponentially. Nothing asks when the stone touched. On the plane z = 0, in double, per
/// unit of mass; shares no formula with src/.

#include <array>
#include <cstdint>

namespace goishi::verify {

/// What the talk's loop holds constant in the air.
enum class PublishedTurning {
  velocity,  // the talk: ω is the state, so that the stone's shape has no effect on it
  momentum   // the original program: L is the state, ω is made of it at every step
};

struct PublishedStone {
  double sphere_radius, sphere_offset, ring_radius, tube_radius;  // [m] caps' balls and their centres, bevel's torus
  double axial, transverse;                                       // I_a/m, I_t/m [m²]
};

/// The original program's factors are a frame's, 1/60 s: in contact 0.975 for the angular momentum, and 0.999 for both
/// always. (Its factor in contact falls to 0.75 for slow spins; here the mildest is taken for all.)
struct PublishedRules {
  double restitution = 0.5;
  double friction = 0.3;
  double gravity = 9.80665;  // [m/s²] downwards; the talk's own is ten times too small (claim PUBLISHED-8)
  PublishedTurning turning = PublishedTurning::velocity;
  double kept_in_contact = 1.0;  // of the angular momentum, a frame
  double kept = 1.0;             // of both momenta, a frame
};

/// Attitude (w, x, y, z), body to world; all else in the world.
struct PublishedState {
  std::array<double, 3> p, v;
  std::array<double, 4> q;
  std::array<double, 3> w;  // [rad/s]
};

struct PublishedPath {
  PublishedState end;
  std::int64_t contacts = 0;   // steps that ended inside the board
  double raised = 0.0;         // [m] by pushing out, in all
  double greatest_rise = 0.0;  // [m²/s²] of the energy from one step to the next
};

[[nodiscard]] double published_energy(const PublishedStone& stone, const PublishedRules& rules,
                                      const PublishedState& state);

/// So many steps of Δt. `watch_energy` looks for the greatest rise, which takes time.
[[nodiscard]] PublishedPath run_published_loop(const PublishedStone& stone, const PublishedRules& rules,
                                               const PublishedState& start, double dt, std::int64_t steps,
                                               bool watch_energy = false);

}  // namespace goishi::verify
