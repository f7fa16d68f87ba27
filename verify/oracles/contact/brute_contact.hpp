#pragma once
/// \file
/// The greatest separation of a stone and another body, by search over the normals: samples, golden sections,
/// simplexes.

#include "verify/oracles/stone/hull.hpp"

namespace goishi::verify {

/// A stone that stands at p with its axis along the unit vector u.
struct Standing {
  Hull<long double> hull;
  Triple<long double> p;
  Triple<long double> u;
};

/// inf n · x over the stone, n a unit vector.
[[nodiscard]] long double nearest_along(const Standing& stone, const Triple<long double>& n);

struct Best {
  long double value;      // of the separation: a lower bound of the greatest
  Triple<long double> n;  // where
};

/// The greatest separation of a stone and the infinitely deep board |x| <= X, |y| <= Y, z <= 0, over its normals: five
/// faces, eight quarter circles, the hemisphere between; `density` samples a quarter circle.
[[nodiscard]] Best search_board(const Standing& stone, long double X, long double Y, int density);

/// The greatest separation of two stones over the whole sphere of normals.
[[nodiscard]] Best search_pair(const Standing& stone, const Standing& other, int density);

}  // namespace goishi::verify
