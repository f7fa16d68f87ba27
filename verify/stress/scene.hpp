#pragma once
/// \file
/// Drops for the stress test: any stone, pose, spin, law and material, with the awkward ones on purpose.

#include <cstdint>
#include <optional>
#include <string>

#include "compiled/drop.hpp"

namespace goishi::verify::stress {

struct Scene {
  Stone<double> stone;
  RigidBody<double> body;
  State<double> start;
  std::optional<Board<double>> board;  // else the plane z = 0
  DropSettings<double> settings;       // every one set
  bool physical = true;                // δ, κ <= w/4: here giving up is a fault
};

/// The scene of a number: the same for a seed and an index, whatever else runs.
///
/// Stones  ordinary, thin to h/w = 1e-4, nearly round, balls; sharp, and with bevels from 1e-6 of the height up. Most are
///         22 mm wide; some are smaller or larger, from 1e-6 to 1e4 times, and the board, the starts and the times with them.
/// Starts  in the air, touching, at rest, flat, on the rim; over the surface, its edges and corners, beside the board;
///         some with the centre exactly over an edge.
/// Spins   none, about the axis, any up to 100 rad/s, by decades up to 1000 rad/s.
/// Laws    every law of impact and friction; e and μ over their whole ranges with 0, 1, nearly 1, infinity; resistance
///         none, of one kind, of both, from 1e-7 of the width to a quarter, seldom to a half; slopes, no gravity; damping;
///         tolerances 1e-9 … 1e-4.
/// Most run to rest, with the usual horizon; what nothing brings there is followed for a while.
[[nodiscard]] Scene draw_scene(std::uint64_t seed, std::uint64_t index);

/// The same stone, law and numbers, on the floor, on the way to a place where the board stands, or past its corners.
[[nodiscard]] Scene draw_floor_scene(std::uint64_t seed, std::uint64_t index);

[[nodiscard]] DropResult<double> run(const Scene& scene);

/// What was drawn, in a line.
[[nodiscard]] std::string describe(const Scene& scene);

}  // namespace goishi::verify::stress
