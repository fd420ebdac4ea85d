# SPDX-License-Identifier: BSD-3-Clause
# Fails where PROGRAM with its ARGUMENTS ends with an error or prints anything else than the file EXPECTED.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
file(READ ${EXPECTED} expected)
if(NOT status EQUAL 0 OR NOT printed STREQUAL expected)
    message(FATAL_ERROR "exit code ${status}; printed:\n${printed}\nexpected:\n${expected}")
endif()
