#pragma once
/// \file
/// What a user types: a decimal number, bare (SI) or with a unit. "22mm", "2.2 cm" and "0.022" are the
/// same length, exactly.

#include <string>
#include <string_view>

#include "number.hpp"

namespace goishi::cli {

/// The units that are read, the bare one first.
inline constexpr std::string_view length_units = "m cm mm um µm nm km";
inline constexpr std::string_view density_units = "kg/m³ kg/m3 kg/m^3 g/cm³ g/cm3 g/cm^3";
inline constexpr std::string_view mass_units = "kg g mg";

/// InvalidArgument, with the argument's name, when the text is no decimal number, its unit is none, or
/// it is out of range.
[[nodiscard]] Number parse_length(const std::string& argument, std::string_view text);   // [m]
[[nodiscard]] Number parse_density(const std::string& argument, std::string_view text);  // [kg/m³]
[[nodiscard]] Number parse_mass(const std::string& argument, std::string_view text);     // [kg]

}  // namespace goishi::cli
