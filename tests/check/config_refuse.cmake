# SPDX-License-Identifier: BSD-3-Clause
# core/config.hpp refuses what fstiff cannot work with, in one clear sentence that comes first, and takes the rest.
# COMPILER, INCLUDE: of fstiff, WORK.
cmake_minimum_required(VERSION 3.25)
file(WRITE ${WORK}/error.cpp "#include <fstiff/core/error.hpp>\nint main() {}\n")
file(WRITE ${WORK}/config.cpp "#include <fstiff/core/config.hpp>\nint main() {}\n")

# compile(expected flag...): expected is a part of the first error, "" when there must be none. Of config.hpp, or of FILE.
set(FILE config)
function(compile expected)
    execute_process(COMMAND ${COMPILER} -fsyntax-only -I${INCLUDE} ${ARGN} ${WORK}/${FILE}.cpp
                    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX MATCH "error: [^\n]*" first "${said}")
    if((expected STREQUAL "" AND NOT result EQUAL 0)
       OR (NOT expected STREQUAL "" AND (result EQUAL 0 OR NOT first MATCHES "${expected}")))
        message(SEND_ERROR "${ARGN}: '${expected}' expected, result ${result}: ${said}")
    endif()
endfunction()

foreach(FILE IN ITEMS error config)  # an error comes first from a header that includes it, too
    compile("" -std=c++20)
    compile("fstiff needs C\\+\\+20" -std=c++17)
endforeach()
compile("fstiff needs C\\+\\+20" -std=c++11)
foreach(flag IN ITEMS -ffast-math -Ofast -ffinite-math-only)
    compile("fstiff needs NaN" -std=c++20 ${flag})
endforeach()
compile("" -std=c++20 -ffast-math -fno-finite-math-only)
compile("" -std=c++20 -fassociative-math -fno-signed-zeros -fno-trapping-math)
compile("" -std=c++20 -freciprocal-math)

# The scalars are two, also where the compiler counts others among the floating-point numbers.
file(WRITE ${WORK}/scalars.cpp "#include <fstiff/core/numbers.hpp>
#if defined(__SIZEOF_FLOAT128__)
static_assert(!fstiff::Real<__float128>);
#endif
static_assert(fstiff::Real<float> && fstiff::Real<const double> && !fstiff::Real<long double>);
int main() {}
")
execute_process(COMMAND ${COMPILER} -std=gnu++20 -fsyntax-only -I${INCLUDE} ${WORK}/scalars.cpp
                RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 0)
    message(SEND_ERROR "${said}")
endif()

# The x87 unit, where the compiler can use it.
execute_process(COMMAND ${COMPILER} -std=c++20 -mfpmath=387 -dM -E -x c++ /dev/null
                RESULT_VARIABLE result OUTPUT_VARIABLE macros ERROR_QUIET)
if(result EQUAL 0 AND macros MATCHES "__FLT_EVAL_METHOD__ 2")
    compile("fstiff needs every operation rounded" -std=c++20 -mfpmath=387)
endif()
