#pragma once
/// \file
/// Numbers for people. Every function gives the same text on every machine and in every locale.

#include <cstdint>
#include <string>

namespace goishi::verify {

/// How many significant digits it takes to tell two numbers apart, at least `least`: "4.0003 > 4", never "4 > 4".
[[nodiscard]] int digits_to_tell(double first, double second, int least = 3);

/// "0", "1.34e-15", "0.0123", "74.6", "123457", "nan", "-inf"; trailing zeros dropped.
[[nodiscard]] std::string plain_number(double value, int digits = 3);

/// The same in XHTML: "1.34 × 10<sup>−15</sup>", "∞", "not a number".
[[nodiscard]] std::string html_number(double value, int digits = 3);

/// "12 345 678", with narrow no-break spaces.
[[nodiscard]] std::string grouped(std::uint64_t count);

/// "3.2 µs", "120 ms", "12.3 s", "3 min 20 s".
[[nodiscard]] std::string duration(double seconds);

/// 10 to a power: "10⁻¹²".
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace goishi::verify
