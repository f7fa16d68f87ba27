#include "inertia.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <vector>

#include "alignment.hpp"
#include "colors.hpp"
#include "file.hpp"
#include "json.hpp"
#include "number.hpp"
#include "properties.hpp"
#include "quantity.hpp"

namespace goishi::cli {

namespace {

/// The stone that was asked for.
struct Subject {
  std::string title;
  Number width;  // of the generating lens, or, if `measured`, of the finished stone
  Number height;
  Number bevel;
  bool measured;
  int assumed_density;
};

void refuse_together(const char* argument, const std::optional<std::string>& value, const char* other,
                     const std::optional<std::string>& other_value) {
  if (value && other_value) {
    throw InvalidArgument(argument, *value, fmt::format("must not be given with --{} ({})", other, *other_value));
  }
}

void require_with(const char* argument, const std::optional<std::string>& value, const char* other,
                  const std::optional<std::string>& other_value) {
  if (value && !other_value) {
    throw InvalidArgument(argument, *value, fmt::format("needs --{} too", other));
  }
}

void check_combination(const InertiaOptions& options) {
  refuse_together("width", options.width, "size", options.size);
  refuse_together("height", options.height, "size", options.size);
  refuse_together("density", options.density, "mass", options.mass);
  require_with("width", options.width, "height", options.height);
  require_with("height", options.height, "width", options.width);
  if (!options.size && !options.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  require_with("color", options.color, "size", options.size);
  if (options.format != "text" && options.format != "json") {
    throw InvalidArgument("format", options.format, "must be text or json");
  }
}

CatalogueStone parse_size(const std::string& text, StoneColor color) {
  int number = -1;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  try {
    return catalogue_stone(result.ptr == end ? number : -1, color);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(error.argument(), text, error.rule());
  }
}

Subject subject_of(const InertiaOptions& options) {
  const Number bevel = options.bevel ? parse_length("bevel", *options.bevel) : Number(0);
  if (!options.size) {
    return {.title = "The stone of the given width and height",
            .width = parse_length("width", *options.width),
            .height = parse_length("height", *options.height),
            .bevel = bevel,
            .measured = options.measured,
            .assumed_density = catalogue::assumed_white_density};
  }
  const StoneColor color = options.color ? parse_color(*options.color) : StoneColor::white;
  const CatalogueStone entry = parse_size(*options.size, color);
  return {.title = fmt::format("The {} stone of size {}", to_string(color), entry.number),
          .width = metres<Number>(entry.width),
          .height = metres<Number>(entry.height),
          .bevel = bevel,
          .measured = options.measured,
          .assumed_density = entry.density};
}

Stone<Number> stone_of(const Subject& subject) {
  if (!subject.measured) {
    return make_stone(subject.width, subject.height, subject.bevel);
  }
  try {
    return make_measured_stone(subject.width, subject.height, subject.bevel);
  } catch (const InvalidArgument& error) {
    // The user knows it as --width.
    const bool outer = error.argument() == "outer_width";
    throw InvalidArgument(outer ? "width" : error.argument(), error.value(), error.rule());
  }
}

MassProperties<Number> properties_of(const Stone<Number>& stone, const InertiaOptions& options, int assumed_density) {
  if (options.mass) {
    return mass_properties(stone, Mass{parse_mass("mass", *options.mass)});
  }
  const Number density = options.density ? parse_density("density", *options.density) : Number(assumed_density);
  return mass_properties(stone, Density{density});
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

const char* explanation(const Subject& subject) {
  if (subject.bevel == 0) {
    return "Sharp: no bevel.";
  }
  return subject.measured ? "Measured: the finished stone has the width given; `width` is its lens's."
                          : "As published: the width given is the lens's, and the bevel shrinks the stone.";
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

void run_inertia(const InertiaOptions& options) {
  check_combination(options);
  const Subject subject = subject_of(options);
  const Stone<Number> stone = stone_of(subject);
  const Values values = values_of(stone, properties_of(stone, options, subject.assumed_density));
  const bool assumed = !options.mass && !options.density;
  write_standard_output(options.format == "json" ? to_json(values) : to_block(subject, values, assumed));
}

}  // namespace goishi::cli
