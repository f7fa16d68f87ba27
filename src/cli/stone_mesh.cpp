#include "stone_mesh.hpp"

#include <fmt/format.h>

#include <goishi/error.hpp>
#include <goishi/mesh/deviation.hpp>
#include <stdexcept>

#include "catalogue.hpp"
#include "formats/cache_order.hpp"
#include "quantity.hpp"

namespace goishi::cli {

namespace {

Tessellation parse_tessellation(const std::optional<std::string>& text) {
  for (const Tessellation method : {Tessellation::subdivision, Tessellation::rings}) {
    if (!text || *text == to_string(method)) {
      return method;
    }
  }
  throw InvalidArgument("method", *text, "must be subdivision or rings");
}

double in_mesh(const char* argument, const Number& value) {
  return to_double(argument, value, "a mesh", mesh_order);
}

}  // namespace

void check_one_stone(const StoneOptions& options) {
  check_stone(options);
  if (!options.size && !options.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  check_catalogue(options, false);
}

StoneMesh mesh_of(const Subject& subject, const MeshChoice& choice, int default_level) {
  refuse_together("tolerance", choice.tolerance, "level", choice.level);
  static_cast<void>(in_mesh("width", subject.width));
  static_cast<void>(in_mesh("height", subject.height));
  static_cast<void>(in_mesh("bevel", subject.bevel));
  StoneMesh result{.stone = stone_cast<double>(stone_of(subject)),
                   .method = parse_tessellation(choice.method),
                   .fineness = {},
                   .mesh = {}};
  if (choice.tolerance) {
    const Number tolerance = parse("tolerance", *choice.tolerance, measure::length);
    require_positive("tolerance", tolerance);
    result.fineness = fineness_for(result.stone, result.method, in_mesh("tolerance", tolerance));
  } else {
    const int level = choice.level ? parse_whole("level", *choice.level, 0, finest_level) : default_level;
    result.fineness = fineness_of_level(result.stone, level);
  }
  result.mesh = tessellate(result.stone, result.method, result.fineness);
  if (choice.cache_order) {
    result.mesh = in_cache_order(result.mesh);
  }
  return result;
}

std::string mesh_comment(const Subject& subject, std::string_view unit) {
  return fmt::format("goishi: lengths in {}. {}", unit, described(subject));
}

Color color_of(const StoneOptions& options) {
  const bool black = options.color && parse_color(*options.color) == StoneColor::black;
  return black ? Color{0.04, 0.04, 0.045} : Color{0.92, 0.9, 0.84};
}

}  // namespace goishi::cli
