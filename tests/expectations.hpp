#pragma once
/// \file
/// What tests of several subjects expect in the same words.

#include <gtest/gtest.h>

#include <functional>
#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <limits>
#include <string>
#include <string_view>

namespace goishi::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// How often `part` stands in `text`.
[[nodiscard]] inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}
[[nodiscard]] inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// How near to `expected`, component by component.
template <class T>
void expect_near(const Vec3<T>& actual, const Vec3<T>& expected, const T& error) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(static_cast<double>(actual[i] - expected[i]), 0.0, static_cast<double>(error))
        << "component " << i << " of " << actual.transpose() << ", not " << expected.transpose();
  }
}

template <class T>
void expect_near(const T& actual, const T& expected, const T& error) {
  EXPECT_NEAR(static_cast<double>(actual - expected), 0.0, static_cast<double>(error))
      << actual << ", not " << expected;
}

/// Expects InvalidArgument about this argument, in one line.
inline void expect_invalid(const std::string& argument, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << argument << ": nothing was thrown";
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.argument(), argument) << error.what();
    EXPECT_FALSE(error.value().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

}  // namespace goishi::test
