# SPDX-License-Identifier: BSD-3-Clause
# Every public header compiled alone, as CMAKE_VERIFY_INTERFACE_HEADER_SETS does, in a third of the time: by its syntax, without
# code, and with what it reaches of <Eigen/Core>, core/error.hpp, profile/fractal_fit.hpp and measure/measure.hpp by its includes
# precompiled. Files *_inline.hpp are parts of headers, and left out. What that cannot see is a header that uses these, or what
# they include, above the line that brings them; and what a header reaches is found out when CMake is run. The presets without
# FSTIFF_UNITY leave it to CMake, without anything precompiled.
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

separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(TRANSFORM eigen PREPEND -isystem)
set(alone ${CMAKE_CXX_COMPILER} ${flags} -std=c++20 -I${PROJECT_SOURCE_DIR}/include ${eigen})
set(headers_alone "")

# fstiff_compile_alone(group headers precompiled...)
function(fstiff_compile_alone group headers)
    set(folder headers_alone)  # of the build folder
    set(precompiled "")
    set(with "")
    if(ARGN)
        list(TRANSFORM ARGN PREPEND "#include ")
        list(JOIN ARGN "\n" includes)
        set(file ${folder}/${group}.hpp)
        set(precompiled ${PROJECT_BINARY_DIR}/${file}.gch)
        file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${file} CONTENT "${includes}\n" @ONLY)
        add_custom_command(
            OUTPUT ${precompiled}
            COMMAND ${alone} -MD -MF ${file}.d -MT ${file}.gch -x c++-header ${file} -o ${file}.gch
            DEPENDS ${PROJECT_BINARY_DIR}/${file} DEPFILE ${file}.d
            WORKING_DIRECTORY ${PROJECT_BINARY_DIR} COMMENT "Precompiling ${file}" VERBATIM)
        set(with -include ${file})
        if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
            set(with -include-pch ${file}.gch)
        endif()
    endif()
    foreach(header IN LISTS headers)
        if(header MATCHES "(_inline|/implementation)\\.hpp$")  # src/instances compiles the latter
            continue()
        endif()
        set(source ${folder}/${header}.cpp)
        set(stamp ${folder}/${header}.checked)
        file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${source} CONTENT
             "#include <${header}>\n#include <${header}>\nstatic_assert(FSTIFF_VERSION > 0);\n")  # the second brings nothing
        add_custom_command(
            OUTPUT ${PROJECT_BINARY_DIR}/${stamp}
            COMMAND ${alone} ${with} -fsyntax-only -MD -MF ${stamp}.d -MT ${stamp} ${source}
            COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
            DEPENDS ${PROJECT_BINARY_DIR}/${source} ${precompiled} DEPFILE ${stamp}.d
            WORKING_DIRECTORY ${PROJECT_BINARY_DIR} COMMENT "Compiling ${header} alone" VERBATIM)
        list(APPEND headers_alone ${PROJECT_BINARY_DIR}/${stamp})
    endforeach()
    set(headers_alone ${headers_alone} PARENT_SCOPE)
endfunction()

fstiff_reaching(with_eigen "Eigen/|unsupported/Eigen/")
fstiff_reaching(with_error "fstiff/core/error\\.hpp")
fstiff_reaching(with_fit "fstiff/profile/fractal_fit\\.hpp")
fstiff_reaching(with_measure "fstiff/measure/measure\\.hpp")
set(neither ${headers})
list(REMOVE_ITEM neither ${with_error})
set(without_eigen ${with_error})
list(REMOVE_ITEM without_eigen ${with_eigen})
list(REMOVE_ITEM with_error ${without_eigen} ${with_fit})
list(REMOVE_ITEM with_fit ${with_measure})
fstiff_compile_alone(neither "${neither}")
fstiff_compile_alone(errors "${without_eigen}" <fstiff/core/error.hpp>)
fstiff_compile_alone(eigen "${with_error}" <Eigen/Core> <fstiff/core/error.hpp>)
fstiff_compile_alone(fit "${with_fit}" <fstiff/profile/fractal_fit.hpp>)
fstiff_compile_alone(measure "${with_measure}" <fstiff/measure/measure.hpp>)
add_custom_target(fstiff_headers_alone ALL DEPENDS ${headers_alone})
