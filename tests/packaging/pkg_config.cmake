# SPDX-License-Identifier: BSD-3-Clause
# Builds the consumers of ../consumer with the flags that pkg-config prints for fstiff, which was installed elsewhere and moved to PREFIX.
cmake_minimum_required(VERSION 3.25)
if(NOT PKG_CONFIG)
    message("SKIPPED: there is no pkg-config")
    return()
endif()
file(MAKE_DIRECTORY ${WORK})
file(GLOB_RECURSE of_io ${PREFIX}/lib*/fstiff-io.pc)
cmake_path(GET of_io PARENT_PATH folder_of_io)
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/share/pkgconfig:${folder_of_io})
execute_process(COMMAND ${PKG_CONFIG} --exists eigen3 RESULT_VARIABLE no_eigen)
if(no_eigen)
    message("SKIPPED: pkg-config does not know eigen3")
    return()
endif()
execute_process(COMMAND ${PKG_CONFIG} --modversion fstiff OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs fstiff OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
if(NOT version STREQUAL VERSION OR NOT flags MATCHES "eigen3" OR flags MATCHES "-l")
    message(FATAL_ERROR "pkg-config says version ${version}, flags ${flags}")
endif()
separate_arguments(flags UNIX_COMMAND "${flags} ${FLAGS}")
execute_process(
    COMMAND ${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/../consumer/main.cpp -o ${WORK}/program ${flags}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/program COMMAND_ERROR_IS_FATAL ANY)

# The component io, with the libraries of packed files that it was built with.
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs fstiff-io OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${FLAGS}")
execute_process(
    COMMAND ${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/../consumer/reads.cpp -o ${WORK}/reads ${flags}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/reads COMMAND_ERROR_IS_FATAL ANY)
