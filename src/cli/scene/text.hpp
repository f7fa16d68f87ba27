#pragma once
/// \file
/// A scene that was played as `goishi scene` prints it.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "json.hpp"
#include "scene/play.hpp"

namespace goishi::cli {

/// How a scene went, for people: what was in it, what was done, how it ended, and what it cost.
class SceneSummary {
 public:
  explicit SceneSummary(const ScenePlay& start) : energy_(start.scene().energy()) {}

  void tell(const SceneEvent<double>& event);

  [[nodiscard]] std::string text(const SceneFile& file, const ScenePlay& end, bool rests) const;

 private:
  double energy_;  // [J] at the start
  std::array<long long, 1 + static_cast<std::size_t>(EventKind::end)> kinds_{};
  long long of_pairs_ = 0;  // impacts, of two stones each
};

/// For programs: events while they happen, and the end.
class SceneJson {
 public:
  explicit SceneJson(const SceneFile& file);

  void tell(const ScenePlay& play, const SceneEvent<double>& event);

  /// The whole document.
  [[nodiscard]] std::string text(const ScenePlay& end, bool rests);

 private:
  const SceneFile& file_;
  JsonText json_;
};

/// "at rest after 1.5 s", "still moving after 1 s: 3 of 9 stones".
[[nodiscard]] std::string end_of(const ScenePlay& play, bool rests);

/// The counters of a scene, by the names that its JSON has.
[[nodiscard]] std::vector<std::pair<const char*, long long>> counts_of(const SceneCounters& counters);

}  // namespace goishi::cli
