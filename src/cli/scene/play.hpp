#pragma once
/// \file
/// A scene's file played: its stones, and its actions when their times come.

#include <vector>

#include "compiled/scene.hpp"
#include "scene/scene_file.hpp"

namespace goishi::cli {

[[nodiscard]] constexpr std::size_t index_of(StoneId id) {
  return static_cast<std::size_t>(id);
}

/// Throws what `in_file` throws, for stones that overlap, ids that nobody has, hands that move a stone into the board.
class ScenePlay {
 public:
  /// `file` must live as long.
  explicit ScenePlay(const SceneFile& file);

  /// Up to a time, what is done at that time included.
  void advance_to(double time, SceneSink<double> sink = {});

  /// To the end of the file. Whether all stones rest then.
  bool advance_to_end(SceneSink<double> sink = {});

  [[nodiscard]] const Scene<double>& scene() const { return scene_; }

  /// Of any stone, also one that was removed.
  [[nodiscard]] const SolidStone& solid(StoneId id) const { return file_->solids[solids_[index_of(id)]]; }

  /// How many stones there were in all.
  [[nodiscard]] std::size_t count() const { return solids_.size(); }

  /// How many stones move, by themselves or in a hand.
  [[nodiscard]] long long moving() const;

  /// What hands have done to other stones   [J].
  [[nodiscard]] double hand_work() const;

 private:
  /// Until it says that it is there: the work of one call is bounded.
  template <class Go>
  void in_calls(double time, Go&& go);
  void go_to(double time, SceneSink<double> sink);
  void add(const StoneEntry& entry);
  void apply(const SceneAction& action, SceneSink<double> sink);

  const SceneFile* file_;
  Scene<double> scene_;
  std::vector<std::size_t> solids_;  // of each id
  std::size_t done_ = 0;             // actions
  double removed_work_ = 0;          // [J] of hands on stones that are no more
};

/// Rows of CSV for each stone, at so many times from the start to `end`, which is `scene().time()` of a play that came to its
/// end. The scene is played once more.
[[nodiscard]] std::string series_of(const SceneFile& file, double end, int times);

/// A series has no more rows.
inline constexpr long long most_scene_rows = 1'000'000;

}  // namespace goishi::cli
