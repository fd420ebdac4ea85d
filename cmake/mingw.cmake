# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset "windows": MinGW-w64 for 64-bit Windows (Debian 12: g++-mingw-w64-x86-64). The programs need
# no other library: those of GCC are in them.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
# Debian has two of them; std::thread and std::mutex are in the one with POSIX threads.
find_program(CMAKE_C_COMPILER NAMES x86_64-w64-mingw32-gcc-posix x86_64-w64-mingw32-gcc REQUIRED)
find_program(CMAKE_CXX_COMPILER NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++ REQUIRED)
# A template that several files instantiate is one function in the program. GCC 12 assumes here that it is the copy of the
# file, whose use of registers it has seen. Files that are optimised in different ways then crash.
set(CMAKE_CXX_FLAGS_INIT -fno-ipa-ra)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -s")

include(${CMAKE_CURRENT_LIST_DIR}/staged-headers.cmake)
set(CMAKE_FIND_ROOT_PATH ${headers} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)  # Eigen
