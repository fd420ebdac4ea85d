# SPDX-License-Identifier: BSD-3-Clause
# Installs the components dev and double of BUILD to WORK: the package of CMake and that of pkg-config bring the DEFINITIONS
# of fstiff::double, and a program for the processor of this machine runs with them.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" DEFINITIONS ${DEFINITIONS})
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${prefix} ${WORK}/first)
foreach(component IN ITEMS dev double)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first --component ${component}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(RENAME ${WORK}/first ${prefix})  # it may be moved
file(GLOB_RECURSE targets ${prefix}/fstiff-double-targets.cmake)
file(READ ${targets} exported)
foreach(definition IN LISTS DEFINITIONS)
    if(NOT exported MATCHES "[\";]${definition}[\";]")
        message(SEND_ERROR "${definition} is not exported with the target: ${exported}")
    endif()
endforeach()

file(GLOB_RECURSE package ${prefix}/fstiff-double.pc)
cmake_path(GET package PARENT_PATH folder)
set(ENV{PKG_CONFIG_PATH} ${prefix}/share/pkgconfig:${folder})
if(PKG_CONFIG)
    execute_process(COMMAND ${PKG_CONFIG} --exists eigen3 RESULT_VARIABLE no_eigen)
endif()
if(NOT PKG_CONFIG OR no_eigen)
    message("SKIPPED: there is no pkg-config that finds eigen3")
    return()
endif()
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs fstiff-double OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${FLAGS}")
execute_process(COMMAND ${COMPILER} -march=native -fsyntax-only -x c++ /dev/null RESULT_VARIABLE no_native ERROR_QUIET)
if(NOT no_native)
    list(PREPEND flags -march=native)
endif()
execute_process(
    COMMAND ${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/../check/processors/map.cpp -o ${WORK}/program ${flags}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/program OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
