// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The version of fstiff, which every header brings. CMakeLists.txt, the command and the package files read it from
/// here; fstiff.h repeats the number for C.

#define FSTIFF_VERSION_MAJOR 0
#define FSTIFF_VERSION_MINOR 1
#define FSTIFF_VERSION_PATCH 0
#define FSTIFF_VERSION 100  // 10000 major + 100 minor + patch, as in #if FSTIFF_VERSION >= 200
#define FSTIFF_VERSION_TEXT "0.1.0"
