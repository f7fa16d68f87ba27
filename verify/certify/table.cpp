#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

#include "verify/certify/certify.hpp"
#include "verify/certify/printed.hpp"
#include "verify/certify/sentences.hpp"
#include "verify/certify/table_text.hpp"
#include "verify/certify/witness.hpp"

namespace goishi::verify::certify {

namespace {

/// A number with fewer digits must be the exact value.
constexpr int table_digits = 6;

/// How many powers of ten a number grows by when its SI unit becomes this one. SI itself, and grams and centimetres.
int power_of(const std::string& unit) {
  constexpr std::array<std::pair<std::string_view, int>, 20> powers = {
      {{"m", 0},      {"m²", 0},    {"m³", 0},    {"kg", 0},  {"kg/m³", 0},  {"kg m²", 0}, {"m2", 0},
       {"m3", 0},     {"kg_m3", 0}, {"kg_m2", 0}, {"cm", 2},  {"cm²", 4},    {"cm³", 6},   {"g", 3},
       {"g/cm³", -3}, {"g cm²", 7}, {"cm2", 4},   {"cm3", 6}, {"g_cm3", -3}, {"g_cm2", 7}}};
  const auto* const found = std::ranges::find(powers, unit, &std::pair<std::string_view, int>::first);
  if (found == powers.end()) {
    throw std::runtime_error(fmt::format("has a column in an unknown unit, [{}]", unit));
  }
  return found->second;
}

Ball in_unit(const Ball& exact, const std::string& unit) {
  return exact * Ball::from_decimal(fmt::format("1e{}", power_of(unit)));
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

RowKey key_of_row(const TableText& table, const std::vector<std::string>& row) {
  const std::size_t bevel = index_of(table, "bevel");
  const double metres = std::atof(row[bevel].c_str()) / std::pow(10.0, power_of(table.columns[bevel].unit));
  return {.number = std::atoi(row[index_of(table, "number")].c_str()),
          .color = row[index_of(table, "color")] == "white" ? StoneColor::white : StoneColor::black,
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

void judge_row(const TableText& table, const std::vector<std::string>& row, const RowKey& key, Outcome& outcome) {
  const StoneWitness witness = witness_of(catalogue_stone(key.number, key.color), key.bevel);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto& [name, unit, printed] = table.columns[i];
    if (!printed || name == "number" || name == "color") {
      continue;
    }
    const auto* const quantity = std::ranges::find(witness, name, &Quantity::key);
    if (quantity == witness.end()) {
      throw std::runtime_error(fmt::format("has a column of an unknown quantity, {}", name));
    }
    const Ball exact = in_unit(quantity->exact, unit);
    if (is_proved(table, row[i], exact)) {
      ++outcome.certified;
    } else {
      outcome.faults.push_back(fmt::format("{} of size {} {}, b = {} µm: {} is printed, {:.17g} is right", name,
                                           key.number, to_string(key.color), key.bevel, row[i],
                                           static_cast<double>(exact)));
    }
  }
}

Outcome judge_table(const TableText& table) {
  Outcome outcome;
  std::map<RowKey, int> rows;
  std::map<std::pair<StoneColor, int>, int> groups;
  for (const std::vector<std::string>& row : table.rows) {
    const RowKey key = key_of_row(table, row);
    judge_row(table, row, key, outcome);
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

Outcome certify_table(std::string_view text) {
  return judge_table(read_table(text));
}

Outcome certify_document(std::string_view text) {
  Outcome outcome = judge_table(read_marked_table(text));
  judge_sentences(text, exact_results(), outcome);
  return outcome;
}

}  // namespace goishi::verify::certify
