# What a report says about the program that wrote it: target goishi_build_info, header <build_info.hpp>.
# The file is also the script that writes the header, once per build; it touches the header only when its text changes.

if(CMAKE_SCRIPT_MODE_FILE)
  set(commit "unknown")
  if(GIT AND EXISTS "${SOURCE_DIR}/.git")
    execute_process(COMMAND "${GIT}" rev-parse --verify HEAD WORKING_DIRECTORY "${SOURCE_DIR}"
      OUTPUT_VARIABLE head RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      execute_process(COMMAND "${GIT}" --no-optional-locks status --porcelain WORKING_DIRECTORY "${SOURCE_DIR}"
        OUTPUT_VARIABLE changes ERROR_QUIET)
      set(commit "${head}")
      if(changes)
        string(APPEND commit "-dirty")
      endif()
    endif()
  endif()
  file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
#pragma once

#include <string_view>

namespace goishi::build_info {

inline constexpr std::string_view version = R"(@VERSION@)";
inline constexpr std::string_view commit = R"(@commit@)";
inline constexpr std::string_view compiler = R"(@COMPILER@)";
inline constexpr std::string_view build_type = R"(@BUILD_TYPE@)";
inline constexpr std::string_view flags = R"(@FLAGS@)";

}  // namespace goishi::build_info
]])
  return()
endif()

find_package(Git QUIET)
string(TOUPPER "${CMAKE_BUILD_TYPE}" config)
string(JOIN " " flags ${CMAKE_CXX20_STANDARD_COMPILE_OPTION} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${config}} ${GOISHI_COMPILE_OPTIONS})
set(generated "${PROJECT_BINARY_DIR}/generated")

add_custom_target(goishi_build_info_header
  COMMAND "${CMAKE_COMMAND}"
    "-DGIT=${GIT_EXECUTABLE}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DOUTPUT=${generated}/build_info.hpp"
    "-DVERSION=${PROJECT_VERSION}" "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}" "-DFLAGS=${flags} $<JOIN:$<TARGET_PROPERTY:goishi,INTERFACE_COMPILE_OPTIONS>, >"
    -P "${CMAKE_CURRENT_LIST_FILE}"
  BYPRODUCTS "${generated}/build_info.hpp"
  COMMENT "Stamping the commit"
  VERBATIM)

add_library(goishi_build_info INTERFACE)
target_include_directories(goishi_build_info INTERFACE "${generated}")
add_dependencies(goishi_build_info goishi_build_info_header)
