# SPDX-License-Identifier: BSD-3-Clause
# Of toolchains for other systems: what consists of headers alone is taken from this machine, by links, into ${headers}.
# All of /usr/include is not for them.
set(FSTIFF_HEADERS /usr/include CACHE PATH "Folder that holds CLI, nlohmann, toml++ and catch2")
set(headers ${CMAKE_BINARY_DIR}/headers)
get_property(is_trial GLOBAL PROPERTY IN_TRY_COMPILE)
if(NOT is_trial)
    file(MAKE_DIRECTORY ${headers}/include)
    foreach(folder IN ITEMS CLI nlohmann toml++ catch2)
        file(CREATE_LINK ${FSTIFF_HEADERS}/${folder} ${headers}/include/${folder} SYMBOLIC)
    endforeach()
    foreach(package IN ITEMS CLI11 nlohmann_json tomlplusplus)
        file(WRITE ${headers}/lib/cmake/${package}/${package}Config.cmake
             "add_library(${package}::${package} INTERFACE IMPORTED)\n"
             "target_include_directories(${package}::${package} SYSTEM INTERFACE ${headers}/include)\n")
    endforeach()
endif()
