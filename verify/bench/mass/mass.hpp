#pragma once
/// \file
/// What a stone and its mass properties cost. How far they are off the claims MASS say.

#include "verify/bench/race.hpp"

namespace goishi::verify::bench::mass {

[[nodiscard]] Subject subject();

/// Meshes in place of closed forms.
[[nodiscard]] std::vector<Problem> mesh_problems();

}  // namespace goishi::verify::bench::mass
