#include "quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/error.hpp>
#include <optional>
#include <span>

namespace goishi::cli {

namespace {

/// A unit is 10^power SI units.
struct InputUnit {
  std::string_view name;
  int power;
};

// Both letters that look like µ: U+00B5 and U+03BC.
constexpr InputUnit lengths[] = {{"m", 0},        {"cm", -2},      {"mm", -3}, {"um", -6},
                                 {"\u00b5m", -6}, {"\u03bcm", -6}, {"nm", -9}, {"km", 3}};
constexpr InputUnit densities[] = {{"kg/m³", 0}, {"kg/m3", 0}, {"kg/m^3", 0},
                                   {"g/cm³", 3}, {"g/cm3", 3}, {"g/cm^3", 3}};
constexpr InputUnit masses[] = {{"kg", 0}, {"g", -3}, {"mg", -6}};
constexpr InputUnit times[] = {{"s", 0}, {"ms", -3}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  return text.substr(0, text.find_last_not_of(blank) + 1);
}

std::string range_rule(std::string_view unit) {
  return fmt::format("must be 0 or from 1e-{0} to 1e{0} {1}", largest_order, unit);
}

/// The whole text is a decimal, or nothing.
std::optional<Decimal> whole_decimal(std::string_view text) {
  std::string_view rest = trimmed(text);
  const std::optional<Decimal> decimal = take_decimal(rest);
  return rest.empty() ? decimal : std::nullopt;
}

Number parse(const std::string& argument, std::string_view text, std::span<const InputUnit> units,
             std::string_view names) {
  const auto broken = [&](const std::string& rule) { return InvalidArgument(argument, std::string(text), rule); };
  std::string_view rest = trimmed(text);
  auto decimal = take_decimal(rest);
  if (!decimal) {
    throw broken(fmt::format("must be a decimal number, bare ({}) or with a unit ({})", units.front().name, names));
  }
  rest = trimmed(rest);
  if (!rest.empty()) {
    const auto unit = std::ranges::find(units, rest, &InputUnit::name);
    if (unit == units.end()) {
      throw broken(fmt::format("must have one of the units {}, not '{}'", names, rest));
    }
    decimal->exponent += unit->power;
  }
  if (!in_range(*decimal)) {
    throw broken(range_rule(units.front().name));
  }
  return to_number(*decimal);
}

}  // namespace

Number parse_length(const std::string& argument, std::string_view text) {
  return parse(argument, text, lengths, length_units);
}

Number parse_density(const std::string& argument, std::string_view text) {
  return parse(argument, text, densities, density_units);
}

Number parse_mass(const std::string& argument, std::string_view text) {
  return parse(argument, text, masses, mass_units);
}

Number parse_time(const std::string& argument, std::string_view text) {
  return parse(argument, text, times, time_units);
}

Number parse_bare(const std::string& argument, std::string_view text, std::string_view unit) {
  const std::optional<Decimal> decimal = whole_decimal(text);
  if (!decimal) {
    throw InvalidArgument(argument, std::string(text), fmt::format("must be a decimal number, in {}", unit));
  }
  if (!in_range(*decimal)) {
    throw InvalidArgument(argument, std::string(text), range_rule(unit));
  }
  return to_number(*decimal);
}

std::vector<Number> parse_list(const std::string& argument, std::string_view text, std::size_t count) {
  std::vector<Number> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::optional<Decimal> decimal = whole_decimal(rest.substr(0, comma));
    if (!decimal || !in_range(*decimal)) {
      break;
    }
    numbers.push_back(to_number(*decimal));
    if (comma == rest.size()) {
      if (numbers.size() == count) {
        return numbers;
      }
      break;
    }
    rest.remove_prefix(comma + 1);
  }
  throw InvalidArgument(argument, std::string(text),
                        fmt::format("must be {} decimal numbers with commas between them", count));
}

Vec3<Number> parse_vector(const std::string& argument, std::string_view text) {
  const std::vector<Number> c = parse_list(argument, text, 3);
  return {c[0], c[1], c[2]};
}

Quat<Number> parse_attitude(const std::string& argument, std::string_view text) {
  const std::vector<Number> c = parse_list(argument, text, 4);
  const Quat<Number> typed(c[0], c[1], c[2], c[3]);
  const Number square = typed.squaredNorm();
  if (!(abs(Number(square - 1)) < unit_tolerance<double>())) {
    throw InvalidArgument(argument, std::string(text),
                          fmt::format("must be a unit quaternion w,x,y,z to 15 digits; the sum of its squares is {}",
                                      seventeen_digits(square)));
  }
  return Quat<Number>(typed.coeffs() / sqrt(square));
}

double to_double(const char* argument, const Number& value, std::string_view what) {
  const double result = value.convert_to<double>();
  require(std::isnormal(result) || value == 0, argument, value, "is beyond the range of a double, in which ", what,
          " computes");
  return result;
}

}  // namespace goishi::cli
