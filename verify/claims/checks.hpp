#pragma once
/// \file
/// Checks, made in a line.

#include <functional>
#include <string>
#include <utility>

#include "verify/suite/claim.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify {

/// A check of values: its errors are within `bound`, and why. `resolution` as in `Check`.
[[nodiscard]] inline Check within(std::string name, double bound, std::string unit, std::string reason,
                                  double resolution = 0.0) {
  return {.name = std::move(name),
          .unit = std::move(unit),
          .bound = bound,
          .reason = std::move(reason),
          .resolution = resolution};
}

/// What must not be: wrong choices, faults, refusals of what is right.
[[nodiscard]] inline Check none(std::string name, std::string unit) {
  return {
      .name = std::move(name), .unit = std::move(unit), .bound = 0.0, .reason = "there must be none", .counts = true};
}

/// Sees whether something is right.
template <class Describe>
void see_choice(Worst& worst, bool right, Describe&& describe) {
  worst.see(right ? 0.0 : 1.0, std::forward<Describe>(describe));
}

/// The measurement of a claim that looks at samples in double, and as many in float.
[[nodiscard]] inline std::function<Measurement(Context&)> measure_both(void (*in_double)(Context&, Checks&, int),
                                                                       void (*in_float)(Context&, Checks&, int),
                                                                       int quick, int full) {
  return [=](Context& context) {
    Checks checks;
    in_double(context, checks, context.samples(quick, full));
    in_float(context, checks, context.samples(quick, full));
    return checks.measurement();
  };
}

}  // namespace goishi::verify
