#pragma once
/// \file
/// Every number of a drop that can be chosen: once, with its unit and its reason.

#include <cstddef>
#include <goishi/error.hpp>
#include <goishi/impact/material.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <limits>
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

template <class T>
struct DropSettings {
  // --- The scene
  T restitution = T(0.5);            // e; stone on wood 0.4 … 0.7 (assumed range)
  T friction = T(0.3);               // μ; stone on wood 0.2 … 0.4 (assumed range); infinity is allowed
  Vec3<T> gravity = gravity_W<T>();  // [m/s²] in W; a slope is a gravity that leans
  /// δ [m]: torque δ N against rolling; 1e-5 … 1e-4 on wood. Where only one of δ and κ is given, the other counts as a
  /// hundredth of it: a patch that resists the one resists the other, and without that the torque would be a dry
  /// friction of one direction alone, which jumps wherever the turning there ceases.
  T rolling_resistance = T(1e-4);
  T pivot_radius = T(5e-5);  // κ [m]: torque κ N against turning on the spot, (3π/16) μ a_c
  FrictionModel friction_model = FrictionModel::dry;
  T slip_coefficient = T(1);  // c [s/m] of slip_proportional
  T patch_radius = T(1e-4);   // a_c [m] of coulomb_contensou; 0: dry
  T creep_speed = T(1e-4);    // [m/s] of coulomb_contensou: a slip so slow meets friction in proportion, also where
                              // the patch does not turn. The law has no rest; steps get shorter in proportion to this
  T damping = T(0);           // [1/s] the talk's exponential damping of both momenta while in contact. It has
                              // no physical basis and never stops: for comparison only
  ImpactLaw law = ImpactLaw::chatterjee_ruina;

  // --- When to stop
  T horizon = T(60);                                      // [s] of simulated time
  int maximum_impacts = std::numeric_limits<int>::max();  // stop after so many
  int maximum_events = 100000;                            // a run that makes more is given up, and says so
  int maximum_steps = 2000000;                            // of the contact phase, likewise

  // --- How exactly
  /// Of a step of the contact phase, relative to the stone's own scales.
  T tolerance = T(1e-9);
  /// [m/s] Approach below which bounces are closed by a plastic impulse. Where a stone dropped from 5 cm comes to rest
  /// depends on it by 1.6e-9 m in the median; by 1.4e-6 m at 1e-3 m/s (100 drops against 1e-8 m/s, measured 2026-11-22).
  T contact_speed = T(1e-6);
  /// [m/s] Leaving speed below which the bounces of a flat drop are summed, exactly. Higher is as right, and shows
  /// fewer.
  T closing_speed = T(1e-2);
  /// [m/s] Of the micro-impacts that stand for a contact that lasts on an edge, a side or at two places: hops of up to
  /// 2e-4 s and 5e-8 m. Their error falls with it, their number grows as 1/it.
  T edge_speed = T(1e-3);
  /// Of the width: a stone no deeper inside is taken as touching, a deeper one refused.
  T touching = T(1e-9);
};

/// Throws InvalidArgument unless every setting is in its range.
template <Ordered T>
void require_settings(const DropSettings<T>& settings) {
  const auto not_negative = [](const char* argument, const T& value) {
    require(T(0) <= value && scalar::is_finite(value), argument, value, "must be finite and at least 0");
  };
  static_cast<void>(make_material(settings.restitution, settings.friction));
  require(scalar::is_finite(T(settings.gravity.sum())), "gravity", settings.gravity.transpose(), "must be finite");
  not_negative("rolling_resistance", settings.rolling_resistance);
  not_negative("pivot_radius", settings.pivot_radius);
  not_negative("slip_coefficient", settings.slip_coefficient);
  not_negative("patch_radius", settings.patch_radius);
  require_positive("creep_speed", settings.creep_speed);
  not_negative("damping", settings.damping);
  require(T(0) < settings.horizon, "horizon", settings.horizon, "must be positive (infinity is allowed)");
  require(0 < settings.maximum_impacts, "maximum_impacts", settings.maximum_impacts, "must be at least 1");
  require(0 < settings.maximum_events, "maximum_events", settings.maximum_events, "must be at least 1");
  require(0 < settings.maximum_steps, "maximum_steps", settings.maximum_steps, "must be at least 1");
  require(T(100) * std::numeric_limits<T>::epsilon() < settings.tolerance && settings.tolerance <= T(1e-2), "tolerance",
          settings.tolerance, "must be from 100 ε to 0.01");
  require_positive("contact_speed", settings.contact_speed);
  not_negative("closing_speed", settings.closing_speed);
  require_positive("edge_speed", settings.edge_speed);
  not_negative("touching", settings.touching);
}

}  // namespace goishi
