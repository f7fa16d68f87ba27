#pragma once
/// \file
/// The drop that `goishi drop` prints, and what it is at any time between its events.

#include <vector>

#include "compiled/drop.hpp"
#include "drop_scene.hpp"
#include "sample.hpp"

namespace goishi::cli {

[[nodiscard]] Sample sample_of(const DropScene& scene, double time, const State<double>& state);

/// The drop, about to begin.
[[nodiscard]] Drop<double> drop_of(const DropScene& scene);

/// What an event's contact is with.
enum class Touched { nothing, board, plane, floor };

[[nodiscard]] std::string_view to_string(Touched touched);

[[nodiscard]] Touched touched_at(const DropScene& scene, const Event<double>& event);

[[nodiscard]] Touched touched_last(const DropScene& scene, const DropResult<double>& drop);

/// The drop once more, with its state at times that rise. No motion is kept: it goes from one to the next, which changes
/// no bit of it.
[[nodiscard]] std::vector<Sample> samples_of(const DropScene& scene, const std::vector<double>& times);

/// At so many times, equally spaced from the start to the end.
[[nodiscard]] std::vector<Sample> series_of(const DropScene& scene, double end, int rows);

}  // namespace goishi::cli
