#pragma once
/// \file
/// What a scene tells: which stone, what happened to it, what it touches, and what was computed.

#include <goishi/drop/events.hpp>
#include <optional>

namespace goishi {

/// A stone of a scene, from when it is added on; no other ever gets the same.
enum class StoneId : std::size_t {};

/// How a stone goes on.
enum class StoneMode {
  flight,   // closed form, up to the next touch
  contact,  // alone on the board: the contact phase of a drop
  cluster,  // touches other stones: by steps
  rest,     // held by statics: no work
  held      // by a hand
};

[[nodiscard]] constexpr std::string_view to_string(StoneMode mode) {
  constexpr std::string_view names[] = {"flight", "contact", "cluster", "rest", "held"};
  return names[static_cast<std::size_t>(mode)];
}

/// An event of one stone. An impact of two stones is told of each.
template <class T>
struct SceneEvent {
  StoneId stone = {};
  std::optional<StoneId> other;  // the stone that did it, if one did
  Event<T> event;
};

template <class T>
using SceneSink = Sink<SceneEvent<T>>;

/// What touches, and how it pushes.
template <class T>
struct SceneContact {
  StoneId stone = {};
  std::optional<StoneId> other;  // or the board
  Vec3<T> p_WC = Vec3<T>::Constant(scalar::unset<T>());
  Vec3<T> n_W = Vec3<T>::Constant(scalar::unset<T>());      // unit, out of the other towards the stone
  Vec3<T> force_W = Vec3<T>::Constant(scalar::unset<T>());  // [N] on the stone, the mean of its present stretch or step
};

/// What was computed, so that it can be seen what was not.
struct SceneCounters {
  long long stretches = 0;    // of stones alone
  long long looks = 0;        // at two stones that may touch
  long long separations = 0;  // of two stones
  long long pair_impacts = 0;
  long long joins = 0;        // of a stone or a cluster to a cluster
  long long steps = 0;        // of clusters
  long long stone_steps = 0;  // their stones
  long long cut_steps = 0;    // that something ended early
  long long retries = 0;      // steps taken again, most of them shorter
  long long solves = 0;
  long long sweeps = 0;
  long long updates = 0;   // of a contact in a sweep
  long long unsolved = 0;  // ended by their number of sweeps
  long long rest_trials = 0;
};

}  // namespace goishi
