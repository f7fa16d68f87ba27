#pragma once
/// \file
/// What `goishi drop` drops, and onto what: in double, as the library computes it.

#include <goishi/board/board.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/shape/stone.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "drop.hpp"

namespace goishi::cli {

/// A stone in double, as the library drops it, and what it weighs.
struct SolidStone {
  std::string title;  // "The white stone of size 33, sharp"
  bool density_assumed = false;
  Stone<double> stone;
  RigidBody<double> body;
};

/// InvalidArgument for whatever was typed wrong.
/// Domain  --size, or --width and --height, were given.
[[nodiscard]] SolidStone solid_stone(const StoneOptions& options);

/// How a stone is dropped; all but when it ends.
[[nodiscard]] DropSettings<double> drop_settings(const DropOptions& options);

/// The attitude of a stone that lies flat turned by degrees about an axis.
/// Domain  an axis that is not zero.
[[nodiscard]] Quat<double> turned(const Number& degrees, const Vec3<Number>& axis);

struct DropScene {
  SolidStone solid;
  std::optional<Board<double>> board;  // none: the plane z = 0
  std::string ground;                  // "board", "floor board, nihon-kiin", "plane z = 0"
  State<double> start;
  DropSettings<double> settings;
  std::string until;  // what the drop is followed to, for people
};

/// A given number other than 0 has a magnitude from 1e-20 to 1e20 in SI units (`to_double`).
inline constexpr int drop_order = 20;

/// The time that a drop to rest is followed, at most   [s].
inline constexpr double longest_drop = 60;

/// The law as it is typed.
[[nodiscard]] std::string name_of(ImpactLaw law);

/// InvalidArgument for whatever was typed wrong.
[[nodiscard]] DropScene scene_of(const DropOptions& options);

}  // namespace goishi::cli
