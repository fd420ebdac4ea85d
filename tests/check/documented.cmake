# SPDX-License-Identifier: BSD-3-Clause
# Every type and every enumeration of the headers in SOURCE/include has a comment that DOXYGEN finds. With REFUSES a header
# without one is added, which must be reported.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/bare.hpp "#pragma once\n/// \\file\n/// Nothing.\nstruct Bare { int a; };\n")
set(input ${SOURCE}/include)
if(REFUSES)
    string(APPEND input " ${WORK}/bare.hpp")
endif()
file(WRITE ${WORK}/Doxyfile "INPUT = ${input}\n"
     "FILTER_PATTERNS = \"*.hpp=sed -E -f ${SOURCE}/cmake/headers.sed\"\n"
     "EXCLUDE_PATTERNS = */fstiff/double/*\nRECURSIVE = YES\nFILE_PATTERNS = *.hpp *.h\nOUTPUT_DIRECTORY = ${WORK}\nGENERATE_HTML = NO
GENERATE_LATEX = NO\nGENERATE_XML = YES\nEXCLUDE_SYMBOLS = *::detail *::detail::* *::parts *::parts::* *::math *::math::*\nQUIET = YES\nHAVE_DOT = NO\n")
execute_process(COMMAND ${DOXYGEN} ${WORK}/Doxyfile ERROR_VARIABLE warnings OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]*(Compound|enumeration)[^\n]* is not documented[^\n]*" bare "${warnings}")
list(FILTER bare EXCLUDE REGEX "ContactLaw::(At|Tangent)")  # named after the members that return them
if(bare)
    list(JOIN bare "\n" bare)
    message(FATAL_ERROR "${bare}")
endif()
