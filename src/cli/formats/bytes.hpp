#pragma once
/// \file
/// Numbers as the bytes of a file, the lowest first, whatever machine writes them.

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <goishi/rotation.hpp>
#include <string>

namespace goishi::cli {

template <std::unsigned_integral T>
void append(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
  }
}

inline void append(std::string& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}

inline void append(std::string& bytes, double value) {
  append(bytes, std::bit_cast<std::uint64_t>(value));
}

/// The three components, each rounded to T.
template <std::floating_point T>
void append(std::string& bytes, const Vec3<double>& v) {
  for (const double component : v) {
    append(bytes, static_cast<T>(component));
  }
}

}  // namespace goishi::cli
