# SPDX-License-Identifier: BSD-3-Clause
# Installs component c of BUILD, moves it, and builds example.c against it: by find_package(fstiff-c), and by pkg-config.
cmake_minimum_required(VERSION 3.25)
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()
set(prefix ${WORK}/moved)
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first --component c)
file(RENAME ${WORK}/first ${prefix})
file(GLOB_RECURSE installed RELATIVE ${prefix} ${prefix}/*)
foreach(expected IN ITEMS include/fstiff.h include/fstiff_answer.h share/fstiff/fortran/fstiff.f90 share/doc/fstiff-c/LICENSE)
    if(NOT expected IN_LIST installed)
        message(FATAL_ERROR "${expected} is not installed, but: ${installed}")
    endif()
endforeach()
if(installed MATCHES "\\.hpp")
    message(FATAL_ERROR "headers of C++ in the component of C: ${installed}")
endif()

set(language C)
if(STATIC)
    set(language C CXX)
endif()
file(WRITE ${WORK}/user/CMakeLists.txt
     "cmake_minimum_required(VERSION 3.25)\nproject(user LANGUAGES ${language})\nfind_package(fstiff-c REQUIRED)\n"
     "add_executable(user ${SOURCE}/example.c)\ntarget_link_libraries(user PRIVATE fstiff::c)\n")
run(${CMAKE_COMMAND} -S ${WORK}/user -B ${WORK}/build -G ${GENERATOR} -D CMAKE_C_COMPILER=${CC}
    -D CMAKE_PREFIX_PATH=${prefix} "-DCMAKE_C_FLAGS=${FLAGS}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/user)

# with the headers it is a component of fstiff
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component dev)
file(WRITE ${WORK}/component/CMakeLists.txt
     "cmake_minimum_required(VERSION 3.22)\nproject(component LANGUAGES C CXX)\nfind_package(fstiff REQUIRED COMPONENTS dev c)\n"
     "get_target_property(file fstiff::c LOCATION)\n")
run(${CMAKE_COMMAND} -S ${WORK}/component -B ${WORK}/component/build -D CMAKE_PREFIX_PATH=${prefix})

find_program(pkg_config NAMES pkg-config pkgconf)
if(NOT pkg_config)
    return()
endif()
set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
execute_process(COMMAND ${pkg_config} --cflags --libs fstiff-c OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${FLAGS}")
run(${CC} ${SOURCE}/example.c -o ${WORK}/by_pkg_config ${flags})
set(ENV{LD_LIBRARY_PATH} ${prefix}/${LIBDIR})
run(${WORK}/by_pkg_config)
