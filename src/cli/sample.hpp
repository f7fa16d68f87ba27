#pragma once
/// \file
/// What `goishi drop` and `goishi scene` print of a stone's state and of what happens to it, for programs.

#include <goishi/board/board.hpp>
#include <goishi/drop/events.hpp>
#include <goishi/motion/state.hpp>
#include <string>
#include <string_view>

namespace goishi::cli {

class JsonText;

struct Sample {
  double time = 0;  // [s]
  State<double> state;
  Vec3<double> w_WB_B;  // [rad/s]
  double tilt = 0;      // [°] of the symmetry axis from the vertical, 0 … 180: a stone turned over lies at 180
  double energy = 0;    // [J] zero at the height of the surface
};

[[nodiscard]] Sample sample_of(double time, const State<double>& state, const RigidBody<double>& body,
                               const Vec3<double>& gravity);

/// The names of what `append_cells` appends, with commas between them.
inline constexpr std::string_view sample_columns =
    "position_x_m,position_y_m,position_z_m,attitude_w,attitude_x,attitude_y,attitude_z,"
    "velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,spin_body_x_rad_s,spin_body_y_rad_s,spin_body_z_rad_s,"
    "height_m,tilt_deg,energy_J";

/// Appends the cells of a row of CSV, but for the time, each with a comma before it.
void append_cells(std::string& text, const Sample& sample);

/// The members of a state: position, attitude, velocity, spin_body, energy.
void write_sample(JsonText& json, const Sample& sample);

/// The members of an event; `touched` names what it touches, if it touches anything.
void write_event(JsonText& json, const Event<double>& event, const RigidBody<double>& body, const Vec3<double>& gravity,
                 std::string_view touched);

/// Whether what an event touches is the floor, and not the board.
[[nodiscard]] bool is_on_floor(const Board<double>& board, const Vec3<double>& contact_W, OtherFeature feature);

}  // namespace goishi::cli
