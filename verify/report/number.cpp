#include "verify/report/number.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace goishi::verify {

int digits_to_tell(double first, double second, int least) {
  int digits = least;
  while (digits < 17 && first != second && plain_number(first, digits) == plain_number(second, digits)) {
    ++digits;
  }
  return digits;
}

std::string plain_number(double value, int digits) {
  if (std::isnan(value)) {
    return "nan";
  }
  if (std::isinf(value)) {
    return value > 0 ? "inf" : "-inf";
  }
  if (value == 0) {
    return "0";
  }
  std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));  // after rounding
  if (exponent >= -3 && exponent < 6) {
    text = fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
  } else {
    text.resize(e);
  }
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return exponent >= -3 && exponent < 6 ? text : fmt::format("{}e{}", text, exponent);
}

std::string html_number(double value, int digits) {
  if (std::isnan(value)) {
    return "not a number";
  }
  if (std::isinf(value)) {
    return value > 0 ? "∞" : "−∞";
  }
  const std::string text = plain_number(std::abs(value), digits);
  const std::string_view sign = value < 0 ? "−" : "";
  const std::size_t e = text.find('e');
  if (e == std::string::npos) {
    return fmt::format("{}{}", sign, text);
  }
  const std::string_view factor = std::string_view(text).substr(0, e);
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}{}{}10<sup>{}{}</sup>", sign, factor == "1" ? "" : factor, factor == "1" ? "" : "\u202F×\u202F",
                     exponent < 0 ? "−" : "", std::abs(exponent));
}

std::string grouped(std::uint64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) {
      result += "\u202F";
    }
    result += digits[i];
  }
  return result;
}

std::string duration(double seconds) {
  if (!(seconds >= 0) || std::isinf(seconds)) {
    return "?";
  }
  if (seconds < 1e-3) {
    return fmt::format("{} µs", plain_number(seconds * 1e6, 2));
  }
  if (seconds < 0.9995) {
    return fmt::format("{} ms", plain_number(seconds * 1e3, seconds < 0.1 ? 2 : 3));
  }
  if (seconds < 99.95) {
    return fmt::format("{} s", plain_number(seconds, 3));
  }
  const double whole = std::round(seconds);
  return fmt::format("{:.0f} min {:.0f} s", std::floor(whole / 60), std::fmod(whole, 60));
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = "10";
  for (const char c : std::to_string(exponent)) {
    result += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  }
  return result;
}

}  // namespace goishi::verify
