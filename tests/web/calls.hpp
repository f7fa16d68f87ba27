#pragma once
/// \file
/// Every function of the C interface that returns a status, with arguments that it takes: for tests and fuzzing to spoil.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "goishi.h"

namespace goishi::web_test {

enum class Kind { numbers, ints, corners, size, integer, drop, new_drop, scene, new_scene };

/// An argument that is a pointer. The kinds from `size` on come without a size.
struct Array {
  std::string name;
  std::vector<double> values;  // of an output, what stands there before
  bool output = false;
  bool rows = false;  // of so many rows as there is room for
  Kind kind = Kind::numbers;

  [[nodiscard]] bool has_size() const { return kind <= Kind::corners; }
};

struct Whole {
  std::string name;
  long long value;
  std::vector<long long> bad;
};

struct Scalar {
  std::string name;
  double value;
  std::vector<double> bad;
};

/// A pointer and its size, as the function gets them.
struct View {
  void* pointer = nullptr;
  std::size_t size = 0;

  [[nodiscard]] double* numbers() const { return static_cast<double*>(pointer); }
  [[nodiscard]] int* ints() const { return static_cast<int*>(pointer); }
  [[nodiscard]] std::uint32_t* corners() const { return static_cast<std::uint32_t*>(pointer); }
  [[nodiscard]] std::size_t* sizes() const { return static_cast<std::size_t*>(pointer); }
  [[nodiscard]] goishi_drop* drop() const { return static_cast<goishi_drop*>(pointer); }
  [[nodiscard]] goishi_drop** new_drop() const { return static_cast<goishi_drop**>(pointer); }
  [[nodiscard]] goishi_scene* scene() const { return static_cast<goishi_scene*>(pointer); }
  [[nodiscard]] goishi_scene** new_scene() const { return static_cast<goishi_scene**>(pointer); }
};

using Views = std::vector<View>;
using Wholes = std::vector<long long>;
using Scalars = std::vector<double>;

struct Call {
  std::string name;
  std::vector<Array> arrays;
  std::vector<Whole> wholes;
  std::vector<Scalar> scalars;
  std::function<int(const Views&, const Wholes&, const Scalars&)> run;
};

[[nodiscard]] std::vector<Call> all_calls();

/// A drop that has fallen for a tenth of a second, with its motion kept.
[[nodiscard]] goishi_drop* falling_drop();

/// A scene of three stones: 0 falls, 1 lies on the board, 2 is held by a hand.
[[nodiscard]] goishi_scene* busy_scene();

/// The memory of an array's argument, no byte longer than it is.
class Memory {
 public:
  explicit Memory(const Array& array);
  ~Memory();
  Memory(Memory&&) noexcept;
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  Memory& operator=(Memory&&) = delete;

  [[nodiscard]] View view() const;
  /// What stands there now, as bytes.
  [[nodiscard]] std::vector<unsigned char> bytes() const;

 private:
  std::size_t count_, size_;
  Kind kind_;
  std::unique_ptr<unsigned char[]> data_;
  goishi_drop* drop_ = nullptr;
  goishi_scene* scene_ = nullptr;
};

}  // namespace goishi::web_test
