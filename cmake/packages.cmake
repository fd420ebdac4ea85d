# SPDX-License-Identifier: BSD-3-Clause
# Packages by cpack, in the build folder after the build:
#     cpack -G DEB    fstiff (component cli), libfstiff-dev (dev) and libfstiff-c (c), each with what it depends on
#     cpack -G TGZ    one archive of these components
#     cpack --config CPackSourceConfig.cmake    the sources, without the build folder
set(CPACK_PACKAGE_VENDOR "the fstiff authors")
set(CPACK_PACKAGE_CONTACT "the fstiff authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/packages-by-generator.cmake)
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL dev)
if(TARGET fstiff_cli)
    list(APPEND CPACK_COMPONENTS_ALL cli)
endif()
if(TARGET fstiff_c)
    list(APPEND CPACK_COMPONENTS_ALL c)
endif()
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers of C++20, and the files that CMake and pkg-config find them by.")
set(CPACK_COMPONENT_CLI_DESCRIPTION "The command fstiff, and scenes to begin with.")
set(CPACK_COMPONENT_C_DESCRIPTION "The C interface with its header, and the Fortran module.")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libfstiff-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_CLI_PACKAGE_NAME fstiff)
set(CPACK_DEBIAN_CLI_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_C_PACKAGE_NAME libfstiff-c)
set(CPACK_DEBIAN_C_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_C_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(CPACK_SOURCE_GENERATOR TGZ)
string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" fstiff_source_pattern "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${fstiff_source_pattern}/build/;^${fstiff_source_pattern}/\\.git;__pycache__")
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
