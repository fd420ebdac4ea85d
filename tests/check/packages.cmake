# SPDX-License-Identifier: BSD-3-Clause
# Which Eigen is taken and which is refused, by the folder SOURCE and by the package installed under PREFIX; Eigen as a
# target of the project around; components that do not exist. Projects are configured in WORK, nothing is built.
# EIGEN: the headers of Eigen, which pass for other versions here. COMPILER: for the languages of the projects.
cmake_minimum_required(VERSION 3.25)
include(CMakePackageConfigHelpers)
set(project ${CMAKE_CURRENT_LIST_DIR}/../consumer/configured)
file(REMOVE_RECURSE ${WORK})

# eigen(version): a package of Eigen with the kind of version file that Eigen ships, in WORK/eigen-<version>.
function(eigen version)
    set(folder ${WORK}/eigen-${version})
    file(WRITE ${folder}/Eigen3Config.cmake "
        if(NOT TARGET Eigen3::Eigen)
            add_library(Eigen3::Eigen INTERFACE IMPORTED)
            set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES \"${EIGEN}\")
        endif()\n")
    write_basic_package_version_file(
        ${folder}/Eigen3ConfigVersion.cmake VERSION ${version} COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
endfunction()

# configure(name expected [option...]): expected is a regular expression for the output; one that begins with "refused:"
# is for the output of a project that must be refused.
function(configure name expected)
    set(build ${WORK}/${name})
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${project} -B ${build} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN}
                    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")  # messages are wrapped
    set(should_fail FALSE)
    if(expected MATCHES "^refused: *(.*)$")
        set(should_fail TRUE)
        set(expected "${CMAKE_MATCH_1}")
    endif()
    if((should_fail AND result EQUAL 0) OR (NOT should_fail AND NOT result EQUAL 0) OR NOT said MATCHES "${expected}")
        message(SEND_ERROR "${name}: '${expected}' expected, result ${result}: ${said}")
    endif()
endfunction()

set(source -DFSTIFF_SOURCE=${SOURCE})
set(package -DCMAKE_PREFIX_PATH=${PREFIX})

foreach(version IN ITEMS 3.3.9 3.4.0 5.0.1 6.0.0)
    eigen(${version})
    foreach(from IN ITEMS source package)
        set(expected "Eigen of fstiff: [^ ]*/eigen-${version} ")
        if(version MATCHES "^(3\\.3|6)")
            set(expected "refused: Eigen3 ${version} in .*: fstiff needs 3.4 or later, below 6")
        endif()
        configure(${from}-${version} "${expected}" ${${from}} -DEigen3_DIR=${WORK}/eigen-${version})
    endforeach()
endforeach()

# The project's own target replaces Eigen: nothing is searched, and fstiff is installed only on request.
set(own -DOWN_EIGEN=${EIGEN} -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
configure(own "Eigen of fstiff: -- " ${source} ${own})
configure(own-installed "Eigen of fstiff: -- " ${source} ${own} -DFSTIFF_INSTALL=ON)
configure(own-package "Eigen of fstiff: -- " ${package} ${own})
foreach(build IN ITEMS own own-installed)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${WORK}/${build} --prefix ${WORK}/${build}/prefix
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(EXISTS ${WORK}/own/prefix)
    message(SEND_ERROR "a subproject installs fstiff without being asked")
endif()
# what such a project installed is a package like any other
configure(own-twice "Eigen of fstiff: [^ ]*/eigen-5.0.1 " -DCMAKE_PREFIX_PATH=${WORK}/own-installed/prefix -DEigen3_DIR=${WORK}/eigen-5.0.1)

# The functions of the answer are compiled with a target that links fstiff::fstiff, unless its property has it off.
foreach(build IN ITEMS source-5.0.1 package-5.0.1)
    file(READ ${WORK}/${build}/sources.txt sources)
    if(NOT sources MATCHES "^program [^ ]*main.cpp;[^ ]*/fstiff-implementation.cpp without [^ ;]*main.cpp;?\n$")
        message(SEND_ERROR "${build}: sources of the targets are ${sources}")
    endif()
endforeach()

configure(component-io "Eigen of fstiff: " ${package} -DCOMPONENTS=io)
configure(component-dev "Eigen of fstiff: " ${package} -DCOMPONENTS=dev)
configure(component-c "refused:.*component c is not installed" ${package} -DCOMPONENTS=c)
configure(component "refused:.*there is no component \"nonsense\"; there are dev, io, double and c" ${package} -DCOMPONENTS=nonsense)
