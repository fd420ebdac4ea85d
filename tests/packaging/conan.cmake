# SPDX-License-Identifier: BSD-3-Clause
# packaging/conan: the recipe is Python, and, where the client of Conan is installed or lies in build/conan (tools/check-conan
# puts it there), `conan create` packs the clone, builds a program against it and runs it, with Eigen of the system.
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
foreach(file IN ITEMS CMakeLists.txt LICENSE cmake include src/io packaging/conan/conanfile.py packaging/conan/test_package/CMakeLists.txt
                      packaging/conan/test_package/conanfile.py tests/consumer/main.cpp)
    cmake_path(GET file PARENT_PATH folder)
    file(COPY ${SOURCE}/${file} DESTINATION ${WORK}/clone/${folder})
endforeach()
execute_process(COMMAND ${conan} profile detect OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(
    COMMAND ${conan} create ${WORK}/clone/packaging/conan -o "fstiff/*:system_eigen=True" -s compiler.cppstd=20
            --no-remote
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(result OR NOT said MATCHES "Running test\\(\\)")
    message(FATAL_ERROR "conan create:\n${said}")
endif()
message("conan create has packed fstiff, and built and run the program of test_package")
