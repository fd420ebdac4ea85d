// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of fstiff/answer.hpp, for one file of a program that does not link fstiff::double; with a second one it
/// does not link. The CMake target fstiff::fstiff compiles such a file (docs/linking-cpp.md). Where fstiff::double is
/// linked, this is empty.

#include <fstiff/core/config.hpp>

#ifdef FSTIFF_ANSWER_INLINE
#error "fstiff/implementation.hpp must be included before fstiff/answer_inline.hpp, or in another file"
#endif

#ifndef FSTIFF_COMPILED
#undef FSTIFF_INLINE
#define FSTIFF_INLINE
#include <fstiff/answer/answer_inline.hpp>
#include <fstiff/answer/measured_face_inline.hpp>
#endif
