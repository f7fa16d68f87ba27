#include "formats/body_form.hpp"

namespace goishi::cli {

std::string as_sdf(const BodyFile& body) {
  constexpr const char* form = R"(<?xml version="1.0"?>
<!-- {comment} -->
<sdf version="1.9">
  <model name="stone">
    <link name="stone">
      <inertial>
        <mass>{mass}</mass>
        <inertia>
          <ixx>{transverse}</ixx>
          <ixy>0</ixy>
          <ixz>0</ixz>
          <iyy>{transverse}</iyy>
          <iyz>0</iyz>
          <izz>{axial}</izz>
        </inertia>
      </inertial>
      <visual name="visual">
        <geometry>
          <mesh>
            <uri>{mesh}</uri>
          </mesh>
        </geometry>
        <material>
          <ambient>{color}</ambient>
          <diffuse>{color}</diffuse>
        </material>
      </visual>
      <collision name="collision">
        <geometry>
          <mesh>
            <uri>{mesh}</uri>
          </mesh>
        </geometry>
      </collision>
    </link>
  </model>
</sdf>
)";
  return filled(form, body);
}

}  // namespace goishi::cli
