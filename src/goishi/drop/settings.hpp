#pragma once
/// \file
/// Every number of a drop that can be chosen: once, with its unit and its reason.

#include <cstddef>
#include <goishi/error.hpp>
#include <goishi/impact/material.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/vector.hpp>
#include <limits>
#include <optional>
#include <string_view>

namespace goishi {

/// Friction of a contact that lasts. F is what it adds to the force on the stone, N the normal force, s the slip.
enum class FrictionModel {
  dry,                // Coulomb: F = −μ N s/|s|, and up to μ N without slip
  slip_proportional,  // F = −c N s: no sticking. The tippe-top's results hold for it
  coulomb_contensou   // F = −μ N s/√(s² + (8 a_c ω_z/3π)²): a contact patch of radius a_c that also turns
};

[[nodiscard]] constexpr std::string_view to_string(FrictionModel model) {
  constexpr std::string_view names[] = {"dry", "slip-proportional", "coulomb-contensou"};
  return names[static_cast<std::size_t>(model)];
}

/// What is not set here is a multiple of the stone's own scales, w, √(w g) and √(w/g), so that a stone of any size drops
/// as a large one or a small one does; beside it stands its value for a stone 22 mm wide.
/// Claim  DROP-25: in units of length, time and mass that differ by powers of two a drop is the same, bit for bit.
template <class T>
struct DropSettings {
  // --- The scene
  T restitution = T(0.5);            // e; stone on wood 0.4 … 0.7 (assumed range)
  T friction = T(0.3);               // μ; stone on wood 0.2 … 0.4 (assumed range); infinity is allowed
  Vec3<T> gravity = gravity_W<T>();  // [m/s²] in W; a slope is a gravity that leans
  /// δ [m] <= w/2: torque δ N against rolling; 1e-5 … 1e-4 on wood. w/220: 1e-4. Neither of δ and κ counts as less than a
  /// hundredth of the other: a patch that resists the one resists the other, and without that the torque would be a dry
  /// friction of one direction alone, which jumps wherever the turning there ceases.
  std::optional<T> rolling_resistance;
  std::optional<T> pivot_radius;  // κ [m] <= w/2: torque κ N against turning on the spot, (3π/16) μ a_c. w/440: 5e-5
  FrictionModel friction_model = FrictionModel::dry;
  std::optional<T> slip_coefficient;  // c [s/m] of slip_proportional. 1/(2 √(w g)): 1.08
  std::optional<T> patch_radius;      // a_c [m] <= w/2 of coulomb_contensou; 0: dry. w/220: 1e-4
  /// [m/s] of coulomb_contensou: a slip so slow meets friction in proportion, also where the patch does not turn. The law
  /// has no rest; steps get shorter in proportion to this. 2e-4 √(w g): 9.3e-5
  std::optional<T> creep_speed;
  T damping =
      T(0);  // [1/s] the talk's exponential damping of both momenta while in contact. It has no physical basis and
             // never stops: for comparison only
  ImpactLaw law = ImpactLaw::chatterjee_ruina;

  // --- When to stop
  std::optional<T> horizon;                               // [s] of simulated time. 1300 √(w/g): 61.6
  int maximum_impacts = std::numeric_limits<int>::max();  // stop after so many
  int maximum_events = 100000;                            // a run that makes more is given up, and says so
  int maximum_steps = 2000000;  // of everything that is repeated, `DropCounters::work`; likewise

