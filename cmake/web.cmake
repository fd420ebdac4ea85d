# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset "web": WebAssembly by Emscripten (Debian 12: emscripten). Threads are off, exceptions are on, and
# X3P and compressed files of Digital Surf are refused, because their libraries are not there.
find_path(FSTIFF_EMSCRIPTEN cmake/Modules/Platform/Emscripten.cmake HINTS $ENV{EMSDK}/upstream/emscripten
          PATHS /usr/share/emscripten NO_CMAKE_FIND_ROOT_PATH REQUIRED)
include(${FSTIFF_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake)
unset(CMAKE_CROSSCOMPILING_EMULATOR)
unset(CMAKE_CROSSCOMPILING_EMULATOR CACHE)
# Exceptions of WebAssembly itself, which every browser has had since 2022; those by JavaScript make it larger and slower.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/../src/web/emscripten.hpp")
# Debian keeps the modules of Node here, where a Node of another origin does not look.
set(ENV{NODE_PATH} /usr/share/nodejs:$ENV{NODE_PATH})
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=$ENV{NODE_PATH}")

include(${CMAKE_CURRENT_LIST_DIR}/staged-headers.cmake)
list(APPEND CMAKE_FIND_ROOT_PATH ${headers})
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)  # Eigen
