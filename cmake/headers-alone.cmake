# SPDX-License-Identifier: BSD-3-Clause
# Every header compiled alone, as CMAKE_VERIFY_INTERFACE_HEADER_SETS does, in a third of the time: without optimisation, and
# with what it reaches by its includes of <Eigen/Core> and core/error.hpp precompiled. What that cannot see is a header that
# uses these, or what they include, above the line that brings them; and what a header reaches is found out when CMake is
# run. The presets without FSTIFF_UNITY leave it to CMake, without anything precompiled.
get_target_property(sets fstiff INTERFACE_HEADER_SETS_TO_VERIFY)
set(headers "")
foreach(set IN LISTS sets)
    get_target_property(files fstiff HEADER_SET_${set})
    list(APPEND headers ${files})
endforeach()
get_target_property(files fstiff_io HEADER_SET)
list(APPEND headers ${files})
list(TRANSFORM headers REPLACE "^.*include/fstiff" "fstiff")
foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} includes_of_${header} REGEX "^ *# *include")
endforeach()

# fstiff_reaching(result regex): those headers whose includes match, and what includes these, and so on
function(fstiff_reaching result regex)
    set(reaching "")
    set(rest ${headers})
    set(found TRUE)
    while(found)
        set(found "")
        foreach(header IN LISTS rest)
            if("${includes_of_${header}}" MATCHES "<(${regex})")
                list(APPEND found ${header})
            endif()
        endforeach()
        list(REMOVE_ITEM rest ${found})
        list(APPEND reaching ${found})
        list(JOIN found "|" regex)
    endwhile()
    set(${result} ${reaching} PARENT_SCOPE)
endfunction()

# fstiff_compile_alone(target headers precompiled...)
function(fstiff_compile_alone target headers)
    set(sources "")
    foreach(header IN LISTS headers)
        set(source ${PROJECT_BINARY_DIR}/headers_alone/${header}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT
             "#include <${header}>\n#include <${header}>\nstatic_assert(FSTIFF_VERSION > 0);\n")  # the second brings nothing
        list(APPEND sources ${source})
    endforeach()
    add_library(${target} OBJECT ${sources})
    target_link_libraries(${target} PRIVATE fstiff::fstiff)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>
                                             $<$<CXX_COMPILER_ID:GNU>:-fno-implicit-templates>)  # nothing links them
endfunction()

fstiff_reaching(with_eigen "Eigen/|unsupported/Eigen/")
fstiff_reaching(with_error "fstiff/core/error\\.hpp")
set(neither ${headers})
list(REMOVE_ITEM neither ${with_error})
set(without_eigen ${with_error})
list(REMOVE_ITEM without_eigen ${with_eigen})
list(REMOVE_ITEM with_error ${without_eigen})
fstiff_compile_alone(fstiff_headers_alone "${neither}")
fstiff_compile_alone(fstiff_headers_alone_errors "${without_eigen}" <fstiff/core/error.hpp>)
fstiff_compile_alone(fstiff_headers_alone_eigen "${with_error}" <Eigen/Core> <fstiff/core/error.hpp>)
