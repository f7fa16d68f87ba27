# Headers that nearly every file of ours parses, parsed once for each set of flags. Not CLI11: what it defines at namespace
# scope is compiled into every file that sees it, 5 s of each.

set(GOISHI_PRECOMPILED
  <algorithm> <array> <chrono> <cmath> <cstdint> <functional> <limits> <memory> <numbers> <optional> <random> <string>
  <string_view> <tuple> <utility> <vector>
  <Eigen/Geometry>)

# Once std::string is precompiled, g++ 12 warns of its own operator+ where it optimizes fully (its bug 105651).
set(GOISHI_PRECOMPILED_WARNINGS "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-array-bounds>")

# goishi_precompile(TARGET HEADER...) makes them, with HEADER... besides; goishi_precompile(TARGET FROM OTHER) takes those of
# a target with the same flags.
function(goishi_precompile target)
  if(ARGV1 STREQUAL "FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${GOISHI_PRECOMPILED} ${ARGN})
  endif()
endfunction()
