#pragma once
/// \file
/// What the printed numbers are held against: enclosures from the rigorous integral of a stone's meridian. No formula
/// of src/, only the catalogue's decimal dimensions, as exact fractions.

#include <array>
#include <goishi/shape/catalogue.hpp>
#include <string_view>

#include "verify/oracles/drop/spin.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/oracles/stone/rigorous_integral.hpp"

namespace goishi::verify::certify {

/// A quantity of a stone in SI units, by the name that it has in inertia_table.hpp and in the program's JSON.
struct Quantity {
  std::string_view key;
  Ball exact;
};

using StoneWitness = std::array<Quantity, 12>;

/// The catalogue's stone with a bevel of whole micrometres, 0: sharp.
[[nodiscard]] StoneWitness witness_of(const CatalogueStone& entry, int bevel);

/// The sharp stone that spins on its cap, enclosed.
[[nodiscard]] SpinningCap<Ball> spinning_cap(const CatalogueStone& entry, const Ball& gravity);

/// The tilt where it settles from a flat spin   [°]. A sign change between the ends of the enclosure proves that a solution
/// lies there; that the stone goes to it is for DROP-8. Throws std::runtime_error if the spin is not above the threshold.
[[nodiscard]] Ball settling_tilt(const SpinningCap<Ball>& stone, const Ball& spin);

}  // namespace goishi::verify::certify
