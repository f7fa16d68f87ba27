#pragma once
/// \file
/// Quantiles of measured values.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace goishi::verify {

/// Linear between the sorted values; `part` from 0 to 1. NaN of nothing.
[[nodiscard]] inline double quantile(std::vector<double> values, double part) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const double at = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
}

}  // namespace goishi::verify
