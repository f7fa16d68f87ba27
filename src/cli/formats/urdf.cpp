#include "formats/body_form.hpp"

namespace goishi::cli {

std::string as_urdf(const BodyFile& body) {
  constexpr const char* form = R"(<?xml version="1.0"?>
<!-- {comment} -->
<robot name="stone">
  <link name="stone">
    <inertial>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <mass value="{mass}"/>
      <inertia ixx="{transverse}" ixy="0" ixz="0" iyy="{transverse}" iyz="0" izz="{axial}"/>
    </inertial>
    <visual>
      <geometry>
        <mesh filename="{mesh}"/>
      </geometry>
      <material name="stone">
        <color rgba="{color}"/>
      </material>
    </visual>
    <collision>
      <geometry>
        <mesh filename="{mesh}"/>
      </geometry>
    </collision>
  </link>
  <mujoco>
    <compiler fusestatic="false"/>
  </mujoco>
</robot>
)";
  return filled(form, body);
}

}  // namespace goishi::cli
