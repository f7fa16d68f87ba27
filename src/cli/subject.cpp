#include "subject.hpp"

#include <fmt/format.h>

#include <charconv>
#include <goishi/error.hpp>
#include <goishi/shape/catalogue.hpp>

#include "colors.hpp"
#include "quantity.hpp"

namespace goishi::cli {

namespace {

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

}  // namespace

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

void check_stone(const StoneOptions& options) {
  refuse_together("width", options.width, "size", options.size);
  refuse_together("height", options.height, "size", options.size);
  refuse_together("density", options.density, "mass", options.mass);
  require_with("width", options.width, "height", options.height);
  require_with("height", options.height, "width", options.width);
}

Subject subject_of(const StoneOptions& options) {
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

MassProperties<Number> properties_of(const Stone<Number>& stone, const StoneOptions& options, int assumed_density) {
  if (options.mass) {
    return mass_properties(stone, Mass{parse_mass("mass", *options.mass)});
  }
  const Number density = options.density ? parse_density("density", *options.density) : Number(assumed_density);
  return mass_properties(stone, Density{density});
}

const char* explanation(const Subject& subject) {
  if (subject.bevel == 0) {
    return "Sharp: no bevel.";
  }
  return subject.measured ? "Measured: the finished stone has the width given; `width` is its lens's."
                          : "As published: the width given is the lens's, and the bevel shrinks the stone.";
}

}  // namespace goishi::cli
