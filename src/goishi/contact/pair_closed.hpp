#pragma once
/// \file
/// Normals of two stones that are known in closed form: where a cap meets a cap, or a cap meets a rim.

#include <goishi/contact/pair.hpp>

namespace goishi::detail {

/// The centre of the sphere of the cap that looks along `sign` u, from the stone's centre, seen along −n: what a cap adds to
/// D · n is sign d u · n − R.
template <Ordered T>
[[nodiscard]] Vec3<T> with_sphere(const Vec3<T>& v, const Placed<T>& placed, const T& sign) {
  return sum(T(1), v, T(sign * placed.stone.sphere_offset), placed.u_W);
}

/// From the nearest point of a stone's core rim to a point v, both seen from the stone's centre; along the normal. 0 if the
/// point is not outside the rim's cylinder: then the rim's nearest point is not the one that is met along the normal.
template <Ordered T>
[[nodiscard]] Vec3<T> from_rim(const Vec3<T>& v, const Placed<T>& placed) {
  const T& r1 = placed.stone.bevel_major_radius;
  const Vec3<T> radial = sum(T(1), v, T(-dot(v, placed.u_W)), placed.u_W);
  const T rho = scalar::sqrt(dot(radial, radial));
  return r1 < rho ? sum(T(1), v, T(-(r1 / rho)), radial) : Vec3<T>(T(0), T(0), T(0));
}

/// Whether a stone meets a normal v/|v| with the cap that looks along `sign` u.
template <Ordered T>
[[nodiscard]] bool meets_with_cap(const Placed<T>& placed, const T& sign, const Vec3<T>& v, const T& size2) {
  const T axial = sign * dot(placed.u_W, v);
  return T(0) <= axial && scalar::sq(placed.stone.joint_sine) * size2 <= scalar::sq(axial);
}

template <Ordered T>
[[nodiscard]] bool meets_with_rim(const Placed<T>& placed, const Vec3<T>& v, const T& size2) {
  const T axial = dot(placed.u_W, v);
  return scalar::sq(axial) <= scalar::sq(placed.stone.joint_sine) * size2;
}

/// The sign of the cap that a stone is likely to turn towards a direction.
template <Ordered T>
[[nodiscard]] T sign_towards(const Placed<T>& placed, const Vec3<T>& v) {
  return dot(placed.u_W, v) < T(0) ? T(-1) : T(1);
}

/// Looks for a closed form that holds and at which the cores are apart: then no other normal separates more. Else false;
/// `along` is a direction to search from, or 0.
template <Ordered T>
[[nodiscard]] bool find_apart(const Pair<T>& pair, Vec3<T>& along) {
  const T sign1 = sign_towards(pair.first, pair.between), sign2 = sign_towards(pair.second, pair.between);
  const T &R1 = pair.first.stone.core_sphere_radius, &R2 = pair.second.stone.core_sphere_radius;
  const Vec3<T> from_first = with_sphere(pair.between, pair.first, sign1);
  const Vec3<T> caps = with_sphere(from_first, pair.second, sign2);
  const T caps2 = dot(caps, caps);
  if (scalar::sq(T(R1 + R2)) < caps2 && meets_with_cap(pair.first, sign1, caps, caps2) &&
      meets_with_cap(pair.second, sign2, caps, caps2)) {
    along = caps;
    return true;
  }
  const Vec3<T> rim2 = from_rim(from_first, pair.second);
  const T rim2_2 = dot(rim2, rim2);
  if (scalar::sq(R1) < rim2_2 && meets_with_cap(pair.first, sign1, rim2, rim2_2) &&
      meets_with_rim(pair.second, rim2, rim2_2)) {
    along = rim2;
    return true;
  }
  const Vec3<T> rim1 = from_rim(with_sphere(pair.between, pair.second, sign2), pair.first);
  const T rim1_2 = dot(rim1, rim1);
  if (scalar::sq(R2) < rim1_2 && meets_with_cap(pair.second, sign2, rim1, rim1_2) &&
      meets_with_rim(pair.first, rim1, rim1_2)) {
    along = rim1;
    return true;
  }
  // Two rims, mostly: nearest to where the better of the two would be.
  along = scalar::sqrt(rim1_2) - R2 < scalar::sqrt(rim2_2) - R1 ? rim2 : rim1;
  return false;
}

/// Tries every normal at which a cap and a cap, or a cap and a rim, could separate most; each counts for what it gives.
template <Ordered T>
void try_caps(const Pair<T>& pair, PairPoint<T>& best) {
  const auto try_normal = [&](const Vec3<T>& v) {
    const T size = scalar::sqrt(dot(v, v));
    if (T(0) < size) {
      const PairPoint<T> at = pair_point(pair, Vec3<T>(T(v.x() / size), T(v.y() / size), T(v.z() / size)));
      if (best.g < at.g) {
        best = at;
      }
    }
  };
  for (const T& sign : {T(1), T(-1)}) {
    const Vec3<T> from_first = with_sphere(pair.between, pair.first, sign);
    try_normal(with_sphere(from_first, pair.second, T(1)));
    try_normal(with_sphere(from_first, pair.second, T(-1)));
    try_normal(from_rim(from_first, pair.second));
    try_normal(from_rim(with_sphere(pair.between, pair.second, sign), pair.first));
  }
}

}  // namespace goishi::detail
