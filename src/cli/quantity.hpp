#pragma once
/// \file
/// What a user types: numbers, bare (SI) or with a unit. "22mm", "2.2 cm" and "0.022" are the same length, exactly.
///
/// One rule for all of them, those in lists and whole ones too: blanks, what `take_decimal` reads, blanks, a unit or
/// nothing, blanks.

#include <goishi/rotation.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "number.hpp"

namespace goishi::cli {

/// A unit is 10^power SI units. `µ`, `²` and `³` may be typed `u`, `2` or `^2`, `3` or `^3`.
struct InputUnit {
  std::string_view name;
  int power;
};

/// What a number measures: the units that are read, the one of a bare number first. A ratio has none.
struct Measure {
  std::string_view plural;
  std::span<const InputUnit> units;
};

namespace measure {

inline constexpr InputUnit length_units[] = {{"m", 0}, {"cm", -2}, {"mm", -3}, {"µm", -6}, {"nm", -9}, {"km", 3}};
inline constexpr InputUnit velocity_units[] = {{"m/s", 0}, {"cm/s", -2}, {"mm/s", -3}, {"km/s", 3}};
inline constexpr InputUnit acceleration_units[] = {{"m/s²", 0}, {"cm/s²", -2}, {"mm/s²", -3}};
inline constexpr InputUnit spin_units[] = {{"rad/s", 0}};
inline constexpr InputUnit angle_units[] = {{"°", 0}, {"deg", 0}};
inline constexpr InputUnit density_units[] = {{"kg/m³", 0}, {"g/cm³", 3}};
inline constexpr InputUnit mass_units[] = {{"kg", 0}, {"g", -3}, {"mg", -6}};
inline constexpr InputUnit moment_units[] = {{"kg m²", 0}, {"g cm²", -7}};
inline constexpr InputUnit time_units[] = {{"s", 0}, {"ms", -3}};
inline constexpr InputUnit slip_units[] = {{"s/m", 0}};

inline constexpr Measure length{"lengths", length_units};
inline constexpr Measure velocity{"velocities", velocity_units};
inline constexpr Measure acceleration{"accelerations", acceleration_units};
inline constexpr Measure spin{"spins", spin_units};
inline constexpr Measure angle{"angles", angle_units};
inline constexpr Measure density{"densities", density_units};
inline constexpr Measure mass{"masses", mass_units};
inline constexpr Measure moment{"moments", moment_units};
inline constexpr Measure time{"times", time_units};
inline constexpr Measure slip_coefficient{"slip coefficients", slip_units};
inline constexpr Measure ratio{"ratios", {}};

}  // namespace measure

/// "m, cm, mm, µm, nm, km"
[[nodiscard]] std::string names_of(const Measure& measure);

/// Without the blanks (spaces and tabs) around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// In SI units. InvalidArgument, with the argument's name, when the text is no decimal number, its unit is none, or it
/// is out of range.
[[nodiscard]] Number parse(const std::string& argument, std::string_view text, const Measure& measure);

/// Numbers with commas between them, "1,-2, 3" or "1mm,0,3cm"; InvalidArgument unless there are `count`, and where one
/// has a unit all that are not 0 have.
[[nodiscard]] std::vector<Number> parse_list(const std::string& argument, std::string_view text, const Measure& measure,
                                             std::size_t count);

[[nodiscard]] Vec3<Number> parse_vector(const std::string& argument, std::string_view text, const Measure& measure);

/// A quaternion w,x,y,z of length 1, but for the digits that were not typed, made unit. InvalidArgument unless its
/// length is within 1e-3 of 1; a note when it is off by more than a double or a decimal of 17 digits leaves out.
[[nodiscard]] Quat<Number> parse_attitude(const std::string& argument, std::string_view text,
                                          std::vector<std::string>& notes);

/// The whole number that the text is ("33", "+033", "33.0", "3.3e1"); nothing if it is none, or beyond an int.
[[nodiscard]] std::optional<int> whole_number(std::string_view text);

/// InvalidArgument unless least <= number <= most.
[[nodiscard]] int parse_whole(const std::string& argument, std::string_view text, int least, int most);

/// The nearest double; InvalidArgument unless the value is 0 or from 10^-order to 10^order, in magnitude: then no
/// product of such numbers that `what` needs leaves the range of a double.
[[nodiscard]] double to_double(const char* argument, const Number& value, std::string_view what, int order);

}  // namespace goishi::cli
