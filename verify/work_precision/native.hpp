#pragma once
/// \file
/// `StoneBatch` and `PlaneBatch` compiled for a level of x86-64 that the build machine has (CMake variable
/// GOISHI_SIMD_LEVEL), in a library of its own that shows nothing but these functions: neither alignment nor
/// instructions of that level leak into the rest of the program. Only numbers pass.

#include <cstddef>
#include <string_view>

#if defined(__GNUC__)
#define GOISHI_NATIVE_API extern "C" __attribute__((visibility("default")))
#else
#define GOISHI_NATIVE_API extern "C"
#endif

/// A flock of flying stones. Opaque.
struct goishi_native_flock;

/// `position` to `momentum`: 3, 4 (w, x, y, z), 3 and 3 numbers for each stone, 13 in a row; `moments`: axial, transverse
/// for each.
GOISHI_NATIVE_API goishi_native_flock* goishi_native_make(std::size_t count, const double* states,
                                                          const double* moments);
GOISHI_NATIVE_API void goishi_native_fly(goishi_native_flock* flock, double gravity, double time);
/// Back into 13 numbers for each stone.
GOISHI_NATIVE_API void goishi_native_get(const goishi_native_flock* flock, double* states);
GOISHI_NATIVE_API void goishi_native_free(goishi_native_flock* flock);
GOISHI_NATIVE_API std::size_t goishi_native_lanes();

/// Many stones near a plane. Opaque.
struct goishi_native_resting;

/// Width, height and bevel, position and attitude (w, x, y, z): 10 numbers in a row for each.
GOISHI_NATIVE_API goishi_native_resting* goishi_native_resting_make(std::size_t count, const double* stones);
/// To the playing surface z = 0.
GOISHI_NATIVE_API void goishi_native_resting_gaps(const goishi_native_resting* stones, double* gaps);
GOISHI_NATIVE_API void goishi_native_resting_free(goishi_native_resting* stones);

namespace goishi::verify::bench {

/// "x86-64-v4", or "" where the compiler's default is used.
[[nodiscard]] std::string_view native_level();
/// Whether this processor has what the library was compiled for. Nothing else may be called when it has not.
[[nodiscard]] bool can_run_native();

}  // namespace goishi::verify::bench
