#include "number.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace goishi::cli {

namespace {

constexpr std::string_view decimal_digits = "0123456789";

std::string_view take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of(decimal_digits), text.size());
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

bool take_minus(std::string_view& text) {
  const bool minus = text.starts_with('-');
  if (minus || text.starts_with('+')) {
    text.remove_prefix(1);
  }
  return minus;
}

/// Exponents far out of range stay far out of range.
std::int64_t take_exponent(std::string_view& text) {
  std::string_view rest = text;
  if (!rest.starts_with('e') && !rest.starts_with('E')) {
    return 0;
  }
  rest.remove_prefix(1);
  const bool minus = take_minus(rest);
  const std::string_view digits = take_digits(rest);
  if (digits.empty()) {
    return 0;
  }
  text = rest;
  std::int64_t exponent = 0;
  for (const char digit : digits) {
    exponent = std::min(10 * exponent + (digit - '0'), 1000 * largest_order);
  }
  return minus ? -exponent : exponent;
}

/// A Number other than 0 rounded to a count of significant digits: d.ddd × 10^order.
struct Rounded {
  bool negative = false;
  std::string digits;
  int order = 0;
};

Rounded round_to(const Number& value, int count) {
  const std::string text = value.str(count - 1, std::ios_base::scientific);
  const std::size_t mark = text.find('e');
  Rounded result{.negative = text.front() == '-', .digits = text.substr(0, mark)};
  std::erase_if(result.digits, [](char c) { return c == '-' || c == '.'; });
  std::string_view exponent = std::string_view(text).substr(mark + 1);
  exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), result.order);
  return result;
}

void drop_zeros(std::string& digits) {
  digits.erase(digits.find_last_not_of('0') + 1);
}

/// Plain where C's %g is plain, else scientific.
std::string layout(const Rounded& number, int precision) {
  std::string text = number.digits;
  const auto point = [&text](int position) {
    if (position < static_cast<int>(text.size())) {
      text.insert(static_cast<std::size_t>(position), ".");
    }
  };
  if (number.order < -4 || precision <= number.order) {
    point(1);
    text += (number.order < 0 ? "e-" : "e+") + std::string(std::abs(number.order) < 10 ? "0" : "") +
            std::to_string(std::abs(number.order));
  } else if (number.order < 0) {
    text.insert(0, "0." + std::string(static_cast<std::size_t>(-number.order - 1), '0'));
  } else {
    const int missing = std::max(0, number.order + 1 - static_cast<int>(text.size()));
    text.append(static_cast<std::size_t>(missing), '0');
    point(number.order + 1);
  }
  return (number.negative ? "-" : "") + text;
}

}  // namespace

std::optional<Decimal> take_decimal(std::string_view& text) {
  std::string_view rest = text;
  Decimal result{.negative = take_minus(rest)};
  result.digits = take_digits(rest);
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    const std::string_view fraction = take_digits(rest);
    result.digits += fraction;
    result.exponent = -static_cast<std::int64_t>(fraction.size());
  }
  if (result.digits.empty()) {
    return std::nullopt;
  }
  result.digits.erase(0, result.digits.find_first_not_of('0'));
  result.exponent += take_exponent(rest);
  text = rest;
  return result;
}

bool in_range(const Decimal& decimal) {
  const std::int64_t order = decimal.exponent + static_cast<std::int64_t>(decimal.digits.size()) - 1;
  return decimal.digits.empty() || (-largest_order <= order && order <= largest_order);
}

Number to_number(const Decimal& decimal) {
  if (decimal.digits.empty()) {
    return Number(0);
  }
  return Number((decimal.negative ? "-" : "") + decimal.digits + "e" + std::to_string(decimal.exponent));
}

std::optional<int> to_whole(const Decimal& decimal) {
  if (decimal.digits.empty()) {
    return 0;
  }
  std::string text = decimal.digits;
  drop_zeros(text);
  const auto zeros = decimal.exponent + static_cast<std::int64_t>(decimal.digits.size() - text.size());
  if (zeros < 0 || std::numeric_limits<int>::digits10 < zeros) {
    return std::nullopt;
  }
  text = (decimal.negative ? "-" : "") + text + std::string(static_cast<std::size_t>(zeros), '0');
  int number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  return result.ec == std::errc() ? std::optional(number) : std::nullopt;
}

std::string seventeen_digits(const Number& value) {
  return value == 0 ? "0" : layout(round_to(value, 17), 17);
}

std::string six_digits(const Number& value) {
  if (value == 0) {
    return "0";
  }
  Rounded exact = round_to(value, 40);
  drop_zeros(exact.digits);
  return layout(exact.digits.size() < 6 ? exact : round_to(value, 6), 6);
}

}  // namespace goishi::cli
