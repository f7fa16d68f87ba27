#include "verify/reference/file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidjson/document.h>

#include <stdexcept>

namespace goishi::verify::reference {

namespace {

/// As JSON; none of our words holds a quote or a backslash.
std::string quoted(const std::string& text) {
  if (text.find_first_of("\"\\\n") != std::string::npos) {
    throw std::runtime_error(fmt::format("must need no escape: {}", text));
  }
  return fmt::format("\"{}\"", text);
}

std::string text_of(const Input& input) {
  if (!input.word.empty()) {
    return quoted(input.word);
  }
  return input.numbers.size() == 1 ? fmt::format("{}", input.numbers.front())
                                   : fmt::format("[{}]", fmt::join(input.numbers, ", "));
}

std::string text_of(const Enclosure& answer) {
  if (!answer.word.empty()) {
    return quoted(answer.word);
  }
  std::vector<std::string> mid;
  for (const std::string& component : answer.mid) {
    mid.push_back(quoted(component));
  }
  const std::string scale = 0.0 < answer.scale ? fmt::format(", \"scale\": {}", answer.scale) : "";
  return fmt::format("{{\"mid\": {}, \"rad\": {}{}}}",
                     mid.size() == 1 ? mid.front() : fmt::format("[{}]", fmt::join(mid, ", ")), quoted(answer.rad),
                     scale);
}

const char* name_of(Proof proof) {
  constexpr const char* names[] = {"formula", "integral", "bracket", "root", "word"};
  return names[static_cast<std::size_t>(proof)];
}

std::string text_of(const Problem& problem) {
  std::vector<std::string> inputs, answers;
  for (const Input& input : problem.inputs) {
    inputs.push_back(fmt::format("{}: {}", quoted(input.name), text_of(input)));
  }
  try {
    for (const Answer<OrderedBall>& answer : problem.enclose()) {
      answers.push_back(fmt::format("{}: {}", quoted(answer.quantity), text_of(printed(answer))));
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{} ({}): {}", problem.id, problem.about, error.what()));
  }
  return fmt::format("    {{\"id\": {}, \"about\": {},\n     \"inputs\": {{{}}},\n     \"answers\": {{\n       {}}}}}",
                     quoted(problem.id), quoted(problem.about), fmt::join(inputs, ", "),
                     fmt::join(answers, ",\n       "));
}

const rapidjson::Value& member(const rapidjson::Value& of, const char* name, bool (rapidjson::Value::*is)() const) {
  const auto found = of.IsObject() ? of.FindMember(name) : rapidjson::Value::ConstMemberIterator();
  if (!of.IsObject() || found == of.MemberEnd() || !(found->value.*is)()) {
    throw std::runtime_error(fmt::format("has no fit member \"{}\"", name));
  }
  return found->value;
}

Enclosure read_answer(const char* quantity, const rapidjson::Value& json) {
  Enclosure answer{.quantity = quantity, .mid = {}, .rad = "0", .scale = 0.0};
  if (json.IsString()) {
    answer.word = json.GetString();
    return answer;
  }
  answer.rad = member(json, "rad", &rapidjson::Value::IsString).GetString();
  if (json.HasMember("scale")) {
    answer.scale = member(json, "scale", &rapidjson::Value::IsNumber).GetDouble();
  }
  const auto mid = json.FindMember("mid");
  const auto add = [&](const rapidjson::Value& component) {
    if (!component.IsString()) {
      throw std::runtime_error(fmt::format("has a \"mid\" that is no decimal in quotes, of {}", quantity));
    }
    answer.mid.emplace_back(component.GetString());
  };
  if (mid != json.MemberEnd() && mid->value.IsArray()) {
    for (const rapidjson::Value& component : mid->value.GetArray()) {
      add(component);
    }
  } else {
    add(member(json, "mid", &rapidjson::Value::IsString));
  }
  return answer;
}

}  // namespace

std::string file_text(const Section& section) {
  std::vector<std::string> inputs, quantities, cases;
  for (const InputKind& input : section.inputs) {
    inputs.push_back(fmt::format("    {}: {{\"unit\": {}, \"about\": {}}}", quoted(input.name), quoted(input.unit),
                                 quoted(input.about)));
  }
  for (const QuantityKind& quantity : section.quantities) {
    quantities.push_back(fmt::format("    {}: {{\"unit\": {}, \"components\": {}, \"proof\": \"{}\", {}\"about\": {}}}",
                                     quoted(quantity.name), quoted(quantity.unit), quantity.components,
                                     name_of(quantity.proof), quantity.either_sign ? "\"either_sign\": true, " : "",
                                     quoted(quantity.about)));
  }
  for (const Problem& problem : section.problems) {
    cases.push_back(text_of(problem));
  }
  return fmt::format(
      "{{\n  \"section\": {},\n  \"about\": {},\n  \"inputs\": {{\n{}\n  }},\n  \"quantities\": {{\n{}\n  }},\n"
      "  \"cases\": [\n{}\n  ]\n}}\n",
      quoted(section.name), quoted(section.about), fmt::join(inputs, ",\n"), fmt::join(quantities, ",\n"),
      fmt::join(cases, ",\n"));
}

ReadFile read_file(std::string_view text) {
  rapidjson::Document json;
  json.Parse<rapidjson::kParseFullPrecisionFlag>(text.data(), text.size());
  if (json.HasParseError()) {
    throw std::runtime_error("is not JSON");
  }
  ReadFile file;
  file.section = member(json, "section", &rapidjson::Value::IsString).GetString();
  for (const auto& quantity : member(json, "quantities", &rapidjson::Value::IsObject).GetObject()) {
    if (quantity.value.IsObject() && quantity.value.HasMember("either_sign")) {
      file.either_sign.emplace_back(quantity.name.GetString());
    }
  }
  for (const rapidjson::Value& one : member(json, "cases", &rapidjson::Value::IsArray).GetArray()) {
    ReadCase read{.id = member(one, "id", &rapidjson::Value::IsString).GetString(), .answers = {}};
    for (const auto& answer : member(one, "answers", &rapidjson::Value::IsObject).GetObject()) {
      read.answers.push_back(read_answer(answer.name.GetString(), answer.value));
    }
    file.cases.push_back(std::move(read));
  }
  return file;
}

}  // namespace goishi::verify::reference
