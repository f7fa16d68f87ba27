#pragma once
/// \file
/// What of a scene can be chosen: once, with its unit and its reason.

#include <goishi/drop/settings.hpp>
#include <optional>

namespace goishi {

/// What is not set is a multiple of w, √(w g) and √(w/g), w the width of the first stone that is added; beside it stands its
/// value for a stone 22 mm wide.
template <class T>
struct SceneSettings {
  DropSettings<T> drop;  // a stone on the board: e, μ, gravity, resistance, tolerance …

  // --- Stone on stone. The resistance is that on the board, the mean of both
  T restitution = T(0.5);
  T friction = T(0.3);

  // --- Stones that touch several things: clusters, which go by steps
  /// [s] Error is in proportion to it, cost to 1/it. 0.044 √(w/g): 1/480. With twice that, heaps of many stones that lean on
  /// each other jitter, and may not come to rest.
  std::optional<T> step;
  /// Of what gravity gives in a step: a sweep over a cluster's contacts that changes less is the last.
  T solver_tolerance = T(0.1);
  /// [m] Stones touch when they are so near. Where the rims of sharp stones overlap, their separation takes a search. w/44000:
  /// 5e-7
  std::optional<T> clearance;
  /// [m/s] A slower approach is no impact: the stones become a cluster. 0.011 √(w g): 5.1e-3
  std::optional<T> impact_speed;
  /// [s] after the last push of a stone on it, one leaves its cluster. 0.21 √(w/g): 1e-2
  std::optional<T> leaving_time;

  /// Things that are due, in one call: stretches, looks, impacts, steps. A full board dropped from 2 cm takes 1.6e5 till it rests.
  long long most_work = 10'000'000;
};

/// The settings with all that was not set filled in, for a stone.
template <Ordered T>
[[nodiscard]] SceneSettings<T> filled(const SceneSettings<T>& settings, const T& width) {
  SceneSettings<T> all = settings;
  const Vec3<T>& gravity = settings.drop.gravity;
  const T square = formula::dot(gravity, gravity);
  const T g = T(0) < square ? scalar::sqrt(square) : width;  // without any, in units of seconds
  const T speed = scalar::sqrt(T(width * g)), time = scalar::sqrt(T(width / g));
  const auto fill = [](std::optional<T>& setting, const T& value) { setting = setting ? *setting : value; };
  fill(all.step, T(T(0.044) * time));
  fill(all.clearance, T(width / T(44000)));
  fill(all.impact_speed, T(T(0.011) * speed));
  fill(all.leaving_time, T(T(0.21) * time));
  return all;
}

/// Throws InvalidArgument unless every setting is in its range.
template <Ordered T>
void require_settings(const SceneSettings<T>& settings) {
  require_settings(settings.drop);
  static_cast<void>(make_material(settings.restitution, settings.friction));
  const auto positive = [](const char* argument, const std::optional<T>& value) {
    require_positive(argument, value.value_or(T(1)));
  };
  positive("step", settings.step);
  positive("clearance", settings.clearance);
  positive("impact_speed", settings.impact_speed);
  positive("leaving_time", settings.leaving_time);
  require(0 < settings.most_work, "most_work", settings.most_work, "must be positive");
  require(T(0) < settings.solver_tolerance && settings.solver_tolerance <= T(1), "solver_tolerance",
          settings.solver_tolerance, "must be positive and at most 1");
}

}  // namespace goishi
