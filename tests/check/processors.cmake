# SPDX-License-Identifier: BSD-3-Clause
# Two files of one program that are compiled for different processors hand a law and a contact to each other: the one is
# compiled for any processor, the other for this one. Linked in both orders, because the linker keeps the first of two
# inline functions; not optimised, so that every one of them is left to the linker.
# COMPILER, INCLUDE: of fstiff, EIGEN, WORK.
cmake_minimum_required(VERSION 3.25)
set(native -march=native)

# macros(variable flag...): what the compiler defines with these flags.
function(macros variable)
    execute_process(COMMAND ${COMPILER} -std=c++20 ${ARGN} -dM -E -x c++ /dev/null
                    RESULT_VARIABLE result OUTPUT_VARIABLE found ERROR_QUIET)
    set(${variable} "${found}" PARENT_SCOPE)
    set(taken ${result} PARENT_SCOPE)
endfunction()
macros(plain)
macros(own ${native})
if(NOT taken EQUAL 0)
    message("SKIPPED: the compiler does not take ${native}")
    return()
elseif(plain STREQUAL own)
    message("SKIPPED: ${native} is what the compiler assumes without it")
    return()
endif()

file(MAKE_DIRECTORY ${WORK})
# object(name flag...): of processors/<name>.cpp. Warnings that hosts turn on are errors in the headers.
function(object name)
    execute_process(COMMAND ${COMPILER} -std=c++20 ${ARGN} -Wconversion -Wsign-conversion
                            -Wdouble-promotion -Werror -I${INCLUDE} -isystem ${EIGEN} -c
                            ${CMAKE_CURRENT_LIST_DIR}/processors/${name}.cpp -o ${WORK}/${name}.o
                    COMMAND_ERROR_IS_FATAL ANY)
endfunction()
object(make)
object(use ${native})
foreach(order IN ITEMS "make.o;use.o" "use.o;make.o")
    execute_process(COMMAND ${COMPILER} ${order} -o program WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${WORK}/program RESULT_VARIABLE result ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        message(SEND_ERROR "linked as ${order}: ${result} ${said}")
    endif()
endforeach()
