#pragma once
/// \file
/// Volume, centre and inertia of what a closed mesh encloses, by the divergence theorem.

#include <goishi/error.hpp>
#include <goishi/mesh/mesh.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>

namespace goishi {

/// Of density 1 kg/m³, in the frame of the mesh.
template <class T>
struct MeshMass {
  T volume = scalar::unset<T>();                           // [m³]
  T surface_area = scalar::unset<T>();                     // [m²]
  Vec3<T> centre = Vec3<T>::Constant(scalar::unset<T>());  // of mass [m]
  Mat3<T> tensor = Mat3<T>::Constant(scalar::unset<T>());  // of inertia about it, per density [m⁵]
};

/// Integrals over a solid, per density.
template <class T>
struct Integrals {
  T volume = T(0);                   // ∫ dV
  Vec3<T> first = Vec3<T>::Zero();   // ∫ p dV
  Mat3<T> second = Mat3<T>::Zero();  // ∫ p pᵀ dV
};

namespace formula {

/// Those of the tetrahedron (0, a, b, c), negative where a, b, c turn clockwise as seen from outside. With D = a · (b × c) and
/// s = a + b + c:
///
///     ∫ dV = D/6,   ∫ p dV = D/24 s,   ∫ p pᵀ dV = D/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ)
///
/// The sum over the triangles of a closed mesh is that of what it encloses, wherever the origin is.
/// Proof  derivations/mesh.cpp.
template <Field T>
[[nodiscard]] Integrals<T> tetrahedron(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const T D = formula::dot(a, formula::cross(b, c));
  const Vec3<T> s = formula::plus(formula::plus(a, b), c);
  Integrals<T> result;
  result.volume = D / T(6);
  result.first = formula::scaled(T(D / T(24)), s);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result.second(i, j) = D / T(120) * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    }
  }
  return result;
}

/// The tensor of inertia about the centre of mass, from integrals about the origin: with S = ∫ p pᵀ dV − V c cᵀ, tr(S) 1 − S.
/// Proof  derivations/mesh.cpp.
template <Field T>
[[nodiscard]] Mat3<T> central_tensor(const Integrals<T>& integrals) {
  Mat3<T> S;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      S(i, j) = integrals.second(i, j) - integrals.first[i] * integrals.first[j] / integrals.volume;
    }
  }
  Mat3<T> tensor;
  tensor << S(1, 1) + S(2, 2), -S(0, 1), -S(0, 2), -S(1, 0), S(2, 2) + S(0, 0), -S(1, 2), -S(2, 0), -S(2, 1),
      S(0, 0) + S(1, 1);
  return tensor;
}

}  // namespace formula

/// What a closed mesh encloses. Any mesh: its triangles need not be a stone's, nor convex.
///
/// Domain  closed (`topology`, which this does not ask again), with a volume above 0 and finite; else InvalidArgument.
/// Error   round-off, some ε for each thousand triangles (MESH-4). A mesh on a stone has less than the stone, by a share that falls
///         as the square of its edges.
template <Ordered T>
[[nodiscard]] MeshMass<T> mesh_mass(const Mesh<T>& mesh) {
  detail::require_mesh(mesh);
  Integrals<T> sum;
  T area(0);
  const Vec3<T> origin = mesh.points.empty() ? Vec3<T>::Zero() : mesh.points.front();  // near it, wherever it is
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3<T> a = formula::minus(mesh.points[triangle[0]], origin);
    const Vec3<T> b = formula::minus(mesh.points[triangle[1]], origin);
    const Vec3<T> c = formula::minus(mesh.points[triangle[2]], origin);
    const Integrals<T> part = formula::tetrahedron(a, b, c);
    sum.volume += part.volume;
    sum.first += part.first;
    sum.second += part.second;
    const Vec3<T> across = formula::cross(formula::minus(b, a), formula::minus(c, a));
    area += scalar::sqrt(formula::dot(across, across)) / T(2);
  }
  require(T(0) < sum.volume && scalar::is_finite(T(sum.volume + sum.second.trace())), "mesh", sum.volume,
          "must enclose a volume above 0, and a finite one (shown, in m³)");
  return {.volume = sum.volume,
          .surface_area = area,
          .centre = formula::plus(origin, formula::scaled(T(T(1) / sum.volume), sum.first)),
          .tensor = formula::central_tensor(sum)};
}

}  // namespace goishi
