// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Requirements on a compiler, each with one clear error, and replacements for gaps of the standard library.
///
///     C++20                 concepts, std::bit_cast, std::span
///     NaN and infinity      NaN is the missing point of a profile or a map, and fails every check of an argument.
///                           Under -ffinite-math-only (a part of -ffast-math) such comparisons may be false or true:
///                           wrong numbers pass without a message. Its other parts give no wrong result, but
///                           associative-math takes away the digits that compensated sums gain.
///     round every operation not the x87 unit, which keeps 64 bits and rounds when it stores: compensated sums, and the
///                           argument reduction of the Gaussian, rest on the rounding of each operation
///
///     FSTIFF_HAS_FLOAT_FROM_CHARS, FSTIFF_HAS_FLOAT_TO_CHARS    1 where std::from_chars, std::to_chars take float and
///                           double. Either may be defined as 0 before the first include, to have the substitutes of
///                           core/text.hpp.

#if defined(_MSVC_LANG)
#if _MSVC_LANG < 202002L
#error "fstiff needs C++20: compile with /std:c++20 or later"
#endif
#elif !defined(__cplusplus) || __cplusplus < 202002L
#error "fstiff needs C++20: compile with -std=c++20 or later (GCC 11, clang 12 or newer)"
#endif

#if defined(__FINITE_MATH_ONLY__) ? __FINITE_MATH_ONLY__ : (defined(__FAST_MATH__) || defined(_M_FP_FAST))
#error "fstiff needs NaN (missing points, guards of arguments): no -ffast-math, -ffinite-math-only, /fp:fast"
#endif

#if (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "fstiff needs every operation rounded, not the 64 bits of x87: use -msse2 -mfpmath=sse or /arch:SSE2"
#endif

#include <fstiff/core/version.hpp>

#include <version>

// Functions of fstiff/answer: inline, and in fstiff/implementation.hpp compiled whether or not the file uses them.
#define FSTIFF_INLINE inline
#if __has_cpp_attribute(gnu::used)
#define FSTIFF_COMPILED_HERE [[gnu::used]] inline
#else
#define FSTIFF_COMPILED_HERE
#endif

// Marks functions that are rarely called, or that a program should hold once: a hint to compilers that support it.
#if __has_cpp_attribute(gnu::cold)
#define FSTIFF_COLD [[gnu::cold]]
#define FSTIFF_COLD_OUT_OF_LINE [[gnu::cold, gnu::noinline]]
#else
#define FSTIFF_COLD
#define FSTIFF_COLD_OUT_OF_LINE
#endif

// libc++ has to_chars for floating-point numbers since LLVM 14 and from_chars since LLVM 20, in its shared library.
// On macOS the deployment target decides whether they are available. libc++ does not define __cpp_lib_to_chars.
#ifndef FSTIFF_HAS_FLOAT_FROM_CHARS
#if defined(_LIBCPP_VERSION)
#if _LIBCPP_VERSION >= 200000 && (!defined(_LIBCPP_AVAILABILITY_HAS_FROM_CHARS_FLOATING_POINT) || \
                                  _LIBCPP_AVAILABILITY_HAS_FROM_CHARS_FLOATING_POINT)
#define FSTIFF_HAS_FLOAT_FROM_CHARS 1
#endif
#elif defined(__cpp_lib_to_chars)
#define FSTIFF_HAS_FLOAT_FROM_CHARS 1
#endif
#ifndef FSTIFF_HAS_FLOAT_FROM_CHARS
#define FSTIFF_HAS_FLOAT_FROM_CHARS 0
#endif
#endif

#ifndef FSTIFF_HAS_FLOAT_TO_CHARS
#if defined(_LIBCPP_AVAILABILITY_HAS_TO_CHARS_FLOATING_POINT)
#define FSTIFF_HAS_FLOAT_TO_CHARS _LIBCPP_AVAILABILITY_HAS_TO_CHARS_FLOATING_POINT
#elif defined(_LIBCPP_VERSION)
#if _LIBCPP_VERSION >= 14000 && !defined(__APPLE__)
#define FSTIFF_HAS_FLOAT_TO_CHARS 1
#endif
#elif defined(__cpp_lib_to_chars)
#define FSTIFF_HAS_FLOAT_TO_CHARS 1
#endif
#ifndef FSTIFF_HAS_FLOAT_TO_CHARS
#define FSTIFF_HAS_FLOAT_TO_CHARS 0
#endif
#endif
