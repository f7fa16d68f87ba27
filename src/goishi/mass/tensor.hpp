#pragma once
/// \file
/// The inertia tensor in its general form, about any point and in any frame; and the way back to principal axes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/vector.hpp>
#include <utility>

namespace goishi {

namespace formula {

/// Inertia tensor of a body with symmetry axis Bz about its centre of mass, in B   [kg m²]: diag(I_t, I_t, I_a).
/// Proof  derivations/tensor.cpp.
template <Field T>
[[nodiscard]] Mat3<T> principal_tensor(const Moments<T>& moments) {
  Mat3<T> tensor;
  tensor << moments.transverse, T(0), T(0), T(0), moments.transverse, T(0), T(0), T(0), moments.axial;
  return tensor;
}

/// The tensor in frame W, from the tensor in frame B: I_W = R_WB I_B R_WBᵀ. Same point, other axes.
/// Domain  R_WB a rotation matrix.   Proof  derivations/tensor.cpp.
template <Field T>
[[nodiscard]] Mat3<T> rotated_tensor(const Mat3<T>& tensor_B, const Mat3<T>& R_WB) {
  Mat3<T> half, result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      half(i, j) = R_WB(i, 0) * tensor_B(0, j) + R_WB(i, 1) * tensor_B(1, j) + R_WB(i, 2) * tensor_B(2, j);
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = half(i, 0) * R_WB(j, 0) + half(i, 1) * R_WB(j, 1) + half(i, 2) * R_WB(j, 2);
    }
  }
  return result;
}

/// The tensor about a point P, from the tensor about the centre of mass C (parallel axes; all vectors in one frame):
///
///     I_P = I_C + m (|c|² 1 − c cᵀ),   c = C − P
///
/// Proof  derivations/tensor.cpp.
template <Field T>
[[nodiscard]] Mat3<T> shifted_tensor(const Mat3<T>& tensor_C, const T& mass, const Vec3<T>& c) {
  const T xx = scalar::sq(c.x()), yy = scalar::sq(c.y()), zz = scalar::sq(c.z());
  const T xy = c.x() * c.y(), xz = c.x() * c.z(), yz = c.y() * c.z();
  Mat3<T> offset;
  offset << yy + zz, -xy, -xz, -xy, zz + xx, -yz, -xz, -yz, xx + yy;
  return tensor_C + mass * offset;
}

}  // namespace formula

/// The talk's general form I = [[Ixx, Iyx, Izx], [Ixy, Iyy, Izy], [Ixz, Iyz, Izz]]: the full inertia tensor of a stone
/// at p_WB with attitude q_WB, about the origin of W, in W   [kg m²]. Off-diagonal entries are minus the products of
/// inertia.
///
/// Domain  q_WB a unit quaternion, |p_WB|² and the result finite (DOMAIN-3); else InvalidArgument.
/// Source  nested integration of the solid itself (GSL-4).
template <Ordered T>
[[nodiscard]] Mat3<T> inertia_tensor(const MassProperties<T>& body, const Quat<T>& q_WB, const Vec3<T>& p_WB) {
  const Mat3<T> about_centre = formula::rotated_tensor(formula::principal_tensor(body.moments), rotation_matrix(q_WB));
  Mat3<T> result = formula::shifted_tensor(about_centre, body.mass, p_WB);
  const T most = std::numeric_limits<T>::max() / T(4);
  // No entry of the tensor of a body exceeds its trace.
  require(formula::dot(p_WB, p_WB) < most && result.trace() < most, "position", p_WB.transpose(),
          "must be finite, and its square times the mass, too");
  return result;
}

/// Principal moments, ascending, and axes of a tensor: I = R diag(moments) Rᵀ, R_WP a rotation (right-handed).
template <class T>
struct PrincipalAxes {
  Vec3<T> moments = Vec3<T>::Constant(scalar::unset<T>());  // [kg m²], ascending
  Mat3<T> R_WP = Mat3<T>::Constant(scalar::unset<T>());  // columns: the axes; where moments are equal, any pair across
};

/// Whether a rigid body can have this tensor: symmetric, positive, and no moment above the sum of the other two
/// (triangle inequality; equality is a lamina). `slack`, in units of the trace, admits round-off: a lamina's own
/// tensor, rotated, must pass.
///
/// Returns the rule that is broken, or nullptr.
template <Ordered T>
[[nodiscard]] const char* broken_inertia_rule(const Vec3<T>& moments,
                                              const T& slack = T(16) * std::numeric_limits<T>::epsilon()) {
  const T trace = moments.x() + moments.y() + moments.z();
  if (!scalar::is_finite(trace)) {
    return "must be finite";
  }
  if (!(T(0) < moments.minCoeff())) {
    return "must have positive principal moments";
  }
  // The largest moment and the other two: trace − max.
  if (!(moments.maxCoeff() < (trace - moments.maxCoeff()) + slack * trace)) {
    return "must satisfy the triangle inequality: no principal moment above the sum of the other two";
  }
  return nullptr;
}

