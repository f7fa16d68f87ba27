#pragma once
/// \file
/// Stones, points, directions and poses for the claims about surface and contact.

#include <goishi/contact/stone_plane.hpp>
#include <goishi/shape/stone.hpp>
#include <string>

#include "verify/oracles/contact/brute_contact.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify {

/// 10^-span … 1, evenly by decades.
[[nodiscard]] double draw_small(Context& context, double span);

[[nodiscard]] Vec3<double> draw_unit(Context& context);

/// A stone, and the numbers that it was made from.
struct Specimen {
  ShapeSample<double> shape;
  Stone<double> stone;
};

/// All shapes of `draw_shape`, every third one sharp; none thinner than `thinnest` of its width.
[[nodiscard]] Specimen draw_specimen(Context& context, int i, double thinnest);

/// Size 33 with a bevel of 1 mm, sharp, thin, round, any: what stones on a board may be, about 22 mm wide.
[[nodiscard]] Specimen draw_stone(Context& context, int i);

/// Unit directions as a stone sees them: any, near the axis, near the middle plane, on them, at the switch of cap and
/// rim, within the cap.
[[nodiscard]] Vec3<double> draw_normal(Context& context, const Stone<double>& stone, int i);

template <class T>
[[nodiscard]] Triple<long double> triple(const Vec3<T>& v) {
  return {static_cast<long double>(v.x()), static_cast<long double>(v.y()), static_cast<long double>(v.z())};
}

[[nodiscard]] Hull<Digits50> hull_of(const Specimen& specimen);

/// A stone in a pose, for the oracle: axis from the attitude in long double, made unit.
[[nodiscard]] Standing standing(const Hull<long double>& hull, const Pose<double>& pose);

using Exact3 = Vec3<Digits50>;

[[nodiscard]] Exact3 exact(const Vec3<double>& v);

/// A stone over a plane, and its gap and lowest point in 50 digits.
struct PlaneCase {
  Specimen specimen;
  Pose<double> pose;
  Plane<double> plane;
  double scale;  // the greatest of width and distances
  Digits50 gap;
  Exact3 lowest;
};

[[nodiscard]] PlaneCase draw_plane_case(Context& context, int i);

[[nodiscard]] std::string describe(const Vec3<double>& v);

[[nodiscard]] std::string describe(const Specimen& specimen);

[[nodiscard]] std::string describe(const Specimen& specimen, const Pose<double>& pose);

[[nodiscard]] std::string describe(const PlaneCase& drawn);

}  // namespace goishi::verify
