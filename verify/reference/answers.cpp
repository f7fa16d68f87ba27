#include "verify/reference/answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "verify/suite/ulps.hpp"

namespace goishi::verify::reference {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string_view without_spaces(std::string_view text) {
  constexpr std::string_view spaces = " \t\r";
  const std::size_t first = text.find_first_not_of(spaces);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

/// What stands before the separator; the text goes on behind it.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

/// The decimal; not finite for any other text.
Ball number_from(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value)) {
    return Ball(1) / Ball(0);
  }
  return text.find_first_of("xX") == std::string::npos ? Ball::from_decimal(text) : Ball(value);
}

std::string value_from(const rapidjson::Value& json) {
  if (!json.IsString()) {  // numbers are, with their digits as they were written
    throw std::runtime_error("has an answer that is neither a number, a word nor an array of numbers");
  }
  return json.GetString();
}

/// |given − sign exact|.
double distance(const std::vector<Ball>& given, const Enclosure& exact, int sign) {
  Ball square(0);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Ball off = given[i] - Ball(sign) * Ball::from_decimal(exact.mid[i]);
    square = square + off * off;
  }
  Ball root;
  arb_sqrtpos(root.get(), square.get(), Ball::precision);
  return static_cast<double>(root);
}

}  // namespace

std::vector<Given> read_csv(std::string_view text) {
  std::vector<Given> result;
  for (int line = 1; !text.empty(); ++line) {
    std::string_view rest = without_spaces(take(text, '\n'));
    if (rest.empty() || rest.front() == '#' || (line == 1 && rest.starts_with("id,"))) {
      continue;
    }
    Given given;
    given.id = without_spaces(take(rest, ','));
    given.quantity = without_spaces(take(rest, ','));
    while (!rest.empty()) {
      given.values.emplace_back(without_spaces(take(rest, ',')));
    }
    if (given.values.empty()) {
      throw std::runtime_error(fmt::format("line {} is not id,quantity,value", line));
    }
    result.push_back(std::move(given));
  }
  return result;
}

std::vector<Given> read_json(std::string_view text) {
  rapidjson::Document json;
  json.Parse<rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseNanAndInfFlag>(text.data(), text.size());
  if (json.HasParseError() || !json.IsObject()) {
    throw std::runtime_error("is not a JSON object");
  }
  std::vector<Given> result;
  for (const auto& one : json.GetObject()) {
    if (!one.value.IsObject()) {
      throw std::runtime_error(fmt::format("has no object for {}", one.name.GetString()));
    }
    for (const auto& answer : one.value.GetObject()) {
      Given given{.id = one.name.GetString(), .quantity = answer.name.GetString(), .values = {}};
      if (answer.value.IsArray()) {
        for (const rapidjson::Value& component : answer.value.GetArray()) {
          given.values.push_back(value_from(component));
        }
      } else {
        given.values.push_back(value_from(answer.value));
      }
      result.push_back(std::move(given));
    }
  }
  return result;
}

std::vector<Given> read_answers(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{' ? read_json(text) : read_csv(text);
}

std::string own_answers(const Section& section) {
  std::string text;
  for (const Problem& problem : section.problems) {
    for (const Answer<double>& answer : problem.compute()) {
      text += fmt::format("{},{},{}\n", problem.id, answer.quantity,
                          answer.word.empty() ? fmt::format("{}", fmt::join(answer.values, ",")) : answer.word);
    }
  }
  return text;
}

double error_of(const Given& given, const Enclosure& exact, bool either_sign) {
  if (!exact.word.empty()) {
    return given.values.size() == 1 && given.values.front() == exact.word ? 0.0 : infinite;
  }
  if (given.values.size() != exact.mid.size()) {
    return infinite;
  }
  std::vector<Ball> values;
  for (const std::string& text : given.values) {
    values.push_back(number_from(text));
    if (!values.back().is_finite()) {
      return infinite;
    }
  }
  const double off =
      either_sign ? std::min(distance(values, exact, 1), distance(values, exact, -1)) : distance(values, exact, 1);
  const double size = 0.0 < exact.scale ? exact.scale : std::strtod(exact.mid.front().c_str(), nullptr);
  return off / ulp_of(size);
}

std::vector<Tally> judge(const std::vector<ReadFile>& files, const std::vector<Given>& answers) {
  std::map<std::pair<std::string, std::string>, const Given*> given;
  for (const Given& answer : answers) {
    if (!given.emplace(std::pair(answer.id, answer.quantity), &answer).second) {
      throw std::runtime_error(fmt::format("{} of {} is answered twice", answer.quantity, answer.id));
    }
  }
  std::vector<Tally> result;
  for (const ReadFile& file : files) {
    const std::size_t first = result.size();
    for (const ReadCase& one : file.cases) {
      for (const Enclosure& exact : one.answers) {
        auto tally = std::find_if(result.begin() + static_cast<std::ptrdiff_t>(first), result.end(),
                                  [&](const Tally& other) { return other.quantity == exact.quantity; });
        if (tally == result.end()) {
          tally = result.insert(
              tally, {.section = file.section, .quantity = exact.quantity, .cases = 0, .errors = {}, .worst = ""});
        }
        ++tally->cases;
        const auto answer = given.find({one.id, exact.quantity});
        if (answer == given.end()) {
          continue;
        }
        const double error = error_of(*answer->second, exact, std::ranges::count(file.either_sign, exact.quantity) > 0);
        if (tally->errors.empty() || tally->errors.back() < error) {
          tally->errors.push_back(error);
          tally->worst = one.id;
        } else {
          tally->errors.insert(std::ranges::upper_bound(tally->errors, error), error);
        }
        given.erase(answer);
      }
    }
  }
  if (!given.empty()) {
    const auto& [id, quantity] = given.begin()->first;
    throw std::runtime_error(fmt::format("no case asks for {} of {}", quantity, id));
  }
  return result;
}

double median_of(const Tally& tally) {
  const std::vector<double>& errors = tally.errors;
  if (errors.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::size_t half = errors.size() / 2;
  return errors.size() % 2 == 1 ? errors[half] : (errors[half - 1] + errors[half]) / 2.0;
}

}  // namespace goishi::verify::reference
