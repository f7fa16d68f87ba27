#pragma once
/// \file
/// What the printed numbers are held against: enclosures from the rigorous integral of a stone's meridian. No formula
/// of src/, only the catalogue's decimal dimensions, as exact fractions.

#include <array>
#include <goishi/shape/catalogue.hpp>
#include <string_view>

#include "verify/oracles/ball.hpp"
#include "verify/oracles/rigorous_integral.hpp"

namespace goishi::verify::certify {

/// A quantity of a stone in SI units, by the name that it has in inertia_table.hpp and in the program's JSON.
struct Quantity {
  std::string_view key;
  Ball exact;
};

using StoneWitness = std::array<Quantity, 12>;

/// The catalogue's stone with a bevel of whole micrometres, 0: sharp.
[[nodiscard]] StoneWitness witness_of(const CatalogueStone& entry, int bevel);

/// A stone that spins on its cap, per unit of mass: what tippe-top theory says of it, enclosed.
class SpinWitness {
 public:
  SpinWitness(const CatalogueStone& entry, const Ball& gravity);

  /// The least flat spin that makes it rise   [rad/s]: ω² = g d (1 − α)²/(I_t − I_a (1 − α)), α = d/r.
  [[nodiscard]] Ball threshold() const;
  /// The tilt where it settles from a flat spin   [°]: its cosine z solves g d D² = J² [I_t r² z + I_a r (d − r z)],
  /// D = I_t r² (1 − z²) + I_a (d − r z)², J = I_a ω (d − r). A sign change between the ends of the enclosure proves
  /// that a solution lies there; that the stone goes to it is for DROP-8.
  [[nodiscard]] Ball settling_tilt(const Ball& spin) const;

 private:
  Ball radius_, offset_, axial_, transverse_, gravity_;
};

}  // namespace goishi::verify::certify
