#pragma once
/// \file
/// The sixteen quantities of a stone, as `goishi inertia` and `goishi table` print them: key, name, symbol, unit,
/// value.

#include <array>
#include <cstddef>
#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>
#include <string_view>

#include "number.hpp"

namespace goishi::cli {

enum class Dimension { length, area, volume, density, mass, moment };

enum class UnitSystem {
  si,
  cgs,
  handy,  // cgs with lengths in mm
};

/// One SI unit is 10^power of this unit.
struct Unit {
  std::string_view name;  // "kg m²"
  std::string_view key;   // "kg_m2"
  int power;
};

[[nodiscard]] Unit unit_of(Dimension dimension, UnitSystem system);

/// An SI value in another unit.
[[nodiscard]] Number in_unit(const Number& value, const Unit& unit);

struct Quantity {
  std::string_view key;
  std::string_view name;
  std::string_view symbol;
  Dimension dimension;
};

/// In the order in which `goishi inertia` prints them.
inline constexpr std::array<Quantity, 16> quantities = {{
    {"width", "width", "w", Dimension::length},
    {"height", "height", "h", Dimension::length},
    {"bevel", "bevel", "b", Dimension::length},
    {"sphere_radius", "sphere radius", "r", Dimension::length},
    {"sphere_offset", "sphere offset", "d", Dimension::length},
    {"bevel_major_radius", "bevel major radius", "r₁", Dimension::length},
    {"bevel_minor_radius", "bevel minor radius", "r₂", Dimension::length},
    {"outer_width", "outer width", "", Dimension::length},
    {"volume", "volume", "V", Dimension::volume},
    {"surface_area", "surface area", "", Dimension::area},
    {"density", "density", "ρ", Dimension::density},
    {"mass", "mass", "m", Dimension::mass},
    {"axial", "axial moment", "I_a", Dimension::moment},
    {"transverse", "transverse moment", "I_t", Dimension::moment},
    {"axial_per_mass", "axial moment per mass", "I_a/m", Dimension::area},
    {"transverse_per_mass", "transverse moment per mass", "I_t/m", Dimension::area},
}};

/// The values of `quantities`, in SI units.
using Values = std::array<Number, quantities.size()>;

[[nodiscard]] Values values_of(const Stone<Number>& stone, const MassProperties<Number>& properties);

}  // namespace goishi::cli
