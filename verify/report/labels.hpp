#pragma once
/// \file
/// Names beside the ends of the curves of a plot, in place of a legend.

#include <string>
#include <vector>

#include "verify/report/canvas.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify::picture {

/// The places nearest to the wanted ones (in order) that are at least `distance` apart and lie between `low` and `high`,
/// if there is room for all.
[[nodiscard]] std::vector<double> spread(std::vector<double> wanted, double distance, double low, double high);

/// In a column to the right of the frame, in the order of the curves' last points, each with its marker and a thin line
/// from there; a star's name stands beside it.
[[nodiscard]] std::string end_labels(const Plot& plot, const Canvas& canvas);

}  // namespace goishi::verify::picture
