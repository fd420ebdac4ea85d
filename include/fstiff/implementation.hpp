// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of fstiff/answer.hpp, for one file of a program that does not link fstiff::double. It needs nothing
/// else:
///
///     #include <fstiff/implementation.hpp>
///
/// The CMake target fstiff::fstiff compiles such a file (docs/linking-cpp.md). A second one in a program does not link.

#include <fstiff/core/config.hpp>

#ifdef FSTIFF_ANSWER_INLINE
#error "fstiff/implementation.hpp must be included before fstiff/answer_inline.hpp, or in a file of its own"
#endif
#undef FSTIFF_INLINE
#define FSTIFF_INLINE

#include <fstiff/answer/answer_inline.hpp>
#include <fstiff/answer/measured_face_inline.hpp>
