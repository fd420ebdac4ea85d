# SPDX-License-Identifier: BSD-3-Clause
# Installs the components dev and io of BUILD, moves them to PREFIX, and checks that they hold the headers of SOURCE, the
# library of io, licences and package files, nothing else; and that dev has no header of io. Whoever uses PREFIX then shows
# that what is installed may be moved.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}-first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}-first --component dev
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE of_io ${PREFIX}-first/*fstiff/io*)
if(of_io)
    message(FATAL_ERROR "installed with the headers: ${of_io}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}-first --component io
                COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}-first ${PREFIX})

file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/include/fstiff/*.hpp)
file(GLOB_RECURSE installed RELATIVE ${PREFIX} ${PREFIX}/*)
set(package ${installed})
list(REMOVE_ITEM package ${headers})
list(REMOVE_ITEM headers ${installed})
if(headers)
    message(FATAL_ERROR "not installed: ${headers}")
endif()
foreach(name IN ITEMS config config-version targets)
    if(NOT "share/cmake/fstiff/fstiff-${name}.cmake" IN_LIST package)
        message(FATAL_ERROR "fstiff-${name}.cmake is not installed")
    endif()
endforeach()
if(NOT "share/doc/fstiff/LICENSE" IN_LIST package)
    message(FATAL_ERROR "the licence is not installed")
endif()
if(NOT "share/pkgconfig/fstiff.pc" IN_LIST package)
    message(FATAL_ERROR "fstiff.pc is not installed")
endif()
foreach(name IN ITEMS config config-version targets)
    if(NOT package MATCHES "lib[^;]*/cmake/fstiff-io/fstiff-io-${name}\\.cmake")
        message(FATAL_ERROR "fstiff-io-${name}.cmake is not installed")
    endif()
endforeach()
list(FILTER package EXCLUDE REGEX
     "^lib[^;]*/(libfstiff_io\\.a|pkgconfig/fstiff-io\\.pc|cmake/fstiff-io/fstiff-io-[a-z-]+\\.cmake)$|^share/doc/fstiff-io/LICENSE$")
list(FILTER package EXCLUDE REGEX
     "^share/cmake/fstiff/fstiff-([a-z0-9-]+\\.cmake|implementation\\.cpp)$|^share/doc/fstiff/LICENSE$|^share/pkgconfig/fstiff\\.pc$")
if(package)
    message(FATAL_ERROR "installed beside the library: ${package}")
endif()
