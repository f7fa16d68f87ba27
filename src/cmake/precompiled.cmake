# Headers that nearly every file of ours parses, parsed once for each set of flags.

set(GOISHI_PRECOMPILED
  <algorithm> <array> <chrono> <cmath> <cstdint> <functional> <limits> <memory> <numbers> <optional> <random> <string>
  <string_view> <tuple> <utility> <vector>
  <Eigen/Geometry>)

# goishi_precompile(TARGET HEADER...) makes them, with HEADER... besides; goishi_precompile(TARGET FROM OTHER) takes those of
# a target with the same flags.
function(goishi_precompile target)
  if(ARGV1 STREQUAL "FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${GOISHI_PRECOMPILED} ${ARGN})
  endif()
endfunction()
