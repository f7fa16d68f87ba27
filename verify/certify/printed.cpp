#include "verify/certify/printed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace goishi::verify::certify {

namespace {

constexpr std::string_view decimal_digits = "0123456789";
constexpr std::string_view minus_sign = "−";

std::string take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of(decimal_digits), text.size());
  const std::string digits(text.substr(0, count));
  text.remove_prefix(count);
  return digits;
}

/// e, sign, one to four digits: all or nothing.
std::optional<int> take_exponent(std::string_view& text) {
  text.remove_prefix(1);
  const bool negative = text.starts_with('-');
  text.remove_prefix(negative || text.starts_with('+') ? 1 : 0);
  const std::string digits = take_digits(text);
  if (digits.empty() || 4 < digits.size()) {
    return std::nullopt;
  }
  return (negative ? -1 : 1) * std::atoi(digits.c_str());
}

Ball magnitude(const Ball& x) {
  Ball result;
  arb_abs(result.get(), x.get());
  return result;
}

bool is_less(const Ball& x, const Ball& y) {
  return arb_lt(x.get(), y.get()) != 0;
}

}  // namespace

std::optional<Printed> read_printed(std::string_view text) {
  bool negative = false;
  for (const std::string_view sign : {minus_sign, std::string_view("-")}) {
    if (text.starts_with(sign)) {
      text.remove_prefix(sign.size());
      negative = true;
      break;
    }
  }
  const std::string whole = take_digits(text);
  std::string fraction;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    fraction = take_digits(text);
    if (fraction.empty()) {
      return std::nullopt;
    }
  }
  int exponent = 0;
  if (text.starts_with('e')) {
    const std::optional<int> given = take_exponent(text);
    if (!given) {
      return std::nullopt;
    }
    exponent = *given;
  }
  if (whole.empty() || !text.empty()) {
    return std::nullopt;
  }
  const std::string digits = whole + fraction;
  const std::string last = "e" + std::to_string(exponent - static_cast<int>(fraction.size()));
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size());
  return Printed{.value = Ball::from_decimal((negative ? "-" : "") + digits + last),
                 .half_unit = Ball::from_decimal("0.5" + last),
                 .digits = static_cast<int>(digits.size() - first)};
}

bool is_certified(const Printed& printed, const Ball& exact, int least_digits) {
  if (printed.digits == 0 && 0 < least_digits) {
    return arb_is_zero(exact.get()) != 0;
  }
  const Ball off = magnitude(exact - printed.value);
  if (printed.digits < least_digits) {
    return is_less(off, Ball::from_decimal("1e-60") * magnitude(printed.value));
  }
  return is_less(off, printed.half_unit);
}

bool is_the_nearest(double value, const Ball& exact) {
  if (arb_is_zero(exact.get()) != 0) {
    return value == 0.0;
  }
  const double below = std::nextafter(value, 0.0);
  const double above = std::nextafter(value, 2.0 * value + 1.0);
  const Ball low = (Ball(below) + Ball(value)) / Ball(2);
  const Ball high = (Ball(value) + Ball(above)) / Ball(2);
  return is_less(low, exact) && is_less(exact, high);
}

}  // namespace goishi::verify::certify
