# SPDX-License-Identifier: BSD-3-Clause
# find_package(fstiff-c): the target fstiff::c, which needs neither Eigen nor a C++ compiler where it is shared.
include("${CMAKE_CURRENT_LIST_DIR}/fstiff-c-targets.cmake")
