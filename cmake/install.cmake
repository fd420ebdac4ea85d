# SPDX-License-Identifier: BSD-3-Clause
# Component dev: headers, the licence, and the package files for find_package(fstiff). Component cli: the command and its
# scenes (src/cli). Read where FSTIFF_INSTALL is on.
include(CMakePackageConfigHelpers)

set(fstiff_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/fstiff)
install(TARGETS fstiff EXPORT fstiff-targets ${fstiff_file_sets})
install(EXPORT fstiff-targets NAMESPACE fstiff:: DESTINATION ${fstiff_package_dir} COMPONENT dev)
configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/fstiff-config.cmake.in ${PROJECT_BINARY_DIR}/fstiff-config.cmake
    INSTALL_DESTINATION ${fstiff_package_dir})
write_basic_package_version_file(
    ${PROJECT_BINARY_DIR}/fstiff-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(
    FILES ${PROJECT_BINARY_DIR}/fstiff-config.cmake ${PROJECT_BINARY_DIR}/fstiff-config-version.cmake
          ${CMAKE_CURRENT_LIST_DIR}/fstiff-eigen.cmake ${CMAKE_CURRENT_LIST_DIR}/fstiff-x3p.cmake
          ${CMAKE_CURRENT_LIST_DIR}/fstiff-zlib.cmake
    DESTINATION ${fstiff_package_dir}
    COMPONENT dev)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/fstiff COMPONENT dev)
