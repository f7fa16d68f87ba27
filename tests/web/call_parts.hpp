#pragma once
/// \file
/// What the lists of calls are made of: arguments that the functions take.

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/web/calls.hpp"

namespace goishi::web_test {

inline constexpr double infinity = std::numeric_limits<double>::infinity(),
                        nan = std::numeric_limits<double>::quiet_NaN();

inline const std::vector<double> stone = {0.022, 0.0092, 0.001, 0.0, 2800.0, 0.0};
inline const std::vector<double> state = {0.01, -0.02, 0.05, 0.8, 0.6, 0.0, 0.0, 0.1, 0.0, -0.2, 1e-6, -2e-6, 3e-6};
inline const std::vector<double> pose(state.begin(), state.begin() + GOISHI_POSE_SIZE);
inline const std::vector<double> other_state = {0.01, -0.02, 0.01, 0.6, 0.0, 0.8, 0.0, 0.0, 0.0, 0.5, 0.0, 1e-6, 0.0};
inline const std::vector<double> other_pose(other_state.begin(), other_state.begin() + GOISHI_POSE_SIZE);
inline const std::vector<double> gravity = {0.0, 0.0, -9.80665};
inline const std::vector<double> point = {0.015, -0.02, 0.046}, normal = {0.0, 0.0, 1.0};
inline const std::vector<double> impulse = {1e-4, -2e-4, 1e-3};
inline const std::vector<double> board = {19.0, 0.022, 0.0237, 0.0141, 0.01395, 0.1515, 0.0};
inline const std::vector<double> plane = {0.0, 0.0, 1.0, 0.0};

[[nodiscard]] inline std::vector<double> settings() {
  std::vector<double> result(GOISHI_SETTINGS_SIZE);
  if (goishi_settings(result.data(), result.size()) != GOISHI_OK) {
    std::abort();
  }
  return result;
}

[[nodiscard]] inline Array in(const char* name, const std::vector<double>& values, Kind kind = Kind::numbers) {
  return {.name = name, .values = values, .kind = kind};
}

[[nodiscard]] inline Array out(const char* name, std::size_t size, bool rows = false, Kind kind = Kind::numbers) {
  return {.name = name, .values = std::vector<double>(size, 77.0), .output = true, .rows = rows, .kind = kind};
}

[[nodiscard]] inline int as_int(long long value) {
  return static_cast<int>(value);
}

/// Runs a function that has arrays of numbers and nothing else.
template <auto function, std::size_t... i>
int with(const Views& a, std::index_sequence<i...> /*places*/) {
  return std::apply(function, std::tuple_cat(std::make_tuple(a[i].numbers(), a[i].size)...));
}
template <auto function, std::size_t count>
int arrays_only(const Views& a, const Wholes& /*none*/, const Scalars& /*none*/) {
  return with<function>(a, std::make_index_sequence<count>());
}

/// Of a scene, see scene_calls.cpp.
[[nodiscard]] std::vector<Call> scene_calls();

}  // namespace goishi::web_test