  // --- How exactly
  /// Of a step of the contact phase, relative to the stone's own scales; where it ends up: claims DROP-19, DROP-29. 1e-4
  /// serves a game, 1e-6 most.
  T tolerance = scalar::max(T(1e-9), T(1000) * std::numeric_limits<T>::epsilon());
  /// [m/s] Approach below which bounces are closed by a plastic impulse. 2e-6 √(w g): 9.3e-7. Where a stone of size 33
  /// dropped from 5 cm comes to rest depends on it by 1.6e-9 m in the median; by 1.4e-6 m at 1e-3 m/s (100 drops against
  /// 1e-8 m/s, measured 2026-11-22).
  std::optional<T> contact_speed;
  /// [m/s] Leaving speed below which the bounces of a flat drop are summed, exactly. Higher is as right, and shows
  /// fewer. 0.02 √(w g): 9.3e-3
  std::optional<T> closing_speed;
  /// [m/s] Of the micro-impacts that stand for a contact that lasts on an edge, a side or at two places. Their error is in
  /// proportion to it (claim DROP-28), their number to 1/it. 2e-3 √(w g): 9.3e-4, hops of up to 2e-4 s and 5e-8 m
  std::optional<T> edge_speed;
  /// Of the width: a stone no deeper inside is taken as touching, a deeper one refused.
  T touching = scalar::max(T(1e-9), T(64) * std::numeric_limits<T>::epsilon());
};

/// The settings with all that was not set filled in, for a stone and the acceleration g that its scales are made with
/// [m/s²].
template <Ordered T>
[[nodiscard]] DropSettings<T> filled(const DropSettings<T>& settings, const Stone<T>& stone, const T& g) {
  const T& w = stone.width;
  const T speed = scalar::sqrt(T(w * g));
  DropSettings<T> all = settings;
  const auto fill = [](std::optional<T>& setting, const T& value) { setting = setting ? *setting : value; };
  fill(all.rolling_resistance, w / T(220));
  fill(all.pivot_radius, w / T(440));
  fill(all.slip_coefficient, T(1) / (T(2) * speed));
  fill(all.patch_radius, w / T(220));
  fill(all.creep_speed, T(2e-4) * speed);
  fill(all.horizon, T(1300) * scalar::sqrt(T(w / g)));
  fill(all.contact_speed, T(2e-6) * speed);
  fill(all.closing_speed, T(2e-2) * speed);
  fill(all.edge_speed, T(2e-3) * speed);
  return all;
}

/// The same in the settings' own gravity.
/// Domain  a gravity that is not zero.
template <Ordered T>
[[nodiscard]] DropSettings<T> filled(const DropSettings<T>& settings, const Stone<T>& stone) {
  return filled(settings, stone, T(scalar::sqrt(formula::dot(settings.gravity, settings.gravity))));
}

namespace detail {

/// What micro-impacts leave of a gap   [m], twice as high as they go: what is no further away counts as touched.
template <Ordered T>
[[nodiscard]] T hop_height(const DropSettings<T>& all, const T& g) {
  return T(2) * scalar::sq(*all.edge_speed) / g;
}

}  // namespace detail

/// Throws InvalidArgument unless every setting is in its range.
template <Ordered T>
void require_settings(const DropSettings<T>& settings) {
  const auto not_negative = [](const char* argument, const std::optional<T>& value) {
    require(!value || (T(0) <= *value && scalar::is_finite(*value)), argument, value.value_or(T(0)),
            "must be finite and at least 0");
  };
  const auto positive = [](const char* argument, const std::optional<T>& value) {
    require_positive(argument, value.value_or(T(1)));
  };
  static_cast<void>(make_material(settings.restitution, settings.friction));
  require(scalar::is_finite(settings.gravity), "gravity", settings.gravity.transpose(), "must be finite");
  not_negative("rolling_resistance", settings.rolling_resistance);
  not_negative("pivot_radius", settings.pivot_radius);
  not_negative("slip_coefficient", settings.slip_coefficient);
  not_negative("patch_radius", settings.patch_radius);
  positive("creep_speed", settings.creep_speed);
  not_negative("damping", settings.damping);
  require(T(0) < settings.horizon.value_or(T(1)), "horizon", settings.horizon.value_or(T(1)),
          "must be positive (infinity is allowed)");
  require(0 < settings.maximum_impacts, "maximum_impacts", settings.maximum_impacts, "must be at least 1");
  require(0 < settings.maximum_events, "maximum_events", settings.maximum_events, "must be at least 1");
  require(0 < settings.maximum_steps, "maximum_steps", settings.maximum_steps, "must be at least 1");
  require(T(100) * std::numeric_limits<T>::epsilon() < settings.tolerance && settings.tolerance <= T(1e-2), "tolerance",
          settings.tolerance, "must be from 100 ε to 0.01");
  positive("contact_speed", settings.contact_speed);
  not_negative("closing_speed", settings.closing_speed);
  positive("edge_speed", settings.edge_speed);
  not_negative("touching", settings.touching);
}

/// The same, and that the lengths of resistance and patch are those of a contact of this stone.
template <Ordered T>
void require_settings(const DropSettings<T>& settings, const Stone<T>& stone) {
  require_settings(settings);
  const auto within = [&](const char* argument, const std::optional<T>& value) {
    require(!value || T(2) * *value <= stone.width, argument, value.value_or(T(0)),
            "is a length, and must not exceed half the width (", stone.width / T(2), ")");
  };
  within("rolling_resistance", settings.rolling_resistance);
  within("pivot_radius", settings.pivot_radius);
  within("patch_radius", settings.patch_radius);
}

}  // namespace goishi
