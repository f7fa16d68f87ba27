#pragma once
/// \file
/// JSON files that keep to a schema.

#include <rapidjson/document.h>

#include <string>
#include <string_view>

namespace goishi::cli {

/// The document of a text. Where it is no JSON, has a member twice, or breaks a rule of the schema, std::runtime_error, of
/// one line: the file, the place, the rule.
///
///     stones.json: line 3, column 12: Missing a comma or } after an object member.
///     stones.json: /stones/0/stone/size = 0: must be at least 1
///
/// Domain  a schema of draft 4, whose `allOf` have a description for each of their parts and no reference in them.
[[nodiscard]] rapidjson::Document read_json(std::string_view file, std::string_view text, std::string_view schema);

/// A value as it stands in a message: at most 60 bytes.
[[nodiscard]] std::string shown(const rapidjson::Value& value);

}  // namespace goishi::cli
