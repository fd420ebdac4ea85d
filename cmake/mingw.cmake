# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset "windows": MinGW-w64 for 64-bit Windows (Debian 12: g++-mingw-w64-x86-64). What is built stands
# alone: the run-time libraries of GCC are in it.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
# Debian has two of them; std::thread and std::mutex are in the one with POSIX threads.
find_program(CMAKE_C_COMPILER NAMES x86_64-w64-mingw32-gcc-posix x86_64-w64-mingw32-gcc REQUIRED)
find_program(CMAKE_CXX_COMPILER NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++ REQUIRED)
# A template that several files instantiate is one function in the program; GCC 12 believes here that it is the one of the
# file, and knows which registers it leaves alone. Files that are optimised in different ways then crash.
set(CMAKE_CXX_FLAGS_INIT -fno-ipa-ra)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -s")

# What consists of headers alone is taken from this machine, by links: all of /usr/include is not for Windows.
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
set(CMAKE_FIND_ROOT_PATH ${headers} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)  # Eigen
