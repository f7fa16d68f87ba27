#include "verify/work_precision/native.hpp"

namespace goishi::verify::bench {

std::string_view native_level() {
  return GOISHI_SIMD_LEVEL;
}

bool can_run_native() {
  if constexpr (sizeof(GOISHI_SIMD_LEVEL) == 1) {
    return true;
  } else {
#if defined(__GNUC__) && defined(__x86_64__)
    return __builtin_cpu_supports(GOISHI_SIMD_LEVEL) != 0;
#else
    return false;
#endif
  }
}

}  // namespace goishi::verify::bench
