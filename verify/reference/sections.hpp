#pragma once
/// \file
/// The files of the set: their problems.

#include <vector>

#include "verify/reference/problem.hpp"

namespace goishi::verify::reference {

[[nodiscard]] Section shapes_section();
[[nodiscard]] Section mass_section();
[[nodiscard]] Section surface_section();
[[nodiscard]] Section flight_section();
[[nodiscard]] Section impact_section();
[[nodiscard]] Section contact_section();
[[nodiscard]] Section drop_section();

/// All, in the order in which a stone meets them.
[[nodiscard]] std::vector<Section> all_sections();

}  // namespace goishi::verify::reference
