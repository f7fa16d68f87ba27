# Headers, the program, the C interface, and the package behind find_package(goishi CONFIG).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/goishi")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/goishi" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.hpp")
install(TARGETS goishi EXPORT goishi_targets INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT goishi_targets NAMESPACE goishi:: FILE goishiTargets.cmake DESTINATION "${package_dir}")
if(GOISHI_BUILD_CLI)
  install(TARGETS goishi_cli RUNTIME)
endif()
if(GOISHI_BUILD_C)  # a component of the package: it is installed where it has been built
  install(TARGETS goishi_c EXPORT goishi_c_targets OPTIONAL
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    PUBLIC_HEADER DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(EXPORT goishi_c_targets NAMESPACE goishi:: FILE goishiC.cmake DESTINATION "${package_dir}")
endif()

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/goishiConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/generated/goishiConfig.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/generated/goishiConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  "${PROJECT_BINARY_DIR}/generated/goishiConfig.cmake"
  "${PROJECT_BINARY_DIR}/generated/goishiConfigVersion.cmake"
  DESTINATION "${package_dir}")
