// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of fstiff/answer.hpp, for one file of a program that does not link fstiff::double. The CMake target
/// fstiff::fstiff compiles such a file (docs/linking-cpp.md). Where FSTIFF_COMPILED is defined, as by fstiff::double,
/// this is empty.

#include <fstiff/core/config.hpp>

#ifdef FSTIFF_ANSWER_INLINE
#error "fstiff/implementation.hpp must be included before fstiff/answer_inline.hpp, or in another file"
#endif

#ifndef FSTIFF_COMPILED
#undef FSTIFF_INLINE
#define FSTIFF_INLINE FSTIFF_COMPILED_HERE
#include <fstiff/answer/answer_inline.hpp>
#include <fstiff/answer/measured_face_inline.hpp>
#endif
