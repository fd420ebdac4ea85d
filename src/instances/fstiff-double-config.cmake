# SPDX-License-Identifier: BSD-3-Clause
# find_package(fstiff COMPONENTS double), or find_package(fstiff-double): the target fstiff::double over fstiff::fstiff.
if(NOT TARGET fstiff::fstiff)
    include(CMakeFindDependencyMacro)
    find_dependency(fstiff ${fstiff-double_VERSION} EXACT)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/fstiff-double-targets.cmake")
