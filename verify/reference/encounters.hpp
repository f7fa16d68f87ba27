#pragma once
/// \file
/// The problems of contact.json.

#include <vector>

#include "verify/reference/encounter.hpp"

namespace goishi::verify::reference {

/// Placed stones: against a plane at any depth; against the board and each other where their cores are apart.
[[nodiscard]] std::vector<Encounter> gap_encounters();

/// Flying stones. Those that meet the board or another have a bevel.
[[nodiscard]] std::vector<Encounter> touch_encounters();

/// The separation of the stones where they are placed, as a caller of the library would ask for it.
[[nodiscard]] Separation<double> separation_of(const Encounter& of);

}  // namespace goishi::verify::reference
