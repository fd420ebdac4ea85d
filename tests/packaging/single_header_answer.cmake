# SPDX-License-Identifier: BSD-3-Clause
# README's program with the one header in place of its includes of fstiff, of which it has the functions of the answer.
cmake_minimum_required(VERSION 3.25)
file(READ ${SOURCE}/README.md page)
string(REGEX MATCH "\n```cpp\n([^`]*)" page "${page}")
string(REGEX REPLACE "#include <fstiff/[^\n]*\n" "" program "${CMAKE_MATCH_1}")
file(WRITE ${WORK}/program.cpp "#define FSTIFF_IMPLEMENTATION\n#include \"${HEADER}\"\n${program}")
execute_process(COMMAND ${COMPILER} -std=c++20 -O0 -isystem ${EIGEN} ${WORK}/program.cpp -o ${WORK}/program
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/program OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
string(STRIP "${printed}" printed)
file(READ ${SOURCE}/README.md page)
string(FIND "${page}" "\n${printed}\n" place)
if(NOT printed MATCHES "^K/A0 = " OR place EQUAL -1)
    message(FATAL_ERROR "README.md does not show ${printed}")
endif()
