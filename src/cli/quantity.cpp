#include "quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/error.hpp>

namespace goishi::cli {

namespace {

/// A unit as those type it who have no µ, ² and ³. Two letters look like µ: U+00B5 and U+03BC.
std::string plain(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> letters[] = {{"\u00b5", "u"}, {"\u03bc", "u"}, {"²", "2"},
                                                                       {"³", "3"},      {"^2", "2"},     {"^3", "3"}};
  std::string text(unit);
  for (const auto& [letter, typed] : letters) {
    for (std::size_t at = 0; (at = text.find(letter, at)) != std::string::npos;) {
      text.replace(at, letter.size(), typed);
    }
  }
  return text;
}

/// What a text must be that has no number where one is needed.
std::string form_of(const Measure& measure, std::size_t count) {
  std::string form = count == 1 ? std::string("must be a decimal number")
                                : fmt::format("must be {} decimal numbers with commas between them", count);
  if (!measure.units.empty()) {
    form += fmt::format(", bare ({}) or with a unit ({})", measure.units.front().name, names_of(measure));
  }
  return form;
}

/// A typed number, and whether a unit was typed with it.
struct Typed {
  Number value;
  bool has_unit;
};

/// Reads the part of the text that is one of its `count` numbers.
Typed read(const std::string& argument, std::string_view text, std::string_view part, const Measure& measure,
           std::size_t count) {
  const auto broken = [&](const std::string& rule) { return InvalidArgument(argument, std::string(text), rule); };
  std::string_view rest = trimmed(part);
  auto decimal = take_decimal(rest);
  rest = trimmed(rest);
  if (!decimal || (measure.units.empty() && !rest.empty())) {
    throw broken(form_of(measure, count));
  }
  const bool has_unit = !rest.empty();
  if (has_unit) {
    const auto unit = std::ranges::find(measure.units, plain(rest), [](const InputUnit& u) { return plain(u.name); });
    if (unit == measure.units.end()) {
      throw broken(fmt::format("must have one of the units {}, not '{}'", names_of(measure), rest));
    }
    decimal->exponent += unit->power;
  }
  if (!in_range(*decimal)) {
    const std::string unit = measure.units.empty() ? "" : fmt::format(" {}", measure.units.front().name);
    throw broken(fmt::format("must be 0 or from 1e-{0} to 1e{0}{1}, in magnitude", largest_order, unit));
  }
  return {to_number(*decimal), has_unit};
}

}  // namespace

std::string names_of(const Measure& measure) {
  std::vector<std::string_view> names;
  std::ranges::transform(measure.units, std::back_inserter(names), &InputUnit::name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  return text.substr(0, text.find_last_not_of(blank) + 1);
}

Number parse(const std::string& argument, std::string_view text, const Measure& measure) {
  return read(argument, text, text, measure, 1).value;
}

std::vector<Number> parse_list(const std::string& argument, std::string_view text, const Measure& measure,
                               std::size_t count) {
  const auto broken = [&](const std::string& rule) { return InvalidArgument(argument, std::string(text), rule); };
  if (static_cast<std::size_t>(std::ranges::count(text, ',')) + 1 != count) {
    throw broken(form_of(measure, count));
  }
  std::vector<Number> numbers;
  bool some_have_units = false;
  bool some_need_units = false;
  std::string_view rest = text;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const Typed number = read(argument, text, rest.substr(0, comma), measure, count);
    numbers.push_back(number.value);
    some_have_units = some_have_units || number.has_unit;
    some_need_units = some_need_units || (!number.has_unit && number.value != 0);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  if (some_have_units && some_need_units) {
    throw broken("must have a unit with each number but 0, or with none");
  }
  return numbers;
}

Vec3<Number> parse_vector(const std::string& argument, std::string_view text, const Measure& measure) {
  const std::vector<Number> c = parse_list(argument, text, measure, 3);
  return {c[0], c[1], c[2]};
}

Quat<Number> parse_attitude(const std::string& argument, std::string_view text, std::vector<std::string>& notes) {
  const std::vector<Number> c = parse_list(argument, text, measure::ratio, 4);
  const Quat<Number> typed(c[0], c[1], c[2], c[3]);
  const Number square = typed.squaredNorm();
  const Number length = sqrt(square);
  const Number off = length - 1;
  if (!(abs(off) < Number("1e-3"))) {
    throw InvalidArgument(argument, std::string(text),
                          fmt::format("must be a unit quaternion w,x,y,z, its length within 0.001 of 1, not {}",
                                      seventeen_digits(length)));
  }
  if (!(abs(Number(square - 1)) < unit_tolerance<double>())) {
    notes.push_back(fmt::format("{} = {}: is made a unit quaternion; its length is 1 {} {}", argument, text,
                                off < 0 ? "-" : "+", six_digits(abs(off))));
  }
  return Quat<Number>(typed.coeffs() / length);
}

std::optional<int> whole_number(std::string_view text) {
  std::string_view rest = trimmed(text);
  const std::optional<Decimal> decimal = take_decimal(rest);
  return decimal && rest.empty() ? to_whole(*decimal) : std::nullopt;
}

int parse_whole(const std::string& argument, std::string_view text, int least, int most) {
  const std::optional<int> number = whole_number(text);
  if (!number || *number < least || most < *number) {
    throw InvalidArgument(argument, std::string(text),
                          fmt::format("must be a whole number from {} to {}", least, most));
  }
  return *number;
}

double to_double(const char* argument, const Number& value, std::string_view what, int order) {
  const Number size = abs(value);
  const Number least = to_number({.digits = "1", .exponent = -order});
  const Number most = to_number({.digits = "1", .exponent = order});
  require(
      value == 0 || (least <= size && size <= most), argument, value,
      fmt::format("must, in SI units, be 0 or from 1e-{0} to 1e{0} in magnitude: {1} computes in double", order, what));
  return value.convert_to<double>();
}

}  // namespace goishi::cli
