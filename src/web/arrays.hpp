#pragma once
/// \file
/// How the C interface reads its arguments, writes its results, and tells what was wrong.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <goishi/contact/contact.hpp>
#include <goishi/error.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "goishi.h"

namespace goishi::c {

using Vec = Vec3<double>;

inline constexpr int most_whole = std::numeric_limits<int>::max();

/// Keeps a text as this thread's message.
void say(std::string_view text) noexcept;

/// What a function of the interface does: no exception leaves it.
template <class Work>
[[nodiscard]] int guarded(Work&& work) noexcept {
  say("");
  try {
    work();
    return GOISHI_OK;
  } catch (const InvalidArgument& error) {
    say(error.what());
    return GOISHI_INVALID_ARGUMENT;
  } catch (const std::bad_alloc&) {
    say("out of memory");
    return GOISHI_OUT_OF_MEMORY;
  } catch (const std::length_error&) {  // of a vector
    say("out of memory");
    return GOISHI_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    say(error.what());
  } catch (...) {
    say("an error without a name");
  }
  return GOISHI_FAILURE;
}

inline void require_pointer(const char* name, const void* pointer) {
  require(pointer != nullptr, name, std::string_view("null"), "must point to something");
}

inline void require_array(const char* name, const void* pointer, std::size_t size, std::size_t expected) {
  require_pointer(name, pointer);
  if (size != expected) {
    throw_invalid((std::string(name) + "_size").c_str(), size, "must be ", expected);
  }
}

/// The numbers of an input.
template <std::size_t count, class T>
[[nodiscard]] std::array<T, count> read(const char* name, const T* pointer, std::size_t size) {
  require_array(name, pointer, size, count);
  std::array<T, count> result;
  std::copy_n(pointer, count, result.begin());
  return result;
}

/// How many rows an output has room for.
[[nodiscard]] inline std::size_t count_rows(const char* name, const void* pointer, std::size_t size, std::size_t row) {
  require_pointer(name, pointer);
  if (size == 0 || size % row != 0) {
    throw_invalid((std::string(name) + "_size").c_str(), size, "must be a multiple of ", row, ", and not 0");
  }
  return size / row;
}

inline void write(const std::vector<double>& values, double* pointer) {
  std::copy(values.begin(), values.end(), pointer);
}

/// A whole number from `least` to `most` that stands in an array of `double`.
[[nodiscard]] inline int whole(const char* name, double value, int least, int most) {
  require(static_cast<double>(least) <= value && value <= static_cast<double>(most) && std::floor(value) == value, name,
          value, "must be a whole number from ", least, " to ", most);
  return static_cast<int>(value);
}

/// The enumerator with a value from 0 to `last`.
template <class Enum>
[[nodiscard]] Enum chosen(const char* name, int value, Enum last) {
  require(0 <= value && value <= static_cast<int>(last), name, value, "must be from 0 to ", static_cast<int>(last));
  return static_cast<Enum>(value);
}

[[nodiscard]] inline double as_number(bool value) {
  return value ? 1.0 : 0.0;
}

template <class Enum>
[[nodiscard]] double as_number(Enum value) {
  return static_cast<double>(static_cast<int>(value));
}

/// A row that is filled from its beginning on.
class Row {
 public:
  explicit Row(std::vector<double>& values) : values_(values) {}

  Row& operator<<(double value) {
    values_.push_back(value);
    return *this;
  }
  Row& operator<<(const Vec& v) { return *this << v.x() << v.y() << v.z(); }
  Row& operator<<(const Quat<double>& q) { return *this << q.w() << q.x() << q.y() << q.z(); }
  Row& operator<<(const State<double>& s) { return *this << s.p_WB << s.q_WB << s.v_WB << s.L_W; }
  Row& operator<<(const Separation<double>& s) {
    return *this << as_number(s.status) << s.gap << s.n_W << s.p_stone << s.p_other << as_number(s.feature)
                 << as_number(s.other_feature) << as_number(s.certified);
  }

 private:
  std::vector<double>& values_;
};

[[nodiscard]] inline Vec read_vector(const char* name, const double* pointer, std::size_t size) {
  const auto [x, y, z] = read<3>(name, pointer, size);
  return {x, y, z};
}

/// Whether an enumerator of the header is that of the library.
template <class Enum>
[[nodiscard]] constexpr bool is(Enum value, int number) {
  return static_cast<int>(value) == number;
}

}  // namespace goishi::c
