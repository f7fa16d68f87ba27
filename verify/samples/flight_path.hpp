#pragma once
/// \file
/// Flying stones for the claims about the time of impact.

#include <goishi/contact/time_of_impact.hpp>
#include <string>

#include "verify/samples/pose.hpp"

namespace goishi::verify {

inline constexpr double earth_gravity = 9.80665;

/// Thrown from p with velocity v, turning about any direction with 0.1 to 1000 rad/s; every ninth not at all.
[[nodiscard]] FlightPath<double> draw_path(Context& context, const Vec3<double>& p, const Vec3<double>& v, int i);

/// The stone's pose at a time, in long double: a parabola, and a turn about k.
[[nodiscard]] Standing standing(const Hull<long double>& hull, const FlightPath<double>& path, long double t);

/// A pose whose axis is the path's at a time.
[[nodiscard]] Pose<double> pose_at(const FlightPath<double>& path, double t);

[[nodiscard]] std::string describe(const FlightPath<double>& path);

}  // namespace goishi::verify
