# SPDX-License-Identifier: BSD-3-Clause
# Every public header compiles after the macros that windows.h, complex.h and hosts define, without the warnings that hosts
# turn on; and a name that is such a macro is refused.
# COMPILER, INCLUDE: of fstiff, EIGEN, WORK, PARTS: whether with the files *_inline.hpp, whose functions instantiate everything.
cmake_minimum_required(VERSION 3.25)

file(WRITE ${WORK}/macros.hpp "// windef.h, minwindef.h, rpcndr.h, objbase.h, winnt.h, wingdi.h, winbase.h
#define near
#define far
#define small char
#define hyper __int64
#define interface struct
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define DELETE (0x00010000L)
#define ERROR 0
#define ABSOLUTE 1
#define RELATIVE 2
#define OPAQUE 2
#define TRANSPARENT 1
#define INFINITE 0xFFFFFFFF
// complex.h, and constants of hosts
#define I _Complex_I
#define E 2.718281828459045
#define G 6.6743e-11
")

# compile(before after): the headers \p before the macros and the text \p after them; sets result and error.
function(compile before after)
    file(WRITE ${WORK}/macros.cpp "${before}\n#include \"macros.hpp\"\n${after}\n")
    execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${definition} -Wall -Wextra -Wconversion -Wsign-conversion
                            -Wdouble-promotion -Werror -I${INCLUDE} -isystem ${EIGEN} ${WORK}/macros.cpp
                    RESULT_VARIABLE result ERROR_VARIABLE error)
    set(result ${result} PARENT_SCOPE)
    set(error "${error}" PARENT_SCOPE)
endfunction()

# Standard headers and those of other libraries come first, as they do with windows.h.
file(GLOB_RECURSE headers RELATIVE ${INCLUDE} ${INCLUDE}/*.hpp ${INCLUDE}/*.h)
set(definition "")
if(PARTS)
    list(FILTER headers EXCLUDE REGEX "/implementation\\.hpp$")  # the same parts for another file
else()
    list(FILTER headers EXCLUDE REGEX "_inline\\.hpp$")
    set(definition -DFSTIFF_COMPILED)  # declares what they define
endif()
set(others "")
set(own "")
foreach(header IN LISTS headers)
    string(APPEND own "#include <${header}>\n")
    file(STRINGS ${INCLUDE}/${header} lines REGEX "^#include <[^>]*>")
    list(FILTER lines EXCLUDE REGEX "<fstiff")
    list(APPEND others ${lines})
endforeach()
list(REMOVE_DUPLICATES others)
list(JOIN others "\n" others)
compile("${others}" "${own}")
if(NOT result EQUAL 0)
    message(SEND_ERROR "${error}")
endif()

compile("#include <algorithm>\n#include <limits>" "inline int right(int a) { return (std::max)(a, (std::numeric_limits<int>::min)()); }")
if(NOT result EQUAL 0)
    message(SEND_ERROR "refused: ${error}")
endif()
foreach(wrong IN ITEMS "return std::max(a, 1);" "return a + std::numeric_limits<int>::min();" "int near = a; return near;"
                       "int far = a; return far;" "int small = a; return small;" "const int E = a; return E;"
                       "const int G = a; return G;")
    set(before "")
    if(wrong MATCHES "std::")
        set(before "#include <algorithm>\n#include <limits>")
    endif()
    compile("${before}" "inline int wrong(int a) { ${wrong} }")
    if(result EQUAL 0)
        message(SEND_ERROR "accepted: ${wrong}")
    endif()
endforeach()
