#include "verify/certify/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

#include "verify/certify/printed.hpp"
#include "verify/certify/sentences.hpp"
#include "verify/certify/table_text.hpp"
#include "verify/certify/witness.hpp"

namespace goishi::verify::certify {

namespace {

/// A number with fewer digits must be the exact value.
constexpr int table_digits = 6;

enum class Kind { length, area, volume, mass, density, moment };

struct Unit {
  std::string_view name;
  Kind kind;
  int power;  // of ten, by which a number grows when its SI unit becomes this one
};

/// SI itself, millimetres, and grams and centimetres.
constexpr std::array<Unit, 21> units = {
    {{"m", Kind::length, 0},       {"mm", Kind::length, 3},      {"cm", Kind::length, 2},
     {"m²", Kind::area, 0},        {"m2", Kind::area, 0},        {"cm²", Kind::area, 4},
     {"cm2", Kind::area, 4},       {"m³", Kind::volume, 0},      {"m3", Kind::volume, 0},
     {"cm³", Kind::volume, 6},     {"cm3", Kind::volume, 6},     {"kg", Kind::mass, 0},
     {"g", Kind::mass, 3},         {"kg/m³", Kind::density, 0},  {"kg_m3", Kind::density, 0},
     {"g/cm³", Kind::density, -3}, {"g_cm3", Kind::density, -3}, {"kg m²", Kind::moment, 0},
     {"kg_m2", Kind::moment, 0},   {"g cm²", Kind::moment, 7},   {"g_cm2", Kind::moment, 7}}};

/// A moment per mass is an area.
constexpr std::array<std::pair<std::string_view, Kind>, 12> quantities = {{{"bevel", Kind::length},
                                                                           {"width", Kind::length},
                                                                           {"height", Kind::length},
                                                                           {"outer_width", Kind::length},
                                                                           {"volume", Kind::volume},
                                                                           {"surface_area", Kind::area},
                                                                           {"density", Kind::density},
                                                                           {"mass", Kind::mass},
                                                                           {"axial", Kind::moment},
                                                                           {"transverse", Kind::moment},
                                                                           {"axial_per_mass", Kind::area},
                                                                           {"transverse_per_mass", Kind::area}}};

/// The power of a column's unit, which must be one of its quantity.
int power_of(const Column& column) {
  const auto* const quantity = std::ranges::find(quantities, column.key, &std::pair<std::string_view, Kind>::first);
  if (quantity == quantities.end()) {
    throw std::runtime_error(fmt::format("has a column of an unknown quantity, {}", column.key));
  }
  const auto* const unit = std::ranges::find(units, column.unit, &Unit::name);
  if (unit == units.end() || unit->kind != quantity->second) {
    throw std::runtime_error(fmt::format("has a column for the {} in a wrong unit, [{}]", column.key, column.unit));
  }
  return unit->power;
}

Ball in_unit(const Ball& exact, const Column& column) {
  return exact * Ball::from_decimal(fmt::format("1e{}", power_of(column)));
}

std::size_t index_of(const TableText& table, std::string_view key) {
  const auto found = std::ranges::find(table.columns, key, &Column::key);
  if (found == table.columns.end()) {
    throw std::runtime_error(fmt::format("has no column for the {}", key));
  }
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// Which stone a row is about.
struct RowKey {
  int number;
  StoneColor color;
  int bevel;  // [µm]
  auto operator<=>(const RowKey&) const = default;
};

/// The whole text is the number.
template <class Number>
Number number_from(std::string_view text, std::string_view what) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error(fmt::format("has a row with the {} \"{}\"", what, text));
  }
  return value;
}

StoneColor color_from(std::string_view text) {
  for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
    if (text == to_string(color)) {
      return color;
    }
  }
  throw std::runtime_error(fmt::format("has a row with the color \"{}\"", text));
}

RowKey key_of_row(const TableText& table, const std::vector<std::string>& row) {
  const std::size_t bevel = index_of(table, "bevel");
  const double metres = number_from<double>(row[bevel], "bevel") / std::pow(10.0, power_of(table.columns[bevel]));
  if (!(0.0 <= metres && metres < 1.0)) {
    throw std::runtime_error(fmt::format("has a row with the bevel \"{}\"", row[bevel]));
  }
  return {.number = number_from<int>(row[index_of(table, "number")], "size"),
          .color = color_from(row[index_of(table, "color")]),
          .bevel = static_cast<int>(std::lround(1e6 * metres))};
}

bool is_proved(const TableText& table, const std::string& text, const Ball& exact) {
  const std::optional<Printed> printed = read_printed(text);
  if (!printed) {
    return false;
  }
  if (table.doubles) {
    const double value = std::atof(text.c_str());
    return fmt::format("{}", value) == text && is_the_nearest(value, exact);
  }
  return is_certified(*printed, exact, table_digits);
}

void judge_row(const TableText& table, const std::vector<std::string>& row, const RowKey& key, Standard standard,
               Outcome& outcome) {
  const StoneWitness witness = witness_of(catalogue_stone(key.number, key.color, standard), key.bevel);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    const std::string& name = column.key;
    if (!column.printed || name == "number" || name == "color") {
      continue;
    }
    const Ball exact = in_unit(std::ranges::find(witness, name, &Quantity::key)->exact, column);
    if (is_proved(table, row[i], exact)) {
      ++outcome.certified;
    } else {
      outcome.faults.push_back(fmt::format("{} of size {} {}, b = {} µm: {} is printed, {:.17g} is right", name,
                                           key.number, to_string(key.color), key.bevel, row[i],
                                           static_cast<double>(exact)));
    }
  }
}

/// Each colour and bevel that occurs must have all sizes; in a whole table all four of them must occur.
Outcome judge_table(const TableText& table, bool whole, Standard standard) {
  Outcome outcome;
  std::map<RowKey, int> rows;
  std::map<std::pair<StoneColor, int>, int> groups;
  if (whole) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      groups[{color, 0}] = groups[{color, catalogue::table_bevel}] = 0;
    }
  }
  for (const std::vector<std::string>& row : table.rows) {
    const RowKey key = key_of_row(table, row);
    judge_row(table, row, key, standard, outcome);
    if (++rows[key] > 1) {
      outcome.faults.push_back(
          fmt::format("size {} {}, b = {} µm stands twice", key.number, to_string(key.color), key.bevel));
    }
    ++groups[{key.color, key.bevel}];
  }
  for (const auto& [group, count] : groups) {
    if (count != static_cast<int>(catalogue::sizes.size())) {
      outcome.faults.push_back(fmt::format("{} of the {} sizes are there, {}, b = {} µm", count,
                                           catalogue::sizes.size(), to_string(group.first), group.second));
    }
  }
  return outcome;
}

}  // namespace

Outcome certify_table(std::string_view text, bool whole, Standard standard) {
  return judge_table(read_table(text), whole, standard);
}

Outcome certify_document(std::string_view text, const std::filesystem::path& file) {
  const std::string_view document = document_of(file);
  Outcome outcome;
  if (document == documents.back()) {
    outcome = judge_table(read_marked_table(text), false, Standard::talk);
  }
  judge_sentences(text, exact_results(document), outcome);
  return outcome;
}

}  // namespace goishi::verify::certify
