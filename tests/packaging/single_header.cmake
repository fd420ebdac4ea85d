# SPDX-License-Identifier: BSD-3-Clause
# The programs ONE and APART print the same, and HEADER has one licence line and each of its includes once, none of fstiff.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${ONE} OUTPUT_VARIABLE one COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${APART} OUTPUT_VARIABLE apart COMMAND_ERROR_IS_FATAL ANY)
if(NOT one STREQUAL apart OR NOT one MATCHES "another file 0x1")
    message(FATAL_ERROR "with one header\n${one}\nand with the headers apart\n${apart}")
endif()
file(STRINGS ${HEADER} licences REGEX "SPDX-License-Identifier")
file(STRINGS ${HEADER} includes REGEX "^ *# *include")
set(once ${includes})
list(REMOVE_DUPLICATES once)
list(LENGTH licences licence_lines)
if(NOT licence_lines EQUAL 1 OR NOT includes STREQUAL once OR includes MATCHES "fstiff/")
    message(FATAL_ERROR "${HEADER}: ${licence_lines} licence lines, includes ${includes}")
endif()

# The one source includes the one header, and no other header of fstiff.
file(STRINGS ${SOURCE_OF_IO} licences REGEX "SPDX-License-Identifier")
file(STRINGS ${SOURCE_OF_IO} includes REGEX "^ *# *include [^<]")
list(LENGTH licences licence_lines)
if(NOT licence_lines EQUAL 1 OR NOT includes STREQUAL "#include \"fstiff.hpp\"")
    message(FATAL_ERROR "${SOURCE_OF_IO}: ${licence_lines} licence lines, includes ${includes}")
endif()
