// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The version of fstiff, written here alone: CMakeLists.txt, the command and the package file read it.

#define FSTIFF_VERSION_MAJOR 0
#define FSTIFF_VERSION_MINOR 1
#define FSTIFF_VERSION_PATCH 0
#define FSTIFF_VERSION "0.1.0"
