#pragma once
/// \file
/// JSON with numbers of 17 significant digits, which RapidJSON itself does not write.

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <string_view>

#include "number.hpp"

namespace goishi::cli {

using JsonWriter = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

inline void write_key(JsonWriter& writer, std::string_view key) {
  writer.Key(key.data(), static_cast<rapidjson::SizeType>(key.size()));
}

inline void write_string(JsonWriter& writer, std::string_view text) {
  writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

inline void write_number(JsonWriter& writer, const Number& value) {
  const std::string digits = seventeen_digits(value);
  writer.RawValue(digits.data(), digits.size(), rapidjson::kNumberType);
}

}  // namespace goishi::cli
