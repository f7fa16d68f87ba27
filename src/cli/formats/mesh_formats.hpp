#pragma once
/// \file
/// A mesh as the bytes of a file that other programs read. Lengths are written as they are in the mesh, in whichever unit.
///
/// glTF is written by tinygltf, the others by us: Assimp exports coordinates in float, and STL alone is no reason for it.

#include <array>
#include <goishi/mesh/mesh.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <string_view>

namespace goishi::cli {

/// Red, green and blue, from 0 to 1.
using Color = std::array<double, 3>;

/// Wavefront OBJ, text. A point stands once, whatever number of normals it has, so that the surface is closed for who
/// reads points alone; numbers are as short as give the double back. The comment is one line.
[[nodiscard]] std::string as_obj(const Mesh<double>& mesh, std::string_view comment);

/// STL, binary: three points in float for each triangle, and the normal of the triangle. Of the comment, 80 bytes; it must
/// not begin with "solid", as a text does.
[[nodiscard]] std::string as_stl(const Mesh<double>& mesh, std::string_view comment);

/// PLY, binary, lowest byte first: a vertex is a point and a normal in double. The comment is one line.
[[nodiscard]] std::string as_ply(const Mesh<double>& mesh, std::string_view comment);

/// glTF 2.0, binary (.glb), points and normals in float: one mesh, one node, which turns Bz to glTF's vertical, y; width,
/// height and bevel of the stone are the node's `extras`.   Domain  a mesh in metres, glTF's unit.
[[nodiscard]] std::string as_glb(const Mesh<double>& mesh, const Stone<double>& stone, const Color& color,
                                 const std::string& generator);

}  // namespace goishi::cli
