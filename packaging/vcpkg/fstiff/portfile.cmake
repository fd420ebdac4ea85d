# SPDX-License-Identifier: BSD-3-Clause
# A port for an overlay: it builds the clone that it lies in.
#     vcpkg install fstiff --overlay-ports=<clone>/packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(
    OUT_FEATURE_OPTIONS options
    FEATURES io FSTIFF_BUILD_IO double FSTIFF_BUILD_DOUBLE c FSTIFF_BUILD_C command FSTIFF_BUILD_CLI)
if(NOT "c" IN_LIST FEATURES AND NOT "io" IN_LIST FEATURES AND NOT "double" IN_LIST FEATURES)
    set(VCPKG_BUILD_TYPE release)  # headers alone, and the command: nothing to link in debug builds
endif()
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" dynamic shared)
vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS ${options} -DFSTIFF_C_SHARED=${shared} -DFSTIFF_BUILD_TESTS=OFF -DFSTIFF_BUILD_BENCH=OFF -DFSTIFF_INSTALL=ON
    MAYBE_UNUSED_VARIABLES FSTIFF_C_SHARED)
vcpkg_cmake_install()

vcpkg_cmake_config_fixup(PACKAGE_NAME fstiff CONFIG_PATH share/cmake/fstiff)
foreach(part IN ITEMS io double c)
    if("${part}" IN_LIST FEATURES)
        vcpkg_cmake_config_fixup(PACKAGE_NAME fstiff-${part} CONFIG_PATH lib/cmake/fstiff-${part})
    endif()
endforeach()
vcpkg_fixup_pkgconfig()
if("command" IN_LIST FEATURES)
    vcpkg_copy_tools(TOOL_NAMES fstiff AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
     "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/fstiff")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
