#pragma once
/// \file
/// A proof that no normal separates two bodies by more than a number: branch and bound over all unit normals.
///
/// g(n) = inf n · x over the one body − sup n · x over the other is concave and homogeneous, so that g(n) <= w · n for all n,
/// w the difference of the two points that are met along any other normal. On a spherical triangle w · n is no more than
/// the greatest of its values at the corners, or, if that is positive, than that over the least length of a point of the
/// flat triangle. A triangle whose bound is above the number is divided; a corner above it is a counterexample.

#include "verify/oracles/contact/brute_contact.hpp"

namespace goishi::verify {

struct AllNormals {
  enum class Answer { none_better, better, too_many };
  Answer answer = Answer::too_many;
  Triple<double> n = {0.0, 0.0, 0.0};  // better: where
  double value = 0.0;                  // there
  int triangles = 0;
};

/// Whether some normal of the infinitely deep board |x| <= X, |y| <= Y, z <= 0 separates it and a stone by more than
/// `bound`. In double: to some round-off of the stone's place.
[[nodiscard]] AllNormals ask_all_normals(const Standing& stone, double X, double Y, double bound);

/// The same of two stones.
[[nodiscard]] AllNormals ask_all_normals(const Standing& stone, const Standing& other, double bound);

}  // namespace goishi::verify
