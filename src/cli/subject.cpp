#include "subject.hpp"

#include <fmt/format.h>

#include <goishi/error.hpp>
#include <goishi/shape/catalogue.hpp>

#include "catalogue.hpp"
#include "quantity.hpp"

namespace goishi::cli {

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

void check_catalogue(const StoneOptions& options, bool has_board) {
  require_with("color", options.color, "size", options.size);
  if (!has_board) {
    require_with("standard", options.standard, "size", options.size);
  }
}

Subject subject_of(const StoneOptions& options) {
  const Number bevel = options.bevel ? parse("bevel", *options.bevel, measure::length) : Number(0);
  if (!options.size) {
    return {.title = "The stone of the given width and height",
            .width = parse("width", *options.width, measure::length),
            .height = parse("height", *options.height, measure::length),
            .bevel = bevel,
            .measured = options.measured,
            .assumed_density = catalogue::assumed_white_density};
  }
  const StoneColor color = options.color ? parse_color(*options.color) : StoneColor::white;
  const Standard standard = parse_standard(options.standard);
  const CatalogueStone entry = catalogue_stone(whole_number(*options.size).value_or(0), color, standard);  // 0 is none
  return {
      .title = fmt::format("The {} stone of size {}{}", to_string(color), entry.number, named_unless_talk(standard)),
      .width = metres<Number>(entry.width),
      .height = metres<Number>(entry.height),
      .bevel = bevel,
      .measured = options.measured,
      .assumed_density = entry.density};
}

Stone<Number> stone_of(const Subject& subject) {
  return subject.measured ? make_measured_stone(subject.width, subject.height, subject.bevel)
                          : make_stone(subject.width, subject.height, subject.bevel);
}

MassProperties<Number> properties_of(const Stone<Number>& stone, const StoneOptions& options, int assumed_density) {
  if (options.mass) {
    return mass_properties(stone, Mass{parse("mass", *options.mass, measure::mass)});
  }
  const Number density =
      options.density ? parse("density", *options.density, measure::density) : Number(assumed_density);
  return mass_properties(stone, Density{density});
}

std::string described(const Subject& subject) {
  return subject.title + (subject.bevel == 0 ? ", sharp" : fmt::format(", bevel {} m", six_digits(subject.bevel)));
}

const char* explanation(const Subject& subject) {
  if (subject.bevel == 0) {
    return "Sharp: no bevel.";
  }
  return subject.measured ? "Measured: the finished stone has the width given; `width` is its lens's."
                          : "As published: the width given is the lens's, and the bevel shrinks the stone.";
}

}  // namespace goishi::cli
