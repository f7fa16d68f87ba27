#pragma once
/// \file
/// Simbody behind numbers alone: its headers are C++17, and do not compile as C++20.

#include <array>
#include <memory>

namespace goishi::verify::bench::rivals {

using Three = std::array<double, 3>;

/// Pose, velocity and angular velocity in W.
struct SimbodyState {
  Three p;
  std::array<double, 4> q;  // w, x, y, z
  Three v, w;
};

struct SimbodySetup {
  double mass;
  Three moments, gravity;
  double friction, sphere_radius, sphere_offset;
  SimbodyState start;
  double accuracy;
};

/// A stone that touches z = 0 with one cap: a sphere on a half-space, elastic after Hunt and Crossley.
class SimbodyBody {
 public:
  explicit SimbodyBody(const SimbodySetup& setup);
  SimbodyBody(const SimbodyBody&) = delete;
  SimbodyBody& operator=(const SimbodyBody&) = delete;
  ~SimbodyBody();
  void advance_to(double time);
  [[nodiscard]] SimbodyState state() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace goishi::verify::bench::rivals
