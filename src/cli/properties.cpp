#include "properties.hpp"

namespace goishi::cli {

Unit unit_of(Dimension dimension, UnitSystem system) {
  const bool si = system == UnitSystem::si;
  switch (dimension) {
    case Dimension::length:
      if (system == UnitSystem::handy) {
        return {"mm", "mm", 3};
      }
      return si ? Unit{"m", "m", 0} : Unit{"cm", "cm", 2};
    case Dimension::area:
      return si ? Unit{"m²", "m2", 0} : Unit{"cm²", "cm2", 4};
    case Dimension::volume:
      return si ? Unit{"m³", "m3", 0} : Unit{"cm³", "cm3", 6};
    case Dimension::density:
      return si ? Unit{"kg/m³", "kg_m3", 0} : Unit{"g/cm³", "g_cm3", -3};
    case Dimension::mass:
      return si ? Unit{"kg", "kg", 0} : Unit{"g", "g", 3};
    case Dimension::moment:
      break;
  }
  return si ? Unit{"kg m²", "kg_m2", 0} : Unit{"g cm²", "g_cm2", 7};
}

Number in_unit(const Number& value, const Unit& unit) {
  Number scale = 1;
  for (int i = 0; i < std::abs(unit.power); ++i) {
    scale *= 10;
  }
  return unit.power < 0 ? Number(value / scale) : Number(value * scale);
}

Values values_of(const Stone<Number>& stone, const MassProperties<Number>& properties) {
  return {stone.width,
          stone.height,
          stone.bevel,
          stone.sphere_radius,
          stone.sphere_offset,
          stone.bevel_major_radius,
          stone.bevel_minor_radius,
          outer_width(stone),
          properties.volume,
          properties.surface_area,
          properties.density,
          properties.mass,
          properties.moments.axial,
          properties.moments.transverse,
          properties.moments_per_mass.axial,
          properties.moments_per_mass.transverse};
}

}  // namespace goishi::cli
