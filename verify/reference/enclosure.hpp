#pragma once
/// \file
/// An enclosure as it is printed: decimals, and how far the value may be from them.

#include <string>
#include <vector>

#include "verify/oracles/numbers/ball.hpp"
#include "verify/reference/problem.hpp"

namespace goishi::verify::reference {

/// Of the value, or of the scale.
inline constexpr int printed_digits = 30;

/// A printed answer: each component lies within `rad` of its `mid`. rad "0": it is that decimal.
struct Enclosure {
  std::string quantity;
  std::vector<std::string> mid;
  std::string rad;
  double scale = 0.0;     // 0: none
  std::string word = {};  // in place of numbers
};

/// Rounds to 30 digits, of the scale where there is one. Throws std::runtime_error where the balls are wider than one unit of
/// the last digit, or where the value may be 0 and there is no scale.
[[nodiscard]] Enclosure printed(const Answer<OrderedBall>& answer);

/// Two ways to one number: throws std::runtime_error unless their balls meet and are narrow.
void require_met(const OrderedBall& one, const OrderedBall& other, const std::string& what);

/// The power of two that is not below `size`; 1 for 0. A scale so coarse does not depend on the mathematics library.
[[nodiscard]] double scale_of(double size);

}  // namespace goishi::verify::reference
