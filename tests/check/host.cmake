# SPDX-License-Identifier: BSD-3-Clause
# A library that fetches fstiff SOURCE and exports its own target is installed, and found by a program with both. In WORK.
cmake_minimum_required(VERSION 3.25)
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()
file(REMOVE_RECURSE ${WORK})
set(project ${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer/host -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER})
run(${project} -B ${WORK}/host -D FSTIFF_FOLDER=${SOURCE})
run(${CMAKE_COMMAND} --install ${WORK}/host --prefix ${WORK}/prefix)
run(${project} -B ${WORK}/program -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/program)
run(${WORK}/program/program)
