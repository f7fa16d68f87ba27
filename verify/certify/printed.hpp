#pragma once
/// \file
/// A decimal as it stands in print, and what proves its digits: an enclosure strictly inside ± half a unit of the last.

#include <optional>
#include <string>
#include <string_view>

#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify::certify {

struct Printed {
  Ball value;
  Ball half_unit;  // of the last printed digit
  int digits = 0;  // significant ones; none: zero
};

/// "2.15347", "1.40864e-07", "−5.85" (U+2212 or ASCII minus); nothing for any other text.
[[nodiscard]] std::optional<Printed> read_printed(std::string_view text);

/// Whether the decimal is the exact value correctly rounded: the whole enclosure rounds to it. A decimal with fewer
/// than `least_digits` significant digits must be the value itself, to 60 digits: 2800, 0.022.
[[nodiscard]] bool is_certified(const Printed& printed, const Ball& exact, int least_digits = 0);

/// Whether no other double than `value` can be the nearest to a number in the ball: the ball lies strictly inside the
/// interval between the midpoints to the neighbours, or is exactly the value.
[[nodiscard]] bool is_the_nearest(double value, const Ball& exact);

}  // namespace goishi::verify::certify
