# SPDX-License-Identifier: BSD-3-Clause
# What is installed, by component; read where FSTIFF_INSTALL is on.
#     dev    headers of C++, the licence, the package files for find_package(fstiff) and pkg-config fstiff (here)
#     cli    the command and its scenes (src/cli)
#     io     the readers and writers of files, with their headers and package files (src/io)
#     double the templates in double, compiled (src/instances)
#     c      the C interface with its header, its package files and the Fortran module (src/c)
include(CMakePackageConfigHelpers)

set(fstiff_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/fstiff)
# The folder is given too: find_package() accepts sets of headers from CMake 3.23 on.
install(TARGETS fstiff EXPORT fstiff-targets ${fstiff_file_sets} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT fstiff-targets NAMESPACE fstiff:: DESTINATION ${fstiff_package_dir} COMPONENT dev)
configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/fstiff-config.cmake.in ${PROJECT_BINARY_DIR}/fstiff-config.cmake
    INSTALL_DESTINATION ${fstiff_package_dir})
write_basic_package_version_file(
    ${PROJECT_BINARY_DIR}/fstiff-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(
    FILES ${PROJECT_BINARY_DIR}/fstiff-config.cmake ${PROJECT_BINARY_DIR}/fstiff-config-version.cmake
          ${CMAKE_CURRENT_LIST_DIR}/fstiff-eigen.cmake ${CMAKE_CURRENT_LIST_DIR}/fstiff-implementation.cmake
          ${CMAKE_CURRENT_LIST_DIR}/fstiff-implementation.cpp
    DESTINATION ${fstiff_package_dir}
    COMPONENT dev)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/fstiff COMPONENT dev)

# For pkg-config, in a folder for files of any processor. It finds the headers relative to its own place.
set(fstiff_pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
file(RELATIVE_PATH fstiff_pc_prefix ${CMAKE_INSTALL_PREFIX}/${fstiff_pc_dir} ${CMAKE_INSTALL_PREFIX})
configure_file(${CMAKE_CURRENT_LIST_DIR}/fstiff.pc.in ${PROJECT_BINARY_DIR}/fstiff.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/fstiff.pc DESTINATION ${fstiff_pc_dir} COMPONENT dev)
