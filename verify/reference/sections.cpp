#include "verify/reference/sections.hpp"

namespace goishi::verify::reference {

std::vector<Section> all_sections() {
  return {shapes_section(), mass_section(),    surface_section(), flight_section(),
          impact_section(), contact_section(), drop_section()};
}

}  // namespace goishi::verify::reference
