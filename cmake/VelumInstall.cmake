# The library, its headers under include/velum/, and a package that find_package(velum) finds.
include(CMakePackageConfigHelpers)

set(velum_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/velum)

install(TARGETS velum EXPORT velum-targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/velum FILES_MATCHING PATTERN "*.hpp"
  PATTERN "simd_dispatch.hpp" EXCLUDE PATTERN "*-inl.hpp" EXCLUDE) # what needs Highway, which only velum is built with
install(EXPORT velum-targets NAMESPACE velum:: FILE velumTargets.cmake DESTINATION ${velum_package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/velumConfig.cmake.in ${PROJECT_BINARY_DIR}/velumConfig.cmake
  INSTALL_DESTINATION ${velum_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/velumConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/velumConfig.cmake ${PROJECT_BINARY_DIR}/velumConfigVersion.cmake DESTINATION ${velum_package_dir})
