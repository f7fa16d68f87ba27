#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "arrays.hpp"

namespace goishi::c {

namespace {

constexpr std::size_t message_size = 512;
thread_local std::array<char, message_size> message = {};

}  // namespace

/// As much of it as there is room for, and no half of a letter.
void say(std::string_view text) noexcept {
  std::size_t size = std::min(text.size(), message_size - 1);
  while (size < text.size() && 0 < size && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) {
    --size;
  }
  std::memcpy(message.data(), text.data(), size);
  message[size] = '\0';
}

}  // namespace goishi::c

extern "C" {

const char* goishi_version(void) {
  return GOISHI_VERSION;
}

const char* goishi_message(void) {
  return goishi::c::message.data();
}

}  // extern "C"
