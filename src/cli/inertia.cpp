#include "inertia.hpp"

#include <fmt/format.h>

#include <goishi/error.hpp>
#include <stdexcept>
#include <vector>

#include "alignment.hpp"
#include "file.hpp"
#include "json.hpp"
#include "number.hpp"
#include "properties.hpp"

namespace goishi::cli {

namespace {

void check_combination(const InertiaOptions& options) {
  const StoneOptions& stone = options.stone;
  check_stone(stone);
  if (!stone.size && !stone.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  check_catalogue(stone);
  if (options.format != "text" && options.format != "json") {
    throw InvalidArgument("format", options.format, "must be text or json");
  }
}

std::string to_json(const Values& values) {
  rapidjson::StringBuffer buffer;
  JsonWriter writer(buffer);
  writer.SetIndent(' ', 2);
  writer.StartObject();
  for (std::size_t i = 0; i < values.size(); ++i) {
    write_key(writer, quantities[i].key);
    write_number(writer, values[i]);
  }
  writer.EndObject();
  return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

std::string to_block(const Subject& subject, const Values& values, bool assumed) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Quantity& quantity = quantities[i];
    const Unit si = unit_of(quantity.dimension, UnitSystem::si);
    const Unit handy = unit_of(quantity.dimension, UnitSystem::handy);
    const bool note = assumed && quantity.dimension == Dimension::density;
    lines.push_back({std::string(quantity.name), std::string(quantity.symbol), six_digits(values[i]),
                     std::string(si.name), six_digits(in_unit(values[i], handy)), std::string(handy.name),
                     note ? "(assumed)" : ""});
  }
  align(lines, {Align::left, Align::left, Align::number, Align::left, Align::number, Align::left, Align::left});
  std::string text =
      fmt::format("{}\n{}\nMoments are about the centre of mass.\n\n", subject.title, explanation(subject));
  for (const Line& line : lines) {
    text += as_row(line);
  }
  return text;
}

}  // namespace

int run_inertia(const InertiaOptions& options) {
  check_combination(options);
  const Subject subject = subject_of(options.stone);
  const Stone<Number> stone = stone_of(subject);
  const Values values = values_of(stone, properties_of(stone, options.stone, subject.assumed_density));
  write_standard_output(options.format == "json" ? to_json(values)
                                                 : to_block(subject, values, assumes_density(options.stone)));
  return 0;
}

}  // namespace goishi::cli
