#pragma once
/// \file
/// Gaps and times of impact, enclosed: found with 100 digits, proved by balls.
///
/// A gap lies between what one normal separates and how near two points are, whatever normal and points: with w the
/// difference of two points of convex bodies A and B, inf n·x over A less sup n·x over B is no more than n·w for any unit
/// normal n, hence no more than |w|. Of stones that is asked of the cores, and the bevels' radii are taken off.
///
/// Before a first touch some normal separates at each moment. Along a fixed normal the gap is an explicit function of time:
/// on an interval it is above its value in the middle less half the length times its greatest rate.

#include <optional>

#include "verify/oracles/numbers/ordered_ball.hpp"
#include "verify/reference/encounter.hpp"

namespace goishi::verify::reference {

/// The separation at a moment.
struct EnclosedGap {
  OrderedBall gap;
  /// Unit, out of the other body; the points that are met. None where the cores are so near that balls do not tell it to 30
  /// digits.
  struct Contact {
    Vec3<OrderedBall> n_W, p_stone, p_other;
  };
  std::optional<Contact> contact;
};

/// Throws std::runtime_error where it is not proved: cores that overlap.
[[nodiscard]] EnclosedGap enclosed_gap(const Encounter& encounter, const OrderedBall& time);

/// When they first touch; nothing if they do not until the horizon.
/// Domain  apart at the start; a touch that is no grazing, of a stone with a bevel where it does not meet a plane. Throws
///         std::runtime_error where it is not proved.
[[nodiscard]] std::optional<OrderedBall> enclosed_touch(const Encounter& encounter);

}  // namespace goishi::verify::reference
