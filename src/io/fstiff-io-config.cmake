# SPDX-License-Identifier: BSD-3-Clause
# find_package(fstiff COMPONENTS io), or find_package(fstiff-io): the target fstiff::io, with fstiff::fstiff behind it.
if(NOT TARGET fstiff::fstiff)
    include(CMakeFindDependencyMacro)
    find_dependency(fstiff ${fstiff-io_VERSION} EXACT)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/fstiff-io-targets.cmake")
