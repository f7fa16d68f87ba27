#pragma once
/// \file
/// Witness for a bevelled stone: its dimensions from its torus, by tangency alone.

#include "algebra.hpp"

namespace derivation {

/// A bevelled stone from its torus: r₁, r₂ and the angle α of the joint's normal, all else by tangency. In τ > 0, with
/// tan(α/2) = 1/(1 + τ), every quantity is a rational function with positive coefficients: cos α = τ(τ + 2)/n,
/// sin α = 2(τ + 1)/n, n = 1 + (1 + τ)².
struct Torus {
  possymbol major = possymbol("r1", "r_1");
  possymbol minor = possymbol("r2", "r_2");
  possymbol tau = possymbol("tau", "\\tau");
  ex norm = 1 + pow(1 + tau, 2);
  Angle joint = {possymbol("alpha", "\\alpha"), tau*(tau + 2) / norm, 2 * (tau + 1) / norm};
  ex joint_radius = major + minor * joint.cosine;
  ex offset = major * joint.sine / joint.cosine;        // d: the joint's normal meets the axis at (0, −d)
  ex sphere_radius = minor + major / joint.cosine;      // r: from there to the joint
  ex height = (2 * (sphere_radius - offset)).normal();  // h: the pole stands at r − d
  ex bevel = 2 * minor * joint.sine;                    // b: the joint stands at b/2
  ex core_radius = major / joint.cosine;
};

}  // namespace derivation
