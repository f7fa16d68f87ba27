#pragma once
/// \file
/// What `goishi contact` answers: the separation with 50 digits, the time of impact in double.

// The search over an octant copies its signs, which are cheap but for a Number.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wrange-loop-construct"
#include <goishi/contact/time_of_impact.hpp>
#pragma GCC diagnostic pop
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "subject.hpp"

namespace goishi::cli {

enum class Against { board, plane, stone };

/// What was asked.
struct ContactQuestion {
  Subject subject;
  Stone<Number> stone;
  Pose<Number> pose;
  Against against = Against::board;
  Standard standard = Standard::talk;  // of the board
  int lines = BoardDimensions<Number>{}.lines;
  Pose<Number> other;  // of the other stone
  Vec3<Number> v_WB;   // if a horizon was given, these, too
  Vec3<Number> w_WB_B;
  Vec3<Number> L_W;          // per unit of density
  Number transverse_moment;  // likewise
  Number gravity;
  std::optional<Number> horizon;
  std::vector<std::string> notes;  // for people, on what was typed
};

struct ContactAnswer {
  Separation<Number> contact;
  std::optional<Region> region;                // against the board
  std::optional<TimeOfImpact<double>> impact;  // with a horizon
};

/// A number below this part of the lengths that it came from is round-off and becomes 0; a stone that only touches has
/// the gap 0.
inline constexpr std::string_view least_length = "1e-28";

/// The numbers of a flight other than 0 have magnitudes from 1e-20 to 1e20 in SI units (`to_double`).
inline constexpr int flight_order = 20;

/// InvalidArgument for a flight whose numbers are beyond those that a double computes with.
[[nodiscard]] ContactAnswer answer_to(const ContactQuestion& question);

}  // namespace goishi::cli
