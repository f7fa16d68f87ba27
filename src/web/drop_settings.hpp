#pragma once
/// \file
/// The settings of a drop as an array, which those of a scene begin with.

#include <cstddef>
#include <goishi/drop/settings.hpp>
#include <optional>

#include "arguments.hpp"

namespace goishi::c {

static_assert(is(FrictionModel::dry, GOISHI_DRY) && is(FrictionModel::slip_proportional, GOISHI_SLIP_PROPORTIONAL) &&
              is(FrictionModel::coulomb_contensou, GOISHI_COULOMB_CONTENSOU));

[[nodiscard]] inline std::optional<double> setting(double value) {
  return value == GOISHI_UNSET ? std::nullopt : std::optional(value);
}

/// The first GOISHI_SETTINGS_SIZE numbers of an array.
[[nodiscard]] inline DropSettings<double> drop_settings(const double* a) {
  DropSettings<double> settings;
  settings.restitution = a[GOISHI_RESTITUTION];
  settings.friction = a[GOISHI_FRICTION];
  settings.gravity = {a[GOISHI_GRAVITY], a[GOISHI_GRAVITY + 1], a[GOISHI_GRAVITY + 2]};
  settings.rolling_resistance = setting(a[GOISHI_ROLLING_RESISTANCE]);
  settings.pivot_radius = setting(a[GOISHI_PIVOT_RADIUS]);
  settings.friction_model =
      static_cast<FrictionModel>(whole("friction_model", a[GOISHI_FRICTION_MODEL], 0, GOISHI_COULOMB_CONTENSOU));
  settings.slip_coefficient = setting(a[GOISHI_SLIP_COEFFICIENT]);
  settings.patch_radius = setting(a[GOISHI_PATCH_RADIUS]);
  settings.creep_speed = setting(a[GOISHI_CREEP_SPEED]);
  settings.damping = a[GOISHI_DAMPING];
  settings.law = static_cast<ImpactLaw>(whole("law", a[GOISHI_LAW], 0, GOISHI_STRONGE));
  settings.horizon = setting(a[GOISHI_HORIZON]);
  settings.maximum_impacts = whole("maximum_impacts", a[GOISHI_MAXIMUM_IMPACTS], 1, most_whole);
  settings.maximum_events = whole("maximum_events", a[GOISHI_MAXIMUM_EVENTS], 1, most_whole);
  settings.maximum_steps = whole("maximum_steps", a[GOISHI_MAXIMUM_STEPS], 1, most_whole);
  settings.tolerance = a[GOISHI_TOLERANCE];
  settings.contact_speed = setting(a[GOISHI_CONTACT_SPEED]);
  settings.closing_speed = setting(a[GOISHI_CLOSING_SPEED]);
  settings.edge_speed = setting(a[GOISHI_EDGE_SPEED]);
  settings.touching = a[GOISHI_TOUCHING];
  return settings;
}

[[nodiscard]] inline DropSettings<double> read_settings(const double* pointer, std::size_t size) {
  return drop_settings(read<GOISHI_SETTINGS_SIZE>("settings", pointer, size).data());
}

[[nodiscard]] inline double value_of(const std::optional<double>& setting) {
  return setting.value_or(GOISHI_UNSET);
}

inline void put_settings(Row row, const DropSettings<double>& own) {
  row << own.restitution << own.friction << own.gravity << value_of(own.rolling_resistance)
      << value_of(own.pivot_radius) << as_number(own.friction_model) << value_of(own.slip_coefficient)
      << value_of(own.patch_radius) << value_of(own.creep_speed) << own.damping << as_number(own.law)
      << value_of(own.horizon) << static_cast<double>(own.maximum_impacts) << static_cast<double>(own.maximum_events)
      << static_cast<double>(own.maximum_steps) << own.tolerance << value_of(own.contact_speed)
      << value_of(own.closing_speed) << value_of(own.edge_speed) << own.touching;
}

}  // namespace goishi::c
