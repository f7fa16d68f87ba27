#pragma once
/// \file
/// What a user types: a decimal number, bare (SI) or with a unit. "22mm", "2.2 cm" and "0.022" are the
/// same length, exactly.

#include <cstddef>
#include <goishi/rotation.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "number.hpp"

namespace goishi::cli {

/// The units that are read, the bare one first.
inline constexpr std::string_view length_units = "m cm mm um µm nm km";
inline constexpr std::string_view density_units = "kg/m³ kg/m3 kg/m^3 g/cm³ g/cm3 g/cm^3";
inline constexpr std::string_view mass_units = "kg g mg";
inline constexpr std::string_view time_units = "s ms";

/// InvalidArgument, with the argument's name, when the text is no decimal number, its unit is none, or
/// it is out of range.
[[nodiscard]] Number parse_length(const std::string& argument, std::string_view text);   // [m]
[[nodiscard]] Number parse_density(const std::string& argument, std::string_view text);  // [kg/m³]
[[nodiscard]] Number parse_mass(const std::string& argument, std::string_view text);     // [kg]
[[nodiscard]] Number parse_time(const std::string& argument, std::string_view text);     // [s]

/// A number without a unit; `unit` says which it is in.
[[nodiscard]] Number parse_bare(const std::string& argument, std::string_view text, std::string_view unit);

/// Numbers with commas between them, "1,-2, 3"; InvalidArgument unless there are `count`.
[[nodiscard]] std::vector<Number> parse_list(const std::string& argument, std::string_view text, std::size_t count);

/// Three numbers without a unit.
[[nodiscard]] Vec3<Number> parse_vector(const std::string& argument, std::string_view text);

/// A quaternion w,x,y,z that is unit but for the digits that a double or a decimal of 17 digits leaves out, made unit.
[[nodiscard]] Quat<Number> parse_attitude(const std::string& argument, std::string_view text);

/// The nearest double; InvalidArgument when more is lost than digits. `what` computes in double.
[[nodiscard]] double to_double(const char* argument, const Number& value, std::string_view what);

}  // namespace goishi::cli
