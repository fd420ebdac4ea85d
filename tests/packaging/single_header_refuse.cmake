# SPDX-License-Identifier: BSD-3-Clause
# tools/make_single_header.py, on a project of two headers: what it writes, and what it refuses.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/tools/make_single_header.py DESTINATION ${WORK}/tools)
file(COPY ${SOURCE}/LICENSE DESTINATION ${WORK})
set(head "// SPDX-License-Identifier: BSD-3-Clause\n#pragma once\n")
file(WRITE ${WORK}/include/fstiff/core/version.hpp "${head}#include <cmath>\n#define FSTIFF_VERSION_TEXT \"1.2.3\"\n")

# header(text): what the script makes of a header of this text; error holds its message, empty without one.
function(header text)
    file(WRITE ${WORK}/include/fstiff/fstiff.hpp "${text}")
    execute_process(COMMAND ${PYTHON} ${WORK}/tools/make_single_header.py fstiff/fstiff.hpp fstiff/core/version.hpp
                    OUTPUT_VARIABLE made ERROR_VARIABLE error)
    set(made "${made}" PARENT_SCOPE)
    set(error "${error}" PARENT_SCOPE)
endfunction()

header("${head}#include <fstiff/core/version.hpp>\n#include <cmath>\nint last;\n")
if(NOT made MATCHES "fstiff 1.2.3.*#include <cmath>\n#define FSTIFF_VERSION_TEXT \"1.2.3\"\n// ---- fstiff/fstiff.hpp\nint last;\n" OR error)
    message(FATAL_ERROR "made:\n${made}${error}")
endif()
function(refuses text expected)
    header("${text}")
    if(made OR NOT error MATCHES "${expected}")
        message(FATAL_ERROR "'${expected}' expected for\n${text}\nmade:\n${made}${error}")
    endif()
endfunction()
refuses("${head}#if ONE\n#include <fstiff/core/version.hpp>\n#endif\n" "stands under a condition")
refuses("${head}#include \"other.hpp\"\n" "must stand in angle brackets")
refuses("#pragma once\nint a;\n" "must begin with the licence line")
refuses("${head}#include <fstiff/core/absent.hpp>\n" "absent.hpp")
