# SPDX-License-Identifier: BSD-3-Clause
# tools/check_layers.cmake on small trees in WORK: it accepts a good one, and names what is wrong with each bad one.
cmake_minimum_required(VERSION 3.25)
set(script ${CMAKE_CURRENT_LIST_DIR}/../../tools/check_layers.cmake)

set(ideas "| core/error | errors |\n| math/root | roots; and brackets |\n| io/text | text |\n")

# check(expected path text): the good tree with one more header; `expected` is "" or a part of the complaint.
function(check expected path text)
    file(REMOVE_RECURSE ${WORK})
    file(WRITE ${WORK}/include/fstiff/core/error.hpp "#include <string>\n")
    file(WRITE ${WORK}/include/fstiff/math/root.hpp "#include <Eigen/Core>\n#include <fstiff/core/error.hpp>\n")
    file(WRITE ${WORK}/include/fstiff/io/text.hpp "#include <fstiff/math/root.hpp>\n")
    file(WRITE ${WORK}/docs/architecture.md "before\n<!-- layers -->\n<!-- /layers -->\nafter; with a semicolon\n${ideas}")
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${WORK} -D UPDATE=ON -P ${script}
                    OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(WRITE ${WORK}/${path} "${text}")
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${WORK} -P ${script}
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE complaint)
    string(FIND "${complaint}" "${expected}" position)
    if(expected STREQUAL "" AND NOT result EQUAL 0)
        message(FATAL_ERROR "refused the good tree: ${complaint}")
    elseif(NOT expected STREQUAL "" AND (result EQUAL 0 OR position EQUAL -1))
        message(FATAL_ERROR "'${text}' in ${path}: '${expected}' expected, result ${result}: ${complaint}")
    endif()
endfunction()

check("" notes.txt "nothing that matters\n")
check("core may include only core" include/fstiff/core/error.hpp "#include <fstiff/math/root.hpp>\n")
check("profile may include only" include/fstiff/profile/a.hpp "#include <fstiff/topography/b.hpp>\n#include <x>\n")
check("<fstiff/core/none.hpp> does not exist" include/fstiff/math/root.hpp "#include <fstiff/core/none.hpp>\n")
check("must name the header in angle brackets" include/fstiff/math/root.hpp "#include \"../core/error.hpp\"\n")
check("only the standard library and Eigen" include/fstiff/math/root.hpp "#  include <gsl/gsl_math.h>\n")
check("only the standard library and Eigen" include/fstiff/math/root.hpp "#include <math.h>\n")
check("needs a threads library" include/fstiff/math/root.hpp "#include <mutex>\n")
check("must be ASCII" include/fstiff/math/root.hpp "// µm\n#include <Eigen/Core>\nauto unit = \"µm\";\n")
check("attributes of one compiler" include/fstiff/math/root.hpp "[[gnu::cold]] void refuse();\n")
check("must be <layer>/<name>.hpp" include/fstiff/misc/thing.hpp "\n")
check("fstiff.hpp does not list" include/fstiff/core/more.hpp "\n")
check("the layer table is old" include/fstiff/math/root.hpp "#include <vector>\n")
check("has no row '| core/more | what it is for |'" include/fstiff/core/more.hpp "\n")
check("has no row '| math/root | what it is for |'" docs/architecture.md
      "<!-- layers -->\n<!-- /layers -->\n| core/error | errors |\n| math/root |  |\n| core/error | math/root | x |\n")
check("must hold the lines" docs/architecture.md "no table\n")
check("" docs/more.md "[root](../include/fstiff/math/root.hpp), math/root `f`, io/text.hpp; docs/*.md, and/or, 1/2\n")
check("'math/none' does not exist" docs/more.md "| math/none | nothing |\n")
check("'tests/math/root_test.cpp' does not exist" docs/more.md "Test: tests/math/root_test.cpp.\n")
check("'include/fstiff/core/none.hpp' does not exist" README.md "in include/fstiff/core/none.hpp\n")
