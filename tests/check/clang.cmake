# SPDX-License-Identifier: BSD-3-Clause
# Clang finds nothing in the headers with the warnings that hosts turn on, whichever compiler builds the project.
# INCLUDE: of fstiff, EIGEN, WORK.
cmake_minimum_required(VERSION 3.25)
find_program(clang NAMES clang++ clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14)
if(NOT clang)
    message("SKIPPED: there is no clang++")
    return()
endif()
list(TRANSFORM EIGEN PREPEND -isystem)
set(compile ${clang} -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror -I${INCLUDE} ${EIGEN})

file(WRITE ${WORK}/headers.cpp "#include <fstiff/fstiff.hpp>\n#include <fstiff/io.hpp>\n#include <fstiff/double/contacts.hpp>\n")
file(WRITE ${WORK}/header.c "#include <fstiff.h>\n")
execute_process(COMMAND ${compile} -std=c++20 ${WORK}/headers.cpp COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${compile} -x c -std=c11 ${WORK}/header.c COMMAND_ERROR_IS_FATAL ANY)

file(WRITE ${WORK}/wrong.cpp "#include <cstddef>\nstd::size_t size(int count) { return count; }\n")
execute_process(COMMAND ${compile} -std=c++20 ${WORK}/wrong.cpp RESULT_VARIABLE result ERROR_QUIET)
if(result EQUAL 0)
    message(FATAL_ERROR "accepted a conversion that changes signs")
endif()
