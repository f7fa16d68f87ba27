#pragma once
/// \file
/// What a scene's file holds: the board, the stones, what is done to them and when, and the end.

#include <goishi/error.hpp>
#include <goishi/scene/events.hpp>
#include <goishi/scene/settings.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drop_scene.hpp"

namespace goishi::cli {

/// A stone that is added.
struct StoneEntry {
  std::string path;       // in the file: "/stones/0"
  std::size_t solid = 0;  // of `SceneFile::solids`
  State<double> start;
};

struct ImpulseAction {
  StoneId id = {};
  Vec3<double> impulse_W, offset_W;  // [N s], [m] from the centre of mass
};

struct HoldAction {
  StoneId id = {};
  Vec3<double> v_WB, w_WB;
  double duration = 0;  // [s]
};

struct ReleaseAction {
  StoneId id = {};
};

struct GravityAction {
  Vec3<double> gravity;
};

struct AddAction {
  StoneEntry entry;
};

struct RemoveAction {
  StoneId id = {};
};

struct SceneAction {
  double time = 0;   // [s]
  std::string path;  // "/actions/0/impulse"
  std::variant<ImpulseAction, HoldAction, ReleaseAction, GravityAction, AddAction, RemoveAction> what;
};

struct SceneFile {
  std::string name;    // of the file
  std::string title;   // what it says, or its name
  std::string ground;  // "board, nihon-kiin"
  Board<double> board;
  SceneSettings<double> settings;
  std::vector<SolidStone> solids;
  std::vector<StoneEntry> stones;
  std::vector<SceneAction> actions;  // in the order of their times
  bool to_rest = true;
  double end = 0;  // [s] when it ends, or to when it must rest
  std::vector<std::string> notes;
};

/// The text of scene.schema.json.
[[nodiscard]] std::string_view scene_schema();

/// Throws what `read_json` does, and for what breaks a rule of the library the same, with the place in the file.
[[nodiscard]] SceneFile read_scene(const std::string& file, std::string_view text);

/// The error of an argument in the file's words: the file, the place, the value and the rule.
[[nodiscard]] std::runtime_error told_in_file(std::string_view file, std::string_view path,
                                              const InvalidArgument& error);

/// What a function returns; its `InvalidArgument` as `told_in_file`.
template <class F>
auto in_file(std::string_view file, std::string_view path, const F& call) -> decltype(call()) {
  try {
    return call();
  } catch (const InvalidArgument& error) {
    throw told_in_file(file, path, error);
  }
}

}  // namespace goishi::cli
