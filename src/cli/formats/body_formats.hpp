#pragma once
/// \file
/// A stone as a rigid body, in the file that a simulator reads. SI units; the body's frame is B, Bz the symmetry axis.

#include <goishi/mass/inertia.hpp>
#include <string>
#include <string_view>

#include "formats/mesh_formats.hpp"
#include "number.hpp"

namespace goishi::cli {

/// What is written of a body. Mass and moments get 17 digits, enough for the double back.
struct BodyFile {
  std::string comment;                // one line, without "--"
  std::string mesh;                   // name of the mesh's file, in the same folder, in metres; `is_plain_name`
  MassProperties<Number> properties;  // about the origin
  Color color;
};

/// Whether a file's name means itself in XML, in a URI and in every program's search path: letters, digits and ._-+ alone.
[[nodiscard]] bool is_plain_name(std::string_view name);

/// URDF: one link. The element <mujoco> is for MuJoCo alone, which otherwise makes a robot's first link a part of the
/// world, without a mass.
[[nodiscard]] std::string as_urdf(const BodyFile& body);

/// SDF 1.9: one model of one link.
[[nodiscard]] std::string as_sdf(const BodyFile& body);

/// MJCF: one body with a free joint. `diaginertia` is what MuJoCo computes with as it stands; a `fullinertia` it would
/// diagonalize.
[[nodiscard]] std::string as_mjcf(const BodyFile& body);

}  // namespace goishi::cli
