#pragma once
/// \file
/// The motion that `goishi spin` prints: exactly, with 50 digits, or in steps, in double.

#include <array>
#include <cstdint>
#include <goishi/motion/steppers.hpp>
#include <string_view>
#include <vector>

#include "number.hpp"

namespace goishi::cli {

/// How a body turns at time 0.
struct SpinStart {
  Moments<Number> moments;
  Quat<Number> q_WB;    // unit
  Vec3<Number> w_WB_B;  // [rad/s]
};

/// A printed number: its vector or scalar, its letter there, its unit.
struct SpinQuantity {
  std::string_view key;        // in JSON and CSV
  std::string_view component;  // of a vector; empty: a scalar
  std::string_view name;
  std::string_view symbol;
  std::string_view unit;
  std::string_view unit_key;
};

inline constexpr std::array<SpinQuantity, 11> spin_quantities = {{
    {"attitude", "w", "attitude", "q_w", "", ""},
    {"attitude", "x", "", "q_x", "", ""},
    {"attitude", "y", "", "q_y", "", ""},
    {"attitude", "z", "", "q_z", "", ""},
    {"spin_body", "x", "spin in the body", "ω_x", "rad/s", "rad_s"},
    {"spin_body", "y", "", "ω_y", "rad/s", "rad_s"},
    {"spin_body", "z", "", "ω_z", "rad/s", "rad_s"},
    {"angular_momentum", "x", "angular momentum", "L_x", "kg m²/s", "kg_m2_s"},
    {"angular_momentum", "y", "in the world", "L_y", "kg m²/s", "kg_m2_s"},
    {"angular_momentum", "z", "", "L_z", "kg m²/s", "kg_m2_s"},
    {"energy", "", "energy of rotation", "E", "J", "J"},
}};

/// The values of `spin_quantities` at one time.
struct SpinSample {
  Number time;
  std::array<Number, spin_quantities.size()> values;
};

/// One sample for each time that was asked for. If stepping broke down, the last one is of the last good step instead.
struct SpinMotion {
  std::vector<SpinSample> samples;
  StepStatus status = StepStatus::completed;
  Number step = 0;  // the step taken; 0: none
};

/// The turn, in rad, that 50 digits are enough for.
inline constexpr std::string_view largest_turn = "1e20";

/// A component that is below this part of its vector, of which the round-off is up to 5e-30, is printed as 0.
inline constexpr std::string_view least_part = "1e-28";

/// How many steps a motion may take.
inline constexpr std::int64_t most_steps = 100'000'000;

/// The methods that take steps need moments and a spin of magnitudes from 1e-100 to 1e100 in SI units (`to_double`).
inline constexpr int stepped_order = 100;

/// By the closed form. A component c of a unit vector is right in all of 17 digits if c > 1e-12, or c > 1e-31 (1 + the
/// turn in rad).
/// Domain  a body turns by less than `largest_turn`, else InvalidArgument.
[[nodiscard]] SpinMotion turn_exactly(const SpinStart& start, const std::vector<Number>& times);

/// By a scheme of goishi::Stepper, in double: equal steps, none longer than `step`, from each time to the next.
/// Domain  times from 0 evenly upwards (or the end alone); step > 0; at most `most_steps` steps; numbers that
///         `to_double` takes; else InvalidArgument.
[[nodiscard]] SpinMotion turn_in_steps(const SpinStart& start, const std::vector<Number>& times, Scheme scheme,
                                       const Number& step);

}  // namespace goishi::cli
