#pragma once
/// \file
/// Errors of the caller. "No contact" and "did not converge" are states in a result, never exceptions.

#include <goishi/scalar.hpp>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace goishi {

/// An argument broke the rule of the function that it was given to.
/// `what()` is one line: "height = 0.03: must not exceed the width (0.022)".
class InvalidArgument : public std::invalid_argument {
 public:
  InvalidArgument(std::string argument, std::string value, std::string rule)
      : std::invalid_argument(argument + " = " + value + ": " + rule),
        argument_(std::move(argument)),
        value_(std::move(value)),
        rule_(std::move(rule)) {}

  [[nodiscard]] const std::string& argument() const noexcept { return argument_; }
  [[nodiscard]] const std::string& value() const noexcept { return value_; }
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }

 private:
  std::string argument_;
  std::string value_;
  std::string rule_;
};

/// A value as an error message shows it: all the digits that T is sure to keep (15 for double), no more than 17.
template <class T>
[[nodiscard]] std::string to_text(const T& value) {
  constexpr int sure = std::numeric_limits<T>::digits10;
  std::ostringstream out;
  out.precision(0 < sure && sure < 17 ? sure : 17);
  out << value;
  return out.str();
}

/// Throws InvalidArgument with the rule's parts joined. Out of line of the callers' fast path: text is made only when
/// a rule is broken.
template <class T, class... Parts>
[[noreturn]] void throw_invalid(const char* argument, const T& value, const Parts&... rule) {
  std::ostringstream text;
  (text << ... << rule);
  throw InvalidArgument(argument, to_text(value), text.str());
}

/// Throws unless `holds`. Write the condition that must hold: a NaN makes it false. The rule is given in parts, joined
/// on throwing.
template <class T, class... Parts>
void require(bool holds, const char* argument, const T& value, const Parts&... rule) {
  if (!holds) [[unlikely]] {
    throw_invalid(argument, value, rule...);
  }
}

template <Ordered T>
void require_positive(const char* argument, const T& value) {
  require(T(0) < value && scalar::is_finite(value), argument, value, "must be positive and finite");
}

/// The lengths that formulas take, which square lengths: ε times the square of `least` is a normal number, and 256 times
/// that of `most` finite (double: 1.1e-146 … 8.4e152, float: 3.2e-16 … 1.1e18).
template <class T>
struct LengthRange {
  T least, most;
};

template <Ordered T>
[[nodiscard]] LengthRange<T> length_range() {
  return {.least = scalar::sqrt(T(std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon())),
          .most = scalar::sqrt(std::numeric_limits<T>::max()) / T(16)};
}

/// Throws InvalidArgument unless a length is in `length_range`.
template <Ordered T>
void require_length(const char* argument, const T& value) {
  require_positive(argument, value);
  const auto [least, most] = length_range<T>();
  require(least <= value && value <= most, argument, value,
          "must not be so small or so great that squares of lengths beside it leave the range of its type");
}

}  // namespace goishi
