#pragma once
/// \file
/// Errors of the caller. "No contact" and "did not converge" are states in a result, never exceptions.
///
/// Where there are no exceptions (-fno-exceptions), or where GOISHI_NO_EXCEPTIONS is defined, an error of the caller ends the
/// program: the line that `InvalidArgument::what()` would give goes to the standard error, then `std::abort` is called.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <goishi/scalar.hpp>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#if !defined(GOISHI_NO_EXCEPTIONS) && !defined(__cpp_exceptions)
#define GOISHI_NO_EXCEPTIONS
#endif

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

namespace detail {

/// A row of built-in numbers, as Eigen has them.
template <class T>
concept RowOfNumbers = requires(const T& row) {
  requires std::floating_point<typename T::Scalar>;
  requires T::RowsAtCompileTime == 1;
  row.coeff(0);
};

/// What a stream of that precision would write. Numbers, texts and rows of numbers need none, which keeps 150 kB of streams
/// out of a small program.
template <class T>
[[nodiscard]] std::string written(const T& value, int precision) {
  if constexpr (std::convertible_to<const T&, std::string_view>) {
    return std::string(std::string_view(value));
  } else if constexpr (std::integral<T> && sizeof(char) < sizeof(T)) {
    return std::to_string(value);
  } else if constexpr (std::floating_point<T>) {
    std::array<char, 64> text;
    int length = 0;
    if constexpr (std::same_as<T, long double>) {
      length = std::snprintf(text.data(), text.size(), "%.*Lg", precision, value);
    } else {
      length = std::snprintf(text.data(), text.size(), "%.*g", precision, static_cast<double>(value));
    }
    std::string number(text.data(), static_cast<std::size_t>(length));
    const std::size_t point =
        number.find_first_not_of("+-0123456789abcdefghijklmnopqrstuvwxyz");  // as the locale has it
    if (point != std::string::npos) {
      number.replace(point, number.find_first_of("0123456789", point) - point, ".");
    }
    return number;
  } else if constexpr (RowOfNumbers<T>) {
    std::string text;
    std::size_t width = 0;  // of all columns
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = 0; i < static_cast<int>(value.size()); ++i) {
        const std::string one = written(value.coeff(i), precision);
        if (pass == 0) {
          width = std::max(width, one.size());
        } else {
          text += (i == 0 ? "" : " ") + std::string(width - one.size(), ' ') + one;
        }
      }
    }
    return text;
  } else {
    std::ostringstream out;
    out.precision(precision);
    out << value;
    return out.str();
  }
}

}  // namespace detail

/// A value as an error message shows it: all the digits that T is sure to keep (15 for double), no more than 17.
template <class T>
[[nodiscard]] std::string to_text(const T& value) {
  constexpr int sure = std::numeric_limits<T>::digits10;
  return detail::written(value, 0 < sure && sure < 17 ? sure : 17);
}

/// Throws InvalidArgument with the rule's parts joined. Out of line of the callers' fast path: text is made only when
/// a rule is broken.
template <class T, class... Parts>
[[noreturn]] void throw_invalid(const char* argument, const T& value, const Parts&... rule) {
  constexpr int usual_precision = 6;
  const std::string text = to_text(value), broken = (std::string() + ... + detail::written(rule, usual_precision));
#ifdef GOISHI_NO_EXCEPTIONS
  std::fputs((std::string(InvalidArgument(argument, text, broken).what()) + "\n").c_str(), stderr);
  std::abort();
#else
  throw InvalidArgument(argument, text, broken);
#endif
}

/// Throws unless `holds`. Write the condition that must hold: a NaN makes it false. The rule is given in parts, joined
/// on throwing.
template <class T, class... Parts>
void require(bool holds, const char* argument, const T& value, const Parts&... rule) {
  if (!holds) [[unlikely]] {
    throw_invalid(argument, value, rule...);
  }
}

namespace detail {

/// Whether all hold, asked together and without a branch. (Of two bools, clang takes & for a slip.)
template <std::same_as<bool>... Holds>
[[nodiscard]] constexpr bool all(Holds... holds) {
  return (static_cast<unsigned>(holds) & ...) != 0U;
}

}  // namespace detail

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
