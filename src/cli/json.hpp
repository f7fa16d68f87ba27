#pragma once
/// \file
/// JSON with numbers of 17 significant digits, which RapidJSON itself does not write.

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <cmath>
#include <goishi/rotation.hpp>
#include <initializer_list>
#include <string>
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

/// A document of doubles, null where one is not finite, whose members are written one after the other.
class JsonText {
 public:
  JsonText() : writer_(buffer_) {
    writer_.SetIndent(' ', 2);
    begin_object();
  }

  void begin_object() { writer_.StartObject(); }
  void begin_object(std::string_view key) {
    write_key(writer_, key);
    writer_.StartObject();
  }
  void end_object() { writer_.EndObject(); }
  void begin_array(std::string_view key) {
    write_key(writer_, key);
    writer_.StartArray();
  }
  void end_array() { writer_.EndArray(); }

  void member(std::string_view key, std::string_view value) {
    write_key(writer_, key);
    write_string(writer_, value);
  }
  void member(std::string_view key, const char* value) { member(key, std::string_view(value)); }
  void member(std::string_view key, double value) {
    write_key(writer_, key);
    write(value);
  }
  void member(std::string_view key, bool value) {
    write_key(writer_, key);
    writer_.Bool(value);
  }
  void count(std::string_view key, long long value) {
    write_key(writer_, key);
    writer_.Int64(value);
  }
  void member(std::string_view key, std::initializer_list<double> values) {
    write_key(writer_, key);
    writer_.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    writer_.StartArray();
    for (const double value : values) {
      write(value);
    }
    writer_.EndArray();
    writer_.SetFormatOptions(rapidjson::kFormatDefault);
  }
  void member(std::string_view key, const Vec3<double>& v) { member(key, {v.x(), v.y(), v.z()}); }

  /// The whole of it, ended.
  [[nodiscard]] std::string text() {
    writer_.EndObject();
    return std::string(buffer_.GetString(), buffer_.GetSize()) + "\n";
  }

 private:
  void write(double value) {
    if (std::isfinite(value)) {
      write_number(writer_, Number(value));
    } else {
      writer_.Null();
    }
  }

  rapidjson::StringBuffer buffer_;
  JsonWriter writer_;
};

}  // namespace goishi::cli
