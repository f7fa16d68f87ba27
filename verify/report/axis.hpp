#pragma once
/// \file
/// An axis of a plot: its range and its ticks. No drawing here.

#include <functional>
#include <string>
#include <vector>

namespace goishi::verify {

/// A logarithmic axis is handled in decades: `low` and `high` are then powers of ten.
struct Axis {
  bool logarithmic = false;
  double low = 0;
  double high = 1;

  /// 0 at the low end, 1 at the high end.
  [[nodiscard]] double at(double value) const;
};

/// Beyond this a linear axis cannot form differences.
inline constexpr double greatest_coordinate = 1e300;

/// Holds all values with a little room; they have a place on such an axis. Equal values get a range about
/// them, no values a range about 0 (in decades on a logarithmic axis).
[[nodiscard]] Axis axis_around(const std::vector<double>& values, bool logarithmic);

struct Tick {
  double at = 0;      // as Axis::at
  std::string label;  // empty: a minor tick
};

/// The densest ticks at 1, 2, 5 or at powers of ten whose labels `fit`.
[[nodiscard]] std::vector<Tick> ticks(const Axis& axis, const std::function<bool(const std::vector<Tick>&)>& fit);

}  // namespace goishi::verify
