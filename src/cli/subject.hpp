#pragma once
/// \file
/// The stone that the options of a command ask for.

#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <optional>
#include <string>

#include "number.hpp"

namespace goishi::cli {

/// As typed; what is not there was not given.
struct StoneOptions {
  std::optional<std::string> size;
  std::optional<std::string> color;
  std::optional<std::string> standard;
  std::optional<std::string> width;
  std::optional<std::string> height;
  std::optional<std::string> bevel;
  std::optional<std::string> mass;
  std::optional<std::string> density;
  bool measured = false;
};

/// The stone, before it is made.
struct Subject {
  std::string title;  // "The white stone of size 33", "The black stone of size 33, nihon-kiin"
  Number width;       // of the generating lens, or, if `measured`, of the finished stone
  Number height;
  Number bevel;
  bool measured;
  int assumed_density;
};

/// InvalidArgument when both options were given.
void refuse_together(const char* argument, const std::optional<std::string>& value, const char* other,
                     const std::optional<std::string>& other_value);

/// InvalidArgument when the first option was given without the other.
void require_with(const char* argument, const std::optional<std::string>& value, const char* other,
                  const std::optional<std::string>& other_value);

/// InvalidArgument when the options contradict each other.
void check_stone(const StoneOptions& options);

/// InvalidArgument when --color or --standard was given, and neither --size nor, for the standard, a board needs it.
void check_catalogue(const StoneOptions& options, bool has_board = false);

/// Domain  --size, or --width and --height, were given.
[[nodiscard]] Subject subject_of(const StoneOptions& options);

[[nodiscard]] Stone<Number> stone_of(const Subject& subject);

/// By the mass or the density given, else by the assumed density.
[[nodiscard]] MassProperties<Number> properties_of(const Stone<Number>& stone, const StoneOptions& options,
                                                   int assumed_density);

/// Whether no mass and no density was given.
[[nodiscard]] inline bool assumes_density(const StoneOptions& options) {
  return !options.mass && !options.density;
}

/// "The white stone of size 33, bevel 0.001 m"
[[nodiscard]] std::string described(const Subject& subject);

/// What the width given is the width of.
[[nodiscard]] const char* explanation(const Subject& subject);

}  // namespace goishi::cli
