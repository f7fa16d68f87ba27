#include <cstring>
#include <utility>

#include "tests/web/calls.hpp"

namespace goishi::web_test {

namespace {

std::size_t element_size(Kind kind) {
  switch (kind) {
    case Kind::numbers:
      return sizeof(double);
    case Kind::ints:
    case Kind::integer:
      return sizeof(int);
    case Kind::corners:
      return sizeof(std::uint32_t);
    case Kind::size:
      return sizeof(std::size_t);
    case Kind::drop:
    case Kind::new_drop:
    case Kind::scene:
    case Kind::new_scene:
      break;
  }
  return sizeof(void*);
}

}  // namespace

Memory::Memory(const Array& array)
    : count_(array.values.size()),
      size_(count_ * element_size(array.kind)),
      kind_(array.kind),
      data_(new unsigned char[size_]) {
  if (kind_ == Kind::drop || kind_ == Kind::scene) {
    drop_ = kind_ == Kind::drop ? falling_drop() : nullptr;
    scene_ = kind_ == Kind::scene ? busy_scene() : nullptr;
    return;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    const double value = array.values[i];
    const auto put = [&](const auto& element) {
      std::memcpy(data_.get() + i * sizeof(element), &element, sizeof(element));
    };
    switch (kind_) {
      case Kind::numbers:
        put(value);
        break;
      case Kind::ints:
      case Kind::integer:
        put(static_cast<int>(value));
        break;
      case Kind::corners:
        put(static_cast<std::uint32_t>(value));
        break;
      case Kind::size:
        put(static_cast<std::size_t>(value));
        break;
      case Kind::drop:
      case Kind::new_drop:
      case Kind::scene:
      case Kind::new_scene:
        put(static_cast<void*>(nullptr));
        break;
    }
  }
}

Memory::Memory(Memory&& other) noexcept
    : count_(other.count_),
      size_(other.size_),
      kind_(other.kind_),
      data_(std::move(other.data_)),
      drop_(std::exchange(other.drop_, nullptr)),
      scene_(std::exchange(other.scene_, nullptr)) {}

Memory::~Memory() {
  if (data_ && kind_ == Kind::new_drop) {
    std::memcpy(&drop_, data_.get(), sizeof(drop_));
  } else if (data_ && kind_ == Kind::new_scene) {
    std::memcpy(&scene_, data_.get(), sizeof(scene_));
  }
  goishi_drop_free(drop_);
  goishi_scene_free(scene_);
}

View Memory::view() const {
  void* const own = drop_ != nullptr ? static_cast<void*>(drop_) : static_cast<void*>(scene_);
  return {.pointer = kind_ == Kind::drop || kind_ == Kind::scene ? own : data_.get(), .size = count_};
}

std::vector<unsigned char> Memory::bytes() const {
  return kind_ == Kind::drop || kind_ == Kind::scene ? std::vector<unsigned char>{}
                                                     : std::vector<unsigned char>(data_.get(), data_.get() + size_);
}

}  // namespace goishi::web_test
