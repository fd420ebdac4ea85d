# SPDX-License-Identifier: BSD-3-Clause
# packaging/conan: the recipe is Python, and, where the client of Conan is installed or lies in build/conan (tools/check-conan
# puts it there), `conan create` packs the clone, builds a program of tests/consumer against it and runs it, with Eigen of the
# system: the headers, and each library of LIBRARIES.
cmake_minimum_required(VERSION 3.25)
foreach(recipe IN ITEMS conanfile.py test_package/conanfile.py)
    execute_process(COMMAND ${PYTHON} -c "import ast, sys; ast.parse(open(sys.argv[1]).read(), sys.argv[1])"
                            ${SOURCE}/packaging/conan/${recipe} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
find_program(conan conan HINTS ${SOURCE}/build/conan/bin)
if(NOT conan)
    message("SKIPPED: there is no conan (tools/check-conan installs it); the recipes are Python")
    return()
endif()
file(REMOVE_RECURSE ${WORK})
set(ENV{CONAN_HOME} ${WORK}/home)
# A copy, because Conan builds the program of test_package next to its recipe.
foreach(file IN ITEMS CMakeLists.txt LICENSE cmake include src/io src/instances packaging/conan tests/consumer
                      tests/check/processors)
    cmake_path(GET file PARENT_PATH folder)
    file(COPY ${SOURCE}/${file} DESTINATION ${WORK}/clone/${folder})
endforeach()
execute_process(COMMAND ${conan} profile detect OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
# What Conan passes to other build systems than CMake.
set(flags_of_io "-lfstiff_io")
set(flags_of_double "-lfstiff_double.*-DFSTIFF_COMPILED.*-DEIGEN_MAX_ALIGN_BYTES=.*-DEIGEN_MAX_STATIC_ALIGN_BYTES=")
foreach(library IN ITEMS "" ${LIBRARIES})
    set(options -o "fstiff/*:system_eigen=True")
    if(library)
        list(APPEND options -o "fstiff/*:${library}=True")
    endif()
    execute_process(
        COMMAND ${conan} create ${WORK}/clone/packaging/conan ${options} -s compiler.cppstd=20 --no-remote
        OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
    if(result OR NOT said MATCHES "Running test\\(\\)")
        message(FATAL_ERROR "conan create ${options}:\n${said}")
    endif()
    if(library)
        file(GLOB_RECURSE package ${WORK}/clone/packaging/conan/test_package/build/fstiff-${library}.pc)
        file(READ ${package} flags)
        if(NOT flags MATCHES "${flags_of_${library}}")
            message(FATAL_ERROR "${package}: ${flags}")
        endif()
    endif()
    list(JOIN options " " options)
    message("conan create ${options}: the program of tests/consumer was built and ran")
endforeach()
