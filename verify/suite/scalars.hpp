#pragma once
/// \file
/// Short names that samples and claims share.

#include <goishi/rotation.hpp>
#include <limits>

namespace goishi::verify {

using Long = long double;
using Long3 = Vec3<Long>;

[[nodiscard]] inline double as_double(Long value) {
  return static_cast<double>(value);
}

template <class T>
inline constexpr double epsilon_of = static_cast<double>(std::numeric_limits<T>::epsilon());
inline constexpr double epsilon = epsilon_of<double>;

}  // namespace goishi::verify
