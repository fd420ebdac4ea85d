# SPDX-License-Identifier: BSD-3-Clause
# A program links fstiff::double with the definitions of its target, for a processor with AVX2 and by AddressSanitizer, and
# with the flags OTHER, all of which align arrays of Eigen in a way of their own otherwise: it ends well and prints the same
# numbers. Without the definitions it does not link, and the message names what is missing.
# COMPILER, INCLUDE: of fstiff, EIGEN, LIBRARY, DEFINITIONS, WORK, OTHER: one more set of flags.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" DEFINITIONS ${DEFINITIONS})
list(TRANSFORM DEFINITIONS PREPEND -D)
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/supported.cpp "int main() { return 0; }\n")

# build(name source flag...): a program; result and message.
function(build name source)
    execute_process(COMMAND ${COMPILER} -std=c++20 ${ARGN} -I${INCLUDE} -isystem ${EIGEN} ${source} ${LIBRARY}
                            -o ${WORK}/${name}
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    set(result ${result} PARENT_SCOPE)
    set(message "${message}" PARENT_SCOPE)
endfunction()

# run(variable name flag...): what the program of processors/map.cpp prints; empty where compiler or processor does not have the flags.
function(run variable name)
    set(${variable} "" PARENT_SCOPE)
    execute_process(COMMAND ${COMPILER} ${ARGN} ${WORK}/supported.cpp -o ${WORK}/supported
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
    if(NOT result EQUAL 0 OR ("-mavx2" IN_LIST ARGN AND NOT cpu MATCHES " avx2 "))
        message("not to be had here: ${ARGN}")
        return()
    endif()
    build(${name} ${CMAKE_CURRENT_LIST_DIR}/processors/map.cpp ${DEFINITIONS} ${ARGN})
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN}: ${message}")
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${WORK}/${name}
                    RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE message)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN}: ends with ${result}: ${message}")
    endif()
    set(${variable} "${printed}" PARENT_SCOPE)
endfunction()

set(cpu "")
if(EXISTS /proc/cpuinfo)
    file(READ /proc/cpuinfo cpu LIMIT 8000)
endif()
run(expected plain)
set(number 1)
foreach(flags IN ITEMS "-mavx2;-fsanitize=address" ${OTHER})
    run(printed with_${number} ${flags})
    math(EXPR number "${number} + 1")
    if(printed AND NOT printed STREQUAL expected)
        message(SEND_ERROR "${flags}: prints ${printed}, without the flags ${expected}")
    endif()
endforeach()

if(NOT DEFINITIONS MATCHES "EIGEN_MAX_ALIGN_BYTES")
    message("SKIPPED: fstiff::double was built as Eigen chooses")
    return()
endif()
file(WRITE ${WORK}/refused_of_answer.cpp "#include <fstiff/answer.hpp>\nint main() { return 0; }\n")
file(WRITE ${WORK}/refused.cpp "#include <fstiff/double/integrals.hpp>\nint main() { return 0; }\n")
build(refused_of_answer ${WORK}/refused_of_answer.cpp -DFSTIFF_COMPILED)
if(result EQUAL 0)
    message(SEND_ERROR "fstiff/answer.hpp links without the alignment")
endif()
foreach(definitions IN ITEMS "-DFSTIFF_COMPILED" "-DFSTIFF_COMPILED;-DEIGEN_MAX_ALIGN_BYTES=32"
                             "-DFSTIFF_COMPILED;-DEIGEN_MAX_ALIGN_BYTES=64;-DEIGEN_MAX_STATIC_ALIGN_BYTES=32" "-DEIGEN_DONT_ALIGN")
    build(refused ${WORK}/refused.cpp ${definitions})
    if(result EQUAL 0 OR NOT message MATCHES "fstiff_double_has_another_EIGEN_MAX_ALIGN_BYTES_than")
        message(SEND_ERROR "${definitions}: ends with ${result}: ${message}")
    endif()
endforeach()
