#include "formats/body_form.hpp"

namespace goishi::cli {

std::string as_mjcf(const BodyFile& body) {
  constexpr const char* form = R"(<!-- {comment} -->
<mujoco model="stone">
  <asset>
    <mesh name="stone" file="{mesh}"/>
  </asset>
  <worldbody>
    <body name="stone">
      <freejoint/>
      <inertial pos="0 0 0" quat="1 0 0 0" mass="{mass}" diaginertia="{transverse} {transverse} {axial}"/>
      <geom type="mesh" mesh="stone" rgba="{color}"/>
    </body>
  </worldbody>
</mujoco>
)";
  return filled(form, body);
}

}  // namespace goishi::cli
