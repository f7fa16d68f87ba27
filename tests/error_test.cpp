/// What error messages look like: what a stream would write.

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <goishi/error.hpp>
#include <goishi/rotation.hpp>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/expectations.hpp"

namespace goishi::error_test {

namespace {

template <class T>
[[nodiscard]] std::string streamed(const T& value, int precision) {
  std::ostringstream out;
  out.precision(precision);
  out << value;
  return out.str();
}

/// As a value and as a part of a rule.
template <class T>
void expect_as_streamed(const T& value, int precision) {
  EXPECT_EQ(to_text(value), streamed(value, precision));
  try {
    throw_invalid("name", value, "must be ", value, " or so");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.what(), "name = " + streamed(value, precision) + ": must be " + streamed(value, 6) + " or so");
  }
}

TEST(ErrorText, Numbers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<std::uint64_t>(random());
    const double value = std::bit_cast<double>(bits), short_one = static_cast<double>(bits % 100000) / 1000.0;
    expect_as_streamed(value, 15);
    expect_as_streamed(short_one, 15);
    expect_as_streamed(static_cast<float>(short_one), 6);
    expect_as_streamed(static_cast<long double>(value) / 3.0L, 17);
  }
  for (const double value : {0.0, -0.0, 1.0, 0.1, 1e15, 1e16, 1e-5, 123456.0, 1234567.0, test::infinity,
                             -test::infinity, test::nan, -test::nan, std::numeric_limits<double>::max(), 5e-324}) {
    expect_as_streamed(value, 15);
    expect_as_streamed(static_cast<float>(value), 6);
    expect_as_streamed(static_cast<long double>(value), 17);
  }
}

TEST(ErrorText, WholeNumbersAndTexts) {
  for (const int value : {0, 7, -3, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    expect_as_streamed(value, 9);
    expect_as_streamed(static_cast<std::int64_t>(value), 17);
    expect_as_streamed(static_cast<std::uint64_t>(value), 17);
    expect_as_streamed(static_cast<std::size_t>(value), 17);
    expect_as_streamed(static_cast<short>(value), 4);
  }
  expect_as_streamed('x', 17);
  expect_as_streamed(true, 17);
  expect_as_streamed(std::string("ein Wert"), 17);
  expect_as_streamed(std::string_view("ρ"), 17);
}

TEST(ErrorText, RowsOfNumbers) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const double a = static_cast<double>(random() % 1000) / 8.0, b = std::bit_cast<double>(random());
    for (const Vec3<double>& v : {Vec3<double>(a, b, -a), Vec3<double>(0.0, 0.0, 1.0), Vec3<double>(b, 1.0, a)}) {
      expect_as_streamed(v.transpose(), 17);
      expect_as_streamed(Vec3<float>(v.cast<float>()).transpose(), 17);
      expect_as_streamed(Eigen::RowVector3d(v), 17);
    }
  }
}

/// Other scalars go through a stream.
TEST(ErrorText, OtherScalars) {
  using Number = boost::multiprecision::cpp_bin_float_50;
  const Number third = Number(1) / 3;
  expect_as_streamed(third, 17);
  expect_as_streamed(Vec3<Number>(third, Number(2), -third).transpose(), 17);
}

}  // namespace

}  // namespace goishi::error_test
