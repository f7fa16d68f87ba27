#pragma once
/// \file
/// `StoneBatch` and `PlaneBatch` compiled for a level of x86-64 that the build machine has (CMake variable
/// GOISHI_SIMD_LEVEL), in a library of its own that shows nothing but these functions: neither alignment nor
/// instructions of that level leak into the rest of the program. Only numbers pass.

#include <cstddef>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/state.hpp>
#include <string_view>

#if defined(__GNUC__)
#define GOISHI_NATIVE_API extern "C" __attribute__((visibility("default")))
#else
#define GOISHI_NATIVE_API extern "C"
#endif

struct goishi_native_stone {
  double width, height, bevel;
  double p_WB[3], q_WB[4], v_WB[3], L_W[3];  // the quaternion as w, x, y, z
};

/// Many stones, which fly, and whose gaps at the start are known. Opaque.
struct goishi_native_stones;

GOISHI_NATIVE_API goishi_native_stones* goishi_native_make(std::size_t count, const goishi_native_stone* stones);
GOISHI_NATIVE_API void goishi_native_free(goishi_native_stones* stones);
GOISHI_NATIVE_API void goishi_native_fly(goishi_native_stones* stones, double gravity, double time);
/// Where a stone has flown.
GOISHI_NATIVE_API void goishi_native_get(const goishi_native_stones* stones, std::size_t i, goishi_native_stone* stone);
/// From where they were made to the playing surface z = 0.
GOISHI_NATIVE_API void goishi_native_gaps(const goishi_native_stones* stones, double* gaps);
GOISHI_NATIVE_API std::size_t goishi_native_lanes();

namespace goishi::verify::bench {

[[nodiscard]] inline State<double> state_of(const goishi_native_stone& stone) {
  const auto& [width, height, bevel, p, q, v, L] = stone;
  return {.p_WB = {p[0], p[1], p[2]},
          .q_WB = {q[0], q[1], q[2], q[3]},
          .v_WB = {v[0], v[1], v[2]},
          .L_W = {L[0], L[1], L[2]}};
}

[[nodiscard]] inline goishi_native_stone numbers_of(const Stone<double>& stone, const State<double>& state) {
  const auto& [p, q, v, L] = state;
  return {stone.width,           stone.height,         stone.bevel, {p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()},
          {v.x(), v.y(), v.z()}, {L.x(), L.y(), L.z()}};
}

[[nodiscard]] inline Moments<double> moments_of(const goishi_native_stone& stone) {
  return mass_properties(make_stone(stone.width, stone.height, stone.bevel), Density{2800.0}).moments;
}

/// "x86-64-v4", or "" where the compiler's default is used.
[[nodiscard]] std::string_view native_level();
/// Whether this processor has what the library was compiled for. Nothing else may be called when it has not.
[[nodiscard]] bool can_run_native();

}  // namespace goishi::verify::bench
