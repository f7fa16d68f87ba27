#pragma once
/// \file
/// The scalar of the program: 50 digits, of which it prints at most 17, and exponents beyond any size.
/// Every printed digit is right as long as no two given lengths agree in more than 30 digits without
/// being equal.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace goishi::cli {

using Number = boost::multiprecision::cpp_bin_float_50;

/// A decimal as it was typed: ± digits × 10^exponent, nothing rounded.
struct Decimal {
  bool negative = false;
  std::string digits = {};  // without leading zeros; empty: zero
  std::int64_t exponent = 0;
};

/// Given numbers other than 0 have magnitudes from 10^-largest_order to below 10^(largest_order + 1):
/// the fifth power of a length, times a density, then fits the exponent of a Number.
inline constexpr std::int64_t largest_order = 100'000'000;

/// Reads `[+-] digits [. digits] [e [+-] digits]` off the front of the text; nothing when no such
/// number stands there.
[[nodiscard]] std::optional<Decimal> take_decimal(std::string_view& text);

[[nodiscard]] bool in_range(const Decimal& decimal);

/// The Number nearest to the decimal.   Domain  `in_range`.
[[nodiscard]] Number to_number(const Decimal& decimal);

/// The decimal as an int; nothing if it is not whole, to the last digit typed, or too large for one.
[[nodiscard]] std::optional<int> to_whole(const Decimal& decimal);

/// For programs: 17 significant digits, in the syntax of JSON.
[[nodiscard]] std::string seventeen_digits(const Number& value);

/// For people: 6 significant digits; a value that is exact with fewer ("0.022") shows no zeros behind
/// them.
[[nodiscard]] std::string six_digits(const Number& value);

}  // namespace goishi::cli
