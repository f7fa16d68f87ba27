#include "quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/error.hpp>
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

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  return text.substr(0, text.find_last_not_of(blank) + 1);
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
    throw broken(fmt::format("must be 0 or from 1e-{0} to 1e{0} {1}", largest_order, units.front().name));
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

}  // namespace goishi::cli
