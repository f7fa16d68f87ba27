#include "scene/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidjson/error/en.h>
#include <rapidjson/pointer.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace goishi::cli {

namespace {

using rapidjson::Document;
using rapidjson::SizeType;
using rapidjson::Value;

std::string_view text_in(const Value& value) {
  return {value.GetString(), value.GetStringLength()};
}

/// The texts of an array, or the names of an object's members.
std::vector<std::string_view> names_in(const Value& value) {
  std::vector<std::string_view> names;
  if (value.IsArray()) {
    std::ranges::transform(value.GetArray(), std::back_inserter(names), text_in);
  } else {
    for (const auto& member : value.GetObject()) {
      names.push_back(text_in(member.name));
    }
  }
  return names;
}

/// Those that an object does not have.
std::string missing_in(const Value& value, const Value& names) {
  std::vector<std::string_view> missing = names_in(names);
  std::erase_if(missing, [&](std::string_view name) { return value.HasMember(std::string(name).c_str()); });
  return fmt::format("{}", fmt::join(missing, ", "));
}

/// "a, b or c"
std::string one_of(const std::vector<std::string_view>& names) {
  const auto last = names.end() - 1;
  return names.size() == 1 ? std::string(*last) : fmt::format("{} or {}", fmt::join(names.begin(), last, ", "), *last);
}

bool keeps_to(const Value& value, const Value& schema) {
  const rapidjson::SchemaDocument compiled(schema);
  rapidjson::SchemaValidator validator(compiled);
  return value.Accept(validator);
}

/// The rule of a schema that the value breaks, in words.
std::string rule_of(const Value& schema, std::string_view keyword, const Value& value) {
  const std::string key(keyword);
  const Value& wanted = schema[key.c_str()];
  if (keyword == "type") {
    return fmt::format("must be of the type {}", text_in(wanted));
  }
  if (keyword == "required") {
    return fmt::format("needs {}", missing_in(value, wanted));
  }
  if (keyword == "dependencies") {
    for (const auto& [name, needed] : wanted.GetObject()) {
      const std::string missing = value.HasMember(name) ? missing_in(value, needed) : "";
      if (!missing.empty()) {
        return fmt::format("with {} needs {}", text_in(name), missing);
      }
    }
  }
  if (keyword == "additionalProperties") {
    return fmt::format("must be {}", one_of(names_in(schema["properties"])));
  }
  if (keyword == "enum") {
    return fmt::format("must be {}", one_of(names_in(wanted)));
  }
  if (keyword == "minimum" || keyword == "maximum") {
    return fmt::format("must be at {} {}", keyword == "minimum" ? "least" : "most", shown(wanted));
  }
  if (keyword.starts_with("min") || keyword.starts_with("max")) {  // …Items, …Properties
    return fmt::format("must have at {} {} member{}", keyword.starts_with("min") ? "least" : "most", shown(wanted),
                       wanted.GetInt() == 1 ? "" : "s");
  }
  if (keyword == "pattern") {
    return fmt::format("must be of the form {}", text_in(wanted));
  }
  if (keyword == "allOf") {
    for (const Value& part : wanted.GetArray()) {
      if (!keeps_to(value, part)) {
        return std::string(text_in(part["description"]));
      }
    }
  }
  return fmt::format("must keep to the schema's {}", keyword);
}

[[noreturn]] void refuse(std::string_view file, const rapidjson::Pointer& place, const Value* value,
                         std::string_view rule) {
  rapidjson::StringBuffer path;
  place.Stringify(path);
  const bool is_short = value != nullptr && !value->IsObject() && !value->IsArray();
  throw std::runtime_error(fmt::format("{}: {}{}: {}", file, path.GetSize() == 0 ? "/" : path.GetString(),
                                       is_short ? " = " + shown(*value) : "", rule));
}

/// RapidJSON keeps both, and finds the first.
void refuse_twins(std::string_view file, const Value& value, const rapidjson::Pointer& place) {
  if (value.IsArray()) {
    for (SizeType i = 0; i < value.Size(); ++i) {
      refuse_twins(file, value[i], place.Append(i));
    }
  } else if (value.IsObject()) {
    for (auto member = value.MemberBegin(); member != value.MemberEnd(); ++member) {
      const rapidjson::Pointer here = place.Append(member->name);
      if (value.FindMember(member->name) != member) {
        refuse(file, here, nullptr, "must be given once");
      }
      refuse_twins(file, member->value, here);
    }
  }
}

}  // namespace

std::string shown(const Value& value) {
  if (value.IsString()) {
    return std::string(text_in(value).substr(0, 60));
  }
  if (value.IsDouble()) {
    return fmt::format("{}", value.GetDouble());
  }
  rapidjson::StringBuffer text;
  rapidjson::Writer<rapidjson::StringBuffer> writer(text);
  value.Accept(writer);
  return std::string(text.GetString(), std::min<std::size_t>(text.GetSize(), 60));
}

Document read_json(std::string_view file, std::string_view text, std::string_view schema) {
  Document document;
  // Every digit; however deep; no bytes that are no characters.
  constexpr unsigned flags =
      rapidjson::kParseFullPrecisionFlag | rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag;
  document.Parse<flags>(text.data(), text.size());
  if (document.HasParseError()) {
    const std::string_view before = text.substr(0, document.GetErrorOffset());
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    throw std::runtime_error(fmt::format("{}: line {}, column {}: {}", file, line, column,
                                         rapidjson::GetParseError_En(document.GetParseError())));
  }
  Document rules;
  rules.Parse(schema.data(), schema.size());
  const rapidjson::SchemaDocument compiled(rules);
  rapidjson::SchemaValidator validator(compiled);
  if (!document.Accept(validator)) {
    const rapidjson::Pointer place = validator.GetInvalidDocumentPointer();
    const std::string_view keyword = validator.GetInvalidSchemaKeyword();
    const Value* value = place.Get(document);
    const Value* rule = validator.GetInvalidSchemaPointer().Get(rules);
    refuse(file, place, value, rule_of(*rule, keyword, *value));
  }
  refuse_twins(file, document, rapidjson::Pointer());
  return document;
}

}  // namespace goishi::cli
