# SPDX-License-Identifier: BSD-3-Clause
# DOCUMENT shows SOURCE, without its first line, and then what PROGRAM prints.
cmake_minimum_required(VERSION 3.25)
file(READ ${SOURCE} code)
string(FIND "${code}" "\n" end)
math(EXPR end "${end} + 1")
string(SUBSTRING "${code}" ${end} -1 code)
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${DOCUMENT} text)
string(FIND "${text}" "```c\n${code}```\n\n```text\n${printed}```\n" found)
if(found EQUAL -1)
    message(FATAL_ERROR "${DOCUMENT} does not show ${SOURCE}, followed by its output\n${printed}")
endif()