/// Throws InvalidArgument unless a body with a symmetry axis can have these moments: positive, I_a <= 2 I_t.
template <Ordered T>
void require_physical(const Moments<T>& moments) {
  require_positive("axial", moments.axial);
  require_positive("transverse", moments.transverse);
  const char* broken = broken_inertia_rule<T>({moments.transverse, moments.transverse, moments.axial});
  require(broken == nullptr, "axial", moments.axial, broken, " (transverse ", moments.transverse, ")");
}

namespace detail {

/// Eigenvalues, ascending, and eigenvectors of a symmetric matrix of trace 1, by Jacobi's rotations: each makes one entry off the
/// diagonal zero. (Eigen's solver rounds as the processor's vector instructions do.)
template <Ordered T>
[[nodiscard]] PrincipalAxes<T> jacobi_axes(Mat3<T> A) {
  constexpr int most_sweeps = 30;
  const T nothing = scalar::sq(std::numeric_limits<T>::epsilon());
  Mat3<T> R = Mat3<T>::Identity();
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    if (!(nothing < scalar::sq(A(0, 1)) + scalar::sq(A(0, 2)) + scalar::sq(A(1, 2)))) {
      break;
    }
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      const T off = A(i, j);
      if (!(off < T(0)) && !(T(0) < off)) {
        continue;
      }
      // tan of the lesser angle: of a denominator that is no number, 0.
      const T half = (A(j, j) - A(i, i)) / (T(2) * off), root = scalar::sqrt(T(T(1) + scalar::sq(half)));
      const T t = half < T(0) ? T(T(1) / (half - root)) : T(T(1) / (half + root));
      const T c = T(1) / scalar::sqrt(T(T(1) + scalar::sq(t))), s = t * c;
      const int k = 3 - i - j;
      const T x = A(i, k), y = A(j, k);
      A(i, k) = A(k, i) = c * x - s * y;
      A(j, k) = A(k, j) = s * x + c * y;
      A(i, j) = A(j, i) = T(0);
      A(i, i) = A(i, i) - t * off;
      A(j, j) = A(j, j) + t * off;
      for (int row = 0; row < 3; ++row) {
        const T u = R(row, i), v = R(row, j);
        R(row, i) = c * u - s * v;
        R(row, j) = s * u + c * v;
      }
    }
  }
  std::array<int, 3> order = {0, 1, 2};
  // Equal ones by their number: of these every standard library makes an order of its own.
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return A(i, i) < A(j, j) || (!(A(j, j) < A(i, i)) && i < j); });
  PrincipalAxes<T> result;
  for (int i = 0; i < 3; ++i) {
    const int from = order[static_cast<std::size_t>(i)];
    result.moments[i] = A(from, from);
    result.R_WP.col(i) = R.col(from);
  }
  return result;
}

}  // namespace detail

/// Principal axes back from the full tensor.
///
/// Domain  of any size (DOMAIN-12), its trace finite; symmetric, positive definite, triangle inequality (within round-off);
///         else InvalidArgument.
/// Error   moments <= 24 ε trace, R a rotation to 24 ε (claim TENSOR-4). A body so far from the point that its least moment
///         is below that is refused: take the tensor about a nearer point.
template <Ordered T>
[[nodiscard]] PrincipalAxes<T> principal_axes(const Mat3<T>& tensor) {
  const T trace = tensor.trace();
  require(T(0) < trace && scalar::is_finite(trace), "tensor", trace, "must have a positive, finite trace (shown)");
  // Scaled to trace 1, so that moments of any unit neither overflow nor underflow in the solver.
  const Mat3<T> scaled = tensor / trace;
  const bool is_number = (scaled.array() - scaled.array() == T(0)).all();  // no infinity, no NaN
  require(is_number, "tensor", trace, "must be finite (its trace is shown)");
  const T asymmetry = (scaled - scaled.transpose()).cwiseAbs().maxCoeff();
  require(asymmetry <= T(16) * std::numeric_limits<T>::epsilon(), "tensor", asymmetry,
          "must be symmetric (largest difference shown, in units of the trace)");
  PrincipalAxes<T> result = detail::jacobi_axes(Mat3<T>((scaled + scaled.transpose()) / T(2)));
  result.moments = trace * result.moments;
  const char* broken = broken_inertia_rule(result.moments);
  require(broken == nullptr, "tensor", result.moments.minCoeff(), broken, " (least moment shown)");
  const Vec3<T> x = result.R_WP.col(0), y = result.R_WP.col(1), z = result.R_WP.col(2);
  if (formula::dot(x, formula::cross(y, z)) < T(0)) {
    result.R_WP.col(0) = -result.R_WP.col(0);
  }
  return result;
}

}  // namespace goishi
