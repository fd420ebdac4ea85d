# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset "clang": the clang++ of the path, else the newest versioned one. CXX in the environment wins.
if(DEFINED ENV{CXX})
    set(CMAKE_CXX_COMPILER $ENV{CXX})
else()
    find_program(CMAKE_CXX_COMPILER NAMES
        clang++ clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14 REQUIRED)
endif()
