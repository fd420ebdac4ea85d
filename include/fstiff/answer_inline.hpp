// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// fstiff/answer.hpp with its functions, for joints of numbers in a program of one file: it compiles what the file
/// uses. A measured face needs fstiff/implementation.hpp. Where fstiff::double has them compiled, they are left out.

#include <fstiff/answer.hpp>

#ifndef FSTIFF_COMPILED
#include <fstiff/answer/answer_inline.hpp>
#endif
