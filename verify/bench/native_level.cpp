#include "verify/bench/native.hpp"

namespace goishi::verify::bench {

std::string_view native_level() {
#ifdef GOISHI_SIMD_LEVEL
  return GOISHI_SIMD_LEVEL;
#else
  return "";
#endif
}

bool can_run_native() {
#if !defined(GOISHI_SIMD_LEVEL)
  return true;
#elif defined(__GNUC__) && defined(__x86_64__)
  return __builtin_cpu_supports(GOISHI_SIMD_LEVEL) != 0;
#else
  return false;
#endif
}

}  // namespace goishi::verify::bench
